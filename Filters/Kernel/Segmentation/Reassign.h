// SPDX-License-Identifier: BSD-3-Clause
// Materials given to voxels by hand: boxes, balls and lists of voxels, one after the other.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"
#include "../Mesh/LabelImage.h"

#include <string>
#include <vector>

namespace lamina
{

enum class EditShape
{
  Box,    ///< voxels whose centres lie between two corners, sides along the world's axes
  Sphere, ///< voxels whose centres lie in a ball
  Voxels  ///< voxels by their indices
};

/// "box", "sphere" or "voxels".
const char* ShapeName(EditShape shape);

/// One decision of a person: the voxels of a shape become a material.
struct VoxelEdit
{
  std::string name; ///< for messages and the report, e.g. "edit 3"
  EditShape shape = EditShape::Voxels;
  Vec3 low; ///< of a box, in world coordinates; below `high` along each axis
  Vec3 high;
  Vec3 centre; ///< of a sphere, in world coordinates
  double radius = 0;
  std::vector<Id> voxels;                ///< 0 to Count() - 1, in any order; twice counts once
  std::array<Id, 3> size{ { 0, 0, 0 } }; ///< of the image that the voxels are of; zeros: not known
  std::vector<int> from;                 ///< only voxels of these materials; empty: of any
  int to = 0;                            ///< 0 to 65,535
};

struct ReassignOptions
{
  std::vector<VoxelEdit> edits; ///< applied in this order
  /// Afterwards change voxels until a manifold surface can pass between the materials (WellComposed.h). Needs
  /// an edit: without one the image stays as it is.
  bool repairTopology = true;
  /// Pairs of materials that may not meet over a face, an edge or a corner.
  std::vector<std::array<int, 2>> forbidden;
  /// Whether forbidden pairs may meet at the image's border, outside of which is background.
  bool openAtImageBorder = false;
};

struct EditReport
{
  std::string name;
  EditShape shape = EditShape::Voxels;
  int to = 0;
  Id covered = 0; ///< voxels in the shape
  Id decided = 0; ///< of these, voxels of the materials asked for
  Id changed = 0; ///< of these, voxels that were not of the material yet
};

struct ReassignReport
{
  std::vector<EditReport> edits;
  bool mended = false;  ///< whether the repair ran
  Id criticalEdges = 0; ///< faults found after the edits, before the repair
  Id criticalCorners = 0;
  Id forbiddenContacts = 0;
  Id remaining = 0;               ///< faults that the repair left
  std::vector<Id> repaired;       ///< voxels that the repair changed, ascending
  Id overridden = 0;              ///< of these, voxels that an edit had decided
  std::vector<Vec3> overriddenAt; ///< where these are
  std::vector<std::string> warnings;
};

/// What became of a voxel.
enum Decision : unsigned char
{
  Untouched = 0,
  Decided = 1,   ///< its material is the one an edit gave
  Overridden = 2 ///< an edit gave it a material, the repair had to change it
};

/// A failure if an edit or a forbidden pair is not one that can be applied to an image on `grid`.
Result<bool> CheckEdits(const GridGeometry& grid, const ReassignOptions& options);

/// Apply the edits to `image` and repair its topology. The repair leaves decided voxels alone at first; only
/// for faults that then remain it may change them, which is reported. `decisions` gets a Decision a voxel. On
/// failure nothing is changed. The same for any number of threads.
Result<ReassignReport> Reassign(LabelImage& image, std::vector<unsigned char>& decisions,
                                const ReassignOptions& options, Monitor& monitor);

} // namespace lamina
