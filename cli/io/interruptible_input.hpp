// SPDX-License-Identifier: GPL-3.0-or-later
// Input for a run that must not wait for it in vain: one that must end with its reports, or that other threads have ended.
#pragma once

#include <unistd.h>

#include <array>
#include <functional>
#include <streambuf>

#include "cli/io/progress.hpp"

namespace fathom::cli {

/// Reads a file descriptor, which stays the caller's; standard input unless another is given. Throws Interrupted once `stopped` returns
/// true, even if nothing comes. Throws InputError if it cannot be read. A stream passes these on if its exceptions() have badbit.
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

}  // namespace fathom::cli
