// SPDX-License-Identifier: BSD-3-Clause
// The names of all arrays that travel down the pipeline (docs/pipeline.md); no other C++ file spells one out.
#pragma once

namespace lamina
{
namespace names
{

// Images: points. Volume meshes: cells.
constexpr const char* MaterialIds = "MaterialIds";
constexpr const char* Disputed = "Disputed";
constexpr const char* Intensity = "Intensity";
constexpr const char* Parts = "Parts";
constexpr const char* Mask = "Mask";

// Surfaces: triangles.
constexpr const char* BoundaryLabels = "BoundaryLabels";
constexpr const char* PatchIds = "PatchIds";
constexpr const char* MissingVolume = "MissingVolume";
constexpr const char* LayersAchieved = "LayersAchieved";
constexpr const char* LayerFraction = "LayerFraction";

// Surfaces: points.
constexpr const char* JunctionOrder = "JunctionOrder";
constexpr const char* JunctionKind = "JunctionKind";
constexpr const char* MaterialFeatureSize = "MaterialFeatureSize";
constexpr const char* FeatureSize = "FeatureSize";
constexpr const char* TargetEdgeLength = "TargetEdgeLength";
constexpr const char* LayerHeight = "LayerHeight";
constexpr const char* LayerSide = "LayerSide";
constexpr const char* MaximumCurvature = "MaximumCurvature";
constexpr const char* MinimumCurvature = "MinimumCurvature";
constexpr const char* MaximumCurvatureDirection = "MaximumCurvatureDirection";

// Volume meshes.
constexpr const char* LayerIndex = "LayerIndex";
constexpr const char* LayerIds = "LayerIds";
constexpr const char* WallDepth = "WallDepth";
constexpr const char* LayerNormals = "LayerNormals";
constexpr const char* Fibers = "Fibers";
constexpr const char* Sheets = "Sheets";
constexpr const char* InterfaceNodeIds = "InterfaceNodeIds";
constexpr const char* MeshQuality = "MeshQuality";
constexpr const char* MeshingFlags = "MeshingFlags";
constexpr const char* GlobalNodeIds = "GlobalNodeIds";
constexpr const char* TwinNodeIds = "TwinNodeIds";

// Field data.
constexpr const char* PatchNames = "PatchNames";
constexpr const char* PatchKinds = "PatchKinds";
constexpr const char* PatchMaterials = "PatchMaterials";
constexpr const char* PatchFaces = "PatchFaces";
constexpr const char* PatchedCells = "PatchedCells";
constexpr const char* NamedMaterials = "NamedMaterials";
constexpr const char* LengthUnit = "LengthUnit";
constexpr const char* LengthScale = "LengthScale";
constexpr const char* MaterialNames = "MaterialNames";
constexpr const char* MaterialList = "MaterialList"; // one text: a line a material, its id and its name
constexpr const char* MaterialVolumes = "MaterialVolumes";
constexpr const char* ImageVolumes = "ImageVolumes";
constexpr const char* MaterialComponents = "MaterialComponents";
constexpr const char* IntersectingPairs = "IntersectingPairs";
constexpr const char* LeastClearance = "LeastClearance";
constexpr const char* LeastAngle = "LeastAngle";
/// Followed by the stage's name: a string of JSON, the report of that stage.
constexpr const char* ReportPrefix = "LaminaReport_";

} // namespace names
} // namespace lamina
