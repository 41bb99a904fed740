// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include "vtkFeatureSize.h"
#include "vtkMultimaterialMarchingCubes.h"

#include <vtkSphereSource.h>

#include <cmath>

TEST(FeatureSize, ArraysOfTheContract)
{
  vtkNew<vtkMultimaterialMarchingCubes> extraction;
  extraction->SetInputData(NestedBoxes());
  vtkNew<vtkFeatureSize> filter;
  filter->SetInputConnection(extraction->GetOutputPort());
  ExpectFine(filter);
  vtkPolyData* out = filter->GetOutput();
  ASSERT_EQ(out->GetNumberOfPoints(), extraction->GetOutput()->GetNumberOfPoints());
  auto* size = vtkDoubleArray::SafeDownCast(out->GetPointData()->GetArray("FeatureSize"));
  auto* target = vtkDoubleArray::SafeDownCast(out->GetPointData()->GetArray("TargetEdgeLength"));
  auto* each = vtkDoubleArray::SafeDownCast(out->GetPointData()->GetArray("MaterialFeatureSize"));
  ASSERT_TRUE(size && target && each);
  ASSERT_GE(each->GetNumberOfComponents(), 2);
  EXPECT_STREQ(each->GetComponentName(each->GetNumberOfComponents() - 1), "2");
  for (vtkIdType i = 0; i < out->GetNumberOfPoints(); ++i)
  {
    EXPECT_GT(size->GetValue(i), 0);
    EXPECT_GT(target->GetValue(i), 0);
  }
  EXPECT_NE(ReportOf(out, "FeatureSize").find("leastSize"), std::string::npos);
}

TEST(FeatureSize, ClosedSurfaceWithoutLabelsIsTakenWhicheverWayItIsTurned)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(24);
  sphere->Update();
  vtkNew<vtkFeatureSize> filter;
  filter->SetInputData(sphere->GetOutput());
  ExpectFine(filter);
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("BoundaryLabels")->GetComponent(0, 0), 1);
  vtkNew<vtkPolyData> turned;
  turned->DeepCopy(sphere->GetOutput());
  for (vtkIdType t = 0; t < turned->GetNumberOfCells(); ++t)
  {
    turned->ReverseCell(t);
  }
  vtkNew<vtkFeatureSize> again;
  again->SetInputData(turned);
  ExpectFine(again);
  for (vtkIdType i = 0; i < turned->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(again->GetOutput()->GetPointData()->GetArray("FeatureSize")->GetComponent(i, 0),
                filter->GetOutput()->GetPointData()->GetArray("FeatureSize")->GetComponent(i, 0), 1e-9);
  }
}

TEST(FeatureSize, PropertiesOutOfRange)
{
  vtkNew<vtkFeatureSize> filter;
  filter->SetInputData(PlainTetrahedron());
  ExpectFine(filter);
  EXPECT_EQ(filter->GetLayers(), 6);
  filter->SetLayers(0);
  ExpectError(filter, "ayers");
  filter->SetLayers(3);
  filter->SetGradient(0);
  ExpectError(filter, "radient");
  filter->SetGradient(0.5);
  filter->SetAnisotropy(-1);
  ExpectError(filter, "nisotropy");
  filter->SetAnisotropy(1);
  filter->SetMinimumSize(2);
  filter->SetMaximumSize(1);
  ExpectError(filter, "least feature size");
  filter->SetMaximumSize(3);
  filter->SetConeAngle(95);
  ExpectError(filter, "ngle");
  filter->SetConeAngle(10);
  ExpectFine(filter);
}
