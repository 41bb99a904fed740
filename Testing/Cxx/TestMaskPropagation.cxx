// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include "SliceReslicing.h"
#include "vtkMaskPropagation.h"
#include "vtkMultimaterialSegmentation.h"

#include <vtkFloatArray.h>
#include <vtkTable.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedShortArray.h>

#include <cmath>
#include <random>
#include <thread>

namespace
{

constexpr int Edge = 30;

/// Whether pixel (i, j) of slice k belongs to a disc that moves from slice to slice.
bool InDisc(int i, int j, int k)
{
  return std::hypot(i - 10 - 0.35 * k, j - 15) < 6;
}

/// Grey values of 120 in the disc and 40 outside, with a bit of texture.
vtkSmartPointer<vtkImageData> Grey()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Edge, Edge, Edge);
  image->AllocateScalars(VTK_FLOAT, 1);
  image->GetPointData()->GetScalars()->SetName("anything");
  for (vtkIdType v = 0; v < image->GetNumberOfPoints(); ++v)
  {
    const int i = static_cast<int>(v) % Edge;
    const int j = static_cast<int>(v) / Edge % Edge;
    const int k = static_cast<int>(v) / (Edge * Edge);
    const double value = (InDisc(i, j, k) ? 120 : 40) + 5 * std::sin(1.7 * i + 2.3 * j + 0.9 * k);
    image->GetPointData()->GetScalars()->SetComponent(v, 0, value);
  }
  return image;
}

/// The disc on every `step`-th slice, with the value given.
vtkSmartPointer<vtkImageData> Mask(int step = 6, int type = VTK_UNSIGNED_CHAR, double value = 1)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Edge, Edge, Edge);
  image->AllocateScalars(type, 1);
  image->GetPointData()->GetScalars()->Fill(0);
  for (vtkIdType v = 0; v < image->GetNumberOfPoints(); ++v)
  {
    const int k = static_cast<int>(v) / (Edge * Edge);
    if (k % step == 0 && InDisc(static_cast<int>(v) % Edge, static_cast<int>(v) / Edge % Edge, k))
    {
      image->GetPointData()->GetScalars()->SetComponent(v, 0, value);
    }
  }
  return image;
}

vtkSmartPointer<vtkMaskPropagation> Filter(vtkImageData* grey, vtkImageData* mask)
{
  auto filter = vtkSmartPointer<vtkMaskPropagation>::New();
  filter->SetInputData(0, grey);
  filter->SetInputData(1, mask);
  return filter;
}

vtkImageData* Output(vtkMaskPropagation* filter)
{
  return vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
}

vtkUnsignedShortArray* Values(vtkMaskPropagation* filter)
{
  return vtkUnsignedShortArray::SafeDownCast(Output(filter)->GetPointData()->GetArray("Mask"));
}

/// Voxels that are not 0 on slice k, counted from the first.
int Count(vtkMaskPropagation* filter, int k)
{
  int count = 0;
  for (vtkIdType v = k * Edge * Edge; v < (k + 1) * Edge * Edge; ++v)
  {
    count += Values(filter)->GetValue(v) != 0 ? 1 : 0;
  }
  return count;
}

double Dice(vtkMaskPropagation* filter, int value = 1)
{
  double common = 0;
  double both = 0;
  for (vtkIdType v = 0; v < Values(filter)->GetNumberOfTuples(); ++v)
  {
    const bool truth = InDisc(static_cast<int>(v) % Edge, static_cast<int>(v) / Edge % Edge,
                              static_cast<int>(v) / (Edge * Edge));
    const bool found = Values(filter)->GetValue(v) == value;
    common += truth && found ? 1 : 0;
    both += (truth ? 1 : 0) + (found ? 1 : 0);
  }
  return 2 * common / both;
}

} // namespace

TEST(MaskPropagation, ArraysOfTheContract)
{
  auto grey = Grey();
  auto mask = Mask();
  auto filter = Filter(grey, mask);
  ExpectFine(filter);
  auto* values = Values(filter);
  ASSERT_TRUE(values);
  EXPECT_EQ(Output(filter)->GetPointData()->GetScalars(), values);
  EXPECT_TRUE(Output(filter)->GetPointData()->GetArray("anything"));
  EXPECT_GT(Dice(filter), 0.97);
  for (vtkIdType v = 0; v < values->GetNumberOfTuples(); ++v)
  {
    if (v / (Edge * Edge) % 6 == 0)
    {
      ASSERT_EQ(values->GetValue(v), mask->GetPointData()->GetScalars()->GetComponent(v, 0));
    }
  }
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  EXPECT_EQ(table->GetNumberOfRows(), 25);
  for (const char* column : { "Slice", "From", "To", "Voxels", "Residual" })
  {
    EXPECT_TRUE(table->GetColumnByName(column)) << column;
  }
  EXPECT_EQ(table->GetValueByName(0, "Slice").ToInt(), 1);
  EXPECT_EQ(table->GetValueByName(0, "To").ToInt(), 6);
  const std::string report = ReportOf(Output(filter), "MaskPropagation");
  EXPECT_NE(report.find("\"drawnSlices\": [0, 6, 12, 18, 24]"), std::string::npos) << report;
  EXPECT_EQ(grey->GetPointData()->GetNumberOfArrays(), 1);
  EXPECT_EQ(mask->GetPointData()->GetNumberOfArrays(), 1);
}

TEST(MaskPropagation, MasksOfAnyNumberType)
{
  auto filter = Filter(Grey(), Mask(6, VTK_DOUBLE, 255));
  ExpectFine(filter);
  EXPECT_GT(Dice(filter, 255), 0.97);
  auto withGaps = Mask(6, VTK_FLOAT, 1);
  for (vtkIdType v = 0; v < withGaps->GetNumberOfPoints(); ++v)
  {
    auto* values = vtkFloatArray::SafeDownCast(withGaps->GetPointData()->GetScalars());
    values->SetValue(v, values->GetValue(v) == 0 ? std::nanf("") : 1);
  }
  filter->SetInputData(1, withGaps);
  ExpectFine(filter);
  EXPECT_GT(Dice(filter), 0.97);
}

TEST(MaskPropagation, PropertiesMatter)
{
  auto filter = Filter(Grey(), Mask());
  filter->SetMethod(vtkMaskPropagation::METHOD_SHAPE);
  ExpectFine(filter);
  EXPECT_NE(ReportOf(Output(filter), "MaskPropagation").find("\"method\": \"shape interpolation\""),
            std::string::npos);
  const double shape = Dice(filter);
  filter->SetMethod(vtkMaskPropagation::METHOD_REGISTRATION);
  ExpectFine(filter);
  const double registration = Dice(filter);
  EXPECT_GT(registration, shape);
  filter->SetSearchRange(0.001);
  ExpectFine(filter);
  EXPECT_NEAR(Dice(filter), shape, 0.005) << "nothing may move";
  filter->SetSearchRange(16);
  filter->SetLevels(1);
  filter->SetSmoothness(15);
  ExpectFine(filter);
  EXPECT_NE(Dice(filter), registration);

  auto ends = Filter(Grey(), Mask(8)); // 0, 8, 16, 24
  ends->SetMaximumSlices(2);
  ExpectFine(ends);
  EXPECT_GT(Count(ends, 26), 0);
  EXPECT_EQ(Count(ends, 27), 0);
  ends->AddDrawnSlice(8);
  ends->AddDrawnSlice(16);
  EXPECT_EQ(ends->GetNumberOfDrawnSlices(), 2);
  EXPECT_EQ(ends->GetDrawnSlice(1), 16);
  ExpectFine(ends);
  EXPECT_GT(Count(ends, 6), 0);
  EXPECT_EQ(Count(ends, 0), 0) << "not listed";
  ends->ClearDrawnSlices();
  ends->SetMaskValue(1);
  ends->SetSliceAxis(vtkMaskPropagation::AXIS_K);
  ExpectFine(ends);
  EXPECT_GT(Count(ends, 0), 0);
  ends->SetMaskValue(3);
  ExpectError(ends, "the mask is 3 nowhere");
}

TEST(MaskPropagation, SlicesAreNumberedByTheExtent)
{
  auto grey = Grey();
  auto mask = Mask();
  grey->SetExtent(5, 34, -3, 26, 100, 129);
  grey->SetOrigin(-5, 3, -100); // the first voxel lies where the mask's does
  auto filter = Filter(grey, mask);
  ExpectFine(filter);
  EXPECT_NE(ReportOf(Output(filter), "MaskPropagation").find("\"drawnSlices\": [100, 106, 112, 118, 124]"),
            std::string::npos);
  EXPECT_EQ(Output(filter)->GetExtent()[4], 100);
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  EXPECT_EQ(table->GetValueByName(0, "Slice").ToInt(), 101);
  EXPECT_GT(Dice(filter), 0.97);
  filter->AddDrawnSlice(6);
  ExpectError(filter, "drawn slice 6 is outside the image: across axis k its slices are 100 to 129");
}

TEST(MaskPropagation, TheMaskFitsTheSegmentation)
{
  auto filter = Filter(Grey(), Mask());
  vtkNew<vtkMultimaterialSegmentation> segmentation;
  segmentation->SetInputData(Grey());
  segmentation->SetInputConnection(1, filter->GetOutputPort());
  segmentation->ClearThresholds();
  segmentation->AddThreshold(80);
  ExpectFine(segmentation);
  auto* ids = vtkImageData::SafeDownCast(segmentation->GetOutputDataObject(0))->GetPointData()->GetScalars();
  EXPECT_EQ(ids->GetComponent(15 * Edge * Edge + 15 * Edge + 15, 0), 1);
}

TEST(MaskPropagation, WrongInputs)
{
  auto small = Mask();
  small->SetDimensions(Edge, Edge, Edge - 1);
  small->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  ExpectError(Filter(Grey(), small), "the mask has 30 x 30 x 29 voxels, the image 30 x 30 x 30");

  auto elsewhere = Mask();
  elsewhere->SetOrigin(0, 0, 1);
  ExpectError(Filter(Grey(), elsewhere), "the mask does not stand where the image does");
  auto coarse = Mask();
  coarse->SetSpacing(1, 1, 2);
  ExpectError(Filter(Grey(), coarse), "the mask does not stand where the image does");

  auto empty = Mask();
  empty->GetPointData()->GetScalars()->Fill(0);
  ExpectError(Filter(Grey(), empty), "no slice is drawn");
  ExpectError(Filter(Grey(), Grey()), "is this the grey image?");
  ExpectError(Filter(Grey(), Mask(6, VTK_SHORT, -1)), "the mask has the value -1");

  vtkNew<vtkImageData> flat;
  flat->SetDimensions(4, 4, 1);
  flat->AllocateScalars(VTK_INT, 1);
  ExpectError(Filter(flat, flat), "a 3-D image is needed");
  ExpectError(Filter(Grey(), flat), "mask: the image has 4 x 4 x 1 voxels");

  vtkNew<vtkImageData> colours;
  colours->SetDimensions(Edge, Edge, Edge);
  colours->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  ExpectError(Filter(colours, Mask()), "3 components");
  ExpectError(Filter(Grey(), colours), "values of 3 components");

  vtkNew<vtkImageData> bare;
  bare->SetDimensions(Edge, Edge, Edge);
  ExpectError(Filter(Grey(), bare), "mask: the image has no array");
}

TEST(MaskPropagation, WrongProperties)
{
  const auto expect = [](auto&& set, const char* part)
  {
    auto filter = Filter(Grey(), Mask());
    set(filter.Get());
    ExpectError(filter, part);
  };
  expect([](vtkMaskPropagation* f) { f->SetSliceAxis(7); }, "slice axis 7");
  expect([](vtkMaskPropagation* f) { f->SetMethod(4); }, "method 4");
  expect([](vtkMaskPropagation* f) { f->SetMaskValue(70000); }, "mask value 70000");
  expect([](vtkMaskPropagation* f) { f->SetMaximumSlices(-3); }, "maximum slices -3");
  expect([](vtkMaskPropagation* f) { f->SetLevels(9); }, "levels 9");
  expect([](vtkMaskPropagation* f) { f->SetSmoothness(0); }, "smoothness");
  expect([](vtkMaskPropagation* f) { f->SetSearchRange(-1); }, "search range");
}

TEST(MaskPropagation, AConstantImageIsWarnedOf)
{
  auto grey = Grey();
  grey->GetPointData()->GetScalars()->Fill(3);
  auto filter = Filter(grey, Mask());
  Watch watch(filter);
  filter->Update();
  EXPECT_FALSE(watch.GetError()) << watch.Error();
  EXPECT_NE(watch.Warning().find("constant"), std::string::npos);
  EXPECT_GT(Dice(filter), 0.85);
}

TEST(MaskPropagation, EmptyInputGivesEmptyOutput)
{
  vtkNew<vtkImageData> nothing;
  auto filter = Filter(nothing, Mask());
  ExpectFine(filter);
  EXPECT_EQ(Output(filter)->GetNumberOfPoints(), 0);
}

TEST(SliceReslicing, PullsAsTheKernelDoes)
{
  constexpr int width = 31;
  constexpr int height = 17;
  std::mt19937 random(3);
  const auto noise = [&](double range)
  {
    lamina::SliceImage image(width, height);
    std::uniform_real_distribution<double> values(-range, range);
    for (float& value : image.values)
    {
      value = static_cast<float>(values(random));
    }
    return image;
  };
  const lamina::SliceImage a = noise(100);
  const lamina::SliceImage b = noise(1);
  const lamina::SliceField field{ noise(40), noise(40) }; // a good part of it leads outside
  const auto expected = lamina::SliceWarper().Pull({ &a, &b }, field);
  std::vector<std::vector<lamina::SliceImage>> pulled(4);
  std::vector<std::thread> threads;
  for (auto& images : pulled)
  {
    threads.emplace_back([&]() { images = lamina::SliceReslicing().Pull({ &a, &b }, field); });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const auto& images : pulled)
  {
    ASSERT_EQ(images.size(), 2u);
    for (std::size_t p = 0; p < a.values.size(); ++p)
    {
      ASSERT_NEAR(images[0].values[p], expected[0].values[p], 0.01) << p;
      ASSERT_NEAR(images[1].values[p], expected[1].values[p], 1e-4) << p;
    }
  }
}
