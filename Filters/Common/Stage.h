// SPDX-License-Identifier: BSD-3-Clause
// How a shell runs: its work either is done or ends in an error of the filter, with empty outputs.
#pragma once

#include "Base/Result.h"

#include <vtkAlgorithm.h>

#include <functional>
#include <string>
#include <vector>

class vtkDataSet;

namespace lamina
{

struct Done
{
};
/// Done or an Error.
using Status = Result<Done>;

/// True if there is nothing to work on: no data set, or one without points or cells.
bool IsEmpty(vtkDataSet* data);

/// The failure of a missing array: what is missing, where, and the filter that makes it.
Error MissingArray(const char* array, const char* where, const char* filter);

/// Empty outputs on all ports of `self` and, unless it was stopped on request, an error that tells what,
/// where and what to do. Returns what RequestData has to return.
int Fail(vtkAlgorithm* self, const Error& error);

/// Do the work of RequestData; a failure or an exception goes to Fail. Returns what RequestData has to
/// return.
int RunStage(vtkAlgorithm* self, const std::function<Status()>& work);

/// A failure if a material of the property `property` is not among those `present`.
Status CheckMaterials(const std::vector<int>& asked, const std::vector<int>& present, const char* property);
/// "1, 2 and 5"; "none" for none.
std::string Listed(const std::vector<int>& ids);

} // namespace lamina
