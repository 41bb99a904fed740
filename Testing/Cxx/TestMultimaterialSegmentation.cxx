// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include "vtkMultimaterialSegmentation.h"

#include <vtkFloatArray.h>
#include <vtkMatrix3x3.h>
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
  for (const char* column : { "Rule", "Material", "Components", "Voxels", "Tunnels", "Cavities" })
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

TEST(MultimaterialSegmentation, TheMaskLiesWhereTheImageDoes)
{
  auto filter = Filter(Grey());
  auto mask = NestedBoxes();
  mask->GetPointData()->GetScalars()->Fill(1);
  mask->SetOrigin(0.4, 0, 0);
  filter->SetInputData(1, mask);
  ExpectFine(filter);
  mask->SetOrigin(0.6, 0, 0);
  ExpectError(filter,
              "the mask lies elsewhere in the world than the image: a corner voxel is at (0.6, 0, 0)");
  mask->SetOrigin(0, 0, 0);
  mask->SetSpacing(1, 1, 1.1);
  ExpectError(filter, "origin, spacing and direction");
  mask->SetSpacing(1, 1, 1);
  mask->SetDirectionMatrix(1, 0, 0, 0, 0, -1, 0, 1, 0);
  ExpectError(filter, "the mask lies elsewhere");
}

TEST(MultimaterialSegmentation, AnyNumberTypeGivesTheSame)
{
  auto first = Filter(Grey());
  ExpectFine(first);
  auto* expected = vtkIntArray::SafeDownCast(Output(first)->GetPointData()->GetScalars());
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
                          VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
                          VTK_UNSIGNED_LONG_LONG, VTK_FLOAT, VTK_DOUBLE, VTK_ID_TYPE })
  {
    auto image = Grey();
    auto values = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
    values->SetNumberOfTuples(image->GetNumberOfPoints());
    values->SetName("values");
    for (vtkIdType v = 0; v < image->GetNumberOfPoints(); ++v)
    {
      // Signed characters end at 127.
      values->SetComponent(v, 0, image->GetPointData()->GetScalars()->GetComponent(v, 0) / 2);
    }
    image->GetPointData()->Initialize();
    image->GetPointData()->SetScalars(values);
    auto filter = Filter(image);
    filter->ClearThresholds();
    for (const double threshold : { 25, 55, 75 })
    {
      filter->AddThreshold(threshold);
    }
    ExpectFine(filter);
    auto* ids = vtkIntArray::SafeDownCast(Output(filter)->GetPointData()->GetScalars());
    ASSERT_TRUE(ids) << type;
    EXPECT_TRUE(
      std::equal(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfTuples(), expected->GetPointer(0)))
      << type;
  }
}

TEST(MultimaterialSegmentation, TheGridStaysAndItsOrientationDoesNotMatter)
{
  auto image = Grey();
  image->SetOrigin(-5, 7, 100);
  image->SetSpacing(0.5, 0.5, 2);
  image->SetDirectionMatrix(0, 1, 0, 1, 0, 0, 0, 0, -1);
  auto filter = Filter(image);
  ExpectFine(filter);
  EXPECT_EQ(Output(filter)->GetSpacing()[2], 2);
  EXPECT_EQ(Output(filter)->GetOrigin()[2], 100);
  EXPECT_EQ(Output(filter)->GetDirectionMatrix()->GetElement(2, 2), -1);
  EXPECT_EQ(Count(filter, 2), 64);
}

TEST(MultimaterialSegmentation, ComponentsContactsAndRepair)
{
  auto image = Grey(24);
  const auto fill = [&](int from, int to, int value)
  {
    for (int k = from; k <= to; ++k)
    {
      for (int j = from; j <= to; ++j)
      {
        for (int i = from; i <= to; ++i)
        {
          *static_cast<int*>(image->GetScalarPointer(i, j, k)) = value;
        }
      }
    }
  };
  fill(5, 18, 85);
  fill(5, 9, 190);
  fill(10, 14, 190); // meets the other in a corner only
  fill(16, 18, 190);
  auto filter = Filter(image);
  filter->SetMinimumVoxels(0);
  filter->SetMinimumShare(0);
  filter->SetRepairTopology(vtkMultimaterialSegmentation::FLAG_ONLY);
  ExpectFine(filter);
  auto* flags = vtkUnsignedCharArray::SafeDownCast(Output(filter)->GetPointData()->GetArray("Disputed"));
  const vtkIdType corner = 9 + 24 * (9 + 24 * 9);
  EXPECT_EQ(flags->GetValue(corner), 2);
  EXPECT_EQ(flags->GetValue(0), 0);
  const vtkIdType before = Count(filter, 2);
  EXPECT_EQ(before, 125 + 125 + 27);
  filter->SetRepairTopology(vtkMultimaterialSegmentation::REPAIR);
  ExpectFine(filter);
  flags = vtkUnsignedCharArray::SafeDownCast(Output(filter)->GetPointData()->GetArray("Disputed"));
  EXPECT_NE(Count(filter, 2), before);
  EXPECT_GT(std::count(flags->GetPointer(0), flags->GetPointer(0) + flags->GetNumberOfTuples(), 4), 0);
  EXPECT_NE(ReportOf(Output(filter), "MultimaterialSegmentation").find("\"criticalCorners\": 1"),
            std::string::npos);
  filter->SetRepairTopology(vtkMultimaterialSegmentation::OFF);
  filter->SetKeptComponents(vtkMultimaterialSegmentation::LARGEST_COMPONENTS);
  filter->SetComponentCount(2);
  ExpectFine(filter);
  EXPECT_EQ(Count(filter, 2), 250);
  filter->SetKeptComponents(vtkMultimaterialSegmentation::LARGEST_COMPONENT);
  ExpectFine(filter);
  EXPECT_EQ(Count(filter, 2), 125);
  filter->SetKeptComponents(3);
  ExpectError(filter, "KeptComponents and RepairTopology are 0, 1 or 2, not 3");
  filter->SetKeptComponents(0);
  filter->SetDisputedVoxels(2);
  ExpectError(filter, "DisputedVoxels is 0 or 1");
  filter->SetDisputedVoxels(1);
  filter->SetSmoothingSweeps(21);
  ExpectError(filter, "smoothing sweeps is 21");
  filter->SetSmoothingSweeps(0);
  filter->SetComponentCount(0);
  ExpectError(filter, "must be at least 1");
  filter->SetComponentCount(1);
  filter->AddForbiddenContact(1, 1);
  ExpectError(filter, "two different materials");
}

TEST(MultimaterialSegmentation, ContactsMayBeAllowedAndSkinsDissolved)
{
  // Blood straight in background, but for a voxel of half values around it.
  auto image = Grey();
  for (vtkIdType v = 0; v < image->GetNumberOfPoints(); ++v)
  {
    auto* value = static_cast<int*>(image->GetScalarPointer()) + v;
    const int place[3] = { int(v % 14), int(v / 14 % 14), int(v / 196) };
    const int margin =
      std::min({ place[0], place[1], place[2], 13 - place[0], 13 - place[1], 13 - place[2] });
    *value = margin > 4 ? 190 : (margin == 4 ? 108 : 20);
  }
  auto filter = Filter(image);
  filter->ClearThresholds();
  filter->AddThreshold(50);
  filter->AddThreshold(150);
  filter->SetMinimumVoxels(0);
  EXPECT_EQ(filter->GetNumberOfForbiddenContacts(), 1);
  EXPECT_EQ(filter->GetForbiddenContact(0)[1], 2);
  ExpectFine(filter);
  EXPECT_EQ(Count(filter, 1), 216 - 64);
  filter->ClearForbiddenContacts();
  ExpectFine(filter);
  EXPECT_EQ(Count(filter, 1), 0);
  EXPECT_EQ(Count(filter, 2), 216);
  filter->DissolveSkinsOff();
  ExpectFine(filter);
  EXPECT_EQ(Count(filter, 1), 216 - 64);
}

TEST(MultimaterialSegmentation, AMaterialThatVanishesIsNamed)
{
  auto filter = Filter(Grey());
  filter->SetMinimumVoxels(65);
  Watch watch(filter);
  filter->Update();
  EXPECT_FALSE(watch.GetError()) << watch.Error();
  ASSERT_TRUE(watch.GetWarning());
  EXPECT_NE(watch.Warning().find("material 2 vanished: its last 64 voxels went by the rule"),
            std::string::npos)
    << watch.Warning();
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
  ExpectFine(filter); // by the histogram
  filter->AddThreshold(150);
  filter->AddThreshold(100);
  ExpectError(filter, "out of order: 150 is not below 100");
  filter->ClearThresholds();
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
