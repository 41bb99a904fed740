// SPDX-License-Identifier: BSD-3-Clause
// NAME=VALUE on the command line of a benchmark, behind the name of a file.
#pragma once

#include <cstdlib>
#include <string>
#include <vector>

namespace lamina
{

class Arguments
{
public:
  Arguments(int argc, char** argv)
    : Words(argv + 2, argv + argc)
  {
  }
  double Get(const std::string& name, double otherwise) const
  {
    const std::string text = this->Text(name);
    return text.empty() ? otherwise : std::atof(text.c_str());
  }
  std::string Text(const std::string& name) const
  {
    for (const std::string& word : this->Words)
    {
      if (word.rfind(name + "=", 0) == 0)
      {
        return word.substr(name.size() + 1);
      }
    }
    return {};
  }

private:
  std::vector<std::string> Words;
};

} // namespace lamina
