// SPDX-License-Identifier: BSD-3-Clause
// One run of TetGen, in this process or as the message to and from a child process. TetGenRun.cxx is the only
// file that sees tetgen.h.
#pragma once

#include "../Base/Types.h"

#include <optional>
#include <string>

namespace lamina
{

struct TetGenTask
{
  std::vector<Vec3> points;
  std::vector<double> sizes; ///< largest tet edge wanted at each point; empty: not asked
  std::vector<Triangle> facets;
  std::vector<Vec3> inserted; ///< interior points
  std::vector<Vec3> holes;    ///< a point in each part that is not to be meshed
  std::string switches; ///< without -p, -Q, -M, -J, which are always set, and -m, which follows from the data
};

struct TetGenAnswer
{
  int code = 0;             ///< 0: done, else TetGen's code or one of our own
  std::string message;      ///< what went wrong
  std::vector<Id> facets;   ///< facets that TetGen named in its complaint
  std::vector<Vec3> points; ///< the task's points first
  std::vector<std::array<Id, 4>> tets;
};

/// Runs TetGen here. Its predicates keep global state, so that runs wait for each other. TetGen prints its
/// complaints to standard output; `transcript` (if given) is called after a failure to tell what was printed.
TetGenAnswer RunTetGen(const TetGenTask& task, std::string (*transcript)() = nullptr);

// The messages between lamina-tetgen and its caller: both run on one machine, so bytes are those of memory.
std::string Encode(const TetGenTask& task);
std::string Encode(const TetGenAnswer& answer);
/// Nothing if the bytes are not a whole message.
std::optional<TetGenTask> DecodeTask(const std::string& bytes);
std::optional<TetGenAnswer> DecodeAnswer(const std::string& bytes);

} // namespace lamina
