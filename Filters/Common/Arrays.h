// SPDX-License-Identifier: BSD-3-Clause
// Between std::vector and VTK's arrays: what the bridges share.
#pragma once

#include "Stage.h"

#include "Base/Result.h"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <string>
#include <vector>

class vtkDataObject;
class vtkStringArray;

namespace lamina
{

/// A VTK array with the vector's values, in tuples of `components`.
template<typename ArrayT, typename T>
vtkSmartPointer<ArrayT> MakeArray(const char* name, const std::vector<T>& values, int components = 1)
{
  static_assert(sizeof(T) == sizeof(typename ArrayT::ValueType), "the memory is copied as it is");
  auto array = vtkSmartPointer<ArrayT>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  if (!values.empty())
  {
    std::memcpy(array->GetPointer(0), values.data(), values.size() * sizeof(T));
  }
  return array;
}

/// Put the values on `attributes`, or take the array of that name away if there are none.
template<typename ArrayT, typename T>
void SetOrRemove(vtkDataSetAttributes* attributes, const char* name, const std::vector<T>& values,
                 int components = 1)
{
  if (values.empty())
  {
    attributes->RemoveArray(name);
    return;
  }
  attributes->AddArray(MakeArray<ArrayT>(name, values, components));
}

/// The same for vectors, in tuples of three.
inline void SetOrRemoveVectors(vtkDataSetAttributes* attributes, const char* name,
                               const std::vector<Vec3>& vectors)
{
  std::vector<double> values;
  values.reserve(3 * vectors.size());
  for (const Vec3& v : vectors)
  {
    values.insert(values.end(), { v.x, v.y, v.z });
  }
  SetOrRemove<vtkDoubleArray>(attributes, name, values, 3);
}

/// The values of an array of any number type; none if the array is missing. `where` is "points" or "cells".
template<typename T>
Result<std::vector<T>> ReadValues(vtkDataSetAttributes* attributes, const char* name, vtkIdType tuples,
                                  int components, const char* where)
{
  std::vector<T> values;
  vtkDataArray* array = attributes->GetArray(name);
  if (!array)
  {
    return values;
  }
  if (array->GetNumberOfComponents() != components || array->GetNumberOfTuples() != tuples)
  {
    return InvalidInput(std::string(name) + " on the " + where + " has " +
                        std::to_string(array->GetNumberOfTuples()) + " tuples of " +
                        std::to_string(array->GetNumberOfComponents()) + " components, where " +
                        std::to_string(tuples) + " of " + std::to_string(components) + " are needed");
  }
  values.resize(static_cast<std::size_t>(tuples) * static_cast<std::size_t>(components));
  if (auto* same = vtkAOSDataArrayTemplate<T>::FastDownCast(array))
  {
    std::copy_n(same->GetPointer(0), values.size(), values.begin());
    return values;
  }
  for (vtkIdType t = 0; t < tuples; ++t)
  {
    for (int c = 0; c < components; ++c)
    {
      values[static_cast<std::size_t>(t * components + c)] = static_cast<T>(array->GetComponent(t, c));
    }
  }
  return values;
}

/// The values that occur, ascending: where they are few, and neighbours alike as a rule.
std::vector<int> DistinctValues(const std::vector<int>& values);

/// Tell which materials `data` has, background apart, by their ids and names, where they have any, in one
/// text: the panels of later stages list them. `ids` in any order, any number of times.
void AttachMaterialList(vtkDataObject* data, std::vector<int> ids,
                        const std::map<int, std::string>& materialNames = {});

/// An array of text.
vtkSmartPointer<vtkStringArray> MakeStrings(const char* name, const std::vector<std::string>& values);

/// The points as doubles; a failure if a coordinate is not finite.
Result<std::vector<Vec3>> ReadPoints(vtkPoints* points);
/// Points of doubles.
vtkSmartPointer<vtkPoints> MakePoints(const std::vector<Vec3>& points);

} // namespace lamina
