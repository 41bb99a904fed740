// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include "vtkMultimaterialMarchingCubes.h"
#include "vtkVesselCut.h"

namespace
{

vtkSmartPointer<vtkPolyData> Boxes()
{
  vtkNew<vtkMultimaterialMarchingCubes> extraction;
  extraction->SetInputData(NestedBoxes());
  extraction->Update();
  return extraction->GetOutput();
}

} // namespace

TEST(VesselCut, TakesAwayWhatIsBeyondAndNamesTheEnds)
{
  const auto boxes = Boxes();
  const vtkIdType before = boxes->GetNumberOfCells();
  AddUniform(boxes, "FeatureSize", 2);
  vtkNew<vtkVesselCut> filter;
  filter->SetInputData(boxes);
  filter->SetOrigin(6.5, 6.5, 7.2);
  filter->SetNormal(0.2, 0.1, 2);
  filter->SetName("outflow");
  ExpectFine(filter);
  vtkPolyData* out = filter->GetOutput();
  auto* names = vtkStringArray::SafeDownCast(out->GetFieldData()->GetAbstractArray("PatchNames"));
  ASSERT_TRUE(names);
  ASSERT_EQ(names->GetNumberOfValues(), 3);
  EXPECT_EQ(names->GetValue(0), "wall");
  EXPECT_EQ(names->GetValue(1), "border_outflow");
  EXPECT_EQ(names->GetValue(2), "opening_outflow");
  vtkDataArray* patches = out->GetCellData()->GetArray("PatchIds");
  vtkDataArray* labels = out->GetCellData()->GetArray("BoundaryLabels");
  ASSERT_TRUE(patches && labels && out->GetPointData()->GetArray("JunctionKind"));
  for (vtkIdType t = 0; t < out->GetNumberOfCells(); ++t)
  {
    const int patch = static_cast<int>(patches->GetComponent(t, 0));
    EXPECT_TRUE(patch == 0 || (labels->GetComponent(t, 0) == patch && labels->GetComponent(t, 1) == 0));
  }
  EXPECT_LT(out->GetBounds()[5], 8.5);
  EXPECT_FALSE(out->GetPointData()->GetArray("FeatureSize")) << "sizes have to be found anew";
  EXPECT_NE(ReportOf(out, "VesselCut").find("cutShare"), std::string::npos);
  EXPECT_FALSE(ReportOf(out, "MultimaterialMarchingCubes").empty()) << "reports travel along";
  EXPECT_FALSE(out->GetFieldData()->GetArray("ImageVolumes")) << "they were those of the whole";
  EXPECT_EQ(boxes->GetNumberOfCells(), before) << "the input is never changed";
}

TEST(VesselCut, OpenMaterials)
{
  vtkNew<vtkVesselCut> filter;
  EXPECT_EQ(filter->GetNumberOfOpenMaterials(), 1);
  EXPECT_EQ(filter->GetOpenMaterial(0), 2);
  EXPECT_EQ(filter->GetOpenMaterial(1), -1);
  filter->SetInputData(Boxes());
  filter->SetOrigin(6.5, 6.5, 7.2);
  filter->ClearOpenMaterials();
  filter->AddOpenMaterial(1);
  filter->AddOpenMaterial(2);
  ExpectFine(filter);
  auto* names =
    vtkStringArray::SafeDownCast(filter->GetOutput()->GetFieldData()->GetAbstractArray("PatchNames"));
  ASSERT_EQ(names->GetNumberOfValues(), 3);
  EXPECT_EQ(names->GetValue(1), "opening_1");
  EXPECT_EQ(names->GetValue(2), "opening_2");
}

TEST(VesselCut, WarnsWhereMostIsCutOff)
{
  vtkNew<vtkVesselCut> filter;
  filter->SetInputData(Boxes());
  filter->SetOrigin(6.5, 6.5, 4.2);
  Watch watch(filter);
  filter->Update();
  EXPECT_FALSE(watch.GetError());
  EXPECT_TRUE(watch.GetWarning());
  EXPECT_NE(watch.Warning().find("turn Normal over"), std::string::npos) << watch.Warning();
}

TEST(VesselCut, PlanesThatMissAndWrongInputs)
{
  vtkNew<vtkVesselCut> filter;
  vtkNew<vtkPolyData> nothing;
  filter->SetInputData(nothing);
  ExpectFine(filter);
  filter->SetInputData(Boxes());
  filter->SetOrigin(6.5, 6.5, 70);
  ExpectError(filter, "misses the surface");
  filter->SetOrigin(60, 6.5, 7.2);
  ExpectError(filter, "misses the vessel");
  filter->SetOrigin(6.5, 6.5, 7.2);
  filter->SetNormal(0, 0, 0);
  ExpectError(filter, "normal that is not zero");
  filter->SetNormal(0, 0, 1);
  filter->SetName("a b");
  ExpectError(filter, "letters, digits");
  filter->SetName("");
  auto open = PlainTetrahedron();
  open->GetPolys()->Initialize();
  const vtkIdType face[3] = { 0, 1, 2 };
  open->GetPolys()->InsertNextCell(3, face);
  filter->SetInputData(open);
  ExpectError(filter, "no BoundaryLabels");
}

TEST(VesselCut, APlainSurfaceEndsInABorder)
{
  vtkNew<vtkVesselCut> filter;
  filter->SetInputData(PlainTetrahedron());
  filter->SetOrigin(0.1, 0.1, 0.4);
  ExpectFine(filter);
  auto* names =
    vtkStringArray::SafeDownCast(filter->GetOutput()->GetFieldData()->GetAbstractArray("PatchNames"));
  ASSERT_TRUE(names);
  EXPECT_EQ(names->GetValue(1), "border_1");
}
