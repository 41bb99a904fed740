// SPDX-License-Identifier: BSD-3-Clause
// How a kernel call ends: with a report, or with a failure that says what, where and what to do.
#pragma once

#include "Types.h"

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace lamina
{

enum class Failure
{
  InvalidInput,  ///< the data handed in cannot be worked on
  InvalidOption, ///< an option is out of its range
  Unreachable,   ///< the method could not reach its goal on this input
  Cancelled,     ///< the monitor asked to stop
  Internal       ///< a guarantee of our own was broken: a bug
};

/// A failure: message (what, and what to do) and, where it helps, the places in world coordinates.
struct Error
{
  Failure kind = Failure::Internal;
  std::string message;
  std::vector<Vec3> places;
};

/// Either a T or an Error.
template<typename T>
class Result
{
public:
  Result(T value)
    : Content(std::move(value))
  {
  }
  Result(Error error)
    : Content(std::move(error))
  {
  }
  explicit operator bool() const { return std::holds_alternative<T>(this->Content); }
  T& operator*() { return std::get<T>(this->Content); }
  const T& operator*() const { return std::get<T>(this->Content); }
  T* operator->() { return &std::get<T>(this->Content); }
  const T* operator->() const { return &std::get<T>(this->Content); }
  const Error& GetError() const { return std::get<Error>(this->Content); }

private:
  std::variant<T, Error> Content;
};

inline Error InvalidInput(std::string message, std::vector<Vec3> places = {})
{
  return { Failure::InvalidInput, std::move(message), std::move(places) };
}
inline Error InvalidOption(std::string message)
{
  return { Failure::InvalidOption, std::move(message), {} };
}
inline Error Unreachable(std::string message, std::vector<Vec3> places = {})
{
  return { Failure::Unreachable, std::move(message), std::move(places) };
}
inline Error Cancelled()
{
  return { Failure::Cancelled, "stopped on request", {} };
}

/// "(x, y, z)" with enough digits to find the place in a viewer.
std::string ToString(const Vec3& place);
/// The first few places as text, e.g. " at (1, 2, 3), (4, 5, 6) and 7 more"; empty for none.
std::string DescribePlaces(const std::vector<Vec3>& places);

} // namespace lamina
