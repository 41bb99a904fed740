// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include "vtkHeartPhantomSource.h"

#include <vtkIdTypeArray.h>
#include <vtkUnsignedCharArray.h>

namespace
{

vtkSmartPointer<vtkHeartPhantomSource> Source(int resolution)
{
  auto source = vtkSmartPointer<vtkHeartPhantomSource>::New();
  source->SetResolution(resolution);
  return source;
}

vtkImageData* Image(vtkHeartPhantomSource* source, int port)
{
  return vtkImageData::SafeDownCast(source->GetOutputDataObject(port));
}

} // namespace

TEST(HeartPhantomSource, ArraysOfTheContract)
{
  auto source = Source(40);
  ExpectFine(source);
  vtkImageData* grey = Image(source, 0);
  vtkImageData* truth = Image(source, 1);
  ASSERT_TRUE(vtkUnsignedCharArray::SafeDownCast(grey->GetPointData()->GetScalars()));
  EXPECT_STREQ(grey->GetPointData()->GetScalars()->GetName(), "Intensity");
  ASSERT_TRUE(vtkIntArray::SafeDownCast(truth->GetPointData()->GetScalars()));
  EXPECT_STREQ(truth->GetPointData()->GetScalars()->GetName(), "MaterialIds");
  auto* parts = vtkUnsignedCharArray::SafeDownCast(truth->GetPointData()->GetArray("Parts"));
  ASSERT_TRUE(parts);
  auto* ids = vtkIntArray::SafeDownCast(truth->GetPointData()->GetScalars());
  for (vtkIdType v = 0; v < parts->GetNumberOfTuples(); ++v)
  {
    const int material = parts->GetValue(v) == 0 ? 0 : (parts->GetValue(v) < 4 ? 1 : 2);
    ASSERT_EQ(material, ids->GetValue(v));
  }
  auto* components = vtkIdTypeArray::SafeDownCast(truth->GetFieldData()->GetArray("MaterialComponents"));
  ASSERT_TRUE(components);
  ASSERT_EQ(components->GetNumberOfTuples(), 3);
  EXPECT_EQ(components->GetValue(1), 1);
  EXPECT_EQ(components->GetValue(2), 2);
  const int* size = grey->GetDimensions();
  EXPECT_EQ(std::max({ size[0], size[1], size[2] }), 40);
  EXPECT_DOUBLE_EQ(grey->GetSpacing()[0], 3);
}

TEST(HeartPhantomSource, PropertiesChangeTheImage)
{
  auto source = Source(40);
  ExpectFine(source);
  vtkNew<vtkImageData> before;
  before->DeepCopy(Image(source, 0));
  const auto differs = [&]()
  {
    ExpectFine(source);
    vtkImageData* now = Image(source, 0);
    bool other = now->GetNumberOfPoints() != before->GetNumberOfPoints();
    for (vtkIdType v = 0; !other && v < now->GetNumberOfPoints(); ++v)
    {
      other = now->GetPointData()->GetScalars()->GetComponent(v, 0) !=
              before->GetPointData()->GetScalars()->GetComponent(v, 0);
    }
    return other;
  };
  EXPECT_FALSE(differs());
  source->SetSeed(2);
  EXPECT_TRUE(differs());
  source->SetSeed(1);
  source->SetNoise(0);
  EXPECT_TRUE(differs());
  source->SetNoise(12);
  source->SetBlur(3);
  EXPECT_TRUE(differs());
  source->SetBlur(1);
  source->SetBias(0.5);
  EXPECT_TRUE(differs());
  source->SetBias(0.05);
  source->OpenVesselsOn();
  EXPECT_TRUE(differs());
  source->OpenVesselsOff();
  EXPECT_FALSE(differs());
  source->SetLength(1);
  ExpectFine(source);
  EXPECT_DOUBLE_EQ(Image(source, 0)->GetSpacing()[0], 1.0 / 40);
}

TEST(HeartPhantomSource, WrongProperties)
{
  ExpectError(Source(15), "it must be 16 to 512");
  auto source = Source(40);
  source->SetLength(0);
  ExpectError(source, "the length must be positive");
  source->SetLength(1);
  source->SetNoise(-1);
  ExpectError(source, "noise must be 0 to 255");
}
