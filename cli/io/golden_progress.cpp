// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/io/golden_progress.hpp"

#include <fmt/format.h>

namespace fathom::cli {
namespace {

constexpr auto interval = std::chrono::milliseconds(100);

}  // namespace

void GoldenProgress::report(std::size_t done, std::size_t all, const std::string& where) {
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < interval || done == 0) return;
  last_ = now;
  const double seconds = std::chrono::duration<double>(now - begin_).count(), rate = static_cast<double>(done) / seconds;
  progress_.about(where);
  progress_.report(fmt::format("{:.0f} {}/s, {:.0f} s left,", rate, units_, static_cast<double>(all - done) / rate),
                   static_cast<double>(done) / static_cast<double>(all));
}

}  // namespace fathom::cli
