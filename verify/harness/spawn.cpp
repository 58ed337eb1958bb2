// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/spawn.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>
#include <utility>

namespace fathom::harness {
namespace {

[[noreturn]] void refuse(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

/// Both ends, closed again unless taken.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) refuse("cannot make a pipe");
    // The child's end must not be a standard stream, which dup2 would overwrite before its turn.
    for (int& end : ends_) {
      if (end > STDERR_FILENO) continue;
      const int higher = ::fcntl(end, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
      if (higher < 0) refuse("cannot make a pipe");
      ::close(end);
      end = higher;
    }
  }
  ~Pipe() {
    for (const int end : ends_)
      if (end >= 0) ::close(end);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  [[nodiscard]] int reading() const { return ends_[0]; }
  [[nodiscard]] int writing() const { return ends_[1]; }
  /// Ours from now on, and never blocking.
  int take(int which) {
    const int end = std::exchange(ends_[which], -1);
    ::fcntl(end, F_SETFL, ::fcntl(end, F_GETFL) | O_NONBLOCK);
    return end;
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

/// The child, between fork and exec: system calls alone, since other threads of the parent may have held any lock.
[[noreturn]] void become(const char* const* words, int input, int output, int errors, pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);
  for (const int signal : {SIGPIPE, SIGINT, SIGQUIT, SIGTERM, SIGHUP, SIGCHLD, SIGALRM}) ::signal(signal, SIG_DFL);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  if (::dup2(input, STDIN_FILENO) >= 0 && ::dup2(output, STDOUT_FILENO) >= 0 && ::dup2(errors, STDERR_FILENO) >= 0) {
    ::close_range(STDERR_FILENO + 1, ~0U, 0);  // the stream of cases, for one, which may hold the answers
    ::execv(words[0], const_cast<char* const*>(words));
  }
  ::_exit(127);
}

}  // namespace

Spawned spawn(const std::string& command) {
  Pipe input, output, errors;
  const char* const words[] = {"/bin/sh", "-c", command.c_str(), nullptr};
  const pid_t parent = ::getpid();
  const pid_t id = ::fork();
  if (id < 0) refuse("cannot start a process");
  if (id == 0) become(words, input.reading(), output.writing(), errors.writing(), parent);
  ::setpgid(id, id);  // whoever of the two comes first
  return {id, input.take(1), output.take(0), errors.take(0)};
}

}  // namespace fathom::harness
