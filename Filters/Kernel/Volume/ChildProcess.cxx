// SPDX-License-Identifier: BSD-3-Clause
#include "ChildProcess.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace lamina
{
namespace
{

constexpr int PollMilliseconds = 200;

std::string Reason(int code)
{
  return std::strerror(code);
}

/// A file descriptor that closes itself.
class Descriptor
{
public:
  explicit Descriptor(int value)
    : Value(value)
  {
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { this->Close(); }
  int Get() const { return this->Value; }
  void Close()
  {
    if (this->Value >= 0)
    {
      close(this->Value);
    }
    this->Value = -1;
  }

private:
  int Value;
};

/// The running program: killed and reaped if it is still there at the end.
class Child
{
public:
  explicit Child(pid_t id)
    : Process(id)
  {
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child()
  {
    if (!this->Reaped)
    {
      kill(this->Process, SIGKILL);
      this->Wait(0);
    }
  }
  /// True once the program has ended; flags as of waitpid.
  bool Wait(int flags)
  {
    pid_t ended = -1;
    do
    {
      ended = waitpid(this->Process, &this->Status, flags);
    } while (ended < 0 && errno == EINTR);
    // Where the host process leaves its children to the system there is no status to be had: the answer must
    // do.
    this->Reaped = ended != 0;
    this->Status = ended < 0 ? 0 : this->Status;
    return this->Reaped;
  }
  /// How it failed, empty if it did not.
  std::string Complaint() const
  {
    if (WIFSIGNALED(this->Status))
    {
      const int signal = WTERMSIG(this->Status);
      return "was ended by signal " + std::to_string(signal) + " (" + strsignal(signal) + ")" +
             (signal == SIGKILL ? ": perhaps memory ran out" : "");
    }
    const int code = WEXITSTATUS(this->Status);
    return code == 0 ? "" : "ended with code " + std::to_string(code);
  }

private:
  pid_t Process;
  int Status = 0;
  bool Reaped = false;
};

/// 0 or the error code.
int Spawn(const std::string& program, int socket, pid_t& process)
{
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&actions);
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_adddup2(&actions, socket, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, socket, STDOUT_FILENO);
  // A host that ignores or blocks signals must not hand that down.
  sigset_t none;
  sigset_t usual;
  sigemptyset(&none);
  sigemptyset(&usual);
  sigaddset(&usual, SIGPIPE);
  sigaddset(&usual, SIGTERM);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &usual);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  std::string name = program;
  char* arguments[] = { name.data(), nullptr };
  const int code = posix_spawn(&process, program.c_str(), &actions, &attributes, arguments, environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return code;
}

/// Both directions of the talk. Sending does not raise SIGPIPE: a program that stops listening shows in its
/// answer.
class Talk
{
public:
  Talk(int socket, const std::string& input)
    : Socket(socket)
    , Input(input)
  {
  }
  /// Waits for a moment and moves what can be moved; false once the other side has closed.
  bool Step()
  {
    pollfd entry{ this->Socket, static_cast<short>(POLLIN | (this->Sent < this->Input.size() ? POLLOUT : 0)),
                  0 };
    if (poll(&entry, 1, PollMilliseconds) <= 0)
    {
      return true;
    }
    if ((entry.revents & POLLOUT) != 0)
    {
      this->Send();
    }
    return (entry.revents & (POLLIN | POLLHUP | POLLERR)) == 0 || this->Receive();
  }
  std::string&& TakeAnswer() { return std::move(this->Answer); }

private:
  void Send()
  {
    const ssize_t count =
      send(this->Socket, this->Input.data() + this->Sent, this->Input.size() - this->Sent, MSG_NOSIGNAL);
    const bool again = count < 0 && (errno == EAGAIN || errno == EINTR);
    this->Sent =
      count >= 0 ? this->Sent + static_cast<std::size_t>(count) : (again ? this->Sent : this->Input.size());
    if (this->Sent == this->Input.size())
    {
      shutdown(this->Socket, SHUT_WR);
    }
  }
  bool Receive()
  {
    char buffer[1 << 16];
    const ssize_t count = recv(this->Socket, buffer, sizeof buffer, 0);
    if (count > 0)
    {
      this->Answer.append(buffer, static_cast<std::size_t>(count));
    }
    return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
  }

  int Socket;
  const std::string& Input;
  std::size_t Sent = 0;
  std::string Answer;
};

} // namespace

Result<std::string> RunChild(const std::string& program, const std::string& input, double secondsExpected,
                             Monitor& monitor)
{
  const auto failed = [&](const std::string& what)
  { return Unreachable("the program " + program + " " + what); };
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
  {
    return failed("got no connection: " + Reason(errno));
  }
  Descriptor own(ends[0]);
  Descriptor other(ends[1]);
  fcntl(own.Get(), F_SETFL, O_NONBLOCK);
  pid_t process = -1;
  if (const int code = Spawn(program, other.Get(), process))
  {
    return failed("could not be started: " + Reason(code));
  }
  other.Close();
  Child child(process);
  Talk talk(own.Get(), input);
  const auto start = std::chrono::steady_clock::now();
  bool isOpen = true;
  while (isOpen || !child.Wait(WNOHANG))
  {
    if (monitor.Cancelled())
    {
      return Cancelled();
    }
    if (isOpen)
    {
      isOpen = talk.Step();
    }
    else
    {
      usleep(2000);
    }
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    monitor.Progress(spent.count() / (spent.count() + secondsExpected), "TetGen is at work");
  }
  const std::string complaint = child.Complaint();
  if (!complaint.empty())
  {
    return failed(complaint);
  }
  return talk.TakeAnswer();
}

} // namespace lamina
