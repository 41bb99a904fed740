// SPDX-License-Identifier: BSD-3-Clause
// Reads a TetGenTask from standard input, runs TetGen and writes the TetGenAnswer to standard output.
#include "Volume/TetGenRun.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

namespace
{

constexpr int BadMessage = 2;
constexpr int BadOutput = 3;

std::string ReadAll(int descriptor)
{
  std::string bytes;
  std::string buffer(1 << 20, '\0');
  for (;;)
  {
    const ssize_t count = read(descriptor, buffer.data(), buffer.size());
    if (count > 0)
    {
      bytes.append(buffer, 0, static_cast<std::size_t>(count));
    }
    else if (count == 0 || errno != EINTR)
    {
      return bytes;
    }
  }
}

bool WriteAll(int descriptor, const std::string& bytes)
{
  for (std::size_t done = 0; done < bytes.size();)
  {
    const ssize_t count = write(descriptor, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno != EINTR)
    {
      return false;
    }
    done += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  return true;
}

/// What TetGen printed: standard output was turned to a nameless file.
std::string Transcript()
{
  std::fflush(stdout);
  lseek(STDOUT_FILENO, 0, SEEK_SET);
  std::string text = ReadAll(STDOUT_FILENO);
  constexpr std::size_t most = 1000;
  text = text.size() > most ? text.substr(text.size() - most) : text;
  for (char& c : text)
  {
    c = c == '\n' ? ' ' : c;
  }
  return text;
}

/// Once the caller is gone there is nobody to work for.
void EndWithCaller()
{
  struct stat status;
  if (fstat(STDIN_FILENO, &status) == 0 && S_ISSOCK(status.st_mode))
  {
    std::thread(
      []()
      {
        pollfd entry{ STDIN_FILENO, 0, 0 };
        while (poll(&entry, 1, -1) < 0 && errno == EINTR)
        {
        }
        std::_Exit(BadOutput);
      })
      .detach();
  }
}

} // namespace

int main()
{
  const int output = dup(STDOUT_FILENO);
  std::FILE* printed = std::tmpfile();
  dup2(printed != nullptr ? fileno(printed) : STDERR_FILENO, STDOUT_FILENO);
  const auto task = lamina::DecodeTask(ReadAll(STDIN_FILENO));
  if (!task)
  {
    std::fputs(
      "lamina-tetgen reads a message from Lamina's filters on standard input; it is not run by hand\n",
      stderr);
    return BadMessage;
  }
  EndWithCaller();
  const bool written = WriteAll(output, Encode(RunTetGen(*task, printed != nullptr ? Transcript : nullptr)));
  // Without the detached thread's and the libraries' farewells.
  std::_Exit(written ? EXIT_SUCCESS : BadOutput);
}
