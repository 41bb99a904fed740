// SPDX-License-Identifier: BSD-3-Clause
#include "Stage.h"

#include "Base/Memory.h"

#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkSetGet.h>

#include <algorithm>
#include <exception>
#include <new>

namespace lamina
{

bool IsEmpty(vtkDataSet* data)
{
  return !data || data->GetNumberOfPoints() == 0 || data->GetNumberOfCells() == 0;
}

Error MissingArray(const char* array, const char* where, const char* filter)
{
  return InvalidInput(std::string("no ") + array + " on the " + where + ": run " + filter + " first");
}

int Fail(vtkAlgorithm* self, const Error& error)
{
  for (int port = 0; port < self->GetNumberOfOutputPorts(); ++port)
  {
    if (vtkDataObject* output = self->GetOutputDataObject(port))
    {
      output->Initialize();
    }
  }
  if (error.kind == Failure::Cancelled)
  {
    return 1;
  }
  const std::string text =
    (error.kind == Failure::Internal ? "a fault of this filter, please report it: " : "") + error.message +
    DescribePlaces(error.places);
  vtkErrorWithObjectMacro(self, << text);
  return 0;
}

int RunStage(vtkAlgorithm* self, const std::function<Status()>& work)
{
  try
  {
    const Status status = work();
    return status ? 1 : Fail(self, status.GetError());
  }
  catch (const std::bad_alloc&)
  {
    return Fail(self, Unreachable("out of memory: this process holds " + MemoryText(PeakMemory()) + ", and " +
                                  MemoryText(FreeMemory()) +
                                  " are free: use a coarser image, larger sizes or fewer layers"));
  }
  catch (const std::exception& exception)
  {
    return Fail(self, Error{ Failure::Internal, exception.what(), {} });
  }
}

std::string Listed(const std::vector<int>& ids)
{
  if (ids.empty())
  {
    return "none";
  }
  std::string text;
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    text += (i == 0 ? "" : (i + 1 == ids.size() ? " and " : ", ")) + std::to_string(ids[i]);
  }
  return text;
}

Status CheckMaterials(const std::vector<int>& asked, const std::vector<int>& present, const char* property)
{
  for (const int id : asked)
  {
    if (id == 0)
    {
      return InvalidOption(std::string(property) +
                           " names material 0, the background, which is never meshed");
    }
    if (std::find(present.begin(), present.end(), id) == present.end())
    {
      return InvalidOption(std::string(property) + " names material " + std::to_string(id) +
                           ", which the input lacks: its materials are " + Listed(present));
    }
  }
  return Done{};
}

} // namespace lamina
