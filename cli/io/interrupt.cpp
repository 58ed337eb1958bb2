// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <string_view>

#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"

namespace fathom::cli {
namespace {

// The handler may run on any thread.
std::atomic<int> working = 0;
std::atomic<unsigned> seconds_to_stop = 1;
std::atomic<bool> requested = false, open_line = false;
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<unsigned>::is_always_lock_free &&
              std::atomic<bool>::is_always_lock_free);

void say(std::string_view text) { [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size()); }

// Every result is flushed as soon as it is complete, so nothing is lost by leaving here.
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

}  // namespace

void install_signal_handlers() {
  handle(SIGPIPE, SIG_DFL);
  handle(SIGALRM, leave);
  // A shell starts background jobs with SIGINT ignored; keep that.
  struct sigaction before = {};
  if (::sigaction(SIGINT, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) handle(SIGINT, note_or_leave);
}

bool interrupt_requested() { return requested; }

void take_time_to_write() { ::alarm(0); }

Working::Working(unsigned patience) {
  seconds_to_stop = patience;
  ++working;
}
Working::~Working() { --working; }

void line_is_open(bool open) { open_line = open; }

}  // namespace fathom::cli
