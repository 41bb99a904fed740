// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include "vtkFluidSolidMesh.h"
#include "vtkMeshAudit.h"
#include "vtkPrismsToTetrahedra.h"
#include "vtkQuadraticCells.h"

namespace
{

/// Two prisms of blood side by side on a square.
vtkSmartPointer<vtkUnstructuredGrid> TwoPrisms()
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k < 2; ++k)
  {
    points->InsertNextPoint(0, 0, k);
    points->InsertNextPoint(1, 0, k);
    points->InsertNextPoint(1, 1, k);
    points->InsertNextPoint(0, 1, k);
  }
  grid->SetPoints(points);
  const vtkIdType cells[2][6] = { { 0, 2, 1, 4, 6, 5 }, { 0, 3, 2, 4, 7, 6 } };
  vtkNew<vtkIntArray> materials;
  materials->SetName("MaterialIds");
  for (const auto& cell : cells)
  {
    grid->InsertNextCell(VTK_WEDGE, 6, cell);
    materials->InsertNextValue(2);
  }
  grid->GetCellData()->AddArray(materials);
  return grid;
}

} // namespace

TEST(PrismsToTetrahedra, AMeshWithoutPatchesHasNoneAfterwards)
{
  vtkNew<vtkPrismsToTetrahedra> filter;
  filter->SetInputData(TwoPrisms());
  ExpectFine(filter);
  EXPECT_FALSE(filter->GetOutput()->GetFieldData()->HasArray("PatchFaces"));
  vtkNew<vtkMeshAudit> audit;
  audit->SetInputData(filter->GetOutput());
  ExpectFine(audit);
  EXPECT_TRUE(audit->GetPassed()) << audit->GetReportAsJSON();
}

TEST(PrismsToTetrahedra, KeepsMaterialsAndPatches)
{
  vtkNew<vtkFluidSolidMesh> mesh;
  mesh->AddInputData(TwoPrisms());
  vtkNew<vtkPrismsToTetrahedra> filter;
  filter->SetInputConnection(mesh->GetOutputPort());
  ExpectFine(filter);
  vtkUnstructuredGrid* tets = filter->GetOutput();
  ASSERT_EQ(tets->GetNumberOfCells(), 6);
  for (vtkIdType c = 0; c < 6; ++c)
  {
    EXPECT_EQ(tets->GetCellType(c), VTK_TETRA);
    EXPECT_EQ(tets->GetCellData()->GetArray("MaterialIds")->GetComponent(c, 0), 2);
  }
  EXPECT_EQ(tets->GetFieldData()->GetArray("PatchFaces")->GetNumberOfTuples(), 4 + 8);
  EXPECT_NE(ReportOf(tets, "PrismsToTetrahedra").find("\"splitCells\": 2"), std::string::npos);
  vtkNew<vtkMeshAudit> audit;
  audit->SetInputData(tets);
  ExpectFine(audit);
  EXPECT_TRUE(audit->GetPassed()) << audit->GetReportAsJSON();
  EXPECT_EQ(mesh->GetOutput()->GetNumberOfCells(), 2); // the input is as it was
}

TEST(PrismsToTetrahedra, EmptyAndWrongInput)
{
  vtkNew<vtkPrismsToTetrahedra> filter;
  filter->SetInputData(vtkNew<vtkUnstructuredGrid>());
  ExpectFine(filter);
  auto flat = TwoPrisms();
  flat->GetPoints()->SetPoint(4, 0, 0, 0);
  flat->GetPoints()->SetPoint(5, 1, 0, 0);
  flat->GetPoints()->SetPoint(6, 1, 1, 0);
  filter->SetInputData(flat);
  ExpectError(filter, "no positive cut");
}

TEST(QuadraticCells, EveryEdgeGetsANode)
{
  vtkNew<vtkFluidSolidMesh> mesh;
  mesh->AddInputData(TwoPrisms());
  vtkNew<vtkQuadraticCells> filter;
  filter->SetInputConnection(mesh->GetOutputPort());
  ExpectFine(filter);
  vtkUnstructuredGrid* cells = filter->GetOutput();
  EXPECT_EQ(cells->GetNumberOfPoints(), 8 + 14);
  EXPECT_EQ(cells->GetCellType(0), VTK_QUADRATIC_WEDGE);
  EXPECT_TRUE(cells->GetFieldData()->GetArray("PatchFaces"));
  EXPECT_EQ(cells->GetCellData()->GetArray("MaterialIds")->GetNumberOfTuples(), 2);
  EXPECT_EQ(cells->GetPointData()->GetArray("GlobalNodeIds")->GetNumberOfTuples(), 22);
  filter->SetLargestOffset(0.6);
  ExpectError(filter, "largestOffset");
  filter->SetLargestOffset(0.2);
  filter->SetSurfaceScale(0);
  ExpectError(filter, "surfaceScale");
}
