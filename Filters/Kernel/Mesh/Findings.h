// SPDX-License-Identifier: BSD-3-Clause
// Places of one kind of trouble, and the sentence they become.
#pragma once

#include "../Base/Result.h"

namespace lamina
{

/// Counts all places and keeps the first few.
class Places
{
public:
  void Add(const Vec3& place)
  {
    ++this->Count;
    if (this->First.size() < 3)
    {
      this->First.push_back(place);
    }
  }
  /// Adds "<count> <what> at (x, y, z), ..." if there are any.
  void Tell(const std::string& what, std::vector<std::string>& findings) const
  {
    if (this->Count > 0)
    {
      const std::string more = this->Count > static_cast<Id>(this->First.size()) ? " and elsewhere" : "";
      findings.push_back(std::to_string(this->Count) + " " + what + DescribePlaces(this->First) + more);
    }
  }
  Id GetCount() const { return this->Count; }

private:
  Id Count = 0;
  std::vector<Vec3> First;
};

} // namespace lamina
