// SPDX-License-Identifier: BSD-3-Clause
#include "TextFile.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <unistd.h>

namespace lamina
{
namespace
{

Error Failed(const std::string& path, int code)
{
  const char* advice = "";
  switch (code)
  {
    case ENOSPC:
    case EFBIG:
    case EDQUOT:
      advice = ": the disk is full; make room or choose another folder";
      break;
    case EACCES:
    case EPERM:
    case EROFS:
      advice = ": choose a folder that you may write to";
      break;
    default:
      break;
  }
  return Unreachable(path + " could not be written: " + std::strerror(code) + advice);
}

} // namespace

TextFile::TextFile(const std::string& path)
  : Path(path)
  , Unfinished(path + ".unfinished")
{
  this->Buffer.resize(Capacity);
  this->Handle = ::open(this->Unfinished.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  this->Failed = this->Handle < 0 ? errno : 0;
}

TextFile::~TextFile()
{
  if (this->Handle >= 0)
  {
    ::close(this->Handle);
    ::unlink(this->Unfinished.c_str());
  }
}

TextFile& TextFile::PutLong(const char* text, std::size_t length)
{
  while (length > 0)
  {
    if (this->Used == Capacity)
    {
      this->Flush();
    }
    const std::size_t part = std::min(length, Capacity - this->Used);
    std::memcpy(&this->Buffer[this->Used], text, part);
    this->Used += part;
    text += part;
    length -= part;
  }
  return *this;
}

TextFile& TextFile::Pad(const char* text, std::size_t length, int width)
{
  static const char blanks[] = "                                ";
  const std::size_t missing = std::max(static_cast<std::size_t>(width), length) - length;
  return this->Put(blanks, std::min(missing, sizeof blanks - 1)).Put(text, length);
}

TextFile& TextFile::Field(Id value, int width)
{
  char text[24];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return this->Pad(text, static_cast<std::size_t>(end - text), width);
}

TextFile& TextFile::Field(double value, int width)
{
  char text[40];
  for (int digits = std::min(17, width - 1);;)
  {
    char* end = std::to_chars(text, text + sizeof text - 2, value, std::chars_format::general, digits).ptr;
    int length = static_cast<int>(end - text);
    // A real number has a point: before the exponent, or at the end.
    const auto size = static_cast<std::size_t>(length);
    if (std::memchr(text, '.', size) == nullptr)
    {
      char* exponent = static_cast<char*>(std::memchr(text, 'e', size));
      char* at = exponent != nullptr ? exponent : end;
      std::memmove(at + 1, at, static_cast<std::size_t>(end - at));
      *at = '.';
      ++length;
    }
    if (length <= width || digits == 1)
    {
      return this->Pad(text, static_cast<std::size_t>(length), width);
    }
    digits = std::max(1, digits - (length - width));
  }
}

TextFile& TextFile::Within(double value, int most)
{
  char text[40];
  const auto shortest = std::to_chars(text, text + sizeof text, value).ptr - text;
  return shortest <= most ? this->Put(text, static_cast<std::size_t>(shortest)) : this->Field(value, most);
}

TextFile& TextFile::Point(const Vec3& p, const char* separator)
{
  return *this << p.x << separator << p.y << separator << p.z;
}

void TextFile::Flush()
{
  std::size_t done = 0;
  while (this->Failed == 0 && done < this->Used)
  {
    const ssize_t n = ::write(this->Handle, this->Buffer.data() + done, this->Used - done);
    if (n < 0 && errno != EINTR)
    {
      this->Failed = errno;
    }
    done += n > 0 ? static_cast<std::size_t>(n) : 0;
  }
  this->Written += static_cast<long long>(done);
  this->Used = 0;
}

Status TextFile::Close()
{
  this->Flush();
  if (this->Failed == 0 && ::fsync(this->Handle) != 0 && errno != EINVAL)
  {
    this->Failed = errno;
  }
  if (this->Handle >= 0 && ::close(this->Handle) != 0 && this->Failed == 0)
  {
    this->Failed = errno;
  }
  this->Handle = -1;
  if (this->Failed == 0 && std::rename(this->Unfinished.c_str(), this->Path.c_str()) != 0)
  {
    this->Failed = errno;
  }
  if (this->Failed != 0)
  {
    ::unlink(this->Unfinished.c_str());
    return lamina::Failed(this->Path, this->Failed);
  }
  return Done{};
}

Status MakeFolder(const std::string& path)
{
  std::error_code code;
  std::filesystem::create_directories(path, code);
  return code ? Status(Failed(path, code.value())) : Status(Done{});
}

std::string FolderOf(const std::string& path)
{
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

std::string StemOf(const std::string& path)
{
  return std::filesystem::path(path).stem().string();
}

} // namespace lamina
