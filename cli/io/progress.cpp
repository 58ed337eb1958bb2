// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/io/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <string_view>
#include <utility>

#include "cli/io/output.hpp"

namespace fathom::cli {
namespace {

// The handler may run on any thread.
std::atomic<int> working = 0;
std::atomic<unsigned> seconds_to_stop = 1;
std::atomic<bool> requested = false, open_line = false;
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<unsigned>::is_always_lock_free &&
              std::atomic<bool>::is_always_lock_free);

void say(std::string_view text) {
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
}

// Every result is flushed as soon as it is complete, so ending here loses nothing.
[[noreturn]] void leave(int) {
  if (open_line) say("\r\033[K");
  say("fathom: interrupted\n");
  ::_exit(interrupted);
}

void note_or_leave(int signal) {
  if (working == 0 || requested.exchange(true)) leave(signal);
  ::alarm(seconds_to_stop);
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  ::sigaction(signal, &action, nullptr);
}

constexpr auto patience = std::chrono::seconds(1);
constexpr auto interval = std::chrono::milliseconds(200);
constexpr std::size_t longest_bar = 30, shortest_bar = 4;
constexpr std::size_t around_bar = 8;  // "[] 100% "

void put(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

/// Returns "[####....]  50% ", as long as `room` allows.
std::string bar_text(double share, std::size_t room) {
  const std::size_t length = std::clamp(room, shortest_bar, longest_bar);
  const auto filled = static_cast<std::size_t>(share * static_cast<double>(length));
  return fmt::format("[{:#<{}}{:.<{}}] {:3.0f}% ", "", filled, "", length - filled, 100 * share);
}

/// Returns the first part, and those of the others that fit. A part is never cut, because half of a
/// number is another number.
std::string whole_parts(const std::vector<std::string>& parts, std::size_t room) {
  std::string text = parts.front();
  for (std::size_t i = 1; i < parts.size(); ++i)
    if (text.size() + parts[i].size() <= room) text += parts[i];
  return text;
}

/// Returns "40 s", "3 min 20 s", "2 h 5 min".
std::string duration_text(double seconds) {
  constexpr double longest = 1e9;
  const auto whole = static_cast<std::uint64_t>(std::clamp(seconds, 0.0, longest)), minutes = whole / 60,
             hours = minutes / 60;
  if (hours > 0) return fmt::format("{} h {} min", hours, minutes % 60);
  return minutes > 0 ? fmt::format("{} min {} s", minutes, whole % 60) : fmt::format("{} s", whole);
}

/// Sets whether the terminal shows an unfinished line, which is erased before a last message.
void line_is_open(bool open) { open_line = open; }

}  // namespace

void install_signal_handlers() {
  handle(SIGPIPE, SIG_DFL);
  handle(SIGALRM, leave);
  // A shell starts background jobs with SIGINT ignored; this is kept.
  struct sigaction before = {};
  if (::sigaction(SIGINT, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) handle(SIGINT, note_or_leave);
}

bool interrupt_requested() { return requested; }

void take_time_to_write() { ::alarm(0); }

InterruptGuard::InterruptGuard(unsigned patience) {
  seconds_to_stop = patience;
  ++working;
}
InterruptGuard::~InterruptGuard() { --working; }

Progress::Progress(std::string units) : units_(std::move(units)), answers_are_seen_(is_terminal(STDOUT_FILENO)) {
  if (is_terminal(STDERR_FILENO)) painter_ = std::thread([this] { keep_drawing(); });
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
  stage_.clear();
  share_ = -1;
  begin_of_case_ = Clock::now();
}

void Progress::report(std::string_view stage, double share) {
  const std::lock_guard lock(mutex_);
  stage_ = stage;
  share_ = share > 0 ? std::min(share, 1.0) : -1;
  active_ = true;
}

void Progress::count(const ProgressCount& count, std::string more) {
  const std::lock_guard lock(mutex_);
  count_ = count;
  if (count_->of && *count_->of < count.done) count_->of.reset();
  more_ = std::move(more);
  active_ = true;
}

void Progress::end_count() {
  const std::lock_guard lock(mutex_);
  count_.reset();
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

/// Returns "12 of 500 cases", ", 3.2/s", ", 2 min 30 s left".
std::vector<std::string> Progress::counted_parts(double seconds) const {
  const auto& [done, of, before] = *count_;
  const double rate = static_cast<double>(done - std::min(before, done)) / seconds;
  std::vector<std::string> parts{of ? fmt::format("{} of {} {}", done, *of, units_)
                                    : fmt::format("{} {}", done, units_)};
  if (rate > 0) parts.push_back(fmt::format(", {:.3g}/s", rate));
  if (rate > 0 && of)
    parts.push_back(fmt::format(", {} left", duration_text(std::ceil(static_cast<double>(*of - done) / rate))));
  if (!of) parts.push_back(", " + duration_text(seconds));
  if (!more_.empty()) parts.push_back(", " + more_);
  return parts;
}

/// Returns "line 12: hull of all differences 40%, 3 s" for a case that takes long, or "".
std::string Progress::stage_text() const {
  const auto time = Clock::now() - begin_of_case_;
  if (what_.empty() || (count_ && time < patience)) return "";
  std::string text = what_ + (stage_.empty() ? "" : ": " + stage_);
  if (share_ >= 0) text += fmt::format(" {:.0f}%", 100 * share_);
  return text + ", " + duration_text(std::chrono::duration<double>(time).count());
}

void Progress::draw() {
  const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
  line_is_open(true);
  drawn_ = true;
  double share = share_;
  std::vector<std::string> parts;
  if (count_) {
    share = count_->of && *count_->of > 0 ? static_cast<double>(count_->done) / static_cast<double>(*count_->of) : -1;
    parts = counted_parts(seconds);
    if (const std::string stage = stage_text(); !stage.empty()) parts.push_back("; " + stage);
  } else {
    parts.push_back(what_ + (what_.empty() ? "" : ": ") + stage_ + (stage_.empty() ? "" : ", ") +
                    duration_text(seconds));
  }
  const std::size_t width = terminal_columns(STDERR_FILENO) - 1;  // a full line would scroll
  const std::size_t of_bar = shortest_bar + around_bar;
  const bool has_bar = share >= 0 && parts.front().size() + of_bar <= width;
  std::string text = whole_parts(parts, has_bar ? width - of_bar : width);
  if (has_bar) text.insert(0, bar_text(share, width - text.size() - around_bar));
  put("\r\033[K" + std::string(cut(text, width)));
}

void Progress::erase() {
  if (!drawn_) return;
  put("\r\033[K");
  drawn_ = false;
  line_is_open(false);
}

}  // namespace fathom::cli
