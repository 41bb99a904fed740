// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include "vtkMeshAudit.h"
#include "vtkMultimaterialMarchingCubes.h"
#include "vtkVolumeConservingSmoothing.h"

#include <vtkTable.h>

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
  filter->SetLargestDrift(0.75);
  EXPECT_EQ(filter->GetLargestDisplacement(), 1.5);
  filter->SetLargestDisplacement(0);
  ExpectError(filter, "displacement");
  filter->SetLargestDisplacement(1.5);
  EXPECT_EQ(filter->GetSettled(), 0.002);
  filter->SetSettled(-1);
  ExpectError(filter, "settled");
}

TEST(VolumeConservingSmoothing, BringsTheImagesVolumesAndItsCertificate)
{
  // Two blocks that touch over an edge alone: the repair of the labels has to bridge or part them.
  vtkNew<vtkImageData> image;
  image->SetDimensions(20, 20, 10);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  image->GetPointData()->GetScalars()->SetName("MaterialIds");
  double voxels = 0;
  for (int k = 0; k < 10; ++k)
  {
    for (int j = 0; j < 20; ++j)
    {
      for (int i = 0; i < 20; ++i)
      {
        const bool inside = k > 1 && k < 8 && i > 1 && j > 1 && i < 18 && j < 18 && (i < 10) == (j < 10);
        image->SetScalarComponentFromDouble(i, j, k, 0, inside ? 1 : 0);
        voxels += inside ? 1 : 0;
      }
    }
  }
  vtkNew<vtkMultimaterialMarchingCubes> extraction;
  extraction->SetInputData(image);
  vtkNew<vtkVolumeConservingSmoothing> filter;
  filter->SetInputConnection(extraction->GetOutputPort());
  ExpectFine(filter);
  vtkPolyData* in = extraction->GetOutput();
  ASSERT_TRUE(in->GetCellData()->GetArray("MissingVolume"));
  EXPECT_EQ(in->GetCellData()->GetArray("MissingVolume")->GetNumberOfComponents(), 2);
  vtkDataArray* volumes = in->GetFieldData()->GetArray("ImageVolumes");
  ASSERT_TRUE(volumes);
  EXPECT_EQ(volumes->GetComponent(0, 0), 1);
  EXPECT_EQ(volumes->GetComponent(0, 1), voxels);
  vtkPolyData* out = filter->GetOutput();
  EXPECT_FALSE(out->GetCellData()->GetArray("MissingVolume")) << "given back";
  ASSERT_TRUE(out->GetFieldData()->GetArray("LeastClearance"));
  EXPECT_EQ(out->GetFieldData()->GetArray("IntersectingPairs")->GetComponent(0, 0), 0);
  EXPECT_GE(out->GetFieldData()->GetArray("LeastClearance")->GetComponent(0, 0), 0.249);
  EXPECT_GE(out->GetFieldData()->GetArray("LeastAngle")->GetComponent(0, 0), 10);

  vtkNew<vtkMeshAudit> audit;
  audit->SetInputData(out);
  ExpectFine(audit);
  auto* table = vtkTable::SafeDownCast(audit->GetOutputDataObject(1));
  double against = 1;
  double clearance = 0;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const std::string name = table->GetValueByName(row, "Name").ToString();
    against = name == "againstImage" ? table->GetValueByName(row, "Value").ToDouble() : against;
    clearance = name == "leastClearance" ? table->GetValueByName(row, "Value").ToDouble() : clearance;
  }
  EXPECT_NEAR(against, 0, 1e-11);
  EXPECT_EQ(clearance, out->GetFieldData()->GetArray("LeastClearance")->GetComponent(0, 0));
}

TEST(VolumeConservingSmoothing, OpenSurfacesIfAccepted)
{
  auto open = PlainTetrahedron();
  vtkNew<vtkIntArray> labels;
  labels->SetName("BoundaryLabels");
  labels->SetNumberOfComponents(2);
  const vtkIdType faces[3][3] = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 } };
  open->GetPolys()->Initialize();
  for (const auto& face : faces)
  {
    open->GetPolys()->InsertNextCell(3, face);
    labels->InsertNextTuple2(1, 0);
  }
  open->GetCellData()->AddArray(labels);
  vtkNew<vtkVolumeConservingSmoothing> filter;
  filter->SetInputData(open);
  EXPECT_FALSE(filter->GetAcceptFaults());
  ExpectError(filter, "is open");
  filter->AcceptFaultsOn();
  ExpectFine(filter);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 3);
  EXPECT_NE(ReportOf(filter->GetOutput(), "VolumeConservingSmoothing").find("\"faultyEdges\": 3"),
            std::string::npos);
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
