// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include "vtkFluidSolidMesh.h"

namespace
{

vtkSmartPointer<vtkUnstructuredGrid> OneTet(int material, double apex)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(0, 1, 0);
  points->InsertNextPoint(0, 0, apex);
  grid->SetPoints(points);
  const vtkIdType up[4] = { 0, 1, 2, 3 };
  const vtkIdType down[4] = { 0, 2, 1, 3 };
  grid->InsertNextCell(VTK_TETRA, 4, apex > 0 ? up : down);
  if (material > 0)
  {
    vtkNew<vtkIntArray> ids;
    ids->SetName("MaterialIds");
    ids->InsertNextValue(material);
    grid->GetCellData()->AddArray(ids);
  }
  return grid;
}

} // namespace

TEST(FluidSolidMesh, JoinsAnyNumberOfParts)
{
  vtkNew<vtkFluidSolidMesh> filter;
  filter->AddInputData(OneTet(1, 1));
  filter->AddInputData(OneTet(2, -1));
  filter->AddInputData(vtkNew<vtkUnstructuredGrid>());
  filter->SetScale(0.5);
  ExpectFine(filter);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 5);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 2);
  EXPECT_EQ(filter->GetOutput()->GetBounds()[1], 0.5);
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("MaterialIds")->GetComponent(1, 0), 2);
}

TEST(FluidSolidMesh, WrongInput)
{
  vtkNew<vtkFluidSolidMesh> filter;
  filter->AddInputData(OneTet(1, 1));
  filter->SetScale(0);
  ExpectError(filter, "Scale must be above 0");
  filter->SetScale(1);
  filter->AddInputData(OneTet(0, 1));
  ExpectError(filter, "part 2: no MaterialIds on the cells: run Layered Tetrahedra");
}
