// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include "vtkFluidSolidMesh.h"

#include <vtkDataAssembly.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkTable.h>

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

TEST(FluidSolidMesh, NamesPatchesMaterialsAndParts)
{
  vtkNew<vtkFluidSolidMesh> filter;
  filter->AddInputData(OneTet(1, 1));
  filter->AddInputData(OneTet(2, -1));
  filter->SetNames("1=tissue; 2 = blood;wall_tissue_1=epicardium");
  filter->SetUnit("mm");
  filter->SetNamedParts(true);
  ExpectFine(filter);
  vtkFieldData* field = filter->GetOutput()->GetFieldData();
  auto* names = vtkStringArray::SafeDownCast(field->GetAbstractArray("PatchNames"));
  ASSERT_TRUE(names);
  ASSERT_EQ(names->GetNumberOfValues(), 3);
  EXPECT_EQ(names->GetValue(0), "interface_tissue_blood_1");
  EXPECT_EQ(names->GetValue(1), "epicardium");
  EXPECT_EQ(names->GetValue(2), "wall_blood_1");
  EXPECT_EQ(field->GetArray("PatchFaces")->GetNumberOfTuples(), 7);
  EXPECT_EQ(field->GetArray("PatchFaces")->GetNumberOfComponents(), 5);
  EXPECT_EQ(vtkStringArray::SafeDownCast(field->GetAbstractArray("LengthUnit"))->GetValue(0), "mm");
  EXPECT_EQ(field->GetArray("LengthScale")->GetComponent(0, 0), 1);
  auto* boundary = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
  EXPECT_EQ(boundary->GetNumberOfCells(), 7);
  EXPECT_EQ(boundary->GetCellData()->GetArray("PatchIds")->GetNumberOfTuples(), 7);
  EXPECT_EQ(boundary->GetCellData()->GetArray("BoundaryLabels")->GetComponent(0, 1), 2);
  EXPECT_TRUE(boundary->GetPointData()->GetArray("GlobalNodeIds"));
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(2));
  EXPECT_EQ(table->GetNumberOfRows(), 3);
  EXPECT_EQ(table->GetValueByName(1, "Kind").ToString(), "wall");
  auto* parts = vtkPartitionedDataSetCollection::SafeDownCast(filter->GetOutputDataObject(3));
  ASSERT_EQ(parts->GetNumberOfPartitionedDataSets(), 5u);
  vtkDataAssembly* assembly = parts->GetDataAssembly();
  ASSERT_TRUE(assembly);
  for (const char* path : { "/FluidSolidMesh/Materials/tissue", "/FluidSolidMesh/Materials/blood",
                            "/FluidSolidMesh/Interfaces/interface_tissue_blood_1",
                            "/FluidSolidMesh/Walls/epicardium", "/FluidSolidMesh/Walls/wall_blood_1" })
  {
    const int node = assembly->GetFirstNodeByPath(path);
    ASSERT_GE(node, 0) << path;
    const auto indices = assembly->GetDataSetIndices(node);
    ASSERT_EQ(indices.size(), 1u);
    EXPECT_GT(parts->GetPartition(indices[0], 0)->GetNumberOfCells(), 0);
  }
}

TEST(FluidSolidMesh, DoubledNodesKnowTheirTwins)
{
  vtkNew<vtkFluidSolidMesh> filter;
  filter->AddInputData(OneTet(1, 1));
  filter->AddInputData(OneTet(2, -1));
  filter->SetInterfaceNodes(vtkFluidSolidMesh::DOUBLED);
  ExpectFine(filter);
  vtkUnstructuredGrid* mesh = filter->GetOutput();
  ASSERT_EQ(mesh->GetNumberOfPoints(), 8);
  vtkDataArray* twins = mesh->GetPointData()->GetArray("TwinNodeIds");
  ASSERT_TRUE(twins);
  int pairs = 0;
  for (vtkIdType p = 0; p < 8; ++p)
  {
    const auto twin = static_cast<vtkIdType>(twins->GetComponent(p, 0));
    pairs += twin > p;
    if (twin >= 0)
    {
      double a[3];
      double b[3];
      mesh->GetPoint(p, a);
      mesh->GetPoint(twin, b);
      EXPECT_TRUE(a[0] == b[0] && a[1] == b[1] && a[2] == b[2]);
    }
    EXPECT_EQ(mesh->GetPointData()->GetArray("GlobalNodeIds")->GetComponent(p, 0), p);
  }
  EXPECT_EQ(pairs, 3);
  filter->ClearFluidMaterials();
  filter->AddFluidMaterial(9);
  ExpectFine(filter);
  EXPECT_EQ(mesh->GetNumberOfPoints(), 5);
}

TEST(FluidSolidMesh, NamesThatAreNotUnderstood)
{
  vtkNew<vtkFluidSolidMesh> filter;
  filter->AddInputData(OneTet(1, 1));
  filter->SetNames("1tissue");
  ExpectError(filter, "'1tissue' is not understood");
  filter->SetNames("1=a;1=b");
  ExpectError(filter, "named twice");
  filter->SetNames("1=a;2=a");
  ExpectError(filter, "given twice");
  filter->SetNames("7=bone");
  Watch watch(filter);
  filter->Update();
  EXPECT_NE(watch.Warning().find("neither a material nor a patch 7"), std::string::npos);
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
