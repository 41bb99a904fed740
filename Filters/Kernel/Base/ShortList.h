// SPDX-License-Identifier: BSD-3-Clause
// A list that needs no memory of its own while it is short.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace lamina
{

/// Up to N items lie in the list itself, more in a vector.
template<typename T, std::size_t N>
class ShortList
{
public:
  std::size_t size() const { return this->Count; }
  bool empty() const { return this->Count == 0; }
  const T* begin() const { return this->More.empty() ? this->Few.data() : this->More.data(); }
  const T* end() const { return this->begin() + this->Count; }
  T* begin() { return this->More.empty() ? this->Few.data() : this->More.data(); }
  T* end() { return this->begin() + this->Count; }
  const T& operator[](std::size_t i) const { return this->begin()[i]; }
  void push_back(const T& item)
  {
    if (this->Count < N)
    {
      this->Few[this->Count] = item;
    }
    else
    {
      if (this->Count == N)
      {
        this->More.assign(this->Few.begin(), this->Few.end());
      }
      this->More.push_back(item);
    }
    ++this->Count;
  }

private:
  std::size_t Count = 0;
  std::array<T, N> Few;
  std::vector<T> More;
};

} // namespace lamina
