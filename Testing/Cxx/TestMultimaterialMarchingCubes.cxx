// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include "vtkMultimaterialMarchingCubes.h"

#include <vtkDataSetAttributes.h>
#include <vtkFloatArray.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

namespace
{

vtkSmartPointer<vtkMultimaterialMarchingCubes> Filter(vtkImageData* image)
{
  auto filter = vtkSmartPointer<vtkMultimaterialMarchingCubes>::New();
  filter->SetInputData(image);
  return filter;
}

} // namespace

TEST(MultimaterialMarchingCubes, ArraysOfTheContract)
{
  auto filter = Filter(NestedBoxes());
  ExpectFine(filter);
  vtkPolyData* surface = filter->GetOutput();
  ASSERT_GT(surface->GetNumberOfPolys(), 0);
  EXPECT_EQ(surface->GetNumberOfCells(), surface->GetNumberOfPolys());
  EXPECT_EQ(surface->GetPoints()->GetDataType(), VTK_DOUBLE);
  auto* labels = vtkIntArray::SafeDownCast(surface->GetCellData()->GetArray("BoundaryLabels"));
  ASSERT_TRUE(labels);
  EXPECT_EQ(labels->GetNumberOfComponents(), 2);
  EXPECT_EQ(labels->GetNumberOfTuples(), surface->GetNumberOfCells());
  for (const char* name : { "JunctionOrder", "JunctionKind" })
  {
    EXPECT_TRUE(vtkUnsignedCharArray::SafeDownCast(surface->GetPointData()->GetArray(name))) << name;
  }
  EXPECT_NE(ReportOf(surface, "MultimaterialMarchingCubes").find("\"materials\": [1, 2]"), std::string::npos);
}

TEST(MultimaterialMarchingCubes, OriginSpacingDirectionAndExtentAreHonoured)
{
  auto image = NestedBoxes();
  auto plain = Filter(image);
  ExpectFine(plain);
  auto placed = vtkSmartPointer<vtkImageData>::New();
  placed->DeepCopy(image);
  placed->SetExtent(3, 16, -2, 11, 5, 18);
  placed->SetOrigin(10, 20, 30);
  placed->SetSpacing(0.5, 1, 2);
  placed->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1);
  auto moved = Filter(placed);
  ExpectFine(moved);
  ASSERT_EQ(moved->GetOutput()->GetNumberOfPoints(), plain->GetOutput()->GetNumberOfPoints());
  for (vtkIdType i = 0; i < plain->GetOutput()->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    plain->GetOutput()->GetPoint(i, p);
    moved->GetOutput()->GetPoint(i, q);
    EXPECT_NEAR(q[0], 10 - (p[1] - 2), 1e-12);
    EXPECT_NEAR(q[1], 20 + 0.5 * (p[0] + 3), 1e-12);
    EXPECT_NEAR(q[2], 30 + 2 * (p[2] + 5), 1e-12);
  }
}

TEST(MultimaterialMarchingCubes, OtherNumberTypesGiveTheSameSurface)
{
  auto image = NestedBoxes();
  auto expected = Filter(image);
  ExpectFine(expected);
  vtkNew<vtkFloatArray> floats;
  floats->DeepCopy(image->GetPointData()->GetScalars());
  floats->SetName("any name");
  vtkNew<vtkImageData> other;
  other->CopyStructure(image);
  other->GetPointData()->AddArray(floats);
  auto filter = Filter(other);
  ExpectFine(filter);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), expected->GetOutput()->GetNumberOfCells());
}

TEST(MultimaterialMarchingCubes, PropertiesAndOpenings)
{
  auto image = NestedBoxes();
  for (int k = 0; k < 5; ++k)
  {
    for (int j = 5; j < 9; ++j)
    {
      for (int i = 5; i < 9; ++i)
      {
        *static_cast<int*>(image->GetScalarPointer(i, j, k)) = 2;
      }
    }
  }
  auto filter = Filter(image);
  EXPECT_EQ(filter->GetNumberOfOpenMaterials(), 1);
  EXPECT_EQ(filter->GetOpenMaterial(0), 2);
  EXPECT_EQ(filter->GetOpenMaterial(1), -1);
  filter->OpenAtImageBorderOn();
  ExpectFine(filter);
  EXPECT_NE(ReportOf(filter->GetOutput(), "MultimaterialMarchingCubes").find("\"openings\": 1"),
            std::string::npos);
  auto* names = filter->GetOutput()->GetFieldData()->GetAbstractArray("PatchNames");
  EXPECT_TRUE(vtkStringArray::SafeDownCast(names));
  EXPECT_TRUE(filter->GetOutput()->GetCellData()->GetArray("PatchIds"));
  filter->ClearOpenMaterials();
  filter->AddOpenMaterial(7);
  ExpectError(filter, "OpenMaterials names material 7, which the input lacks: its materials are 1 and 2");
  filter->OpenAtImageBorderOff();
  ExpectFine(filter);
}

TEST(MultimaterialMarchingCubes, MaskOfAnotherSizeAndMissingMask)
{
  auto filter = Filter(NestedBoxes());
  filter->OpenAtMaskBorderOn();
  ExpectError(filter, "needs a region of interest");
  filter->SetInputData(1, NestedBoxes(16));
  ExpectError(filter, "the mask has 16 x 16 x 16 voxels, the image 14 x 14 x 14");
  vtkNew<vtkImageData> mask;
  mask->DeepCopy(NestedBoxes());
  mask->GetPointData()->GetScalars()->Fill(1);
  filter->SetInputData(1, mask);
  ExpectFine(filter);
}

TEST(MultimaterialMarchingCubes, AGreyImagePlacesTheCuts)
{
  auto labels = NestedBoxes();
  vtkNew<vtkImageData> grey;
  grey->CopyStructure(labels);
  grey->AllocateScalars(VTK_SHORT, 1);
  grey->GetPointData()->GetScalars()->SetName("anything");
  for (vtkIdType v = 0; v < labels->GetNumberOfPoints(); ++v)
  {
    // Background 0, tissue 300, blood 400.
    const int material = static_cast<int>(labels->GetPointData()->GetScalars()->GetComponent(v, 0));
    grey->GetPointData()->GetScalars()->SetComponent(v, 0, material == 2 ? 400 : 300 * material);
  }
  // At high i tissue's outer voxels are partly empty, at low i those beyond it partly full: of the values
  // that part all faces, 140 to 200, 170 is the middle. The surface moves in there and out here.
  for (int k = 2; k < 12; ++k)
  {
    for (int j = 2; j < 12; ++j)
    {
      *static_cast<short*>(grey->GetScalarPointer(11, j, k)) = 200;
      *static_cast<short*>(grey->GetScalarPointer(1, j, k)) = 140;
    }
  }
  auto plain = Filter(labels);
  auto filter = Filter(labels);
  filter->SetInputData(2, grey);
  ExpectFine(plain);
  ExpectFine(filter);
  // In the middle of the two sides, away from the rims.
  const auto reach = [](vtkPolyData* surface, int side)
  {
    double farthest = 0;
    for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
    {
      double x[3];
      surface->GetPoint(p, x);
      const bool isInner = std::abs(x[1] - 6.5) < 2.6 && std::abs(x[2] - 6.5) < 2.6;
      farthest = isInner ? std::max(farthest, side * (x[0] - 6.5)) : farthest;
    }
    return farthest;
  };
  EXPECT_NEAR(reach(plain->GetOutput(), 1), 5, 1e-12);
  EXPECT_NEAR(reach(filter->GetOutput(), 1), 4.65, 1e-9);
  EXPECT_NEAR(reach(filter->GetOutput(), -1), 5.3125, 1e-9);
  auto* volumes = filter->GetOutput()->GetFieldData()->GetArray("ImageVolumes");
  auto* voxels = plain->GetOutput()->GetFieldData()->GetArray("ImageVolumes");
  ASSERT_TRUE(volumes && voxels);
  EXPECT_LT(volumes->GetComponent(0, 1), voxels->GetComponent(0, 1) - 10);
  EXPECT_NE(ReportOf(filter->GetOutput(), "MultimaterialMarchingCubes").find("\"movedPoints\""),
            std::string::npos);

  vtkNew<vtkImageData> other;
  other->DeepCopy(NestedBoxes(16));
  filter->SetInputData(2, other);
  ExpectError(filter, "the grey image has 16 x 16 x 16 voxels, the image 14 x 14 x 14");
}

TEST(MultimaterialMarchingCubes, WrongImages)
{
  auto image = NestedBoxes();
  image->GetPointData()->GetScalars()->SetComponent(100, 0, -3);
  ExpectError(Filter(image), "material ids are whole numbers from 0 to 65535");

  vtkNew<vtkImageData> flat;
  flat->SetDimensions(4, 4, 1);
  flat->AllocateScalars(VTK_INT, 1);
  ExpectError(Filter(flat), "4 x 4 x 1 voxels: a 3-D image is needed");

  vtkNew<vtkImageData> colours;
  colours->SetDimensions(4, 4, 4);
  colours->AllocateScalars(VTK_INT, 3);
  ExpectError(Filter(colours), "has 3 components");

  vtkNew<vtkImageData> bare;
  bare->SetDimensions(4, 4, 4);
  ExpectError(Filter(bare), "run Multimaterial Segmentation first");

  auto twice = NestedBoxes();
  twice->GetPointData()->GetScalars()->SetName("a");
  vtkNew<vtkFloatArray> second;
  second->DeepCopy(twice->GetPointData()->GetScalars());
  second->SetName("b");
  twice->GetPointData()->AddArray(second);
  ExpectError(Filter(twice), "several arrays (a, b)");

  vtkNew<vtkFloatArray> nan;
  nan->DeepCopy(twice->GetPointData()->GetScalars());
  nan->SetName("MaterialIds");
  nan->SetValue(5, std::nanf(""));
  twice->GetPointData()->AddArray(nan);
  ExpectError(Filter(twice), "has the value nan");

  auto still = NestedBoxes();
  still->SetSpacing(1, 0, 1);
  ExpectError(Filter(still), "must be positive");
}

TEST(MultimaterialMarchingCubes, EmptyInputGivesEmptyOutput)
{
  vtkNew<vtkImageData> nothing;
  auto filter = Filter(nothing);
  ExpectFine(filter);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(MultimaterialMarchingCubes, InputIsNotChanged)
{
  auto image = NestedBoxes();
  vtkNew<vtkImageData> before;
  before->DeepCopy(image);
  const auto time = image->GetMTime();
  auto filter = Filter(image);
  ExpectFine(filter);
  EXPECT_EQ(image->GetMTime(), time);
  EXPECT_EQ(image->GetPointData()->GetNumberOfArrays(), before->GetPointData()->GetNumberOfArrays());
}
