// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include "vtkFeatureSize.h"
#include "vtkMultimaterialMarchingCubes.h"

#include <vtkFloatArray.h>
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
  EXPECT_NE(ReportOf(out, "FeatureSize").find("strongestCurvature"), std::string::npos);
}

TEST(FeatureSize, CurvaturesOfABall)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(2);
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(60);
  vtkNew<vtkFeatureSize> filter;
  filter->SetInputConnection(sphere->GetOutputPort());
  ExpectFine(filter);
  vtkPointData* data = filter->GetOutput()->GetPointData();
  auto* maximum = vtkDoubleArray::SafeDownCast(data->GetArray("MaximumCurvature"));
  auto* minimum = vtkDoubleArray::SafeDownCast(data->GetArray("MinimumCurvature"));
  auto* direction = vtkDoubleArray::SafeDownCast(data->GetArray("MaximumCurvatureDirection"));
  ASSERT_TRUE(maximum && minimum && direction);
  ASSERT_EQ(direction->GetNumberOfComponents(), 3);
  for (vtkIdType i = 0; i < maximum->GetNumberOfTuples(); ++i)
  {
    EXPECT_NEAR(maximum->GetValue(i), 0.5, 0.02);
    EXPECT_NEAR(minimum->GetValue(i), 0.5, 0.02);
    double d[3];
    direction->GetTuple(i, d);
    EXPECT_NEAR(d[0] * d[0] + d[1] * d[1] + d[2] * d[2], 1, 1e-9);
  }
}

TEST(FeatureSize, CurvatureAndSizesOfMaterialsAreProperties)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  vtkNew<vtkFeatureSize> filter;
  filter->SetInputConnection(sphere->GetOutputPort());
  filter->SetMinimumSize(0.01);
  filter->SetMaximumSize(10);
  filter->SetLayers(2);
  filter->SetNodesPerCircumference(0);
  const auto edge = [&]()
  {
    ExpectFine(filter);
    return filter->GetOutput()->GetPointData()->GetArray("TargetEdgeLength")->GetComponent(100, 0);
  };
  EXPECT_NEAR(edge(), 1, 0.02); // diameter times Anisotropy over Layers
  filter->SetNodesPerCircumference(20);
  EXPECT_NEAR(edge(), 3.14159265 / 20.5, 0.004);
  filter->SetNodesPerCircumference(0);
  filter->AddMaterialSizing(1, 4, 1, 0, 0);
  EXPECT_NEAR(edge(), 0.25, 0.005);
  double sizing[5];
  filter->GetMaterialSizing(0, sizing);
  EXPECT_EQ(filter->GetNumberOfMaterialSizings(), 1);
  EXPECT_EQ(sizing[1], 4);
  filter->ClearMaterialSizings();
  filter->AddMaterialSizing(1, 0, 0, 3, 0); // edges of 3 but for the layers of 1 / 2
  filter->SetEdgePerLayer(2);
  EXPECT_NEAR(edge(), 1, 0.02);
  filter->SetEdgePerLayer(8);
  EXPECT_NEAR(edge(), 3, 1e-9);
}

TEST(FeatureSize, ArraysFromElsewhere)
{
  // Sizes that stand there already, of another type, are read and replaced; those of a wrong shape are named.
  vtkSmartPointer<vtkPolyData> surface = PlainTetrahedron();
  vtkNew<vtkFloatArray> painted;
  painted->SetName("TargetEdgeLength");
  painted->SetNumberOfTuples(4);
  painted->Fill(0.5);
  surface->GetPointData()->AddArray(painted);
  AddUniform(surface, "FeatureSize", 2);
  vtkNew<vtkFeatureSize> filter;
  filter->SetInputData(surface);
  ExpectFine(filter);
  EXPECT_NE(filter->GetOutput()->GetPointData()->GetArray("FeatureSize")->GetComponent(0, 0), 2);
  EXPECT_EQ(surface->GetPointData()->GetArray("FeatureSize")->GetComponent(0, 0), 2);
  vtkNew<vtkDoubleArray> wrong;
  wrong->SetName("FeatureSize");
  wrong->SetNumberOfTuples(3);
  wrong->Fill(1);
  vtkSmartPointer<vtkPolyData> bad = PlainTetrahedron();
  bad->GetPointData()->AddArray(wrong);
  vtkNew<vtkFeatureSize> other;
  other->SetInputData(bad);
  ExpectError(other, "FeatureSize on the points has 3 tuples of 1 components, where 4 of 1 are needed");
}

TEST(FeatureSize, OpenAndTurnedSurfacesAreRefused)
{
  vtkSmartPointer<vtkPolyData> surface = PlainTetrahedron();
  vtkNew<vtkIntArray> labels;
  labels->SetName("BoundaryLabels");
  labels->SetNumberOfComponents(2);
  for (int t = 0; t < 4; ++t)
  {
    labels->InsertNextTuple2(1, 0);
  }
  surface->GetCellData()->AddArray(labels);
  vtkNew<vtkFeatureSize> filter;
  filter->SetInputData(surface);
  ExpectFine(filter);
  for (vtkIdType t = 0; t < 4; ++t)
  {
    surface->ReverseCell(t);
  }
  surface->Modified();
  ExpectError(filter, "material 1 is inside out");
  vtkSmartPointer<vtkPolyData> open = PlainTetrahedron();
  open->GetPolys()->Initialize();
  const vtkIdType faces[3][3] = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 } };
  for (const auto& face : faces)
  {
    open->GetPolys()->InsertNextCell(3, face);
  }
  labels->SetNumberOfTuples(3);
  open->GetCellData()->AddArray(labels);
  vtkNew<vtkFeatureSize> other;
  other->SetInputData(open);
  ExpectError(other, "is open or turns its normals over (3 edges in all, the first from point 1 to 2");
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
  EXPECT_EQ(filter->GetNodesPerCircumference(), 12);
  filter->SetNodesPerCircumference(1);
  ExpectError(filter, "odesPerCircumference");
  filter->SetNodesPerCircumference(12);
  filter->SetEdgePerLayer(0);
  ExpectError(filter, "dgePerLayer");
  filter->SetEdgePerLayer(8);
  filter->AddMaterialSizing(7, 2, 0, 0, 0);
  ExpectError(filter, "material 7, which the surface lacks");
  filter->ClearMaterialSizings();
  filter->AddMaterialSizing(1, 2.5, 0, 0, 0);
  ExpectError(filter, "a whole number is needed");
  filter->ClearMaterialSizings();
  EXPECT_EQ(filter->GetNumberOfMaterialSizings(), 0);
  ExpectFine(filter);
}
