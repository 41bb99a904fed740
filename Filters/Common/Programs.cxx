// SPDX-License-Identifier: BSD-3-Clause
#include "Programs.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>
#include <memory>

namespace lamina
{

namespace
{

/// The folder of the library (or program) that this code is part of.
std::string OwnFolder()
{
  Dl_info info;
  static const char here = 0;
  if (!dladdr(&here, &info) || !info.dli_fname)
  {
    return {};
  }
  const std::unique_ptr<char, decltype(&std::free)> real(realpath(info.dli_fname, nullptr), &std::free);
  const std::string path = real ? real.get() : info.dli_fname;
  const auto slash = path.rfind('/');
  return slash == std::string::npos ? std::string(".") : path.substr(0, slash);
}

} // namespace

std::string FindProgram(const char* name)
{
  constexpr int levels = 3;
  std::string folder = OwnFolder();
  for (int level = 0; level < levels && !folder.empty(); ++level)
  {
    const std::string path = folder + "/" + name;
    if (access(path.c_str(), X_OK) == 0)
    {
      return path;
    }
    const auto slash = folder.rfind('/');
    folder = slash == std::string::npos ? std::string() : folder.substr(0, slash);
  }
  return {};
}

} // namespace lamina
