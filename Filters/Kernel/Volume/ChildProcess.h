// SPDX-License-Identifier: BSD-3-Clause
// A program that answers one message with another.
#pragma once

#include "../Base/Monitor.h"
#include "../Base/Result.h"

#include <string>

namespace lamina
{

/// Starts `program` without arguments, writes `input` to its standard input and returns what it writes to its
/// standard output (one socket serves as both). Cancelled() is asked several times a second and stops the
/// program. A program that cannot be started, crashes or ends with a code other than 0 is an error.
/// `secondsExpected` paces the progress.
Result<std::string> RunChild(const std::string& program, const std::string& input, double secondsExpected,
                             Monitor& monitor);

} // namespace lamina
