// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include "vtkMultimaterialSegmentation.h"

#include <vtkFloatArray.h>
#include <vtkTable.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace
{

/// Grey values 20, 85 and 190 where NestedBoxes has 0, 1 and 2.
vtkSmartPointer<vtkImageData> Grey(int edge = 14)
{
  auto image = NestedBoxes(edge);
  image->GetPointData()->GetScalars()->SetName("anything");
  auto* values = vtkIntArray::SafeDownCast(image->GetPointData()->GetScalars());
  const int greys[3] = { 20, 85, 190 };
  for (vtkIdType v = 0; v < values->GetNumberOfTuples(); ++v)
  {
    values->SetValue(v, greys[values->GetValue(v)]);
  }
  return image;
}

vtkSmartPointer<vtkMultimaterialSegmentation> Filter(vtkImageData* image)
{
  auto filter = vtkSmartPointer<vtkMultimaterialSegmentation>::New();
  filter->SetInputData(image);
  return filter;
}

vtkImageData* Output(vtkMultimaterialSegmentation* filter)
{
  return vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
}

vtkIdType Count(vtkMultimaterialSegmentation* filter, int material)
{
  auto* ids = vtkIntArray::SafeDownCast(Output(filter)->GetPointData()->GetArray("MaterialIds"));
  return std::count(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfTuples(), material);
}

} // namespace

TEST(MultimaterialSegmentation, ArraysOfTheContract)
{
  auto image = Grey();
  auto filter = Filter(image);
  ExpectFine(filter);
  auto truth = NestedBoxes();
  auto* expected = truth->GetPointData()->GetScalars();
  auto* points = Output(filter)->GetPointData();
  auto* ids = vtkIntArray::SafeDownCast(points->GetScalars());
  ASSERT_TRUE(ids);
  EXPECT_STREQ(ids->GetName(), "MaterialIds");
  for (vtkIdType v = 0; v < ids->GetNumberOfTuples(); ++v)
  {
    ASSERT_EQ(ids->GetValue(v), expected->GetComponent(v, 0));
  }
  EXPECT_TRUE(vtkUnsignedCharArray::SafeDownCast(points->GetArray("Disputed")));
  EXPECT_TRUE(points->GetArray("anything"));
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  ASSERT_GT(table->GetNumberOfRows(), 5);
  for (const char* column : { "Rule", "Material", "Components", "Voxels" })
  {
    EXPECT_TRUE(table->GetColumnByName(column)) << column;
  }
  EXPECT_EQ(image->GetPointData()->GetNumberOfArrays(), 1);
}

TEST(MultimaterialSegmentation, PropertiesMatter)
{
  auto image = Grey();
  const auto set = [&](int i, int j, int k, int value)
  { *static_cast<int*>(image->GetScalarPointer(i, j, k)) = value; };
  for (int k = 0; k < 5; ++k)
  {
    set(7, 7, k, 190);
  }
  auto filter = Filter(image);
  ExpectFine(filter);
  EXPECT_EQ(*static_cast<int*>(Output(filter)->GetScalarPointer(7, 7, 0)), 1);
  filter->OpenAtImageBorderOn();
  ExpectFine(filter);
  EXPECT_EQ(*static_cast<int*>(Output(filter)->GetScalarPointer(7, 7, 0)), 2);
  filter->OpenAtImageBorderOff();
  filter->ClearThresholds();
  filter->AddThreshold(50);
  EXPECT_EQ(filter->GetNumberOfThresholds(), 1);
  EXPECT_EQ(filter->GetThreshold(0), 50);
  ExpectFine(filter);
  EXPECT_EQ(Count(filter, 2), 0);
  filter->ClearThresholds();
  filter->AddThreshold(50);
  filter->AddThreshold(150);
  filter->SetMinimumVoxels(100);
  ExpectFine(filter);
  EXPECT_EQ(Count(filter, 2), 0) << "64 voxels of blood and a thread to the border are too few";
}

TEST(MultimaterialSegmentation, TheMaskIsOneInside)
{
  auto filter = Filter(Grey());
  auto mask = NestedBoxes();
  mask->GetPointData()->GetScalars()->Fill(2);
  filter->SetInputData(1, mask);
  ExpectError(filter, "the mask is 1 nowhere");
  mask->GetPointData()->GetScalars()->Fill(1);
  for (int k = 7; k < 14; ++k)
  {
    for (int v = 0; v < 14 * 14; ++v)
    {
      *static_cast<int*>(mask->GetScalarPointer(v % 14, v / 14, k)) = 2;
    }
  }
  mask->Modified();
  filter->SetMinimumVoxels(5);
  ExpectFine(filter);
  EXPECT_EQ(*static_cast<int*>(Output(filter)->GetScalarPointer(7, 7, 7)), 0);
  EXPECT_EQ(*static_cast<int*>(Output(filter)->GetScalarPointer(7, 7, 6)), 1);
  filter->OpenAtMaskBorderOn();
  ExpectFine(filter);
  EXPECT_EQ(*static_cast<int*>(Output(filter)->GetScalarPointer(7, 7, 6)), 2);
  filter->SetInputData(1, NestedBoxes(16));
  ExpectError(filter, "the mask has 16 x 16 x 16 voxels");
}

TEST(MultimaterialSegmentation, NotANumberIsBackground)
{
  auto image = Grey();
  vtkNew<vtkFloatArray> floats;
  floats->DeepCopy(image->GetPointData()->GetScalars());
  floats->SetValue(0, std::nanf(""));
  image->GetPointData()->Initialize();
  image->GetPointData()->SetScalars(floats);
  auto filter = Filter(image);
  ExpectFine(filter);
  EXPECT_EQ(*static_cast<int*>(Output(filter)->GetScalarPointer(0, 0, 0)), 0);
}

TEST(MultimaterialSegmentation, WrongInputs)
{
  auto filter = Filter(Grey());
  filter->AddThreshold(100);
  ExpectError(filter, "out of order: 150 is not below 100");
  filter->ClearThresholds();
  ExpectError(filter, "no thresholds");
  filter->AddThreshold(-3);
  ExpectError(filter, "-3 is outside the image's range 20 to 190");

  auto constant = Grey();
  constant->GetPointData()->GetScalars()->Fill(7);
  ExpectError(Filter(constant), "constant: every voxel is 7");

  vtkNew<vtkImageData> flat;
  flat->SetDimensions(4, 4, 1);
  flat->AllocateScalars(VTK_INT, 1);
  ExpectError(Filter(flat), "a 3-D image is needed");

  vtkNew<vtkImageData> colours;
  colours->SetDimensions(4, 4, 4);
  colours->AllocateScalars(VTK_INT, 3);
  ExpectError(Filter(colours), "3 components");

  auto share = Filter(Grey());
  share->SetMinimumShare(2);
  ExpectError(share, "a share of 0 to 1");
  auto majority = Filter(Grey());
  majority->SetCoronaryMajority(0);
  ExpectError(majority, "coronary majority");
}

TEST(MultimaterialSegmentation, EmptyInputGivesEmptyOutput)
{
  vtkNew<vtkImageData> nothing;
  auto filter = Filter(nothing);
  ExpectFine(filter);
  EXPECT_EQ(Output(filter)->GetNumberOfPoints(), 0);
}
