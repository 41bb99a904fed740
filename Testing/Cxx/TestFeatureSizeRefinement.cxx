// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include "vtkFeatureSizeRefinement.h"
#include "vtkMath.h"

TEST(FeatureSizeRefinement, NeedsTargets)
{
  vtkNew<vtkFeatureSizeRefinement> filter;
  filter->SetInputData(PlainTetrahedron());
  ExpectError(filter, "no TargetEdgeLength on the points: run Feature Size first");
  auto zero = PlainTetrahedron();
  AddUniform(zero, "TargetEdgeLength", 0);
  filter->SetInputData(zero);
  ExpectError(filter, "TargetEdgeLength of point 0 is not a positive number");
}

TEST(FeatureSizeRefinement, EmptyInputGivesEmptyOutput)
{
  vtkNew<vtkFeatureSizeRefinement> filter;
  vtkNew<vtkPolyData> nothing;
  filter->SetInputData(nothing);
  ExpectFine(filter);
}

TEST(FeatureSizeRefinement, UniformTargetsStandIn)
{
  auto surface = PlainTetrahedron();
  AddUniform(surface, "TargetEdgeLength", 0.3);
  vtkNew<vtkFeatureSizeRefinement> filter;
  filter->SetInputData(surface);
  ExpectFine(filter);
  vtkPolyData* out = filter->GetOutput();
  EXPECT_GT(out->GetNumberOfPoints(), 20);
  EXPECT_TRUE(out->GetCellData()->GetArray("BoundaryLabels"));
  EXPECT_EQ(out->GetPointData()->GetArray("TargetEdgeLength")->GetNumberOfTuples(), out->GetNumberOfPoints());
  EXPECT_NE(ReportOf(out, "SurfaceRefinement").find("edgesInRange"), std::string::npos);
}

TEST(FeatureSizeRefinement, PropertiesOutOfRange)
{
  auto surface = PlainTetrahedron();
  AddUniform(surface, "TargetEdgeLength", 0.5);
  vtkNew<vtkFeatureSizeRefinement> filter;
  filter->SetInputData(surface);
  EXPECT_EQ(filter->GetIterations(), 6);
  filter->SetIterations(0);
  ExpectError(filter, "terations");
  filter->SetIterations(2);
  filter->SetSplitRatio(0.9);
  ExpectError(filter, "plit");
  filter->SetSplitRatio(1.5);
  filter->SetMergeRatio(1.2);
  ExpectError(filter, "erge");
  filter->SetMergeRatio(0.6);
  filter->SetTolerance(-1);
  ExpectError(filter, "olerance");
  filter->SetTolerance(0.1);
  for (const double bad : { 0.5, 4.5 })
  {
    filter->SetTangentialAnisotropy(bad);
    ExpectError(filter, "anisotropy");
  }
  filter->SetTangentialAnisotropy(2);
  ExpectError(filter, "run Feature Size first");
  filter->SetTangentialAnisotropy(1);
  ExpectFine(filter);
}

TEST(FeatureSizeRefinement, OneLengthOrAnyArray)
{
  auto surface = PlainTetrahedron();
  vtkNew<vtkFeatureSizeRefinement> filter;
  filter->SetInputData(surface);
  filter->SetEdgeLength(0.3);
  ExpectFine(filter);
  const vtkIdType count = filter->GetOutput()->GetNumberOfPoints();
  EXPECT_GT(count, 20);
  AddUniform(surface, "Painted", 0.3);
  surface->Modified();
  filter->SetEdgeLength(0);
  filter->SetTargetArray("Painted");
  ExpectFine(filter);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), count);
  filter->SetTargetArray("Absent");
  ExpectError(filter, "no Absent on the points");
  filter->SetEdgeLength(-1);
  ExpectError(filter, "EdgeLength must be positive");
  surface->GetPointData()->GetArray("Painted")->SetComponent(2, 0, vtkMath::Nan());
  surface->Modified();
  filter->SetEdgeLength(0);
  filter->SetTargetArray("Painted");
  ExpectError(filter, "Painted of point 2 is not a positive number");
}

TEST(FeatureSizeRefinement, FlagsNodesThatNoDirectionSees)
{
  auto surface = PlainTetrahedron();
  for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
  {
    double x[3];
    surface->GetPoint(p, x);
    surface->GetPoints()->SetPoint(p, x[0], x[1], 0.15 * x[2]); // edges of 12 degrees around its base
  }
  vtkNew<vtkFeatureSizeRefinement> filter;
  filter->SetInputData(surface);
  filter->SetEdgeLength(0.3);
  filter->SetTolerance(0.01);
  ExpectFine(filter);
  vtkDataArray* flags = filter->GetOutput()->GetPointData()->GetArray("MeshingFlags");
  ASSERT_TRUE(flags);
  EXPECT_EQ(flags->GetNumberOfTuples(), filter->GetOutput()->GetNumberOfPoints());
  int flagged = 0;
  for (vtkIdType p = 0; p < flags->GetNumberOfTuples(); ++p)
  {
    flagged += flags->GetComponent(p, 0) == 16 ? 1 : 0;
  }
  EXPECT_NE(
    ReportOf(filter->GetOutput(), "SurfaceRefinement").find("\"hiddenNodes\": " + std::to_string(flagged)),
    std::string::npos)
    << ReportOf(filter->GetOutput(), "SurfaceRefinement");
  EXPECT_GT(flagged, 0);
  EXPECT_NE(ReportOf(filter->GetOutput(), "SurfaceRefinement").find("\"forbiddenNodes\": "),
            std::string::npos);
}
