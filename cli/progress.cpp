// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "cli/interrupt.hpp"

namespace fathom::cli {
namespace {

constexpr auto patience = std::chrono::seconds(1);
constexpr auto interval = std::chrono::milliseconds(200);
constexpr int bar_width = 30;

void put(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace

Progress::Progress() {
  if (::isatty(STDERR_FILENO) == 1) painter_ = std::thread([this] { keep_drawing(); });
}

Progress::~Progress() {
  clear();
  if (!painter_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_one();
  painter_.join();
}

void Progress::about(std::string what) {
  const std::lock_guard lock(mutex_);
  what_ = std::move(what);
}

bool Progress::report(const std::string& stage, double share) {
  const std::lock_guard lock(mutex_);
  stage_ = stage;
  share_ = std::min(share, 1.0);
  active_ = true;
  return !interrupt_requested();
}

void Progress::clear() {
  const std::lock_guard lock(mutex_);
  active_ = false;
  erase();
}

void Progress::keep_drawing() {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, interval, [this] { return stop_; })) {
    if (active_ && Clock::now() - begin_ >= patience) draw();
  }
}

void Progress::draw() {
  const int filled = static_cast<int>(std::max(share_, 0.0) * bar_width);
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - begin_).count();
  line_is_open(true);
  drawn_ = true;
  const std::string what = what_.empty() ? "" : what_ + " ";
  if (share_ < 0) return put(fmt::format("\r\033[K{}{} {} s", what, stage_, seconds));
  put(fmt::format("\r\033[K{}[{:#<{}}{:.<{}}] {:3.0f}% {} {} s", what, "", filled, "", bar_width - filled, 100 * share_, stage_, seconds));
}

void Progress::erase() {
  if (!drawn_) return;
  put("\r\033[K");
  drawn_ = false;
  line_is_open(false);
}

}  // namespace fathom::cli
