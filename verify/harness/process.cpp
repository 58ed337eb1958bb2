// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

namespace fathom::harness {
namespace {

[[noreturn]] void refuse(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

/// Both ends of a pipe, closed by the destructor unless taken.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) refuse("cannot make a pipe");
    // The child's end must not be one of the standard streams, which dup2 would overwrite.
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
  /// Returns an end, which the caller must close.
  int take(int which) { return std::exchange(ends_[which], -1); }
  /// Does the same, and makes the end non-blocking.
  int take_unblocked(int which) {
    const int end = take(which);
    ::fcntl(end, F_SETFL, ::fcntl(end, F_GETFL) | O_NONBLOCK);
    return end;
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

/// Runs in the child between fork and exec. Makes system calls only, because other threads of the
/// parent may have held any lock.
[[noreturn]] void become(const char* const* words, int input, int output, int errors, pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);
  for (const int signal : {SIGPIPE, SIGINT, SIGQUIT, SIGTERM, SIGHUP, SIGCHLD, SIGALRM}) ::signal(signal, SIG_DFL);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  if (::dup2(input, STDIN_FILENO) >= 0 && ::dup2(output, STDOUT_FILENO) >= 0 && ::dup2(errors, STDERR_FILENO) >= 0) {
    ::close_range(STDERR_FILENO + 1, ~0U, 0);  // for example the stream of cases, which may hold the answers
    ::execv(words[0], const_cast<char* const*>(words));
  }
  ::_exit(127);
}

bool is_program(const std::string& path) {
  struct stat found = {};
  return ::stat(path.c_str(), &found) == 0 && S_ISREG(found.st_mode) && ::access(path.c_str(), X_OK) == 0;
}

/// Returns whether there is a program of this name, which a shell would start: then the name is
/// taken to be no keyword and no function of the shell.
bool is_found(const std::string& name) {
  if (name.empty() || name.find('/') != std::string::npos) return is_program(name);
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (is_program((folder.empty() ? "." : folder) + '/' + name)) return true;
  return false;
}

/// Returns the first word of a command, without its quotation marks. Empty if the command is more
/// than words and redirections to and from files.
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

using std::chrono::milliseconds;

constexpr milliseconds slice(20);  // between two checks of whether the process has ended, and of `stop`
constexpr std::size_t most_at_once = 1 << 16;

void close_end(int& end) {
  if (end >= 0) ::close(std::exchange(end, -1));
}

/// Appends at most `most` bytes that can be read now. Returns false at the end of the input.
bool read_some(int end, std::string& to, std::size_t most) {
  std::array<char, most_at_once> piece;
  const ssize_t got = ::read(end, piece.data(), std::min(most, piece.size()));
  if (got > 0) to.append(piece.data(), static_cast<std::size_t>(got));
  return got > 0 || (got < 0 && (errno == EAGAIN || errno == EINTR));
}

}  // namespace

std::string without_shell(const std::string& command) {
  return (is_found(only_program(command)) ? "exec " : "") + command;
}

Spawned spawn(const std::string& command) {
  Pipe input, output, errors;
  const std::string text = without_shell(command);
  const char* const words[] = {"/bin/sh", "-c", text.c_str(), nullptr};
  const pid_t parent = ::getpid();
  const pid_t id = ::fork();
  if (id < 0) refuse("cannot start a process");
  if (id == 0) become(words, input.reading(), output.writing(), errors.writing(), parent);
  ::setpgid(id, id);  // called by parent and child, as either may run first
  return {id, input.take_unblocked(1), output.take_unblocked(0), errors.take_unblocked(0), input.take(0)};
}

std::string described(const Ending& ending) {
  if (!ending.by_signal) return fmt::format("ended with exit code {}", ending.number);
  const char* const name = ::sigdescr_np(ending.number);
  return name ? fmt::format("killed by signal {} ({})", ending.number, name)
              : fmt::format("killed by signal {}", ending.number);
}

Process::Process(const std::string& command, std::function<bool()> stop) : stop_(std::move(stop)) {
  const Spawned child = spawn(command);
  id_ = child.id;
  input_ = child.input;
  output_ = child.output;
  errors_ = child.errors;
  inlet_ = child.inlet;
}

Process::~Process() {
  ::kill(-id_, SIGKILL);  // before waitpid: until then no other group can have this number
  for (int* end : {&input_, &output_, &errors_, &inlet_}) close_end(*end);
  while (::waitpid(id_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

void Process::send(std::string_view line) {
  outgoing_.erase(0, std::exchange(sent_, 0));
  outgoing_.append(line);
  outgoing_ += '\n';
  last_ = line.size() + 1;
  write_some();
}

bool Process::last_is_unread() const {
  int in_pipe = 0;
  ::ioctl(inlet_, FIONREAD, &in_pipe);
  return static_cast<std::size_t>(in_pipe) + unsent() >= last_;
}

/// Writes without blocking. No SIGPIPE comes if the process has ended, because this process holds
/// the reading end too.
void Process::write_some() {
  while (input_ >= 0 && unsent() > 0) {
    const ssize_t written = ::write(input_, outgoing_.data() + sent_, std::min(unsent(), most_at_once));
    if (written > 0) sent_ += static_cast<std::size_t>(written);
    else if (errno == EAGAIN) return;
    else if (errno != EINTR) close_input();
  }
}

void Process::close_input() { close_end(input_); }

void Process::read_output() {
  if (!read_some(output_, incoming_, longest_line + 1 - std::min(incoming_.size(), longest_line))) close_end(output_);
}

void Process::read_errors() {
  if (!read_some(errors_, words_, most_at_once)) close_end(errors_);
  if (words_.size() > kept_of_stderr) words_.erase(0, words_.size() - kept_of_stderr);
}

/// Reads and writes once whatever is ready; waits at most `patience` until something is.
void Process::pump(milliseconds patience) {
  pollfd ends[] = {{unsent() > 0 ? input_ : -1, POLLOUT, 0}, {output_, POLLIN, 0}, {errors_, POLLIN, 0}};
  if (::poll(ends, std::size(ends), static_cast<int>(patience.count())) <= 0) return;
  if (ends[0].revents != 0) write_some();
  if (ends[1].revents != 0) read_output();
  if (ends[2].revents != 0) read_errors();
}

bool Process::dead() const {
  siginfo_t info = {};
  return ::waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == id_;
}

Process::Got Process::read_line(std::string& line, Clock::time_point deadline) {
  for (bool late = false;;) {
    const std::size_t newline = incoming_.find('\n', searched_);
    if (newline != std::string::npos) {
      line = incoming_.substr(0, newline);
      incoming_.erase(0, newline + 1);
      searched_ = 0;
      return Got::line;
    }
    searched_ = incoming_.size();
    if (incoming_.size() > longest_line) return Got::too_long;
    if (output_ < 0) {
      line = std::exchange(incoming_, {});
      searched_ = 0;
      return Got::end;
    }
    if (late) return Got::time_out;
    if (stop_ && stop_()) return Got::stopped;
    const auto left = std::chrono::ceil<milliseconds>(deadline - Clock::now());
    late = left <= milliseconds(0);
    const bool ended = dead();  // asked before reading, so that all that it wrote before its end is read
    pump(ended ? milliseconds(0) : std::clamp(left, milliseconds(0), slice));
    // A child of the process may keep the pipe open for ever.
    if (ended && incoming_.size() == searched_) close_end(output_);
  }
}

const std::string& Process::waiting() {
  pump(milliseconds(0));
  return incoming_;
}

std::optional<Ending> Process::ending(Clock::time_point deadline) {
  while (!dead()) {
    if (Clock::now() >= deadline || (stop_ && stop_())) return std::nullopt;
    if (output_ >= 0) read_output();  // otherwise the process could wait for us to read
    incoming_.clear();
    searched_ = 0;
    pump(milliseconds(1));
    ::poll(nullptr, 0, 1);
  }
  siginfo_t info = {};
  ::waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOHANG | WNOWAIT);
  if (info.si_code != CLD_EXITED) return Ending{true, info.si_status};
  constexpr int shells_offset = 128;
  const bool told_by_shell = info.si_status > shells_offset && ::sigdescr_np(info.si_status - shells_offset) != nullptr;
  return told_by_shell ? Ending{true, info.si_status - shells_offset} : Ending{false, info.si_status};
}

std::string Process::last_words() {
  constexpr int enough = 16;  // the process may write for ever
  pollfd end = {errors_, POLLIN, 0};
  for (int i = 0; i < enough && errors_ >= 0 && ::poll(&end, 1, 0) > 0; ++i) read_errors();
  return words_;
}

}  // namespace fathom::harness
