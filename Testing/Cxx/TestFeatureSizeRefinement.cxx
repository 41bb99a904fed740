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
