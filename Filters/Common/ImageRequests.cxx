// SPDX-License-Identifier: BSD-3-Clause
#include "ImageRequests.h"

#include <vtkDataObject.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkStreamingDemandDrivenPipeline.h>

namespace lamina
{

void WriteInformation(const GridGeometry& grid, vtkInformation* information)
{
  const int extent[6] = { 0, static_cast<int>(grid.size[0]) - 1, 0, static_cast<int>(grid.size[1]) - 1,
                          0, static_cast<int>(grid.size[2]) - 1 };
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  information->Set(vtkDataObject::ORIGIN(), &grid.origin.x, 3);
  information->Set(vtkDataObject::SPACING(), &grid.spacing.x, 3);
  information->Set(vtkDataObject::DIRECTION(), grid.direction.data(), 9);
}

int TellScalarType(vtkInformationVector* outputs, int type)
{
  vtkDataObject::SetPointDataActiveScalarInfo(outputs->GetInformationObject(0), type, 1);
  return 1;
}

int AskForWholeImages(vtkInformationVector** inputs, int ports)
{
  for (int port = 0; port < ports; ++port)
  {
    if (vtkInformation* info = inputs[port]->GetInformationObject(0))
    {
      int extent[6];
      info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
    }
  }
  return 1;
}

} // namespace lamina
