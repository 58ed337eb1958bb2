// SPDX-License-Identifier: GPL-3.0-or-later
// The progress bar of `fathom golden`, with the rate and the time left at that rate.
#pragma once

#include <chrono>
#include <string>

#include "cli/io/progress.hpp"

namespace fathom::cli {

class GoldenProgress {
 public:
  /// `units`: what is counted, for the bar.
  explicit GoldenProgress(std::string units) : units_(std::move(units)) {}
  /// `done` of `all` units; `where` says what is being worked on. From one thread at a time.
  void report(std::size_t done, std::size_t all, const std::string& where);

 private:
  Progress progress_;
  std::string units_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now(), last_ = begin_;
};

}  // namespace fathom::cli
