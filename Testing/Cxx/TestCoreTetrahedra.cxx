// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include "vtkCoreTetrahedra.h"
#include "vtkMultimaterialMarchingCubes.h"

#include <vtkCell.h>
#include <vtkMath.h>

namespace
{

double Volume(vtkUnstructuredGrid* grid)
{
  double sum = 0;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    double p[4][3];
    for (int i = 0; i < 4; ++i)
    {
      grid->GetPoint(grid->GetCell(c)->GetPointId(i), p[i]);
    }
    double e[3][3];
    for (int i = 0; i < 3; ++i)
    {
      vtkMath::Subtract(p[i + 1], p[0], e[i]);
    }
    sum += vtkMath::Determinant3x3(e[0], e[1], e[2]) / 6;
  }
  return sum;
}

} // namespace

TEST(CoreTetrahedra, PortsAndEmptyInput)
{
  vtkNew<vtkCoreTetrahedra> filter;
  EXPECT_EQ(filter->GetNumberOfOutputPorts(), 2);
  EXPECT_EQ(filter->GetRadiusEdgeRatio(), 1.4);
  EXPECT_EQ(filter->GetSizeFactor(), 1.3);
  EXPECT_EQ(filter->GetMaximumEdge(), 0);
  vtkNew<vtkPolyData> nothing;
  filter->SetInputData(nothing);
  ExpectFine(filter);
}

TEST(CoreTetrahedra, FillsEachMaterialAndAddsNoPointOnTheSurface)
{
  vtkNew<vtkMultimaterialMarchingCubes> extraction;
  extraction->SetInputData(NestedBoxes());
  vtkNew<vtkCoreTetrahedra> filter;
  filter->SetInputConnection(extraction->GetOutputPort());
  ExpectFine(filter);
  vtkUnstructuredGrid* tets = filter->GetOutput();
  ASSERT_GT(tets->GetNumberOfCells(), 0);
  double range[2];
  tets->GetCellData()->GetArray("MaterialIds")->GetRange(range);
  EXPECT_EQ(range[0], 1);
  EXPECT_EQ(range[1], 2);
  EXPECT_TRUE(tets->GetPointData()->GetArray("InterfaceNodeIds"));
  vtkPolyData* surface = extraction->GetOutput();
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    surface->GetPoint(i, p);
    tets->GetPoint(i, q);
    EXPECT_TRUE(p[0] == q[0] && p[1] == q[1] && p[2] == q[2]);
  }
  EXPECT_NEAR(Volume(tets), 1000, 1e-6);
  EXPECT_EQ(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1))->GetNumberOfCells(), 0);
  EXPECT_NE(ReportOf(tets, "CoreTetrahedra").find("aboveGate"), std::string::npos);
}

TEST(CoreTetrahedra, IntersectingSurfacesAreRefusedAndShown)
{
  auto one = PlainTetrahedron();
  auto two = PlainTetrahedron();
  for (vtkIdType i = 0; i < two->GetNumberOfPoints(); ++i)
  {
    double p[3];
    two->GetPoint(i, p);
    two->GetPoints()->SetPoint(i, p[0] + 0.2, p[1] + 0.1, p[2] - 0.3);
  }
  vtkNew<vtkPolyData> both;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  for (vtkPolyData* part : { one.Get(), two.Get() })
  {
    const vtkIdType first = points->GetNumberOfPoints();
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      points->InsertNextPoint(part->GetPoint(i));
    }
    polys->Append(part->GetPolys(), first);
  }
  both->SetPoints(points);
  both->SetPolys(polys);
  vtkNew<vtkCoreTetrahedra> filter;
  filter->SetInputData(both);
  Watch watch(filter);
  filter->Update();
  EXPECT_NE(watch.Error().find("intersect"), std::string::npos) << watch.Error();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_GT(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1))->GetNumberOfCells(), 0);
}

TEST(CoreTetrahedra, PropertiesOutOfRange)
{
  vtkNew<vtkCoreTetrahedra> filter;
  filter->SetInputData(PlainTetrahedron());
  ExpectFine(filter);
  filter->SetRadiusEdgeRatio(0.5);
  ExpectError(filter, "adius");
  filter->SetRadiusEdgeRatio(2);
  filter->SetSizeFactor(0);
  ExpectError(filter, "actor");
  filter->SetSizeFactor(2);
  filter->SetMaximumEdge(-1);
  ExpectError(filter, "Edge");
  filter->SetMaximumEdge(0.3);
  ExpectFine(filter);
}
