// SPDX-License-Identifier: BSD-3-Clause
// Tiny inputs of the filter tests, and a look-out for errors.
#pragma once

#include <gtest/gtest.h>

#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnstructuredGrid.h>

#include <string>

/// An image of `edge` voxels a side: blood (2) in a box of tissue (1) in background, the walls two voxels
/// thick or more.
inline vtkSmartPointer<vtkImageData> NestedBoxes(int edge = 14)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(edge, edge, edge);
  image->AllocateScalars(VTK_INT, 1);
  image->GetPointData()->GetScalars()->SetName("MaterialIds");
  for (int k = 0; k < edge; ++k)
  {
    for (int j = 0; j < edge; ++j)
    {
      for (int i = 0; i < edge; ++i)
      {
        const auto within = [&](int margin)
        {
          const auto one = [&](int x) { return x >= margin && x < edge - margin; };
          return one(i) && one(j) && one(k);
        };
        *static_cast<int*>(image->GetScalarPointer(i, j, k)) = within(5) ? 2 : (within(2) ? 1 : 0);
      }
    }
  }
  return image;
}

/// Errors and warnings of a filter and its executive, kept instead of printed.
class Watch
{
public:
  explicit Watch(vtkAlgorithm* filter)
  {
    filter->AddObserver(vtkCommand::ErrorEvent, this->Own);
    filter->AddObserver(vtkCommand::WarningEvent, this->Own);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Pipeline);
  }
  bool GetError() const { return this->Own->GetError(); }
  bool GetWarning() const { return this->Own->GetWarning(); }
  std::string Error() const { return this->Own->GetErrorMessage(); }
  std::string Warning() const { return this->Own->GetWarningMessage(); }

private:
  vtkNew<vtkTest::ErrorObserver> Own;
  vtkNew<vtkTest::ErrorObserver> Pipeline;
};

/// Updates and expects an error that has `part` in it, and empty outputs.
inline void ExpectError(vtkAlgorithm* filter, const std::string& part)
{
  Watch watch(filter);
  filter->Update();
  EXPECT_TRUE(watch.GetError()) << "no error with: " << part;
  EXPECT_NE(watch.Error().find(part), std::string::npos) << watch.Error();
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    EXPECT_EQ(filter->GetOutputDataObject(port)->GetNumberOfElements(vtkDataObject::POINT), 0) << port;
  }
}

/// Updates and expects neither error nor warning.
inline void ExpectFine(vtkAlgorithm* filter)
{
  Watch watch(filter);
  filter->Update();
  EXPECT_FALSE(watch.GetError()) << watch.Error();
}

/// The report of a stage on a data object; empty if there is none.
inline std::string ReportOf(vtkDataObject* data, const std::string& stage)
{
  auto* text =
    vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(("LaminaReport_" + stage).c_str()));
  return text ? std::string(text->GetValue(0)) : std::string();
}

/// A tetrahedron with its corner at the origin, as a closed surface without any arrays.
inline vtkSmartPointer<vtkPolyData> PlainTetrahedron()
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(0, 1, 0);
  points->InsertNextPoint(0, 0, 1);
  vtkNew<vtkCellArray> polys;
  const vtkIdType faces[4][3] = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };
  for (const auto& face : faces)
  {
    polys->InsertNextCell(3, face);
  }
  data->SetPoints(points);
  data->SetPolys(polys);
  return data;
}

inline void AddUniform(vtkPolyData* surface, const char* name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(surface->GetNumberOfPoints());
  array->Fill(value);
  surface->GetPointData()->AddArray(array);
}
