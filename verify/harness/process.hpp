// SPDX-License-Identifier: GPL-3.0-or-later
// One child process behind three pipes: lines go in, lines come out. Whatever the child does, its
// parent neither blocks nor ends.
//                                                                              [verify/PROTOCOL.md]
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace fathom::harness {

/// How a process ended. A shell's "128 + signal" counts as that signal.
struct Ending {
  bool by_signal = false;
  int number = 0;  ///< of the signal, or the exit code
  [[nodiscard]] bool in_good_order() const { return !by_signal && number == 0; }
};

/// "killed by signal 11 (Segmentation fault)", "ended with exit code 3".
std::string described(const Ending& ending);

inline constexpr std::size_t longest_line = std::size_t{16} << 20;  ///< bytes
inline constexpr std::size_t kept_of_stderr = 4096;                 ///< bytes

/// A shell command in a process group of its own. Not for two threads at once.
class Process {
 public:
  using Clock = std::chrono::steady_clock;
  enum class Got {
    line,
    end,       ///< of the output: it was closed, or the process ended
    time_out,  ///< the deadline passed before the line was whole
    too_long,  ///< longest_line passed without a newline
    stopped    ///< as asked for by `stop`
  };

  /// Runs `/bin/sh -c command`, or the program itself if the command is a simple one. Asks `stop`
  /// now and then while waiting. Throws std::system_error if no process can be started.
  explicit Process(const std::string& command, std::function<bool()> stop = {});
  /// Kills what is left of the process group.
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Queues the line and writes as much as the pipe takes. The rest is written while reading.
  void send(std::string_view line);
  /// Whether the process has read no byte of the line that was sent last. It may have ended.
  [[nodiscard]] bool last_is_unread() const;
  /// Bytes that were sent but not yet written to the pipe.
  [[nodiscard]] std::size_t unsent() const { return outgoing_.size() - sent_; }

  /// Reads the next line of its output, without the newline. After `end`, `line` holds what
  /// followed the last newline.
  Got read_line(std::string& line, Clock::time_point deadline);
  /// The output that has arrived so far and has not been read as a line.
  const std::string& waiting();
  /// Whether it has ended, or closed its output, by now.
  [[nodiscard]] bool gone() const { return output_ < 0 || dead(); }

  /// Waits until it has ended; returns nullopt if it is still alive at the deadline.
  std::optional<Ending> ending(Clock::time_point deadline);
  /// Closes its input.
  void close_input();

  /// The last bytes that it wrote to standard error.
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
  int inlet_ = -1;                              // the end of the input that the process reads from
  std::string outgoing_, incoming_, words_;
  std::size_t last_ = 0, sent_ = 0,
              searched_ =
                  0;  // last_: bytes of the line sent last; no newline in the first `searched_` bytes of incoming_
};

// ---- starting one ----

/// A shell command whose three standard streams are pipes of ours.
struct Spawned {
  pid_t id = -1;
  int input = -1, output = -1, errors = -1;  ///< our ends: non-blocking, closed on exec
  int inlet = -1;  ///< its own end of the input, to see how much of it is unread; closed on exec
};

/// Puts "exec" before a simple command (no lists, pipelines or substitutions) whose program exists.
/// Then no shell stays behind, which would hold the streams open that the program closes.
std::string without_shell(const std::string& command);

/// Runs `/bin/sh -c without_shell(command)` in a process group of its own, with default signal
/// actions, an empty signal mask, and no other open file. The kernel kills it if the calling thread
/// ends first. Throws std::system_error.
Spawned spawn(const std::string& command);

}  // namespace fathom::harness
