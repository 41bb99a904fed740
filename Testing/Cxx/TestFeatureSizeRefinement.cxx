// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include "vtkFeatureSizeRefinement.h"

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
  ExpectFine(filter);
}
