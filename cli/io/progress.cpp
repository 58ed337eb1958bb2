// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/io/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace fathom::cli {
namespace {

constexpr auto patience = std::chrono::seconds(1);
constexpr auto interval = std::chrono::milliseconds(200);
constexpr int longest_bar = 30, shortest_bar = 4, usual_columns = 80;

void put(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

int columns() {
  winsize size = {};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : usual_columns;
}

/// The first `most` characters of UTF-8.
std::string cut(const std::string& text, int most) {
  std::size_t end = 0;
  for (; end < text.size(); ++end) {
    const bool begins_character = (static_cast<unsigned char>(text[end]) & 0xc0) != 0x80;
    if (begins_character && most-- <= 0) break;
  }
  return text.substr(0, end);
}

}  // namespace

Progress::Progress() : answers_are_seen_(::isatty(STDOUT_FILENO) == 1) {
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

void Progress::report(std::string_view stage, double share) {
  const std::lock_guard lock(mutex_);
  stage_ = stage;
  share_ = std::min(share, 1.0);
  active_ = true;
}

void Progress::clear() {
  const std::lock_guard lock(mutex_);
  active_ = false;
  erase();
}

void Progress::answered() {
  if (answers_are_seen_) clear();
}

void Progress::keep_drawing() {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, interval, [this] { return stop_; })) {
    if (active_ && Clock::now() - begin_ >= patience) draw();
  }
}

void Progress::draw() {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - begin_).count();
  line_is_open(true);
  drawn_ = true;
  std::string before = what_, after = stage_ + (stage_.empty() ? "" : " ") + fmt::format("{} s", seconds);
  if (!before.empty()) before += ' ';
  const int width = columns() - 1;
  if (share_ >= 0) {
    const int room = width - static_cast<int>(before.size() + after.size()) - 8;
    const int bar = std::clamp(room, shortest_bar, longest_bar), filled = static_cast<int>(share_ * bar);
    before += fmt::format("[{:#<{}}{:.<{}}] {:3.0f}% ", "", filled, "", bar - filled, 100 * share_);
  }
  put("\r\033[K" + cut(before + after, width));
}

void Progress::erase() {
  if (!drawn_) return;
  put("\r\033[K");
  drawn_ = false;
  line_is_open(false);
}

}  // namespace fathom::cli
