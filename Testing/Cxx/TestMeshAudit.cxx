// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include "vtkMeshAudit.h"
#include "vtkMultimaterialMarchingCubes.h"

#include <vtkTable.h>
#include <vtkUnsignedCharArray.h>

TEST(MeshAudit, SoundSurfacePasses)
{
  vtkNew<vtkMultimaterialMarchingCubes> extraction;
  extraction->SetInputData(NestedBoxes());
  vtkNew<vtkMeshAudit> audit;
  audit->SetInputConnection(extraction->GetOutputPort());
  ExpectFine(audit);
  EXPECT_TRUE(audit->GetPassed()) << audit->GetReportAsJSON();
  auto* surface = vtkPolyData::SafeDownCast(audit->GetOutputDataObject(0));
  ASSERT_TRUE(surface);
  EXPECT_TRUE(vtkUnsignedCharArray::SafeDownCast(surface->GetCellData()->GetArray("MeshingFlags")));
  auto* table = vtkTable::SafeDownCast(audit->GetOutputDataObject(1));
  ASSERT_TRUE(table);
  EXPECT_EQ(table->GetNumberOfColumns(), 4);
  EXPECT_EQ(table->GetValueByName(0, "Name").ToString(), "passed");
  EXPECT_EQ(ReportOf(surface, "MeshAudit"), audit->GetReportAsJSON());
}

TEST(MeshAudit, FindsWhatIsWrongWithASurface)
{
  auto surface = PlainTetrahedron();
  vtkNew<vtkIntArray> labels;
  labels->SetName("BoundaryLabels");
  labels->SetNumberOfComponents(2);
  for (int t = 0; t < 3; ++t)
  {
    labels->InsertNextTuple2(1, 0);
  }
  const vtkIdType faces[3][3] = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 } };
  surface->GetPolys()->Initialize();
  for (const auto& face : faces)
  {
    surface->GetPolys()->InsertNextCell(3, face);
  }
  surface->GetCellData()->AddArray(labels);
  vtkNew<vtkMeshAudit> audit;
  audit->SetInputData(surface);
  ExpectFine(audit);
  EXPECT_FALSE(audit->GetPassed());
  EXPECT_NE(std::string(audit->GetReportAsJSON()).find("3 edges where"), std::string::npos)
    << audit->GetReportAsJSON();
}

TEST(MeshAudit, RefusesOtherCells)
{
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(PlainTetrahedron()->GetPoints());
  const vtkIdType ids[3] = { 0, 1, 2 };
  grid->InsertNextCell(VTK_TRIANGLE, 3, ids);
  vtkNew<vtkMeshAudit> audit;
  audit->SetInputData(grid);
  Watch watch(audit);
  audit->Update();
  EXPECT_NE(watch.Error().find("only tetrahedra, wedges and pyramids are allowed"), std::string::npos);
}

TEST(MeshAudit, EmptyInput)
{
  vtkNew<vtkUnstructuredGrid> nothing;
  vtkNew<vtkMeshAudit> audit;
  audit->SetInputData(nothing);
  ExpectFine(audit);
  EXPECT_FALSE(audit->GetPassed());
}
