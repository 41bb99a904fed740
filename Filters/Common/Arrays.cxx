// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays.h"

#include "MeshArrayNames.h"

#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkStringArray.h>

#include <set>

namespace lamina
{

Result<std::vector<Vec3>> ReadPoints(vtkPoints* points)
{
  const vtkIdType count = points ? points->GetNumberOfPoints() : 0;
  std::vector<Vec3> result(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    Vec3& p = result[static_cast<std::size_t>(i)];
    points->GetPoint(i, &p.x);
    if (!IsFinite(p))
    {
      return InvalidInput("point " + std::to_string(i) + " has a coordinate that is not a finite number");
    }
  }
  return result;
}

vtkSmartPointer<vtkPoints> MakePoints(const std::vector<Vec3>& points)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(points.size()));
  if (!points.empty())
  {
    std::memcpy(array->GetPointer(0), points.data(), points.size() * sizeof(Vec3));
  }
  auto result = vtkSmartPointer<vtkPoints>::Take(vtkPoints::New(VTK_DOUBLE));
  result->SetData(array);
  return result;
}

vtkSmartPointer<vtkStringArray> MakeStrings(const char* name, const std::vector<std::string>& values)
{
  auto array = vtkSmartPointer<vtkStringArray>::New();
  array->SetName(name);
  for (const std::string& value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

std::vector<int> DistinctValues(const std::vector<int>& values)
{
  std::set<int> found;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (i == 0 || values[i] != values[i - 1])
    {
      found.insert(values[i]);
    }
  }
  return { found.begin(), found.end() };
}

void AttachMaterialList(vtkDataObject* data, std::vector<int> ids,
                        const std::map<int, std::string>& materialNames)
{
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::string lines;
  for (const int id : ids)
  {
    const auto name = materialNames.find(id);
    if (id > 0)
    {
      lines += std::to_string(id) + (name == materialNames.end() ? "" : " " + name->second) + "\n";
    }
  }
  data->GetFieldData()->AddArray(MakeStrings(names::MaterialList, { lines }));
}

} // namespace lamina
