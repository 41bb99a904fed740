// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFigures.h"

#include "Arrays.h"
#include "MeshArrayNames.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPolyData.h"

namespace lamina
{

void WriteCertificate(const SurfaceCertificate& certificate, vtkPolyData* output)
{
  vtkFieldData* data = output->GetFieldData();
  data->AddArray(MakeArray<vtkIdTypeArray>(names::IntersectingPairs,
                                           std::vector<vtkIdType>{ certificate.intersectingPairs }));
  data->AddArray(
    MakeArray<vtkDoubleArray>(names::LeastClearance, std::vector<double>{ certificate.leastClearance }));
  data->AddArray(MakeArray<vtkDoubleArray>(names::LeastAngle, std::vector<double>{ certificate.leastAngle }));
}

void WriteImageVolumes(const std::vector<int>& materials, const std::vector<double>& volumes,
                       vtkPolyData* output)
{
  std::vector<double> rows;
  for (std::size_t m = 0; m < materials.size(); ++m)
  {
    rows.insert(rows.end(), { static_cast<double>(materials[m]), volumes[m] });
  }
  auto array = MakeArray<vtkDoubleArray>(names::ImageVolumes, rows, 2);
  array->SetComponentName(0, "Material");
  array->SetComponentName(1, "Volume");
  output->GetFieldData()->AddArray(array);
}

void DropSurfaceFigures(vtkPolyData* output)
{
  for (const char* name :
       { names::IntersectingPairs, names::LeastClearance, names::LeastAngle, names::ImageVolumes })
  {
    output->GetFieldData()->RemoveArray(name);
  }
}

} // namespace lamina
