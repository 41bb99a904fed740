// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include "vtkMultimaterialMarchingCubes.h"
#include "vtkVolumeConservingSmoothing.h"

#include <limits>

TEST(VolumeConservingSmoothing, MovesPointsAndKeepsTrianglesAndArrays)
{
  vtkNew<vtkMultimaterialMarchingCubes> extraction;
  extraction->SetInputData(NestedBoxes());
  vtkNew<vtkVolumeConservingSmoothing> filter;
  filter->SetInputConnection(extraction->GetOutputPort());
  ExpectFine(filter);
  vtkPolyData* in = extraction->GetOutput();
  vtkPolyData* out = filter->GetOutput();
  ASSERT_EQ(out->GetNumberOfPoints(), in->GetNumberOfPoints());
  ASSERT_EQ(out->GetNumberOfCells(), in->GetNumberOfCells());
  EXPECT_TRUE(out->GetCellData()->GetArray("BoundaryLabels"));
  EXPECT_TRUE(out->GetPointData()->GetArray("JunctionKind"));
  double moved = 0;
  for (vtkIdType i = 0; i < in->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    in->GetPoint(i, p);
    out->GetPoint(i, q);
    moved = std::max(moved, std::abs(p[0] - q[0]));
  }
  EXPECT_GT(moved, 0.01);
  EXPECT_NE(ReportOf(out, "VolumeConservingSmoothing").find("volumesAfter"), std::string::npos);
  EXPECT_FALSE(ReportOf(out, "MultimaterialMarchingCubes").empty()) << "reports travel along";
}

TEST(VolumeConservingSmoothing, DropsSizesThatNoLongerFitAndKeepsOthers)
{
  auto surface = PlainTetrahedron();
  AddUniform(surface, "TargetEdgeLength", 1);
  AddUniform(surface, "Mine", 3);
  vtkNew<vtkVolumeConservingSmoothing> filter;
  filter->SetInputData(surface);
  filter->SetSweeps(1);
  ExpectFine(filter);
  EXPECT_FALSE(filter->GetOutput()->GetPointData()->GetArray("TargetEdgeLength"));
  EXPECT_TRUE(filter->GetOutput()->GetPointData()->GetArray("Mine"));
  EXPECT_TRUE(surface->GetPointData()->GetArray("TargetEdgeLength")) << "the input is never changed";
}

TEST(VolumeConservingSmoothing, PropertiesOutOfRange)
{
  vtkNew<vtkVolumeConservingSmoothing> filter;
  filter->SetInputData(PlainTetrahedron());
  EXPECT_EQ(filter->GetSweeps(), 20);
  EXPECT_EQ(filter->GetRelaxation(), 1);
  EXPECT_EQ(filter->GetLargestDrift(), 0.75);
  filter->SetSweeps(-1);
  ExpectError(filter, "weeps");
  filter->SetSweeps(0);
  ExpectFine(filter);
  filter->SetRelaxation(0);
  ExpectError(filter, "elaxation");
  filter->SetRelaxation(0.5);
  filter->SetLargestDrift(-1);
  ExpectError(filter, "rift");
}

TEST(VolumeConservingSmoothing, WrongSurfaces)
{
  vtkNew<vtkVolumeConservingSmoothing> filter;
  vtkNew<vtkPolyData> nothing;
  filter->SetInputData(nothing);
  ExpectFine(filter);

  auto open = PlainTetrahedron();
  open->GetPolys()->Initialize();
  const vtkIdType face[3] = { 0, 1, 2 };
  open->GetPolys()->InsertNextCell(3, face);
  filter->SetInputData(open);
  ExpectError(filter, "no BoundaryLabels on the triangles: run Multimaterial Marching Cubes first");

  auto nan = PlainTetrahedron();
  nan->GetPoints()->SetPoint(2, std::numeric_limits<double>::quiet_NaN(), 0, 0);
  filter->SetInputData(nan);
  ExpectError(filter, "point 2 has a coordinate that is not a finite number");

  auto quads = PlainTetrahedron();
  const vtkIdType quad[4] = { 0, 1, 2, 3 };
  quads->GetPolys()->InsertNextCell(4, quad);
  filter->SetInputData(quads);
  ExpectError(filter, "cell 4 has 4 points: only triangles are allowed");

  auto lines = PlainTetrahedron();
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(2, quad);
  lines->SetLines(line);
  filter->SetInputData(lines);
  ExpectError(filter, "vertices, lines or strips");

  auto labels = PlainTetrahedron();
  vtkNew<vtkIntArray> wrong;
  wrong->SetName("BoundaryLabels");
  wrong->SetNumberOfTuples(4);
  wrong->Fill(1);
  labels->GetCellData()->AddArray(wrong);
  filter->SetInputData(labels);
  ExpectError(filter, "BoundaryLabels on the triangles has 4 tuples of 1 components");
}
