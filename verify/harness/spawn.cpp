// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "verify/harness/process.hpp"

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
  /// Ours from now on.
  int take(int which) { return std::exchange(ends_[which], -1); }
  /// And never blocking.
  int take_unblocked(int which) {
    const int end = take(which);
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

bool is_program(const std::string& path) {
  struct stat found = {};
  return ::stat(path.c_str(), &found) == 0 && S_ISREG(found.st_mode) && ::access(path.c_str(), X_OK) == 0;
}

/// Whether a shell finds a program of this name, which then is neither a word of its own language nor a function.
bool is_found(const std::string& name) {
  if (name.empty() || name.find('/') != std::string::npos) return is_program(name);
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (is_program((folder.empty() ? "." : folder) + '/' + name)) return true;
  return false;
}

/// The first word of a command, without its quotation marks. Empty if the command is more than words and files to read and write.
std::string only_program(const std::string& command) {
  constexpr std::string_view blanks = " \t", never = "`\\(", unless_quoted = ";&|)\n";
  std::string first;
  bool in_first = true;
  char mark = 0;  // the quotation mark that is open
  for (const char c : command.substr(std::min(command.find_first_not_of(blanks), command.size()))) {
    const bool expands = c == '$' && in_first, unquoted = mark == 0;
    if (mark != '\'' && (expands || never.find(c) != never.npos)) return "";
    if (unquoted && unless_quoted.find(c) != unless_quoted.npos) return "";
    if (unquoted && (c == '\'' || c == '"')) mark = c;
    else if (c == mark) mark = 0;
    else if (unquoted && blanks.find(c) != blanks.npos) in_first = false;
    else if (in_first) first += c;
  }
  return mark == 0 ? first : "";
}

}  // namespace

std::string without_shell(const std::string& command) { return (is_found(only_program(command)) ? "exec " : "") + command; }

Spawned spawn(const std::string& command) {
  Pipe input, output, errors;
  const std::string text = without_shell(command);
  const char* const words[] = {"/bin/sh", "-c", text.c_str(), nullptr};
  const pid_t parent = ::getpid();
  const pid_t id = ::fork();
  if (id < 0) refuse("cannot start a process");
  if (id == 0) become(words, input.reading(), output.writing(), errors.writing(), parent);
  ::setpgid(id, id);  // parent and child both call it: either may come first
  return {id, input.take_unblocked(1), output.take_unblocked(0), errors.take_unblocked(0), input.take(0)};
}

}  // namespace fathom::harness
