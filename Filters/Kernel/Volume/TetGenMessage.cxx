// SPDX-License-Identifier: BSD-3-Clause
// The two messages as bytes: a tag, then each array as its length and its memory.
#include "TetGenRun.h"

#include <cstdint>
#include <cstring>

namespace lamina
{
namespace
{

constexpr char TaskTag[] = "LaminaTetGenTask1";
constexpr char AnswerTag[] = "LaminaTetGenAnswer1";

template<typename Array>
void Put(std::string& bytes, const Array& array)
{
  const std::uint64_t count = array.size();
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.append(reinterpret_cast<const char*>(array.data()), count * sizeof(typename Array::value_type));
}

/// Reads what Put wrote; once something is missing, nothing more is read and IsWhole() is false.
class Reader
{
public:
  explicit Reader(const std::string& bytes)
    : Bytes(bytes)
  {
  }
  template<typename Array>
  void Take(Array& array)
  {
    std::uint64_t count = 0;
    if (!this->Copy(&count, sizeof count) || count > this->Left() / sizeof(typename Array::value_type))
    {
      this->Failed = true;
      return;
    }
    array.resize(count);
    this->Copy(array.data(), count * sizeof(typename Array::value_type));
  }
  bool IsWhole() const { return !this->Failed && this->Left() == 0; }

private:
  std::size_t Left() const { return this->Bytes.size() - this->At; }
  bool Copy(void* to, std::size_t count)
  {
    this->Failed = this->Failed || count > this->Left();
    if (this->Failed)
    {
      return false;
    }
    if (count > 0)
    {
      std::memcpy(to, this->Bytes.data() + this->At, count);
    }
    this->At += count;
    return true;
  }

  const std::string& Bytes;
  std::size_t At = 0;
  bool Failed = false;
};

} // namespace

std::string Encode(const TetGenTask& task)
{
  std::string bytes;
  Put(bytes, std::string(TaskTag));
  Put(bytes, task.points);
  Put(bytes, task.sizes);
  Put(bytes, task.facets);
  Put(bytes, task.inserted);
  Put(bytes, task.holes);
  Put(bytes, task.switches);
  return bytes;
}

std::string Encode(const TetGenAnswer& answer)
{
  std::string bytes;
  Put(bytes, std::string(AnswerTag));
  Put(bytes, std::vector<int>{ answer.code });
  Put(bytes, answer.message);
  Put(bytes, answer.facets);
  Put(bytes, answer.points);
  Put(bytes, answer.tets);
  return bytes;
}

std::optional<TetGenTask> DecodeTask(const std::string& bytes)
{
  Reader reader(bytes);
  std::string tag;
  TetGenTask task;
  reader.Take(tag);
  reader.Take(task.points);
  reader.Take(task.sizes);
  reader.Take(task.facets);
  reader.Take(task.inserted);
  reader.Take(task.holes);
  reader.Take(task.switches);
  return reader.IsWhole() && tag == TaskTag ? std::optional<TetGenTask>(std::move(task)) : std::nullopt;
}

std::optional<TetGenAnswer> DecodeAnswer(const std::string& bytes)
{
  Reader reader(bytes);
  std::string tag;
  std::vector<int> code;
  TetGenAnswer answer;
  reader.Take(tag);
  reader.Take(code);
  reader.Take(answer.message);
  reader.Take(answer.facets);
  reader.Take(answer.points);
  reader.Take(answer.tets);
  if (!reader.IsWhole() || tag != AnswerTag || code.size() != 1)
  {
    return std::nullopt;
  }
  answer.code = code.front();
  return answer;
}

} // namespace lamina
