// SPDX-License-Identifier: BSD-3-Clause
// A text file that is written in one stream and gets its name only when it is complete.
#pragma once

#include "Stage.h"

#include "Base/Types.h"

#include <charconv>
#include <cstring>
#include <string>

namespace lamina
{

/// Collects text in a buffer and hands it to the system in large pieces, under a name of its own beside the
/// final one. After a failure further writing does nothing; Close tells. A file that was not closed is
/// removed.
class TextFile
{
public:
  explicit TextFile(const std::string& path);
  ~TextFile();
  TextFile(const TextFile&) = delete;
  TextFile& operator=(const TextFile&) = delete;

  TextFile& operator<<(const char* text) { return this->Put(text, std::char_traits<char>::length(text)); }
  TextFile& operator<<(const std::string& text) { return this->Put(text.data(), text.size()); }
  TextFile& operator<<(char c) { return this->Put(&c, 1); }
  TextFile& operator<<(Id value) { return this->Number(value); }
  TextFile& operator<<(int value) { return this->Number(value); }
  TextFile& operator<<(std::size_t value) { return this->Number(value); }
  /// The shortest text that reads back as the same number.
  TextFile& operator<<(double value) { return this->Number(value); }
  /// The shortest text that reads back as the same number if it fits `most` characters, else as many digits
  /// as fit.
  TextFile& Within(double value, int most);
  /// Right-aligned in a field of `width`.
  TextFile& Field(Id value, int width);
  /// The most digits that fit a field of `width`, with a decimal point; right-aligned.
  TextFile& Field(double value, int width);
  /// "x y z" with a separator.
  TextFile& Point(const Vec3& p, const char* separator = " ");

  bool HasFailed() const { return this->Failed != 0; }
  long long Bytes() const { return this->Written; }
  /// Write what is left and give the file its name; a failure names the path and the cause.
  Status Close();

private:
  static constexpr std::size_t Capacity = std::size_t{ 1 } << 22;

  template<typename T>
  TextFile& Number(T value)
  {
    constexpr std::size_t longest = 32;
    if (this->Used + longest > Capacity)
    {
      this->Flush();
    }
    char* begin = &this->Buffer[this->Used];
    this->Used += static_cast<std::size_t>(std::to_chars(begin, begin + longest, value).ptr - begin);
    return *this;
  }
  TextFile& Put(const char* text, std::size_t length)
  {
    if (this->Used + length > Capacity)
    {
      return this->PutLong(text, length);
    }
    std::memcpy(&this->Buffer[this->Used], text, length);
    this->Used += length;
    return *this;
  }
  TextFile& PutLong(const char* text, std::size_t length);
  TextFile& Pad(const char* text, std::size_t length, int width);
  void Flush();

  std::string Path;
  std::string Unfinished;
  std::string Buffer;
  std::size_t Used = 0;
  long long Written = 0;
  int Handle = -1;
  int Failed = 0; ///< errno
};

/// Make a folder and those above it; a failure names it and the cause.
Status MakeFolder(const std::string& path);
/// The path without its last name: "." if it has none.
std::string FolderOf(const std::string& path);
/// The last name of a path without its extension.
std::string StemOf(const std::string& path);

} // namespace lamina
