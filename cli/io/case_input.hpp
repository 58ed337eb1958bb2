// SPDX-License-Identifier: GPL-3.0-or-later
// Where cases come from: a file, a pipe or standard input, read so that Ctrl-C ends the waiting.
#pragma once

#include <unistd.h>

#include <array>
#include <cstddef>
#include <functional>
#include <istream>
#include <optional>
#include <streambuf>
#include <string>

#include "cli/io/progress.hpp"
#include "reference/files/cases.hpp"

namespace fathom::cli {

/// Reads a file descriptor, which stays the caller's; standard input unless another is given.
/// Throws Interrupted once `stopped` returns true, even if nothing comes. Throws InputError if it
/// cannot be read. A stream passes these on if its exceptions() have badbit.
class InterruptibleInput : public std::streambuf {
 public:
  explicit InterruptibleInput(std::function<bool()> stopped = interrupt_requested, int descriptor = STDIN_FILENO)
      : stopped_(std::move(stopped)), descriptor_(descriptor) {}

 protected:
  int_type underflow() override;

 private:
  std::function<bool()> stopped_;
  int descriptor_;
  std::array<char, 1 << 16> buffer_;
};

// The input of a stream of cases. To wait for a pipe can be stopped.

class CaseInput {
 public:
  /// Opens the file, or the pipe, called `path`; "-" is standard input. Throws InputError if it
  /// cannot be read. Once `stopped` returns true, nothing more can be read.
  CaseInput(const std::string& path, std::function<bool()> stopped);
  ~CaseInput();
  CaseInput(const CaseInput&) = delete;
  CaseInput& operator=(const CaseInput&) = delete;

  /// The cases of this input, which must outlive them. Call it once.
  [[nodiscard]] files::UnreadCases texts();

 private:
  std::string path_;
  int descriptor_ = -1;  ///< of a pipe with a name
  InterruptibleInput buffer_;
  std::istream stream_{&buffer_};
};

// How many cases a file holds, for the progress line.

/// Returns how many lines of the file begin with a brace: so many cases there are if each has a
/// line of its own, or is indented as usual. Returns nullopt if there are none, and for what can be
/// read only once.
std::optional<std::size_t> cases_in(const std::string& path);

}  // namespace fathom::cli
