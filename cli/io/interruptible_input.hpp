// SPDX-License-Identifier: GPL-3.0-or-later
// Standard input for a run that must not end without its reports while it waits for the next case.
#pragma once

#include <array>
#include <streambuf>

namespace fathom::cli {

/// Reads standard input, and throws Interrupted once a SIGINT has been noted, even if nothing comes. Throws InputError if it cannot be
/// read. A stream passes these on if its exceptions() have badbit.
class InterruptibleInput : public std::streambuf {
 protected:
  int_type underflow() override;

 private:
  std::array<char, 1 << 16> buffer_;
};

}  // namespace fathom::cli
