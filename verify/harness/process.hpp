// SPDX-License-Identifier: GPL-3.0-or-later
// A child process connected by three pipes: lines are sent to it and read from it. Whatever the
// child does, the parent neither blocks nor ends.
//                                                                              [verify/PROTOCOL.md]
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace fathom::harness {

/// The end of a process. A shell's "128 + signal" counts as that signal.
struct Ending {
  bool by_signal = false;
  int number = 0;  ///< of the signal, or the exit code
  [[nodiscard]] bool in_good_order() const { return !by_signal && number == 0; }
};

/// Returns "killed by signal 11 (Segmentation fault)", "ended with exit code 3".
std::string described(const Ending& ending);

inline constexpr std::size_t longest_line = std::size_t{16} << 20;  ///< bytes
inline constexpr std::size_t kept_of_stderr = 4096;                 ///< bytes

/// A shell command in a process group of its own. For one thread at a time.
class Process {
 public:
  using Clock = std::chrono::steady_clock;
  enum class Got {
    line,
    end,       ///< of the output: it was closed, or the process ended
    time_out,  ///< the deadline passed before the line was whole
    too_long,  ///< longest_line passed without a newline
    stopped    ///< `stop` returned true
  };

  /// Runs `/bin/sh -c command`, or the program itself if the command is simple. Calls `stop`
  /// periodically while waiting. Throws std::system_error if no process can be started.
  explicit Process(const std::string& command, std::function<bool()> stop = {});
  /// Kills the remaining processes of the group.
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Queues the line and writes as much as the pipe takes. The rest is written while reading.
  void send(std::string_view line);
  /// Returns whether the process has read no byte of the line that was sent last. The process may
  /// have ended.
  [[nodiscard]] bool last_is_unread() const;
  /// Returns the number of bytes that were sent but not yet written to the pipe.
  [[nodiscard]] std::size_t unsent() const { return outgoing_.size() - sent_; }

  /// Reads the next line of its output, without the newline. After `end`, `line` holds what
  /// followed the last newline.
  Got read_line(std::string& line, Clock::time_point deadline);
  /// Returns the output that has arrived but has not been read as a line.
  const std::string& waiting();
  /// Returns whether the process has ended, or closed its output.
  [[nodiscard]] bool gone() const { return output_ < 0 || dead(); }

  /// Waits until it has ended; returns nullopt if it is still alive at the deadline.
  std::optional<Ending> ending(Clock::time_point deadline);
  /// Closes its input.
  void close_input();

  /// Returns the end of its standard error.
  std::string last_words();

 private:
  void pump(std::chrono::milliseconds patience);
  void write_some();
  void read_output();
  void read_errors();
  bool dead() const;

  std::function<bool()> stop_;
  pid_t id_ = -1;
  int input_ = -1, output_ = -1, errors_ = -1;  // -1: closed
  int inlet_ = -1;                              // the reading end of input_
  std::string outgoing_, incoming_, words_;
  std::size_t last_ = 0, sent_ = 0,
              searched_ =
                  0;  // last_: bytes of the line sent last; no newline in the first `searched_` bytes of incoming_
};

// ---- starting one ----

/// A shell command whose three standard streams are pipes to this process.
struct Spawned {
  pid_t id = -1;
  int input = -1, output = -1, errors = -1;  ///< the parent's ends: non-blocking, closed on exec
  int inlet = -1;  ///< the child's end of the input, kept to see how much of it is unread; closed on exec
};

/// Puts "exec" before a simple command (no lists, pipelines or substitutions) whose program exists,
/// so that no shell remains, which would keep open the streams that the program closes.
std::string without_shell(const std::string& command);

/// Runs `/bin/sh -c without_shell(command)` in a process group of its own, with default signal
/// actions, an empty signal mask, and no other open file. The kernel kills it if the calling thread
/// ends first. Throws std::system_error.
Spawned spawn(const std::string& command);

}  // namespace fathom::harness
