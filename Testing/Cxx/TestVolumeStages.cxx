// SPDX-License-Identifier: BSD-3-Clause
// What the stages that fill volumes share: their needs and their ports.
#include "Inputs.h"

#include "vtkCoreTetrahedra.h"
#include "vtkFeatureSize.h"
#include "vtkFeatureSizeRefinement.h"
#include "vtkFluidSolidMesh.h"
#include "vtkLayeredTetrahedra.h"
#include "vtkMeshAudit.h"
#include "vtkMultimaterialMarchingCubes.h"
#include "vtkPrismLayer.h"
#include "vtkVolumeConservingSmoothing.h"

#include <vtkIdTypeArray.h>
#include <vtkMath.h>

namespace
{

/// The stages up to the refined surface, on nested boxes.
struct Surface
{
  vtkNew<vtkMultimaterialMarchingCubes> Extraction;
  vtkNew<vtkVolumeConservingSmoothing> Smoothing;
  vtkNew<vtkFeatureSize> Sizing;
  vtkNew<vtkFeatureSizeRefinement> Refinement;

  Surface()
  {
    this->Extraction->SetInputData(NestedBoxes(20));
    this->Smoothing->SetInputConnection(this->Extraction->GetOutputPort());
    this->Sizing->SetInputConnection(this->Smoothing->GetOutputPort());
    this->Sizing->SetLayers(2);
    this->Refinement->SetInputConnection(this->Sizing->GetOutputPort());
  }
  vtkAlgorithmOutput* Port() { return this->Refinement->GetOutputPort(); }
};

void ExpectGridArrays(vtkUnstructuredGrid* grid)
{
  for (const char* name : { "MaterialIds", "LayerIds" })
  {
    EXPECT_TRUE(vtkIntArray::SafeDownCast(grid->GetCellData()->GetArray(name))) << name;
  }
  EXPECT_TRUE(vtkIntArray::SafeDownCast(grid->GetPointData()->GetArray("LayerIndex")));
  EXPECT_TRUE(vtkIdTypeArray::SafeDownCast(grid->GetPointData()->GetArray("InterfaceNodeIds")));
}

void ExpectLayerArrays(vtkAlgorithm* filter, int port)
{
  auto* surface = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port));
  ASSERT_TRUE(surface);
  for (const char* name : { "LayersAchieved", "LayerFraction" })
  {
    vtkDataArray* array = surface->GetCellData()->GetArray(name);
    ASSERT_TRUE(array) << name;
    EXPECT_EQ(array->GetNumberOfTuples(), surface->GetNumberOfCells());
  }
}

} // namespace

TEST(LayeredTetrahedra, PortsDefaultsAndNeeds)
{
  vtkNew<vtkLayeredTetrahedra> filter;
  EXPECT_EQ(filter->GetNumberOfOutputPorts(), 2);
  EXPECT_EQ(filter->GetNumberOfSolidMaterials(), 0);
  EXPECT_EQ(filter->GetFluidMaterial(0), 2);
  filter->SetInputData(PlainTetrahedron());
  ExpectError(filter, "no MaterialFeatureSize on the points: run Feature Size first");
  filter->AddSolidMaterial(3);
  ExpectError(filter, "SolidMaterials names material 3, which the input lacks: its materials are 1");
  filter->ClearSolidMaterials();
  filter->AddSolidMaterial(0);
  ExpectError(filter, "the background");
}

TEST(LayeredTetrahedra, NothingSolidIsAnEmptyPartWithAWarning)
{
  vtkNew<vtkLayeredTetrahedra> filter;
  filter->SetInputData(PlainTetrahedron());
  filter->AddFluidMaterial(1);
  Watch watch(filter);
  filter->Update();
  EXPECT_FALSE(watch.GetError());
  EXPECT_NE(watch.Warning().find("no solid"), std::string::npos);
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfCells(), 0);
}

TEST(PrismLayer, PortsDefaultsAndNeeds)
{
  vtkNew<vtkPrismLayer> filter;
  EXPECT_EQ(filter->GetNumberOfOutputPorts(), 3);
  filter->SetInputData(PlainTetrahedron());
  {
    Watch watch(filter);
    filter->Update();
    EXPECT_NE(watch.Warning().find("no fluid"), std::string::npos);
    EXPECT_FALSE(watch.GetError());
  }
  filter->AddFluidMaterial(3);
  ExpectError(filter, "FluidMaterials names material");
  filter->ClearFluidMaterials();
  filter->AddFluidMaterial(1);
  ExpectError(filter, "no MaterialFeatureSize on the points: run Feature Size first");
}

TEST(LayeredTetrahedra, ArraysOfTheContractAndRanges)
{
  Surface surface;
  vtkNew<vtkLayeredTetrahedra> filter;
  filter->SetInputConnection(surface.Port());
  filter->SetLayers(2);
  ExpectFine(filter);
  ASSERT_GT(filter->GetOutput()->GetNumberOfCells(), 0);
  ExpectGridArrays(filter->GetOutput());
  ExpectLayerArrays(filter, 1);
  double range[2];
  filter->GetOutput()->GetCellData()->GetArray("MaterialIds")->GetRange(range);
  EXPECT_EQ(range[0], 1);
  EXPECT_EQ(range[1], 1);
  filter->SetLayers(0);
  ExpectError(filter, "ayers");
  filter->SetLayers(1);
  filter->SetAnisotropy(0);
  ExpectError(filter, "nisotropy");
  filter->SetAnisotropy(2);
  filter->SetGrowth(0);
  ExpectError(filter, "rowth");
}

TEST(PrismLayer, ArraysOfTheContractAndRanges)
{
  Surface surface;
  vtkNew<vtkPrismLayer> filter;
  filter->SetInputConnection(surface.Port());
  filter->SetLayers(3);
  ExpectFine(filter);
  ASSERT_GT(filter->GetOutput()->GetNumberOfCells(), 0);
  ExpectGridArrays(filter->GetOutput());
  ExpectLayerArrays(filter, 2);
  auto* inner = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
  ASSERT_TRUE(inner);
  EXPECT_TRUE(inner->GetCellData()->GetArray("BoundaryLabels"));
  vtkDataArray* height = inner->GetPointData()->GetArray("LayerHeight");
  vtkDataArray* side = inner->GetPointData()->GetArray("LayerSide");
  ASSERT_TRUE(height && side);
  ASSERT_EQ(side->GetNumberOfComponents(), 3);
  for (vtkIdType p = 0; p < inner->GetNumberOfPoints(); ++p)
  {
    EXPECT_NEAR(vtkMath::Norm(side->GetTuple3(p)), height->GetComponent(p, 0), 1e-12);
  }
  filter->SetLayers(0);
  ExpectError(filter, "ayers");
  filter->SetLayers(1);
  filter->SetGrowthRatio(0.5);
  ExpectError(filter, "rowth");
  filter->SetGrowthRatio(1);
  filter->SetThickness(0.6);
  ExpectError(filter, "hickness");
  filter->SetThickness(0.25);
  filter->SetLeastQuality(1);
  ExpectError(filter, "least quality");
  filter->SetLeastQuality(0.99); // of which no prism of this surface is
  filter->EndColumnsOff();
  ExpectError(filter, "no layers can stand at");
  filter->SetLeastQuality(0);
  ExpectFine(filter);
  const vtkIdType all = filter->GetOutput()->GetNumberOfCells();
  filter->AddWallPatchId(77);
  ExpectError(filter, "one of the patches");
  filter->AddWallPatchId(0);
  ExpectFine(filter);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), all);
  EXPECT_EQ(filter->GetWallPatchId(1), 0);
  filter->ClearWallPatchIds();
}

TEST(MeshAudit, PassesTheWholeMeshAndFindsAPartMissing)
{
  Surface surface;
  vtkNew<vtkLayeredTetrahedra> solid;
  solid->SetInputConnection(surface.Port());
  solid->SetLayers(2);
  vtkNew<vtkPrismLayer> prisms;
  prisms->SetInputConnection(surface.Port());
  prisms->SetLayers(3);
  vtkNew<vtkCoreTetrahedra> core;
  core->SetInputConnection(prisms->GetOutputPort(1));
  vtkNew<vtkFluidSolidMesh> mesh;
  mesh->AddInputConnection(solid->GetOutputPort());
  mesh->AddInputConnection(prisms->GetOutputPort());
  mesh->AddInputConnection(core->GetOutputPort());
  vtkNew<vtkMeshAudit> audit;
  audit->SetInputConnection(mesh->GetOutputPort());
  audit->SetInputConnection(1, surface.Port());
  ExpectFine(audit);
  EXPECT_TRUE(audit->GetPassed()) << audit->GetReportAsJSON();
  auto* grid = vtkUnstructuredGrid::SafeDownCast(audit->GetOutputDataObject(0));
  EXPECT_TRUE(vtkDoubleArray::SafeDownCast(grid->GetCellData()->GetArray("MeshQuality")));
  EXPECT_TRUE(grid->GetCellData()->GetArray("MeshingFlags"));

  mesh->SetScale(0.001);
  ExpectFine(audit);
  EXPECT_FALSE(audit->GetPassed()) << "the surface is not scaled";
  audit->SetSurfaceScale(0.001);
  ExpectFine(audit);
  EXPECT_TRUE(audit->GetPassed()) << audit->GetReportAsJSON();

  mesh->RemoveInputConnection(0, core->GetOutputPort());
  ExpectFine(audit);
  EXPECT_FALSE(audit->GetPassed());
  audit->SetVolumeTolerance(0);
  EXPECT_EQ(audit->GetVolumeTolerance(), 0);
  audit->SetOverlapSamples(10);
  audit->SetQualityGate(0.2);
}
