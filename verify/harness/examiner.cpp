// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/examiner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>
#include <utility>

#include "reference/files/source.hpp"
#include "verify/harness/seen_case.hpp"

namespace fathom::harness {
namespace {

using Clock = Process::Clock;

constexpr auto grace = std::chrono::seconds(1);  // to end after "stop", or after the output was closed
constexpr int most_starts = 3;                   // in a row, of a subject that had said hello before

Clock::duration duration(double seconds) {
  constexpr double longest = 1e8;  // three years; the clock counts nanoseconds in 64 bits
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(std::clamp(seconds, 0.0, longest)));
}

std::string first_line(const std::string& text) { return shown(text.substr(0, text.find('\n'))); }

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// The number of a run that was answered before by the same process.
bool is_between(const std::string& ticket, std::uint64_t first, std::uint64_t current) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(ticket.data(), ticket.data() + ticket.size(), number);
  return error == std::errc() && end == ticket.data() + ticket.size() && first <= number && number < current;
}

}  // namespace

Examiner::Examiner(Command command, Settings settings) : command_(std::move(command)), settings_(std::move(settings)) { start(); }

Examiner::~Examiner() {
  if (!process_) return;
  process_->send(stop_message());
  process_->close_input();
  process_->ending(Clock::now() + grace);
}

std::string Examiner::with_last_words(std::string sentence) {
  constexpr std::size_t shown_bytes = 300;
  std::string words = process_->last_words();
  words.erase(words.find_last_not_of(" \r\n\t") + 1);
  if (words.empty()) return sentence;
  if (words.size() > shown_bytes) words.erase(0, words.size() - shown_bytes);
  std::replace(words.begin(), words.end(), '\n', ' ');
  return sentence + "; last words: " + printable(words, shown_bytes);
}

void Examiner::start() {
  process_.reset();
  try {
    process_ = std::make_unique<Process>(command_.shell, settings_.stop);
  } catch (const std::system_error& error) {
    throw SubjectError(std::string("the subject cannot be started: ") + error.what());
  }
  ++starts_;
  first_ticket_ = tickets_ + 1;
  const double patience = std::max(settings_.time_out, settings_.hello_time_out);
  process_->send(hello_message());
  std::string line;
  const Process::Got got = process_->read_line(line, Clock::now() + duration(patience));
  if (got == Process::Got::stopped) throw Interrupted();
  if (got == Process::Got::time_out) throw SubjectError(with_last_words(fmt::format("the subject said no hello within {} s", patience)));
  if (got == Process::Got::too_long) throw SubjectError("the subject's first line is no hello: it does not end");
  if (got == Process::Got::end) {
    const std::optional<Ending> ending = process_->ending(Clock::now() + grace);
    throw SubjectError(with_last_words("the subject said no hello: " + (ending ? described(*ending) : "closed its output")));
  }
  try {
    SubjectInfo info = read_hello(line);
    if (starts_ > 1 && hello_text(info) != hello_text(info_))
      throw SubjectError("the subject says something else of itself each time that it is started: first " + hello_text(info_) + ", then " +
                         hello_text(info));
    info_ = std::move(info);
  } catch (const ProtocolError& error) {
    throw SubjectError(with_last_words(std::string("the subject's hello is wrong: ") + error.what()));
  }
}

Outcome Examiner::examine(const Case& pair) {
  const std::optional<Case> seen = as_seen(pair, info_.precision);
  return seen ? ask(*seen) : overflowed(pair, info_.precision);
}

Outcome Examiner::ask(const Case& seen) {
  Outcome outcome = outcome_for(seen);
  // What an earlier case left behind is not this one's fault: a fresh process decides.
  if (!ask_once(seen, outcome)) ask_once(seen, outcome);
  return outcome;
}

void Examiner::start_again(const std::string& why) {
  process_.reset();
  if (!why.empty() && settings_.note) settings_.note(why + "; it is started again");
  for (int tries = 1; !process_; ++tries) {
    try {
      start();
    } catch (const SubjectError&) {
      process_.reset();
      if (tries == most_starts) throw;
    }
  }
}

/// False if the process showed that it was not in order before it got the case; then nothing is said of the case, and it is fresh now.
bool Examiner::ask_once(const Case& seen, Outcome& outcome) {
  if (!process_) start_again("");
  else if (!process_->waiting().empty()) start_again("between two cases the subject wrote " + first_line(process_->waiting()));
  else if (process_->gone()) start_again("the subject ended between two cases");
  if (const std::string& unasked = process_->waiting(); !unasked.empty()) {
    blame(outcome, Verdict::garbage, "written before the case was sent: " + first_line(unasked));
    return true;
  }
  const std::string ticket = std::to_string(++tickets_);
  const std::string message = run_message(ticket, seen, info_.precision, info_.wants_faces);
  const Clock::time_point begin = Clock::now();
  process_->send(message);
  std::string line;
  const Process::Got got = process_->read_line(line, begin + duration(settings_.time_out));
  outcome.seconds = seconds_since(begin);
  switch (got) {
    case Process::Got::line: return understand(line, ticket, seen, outcome);
    case Process::Got::stopped: throw Interrupted();
    case Process::Got::end: {
      const bool fresh = tickets_ == first_ticket_;
      blame_the_end(outcome, line);
      if (outcome.verdict != Verdict::silent || fresh) return true;
      start_again("the subject ended after some cases, without a word on the next");
      return false;
    }
    case Process::Got::too_long: blame(outcome, Verdict::garbage, fmt::format("a line of more than {} bytes", longest_line)); return true;
    case Process::Got::time_out: break;
  }
  std::string detail = fmt::format("no answer within {} s", settings_.time_out);
  if (process_->unsent() > 0)
    detail += fmt::format("; it has not read the last {} of the case's {} bytes", process_->unsent(), message.size());
  blame(outcome, Verdict::time_out, with_last_words(detail));
  return true;
}

bool Examiner::understand(const std::string& line, const std::string& ticket, const Case& seen, Outcome& outcome) {
  std::optional<Answer> answer;
  try {
    answer = read_reply(line, info_.precision);
  } catch (const ProtocolError& error) {
    blame(outcome, Verdict::garbage, with_last_words(error.what()));
    return true;
  }
  if (answer->ticket != ticket) {
    if (is_between(answer->ticket, first_ticket_, tickets_)) {
      start_again("the subject answered an earlier case again: " + shown(line));
      return false;
    }
    blame(outcome, Verdict::garbage, fmt::format("expected the reply to run {}, found one to {}", ticket, shown(answer->ticket)));
    return true;
  }
  if (const std::string& more = process_->waiting(); !more.empty()) {
    blame(outcome, Verdict::garbage, "more than its reply: " + first_line(more));
    return true;
  }
  judge_answer(outcome, seen, *answer, info_, settings_.tolerance, settings_.stop);
  return true;
}

void Examiner::blame(Outcome& outcome, Verdict verdict, std::string detail) {
  outcome.verdict = verdict;
  outcome.detail = std::move(detail);
  process_.reset();
}

void Examiner::blame_the_end(Outcome& outcome, const std::string& rest) {
  const std::optional<Ending> ending = process_->ending(Clock::now() + grace);
  const std::string how = ending ? described(*ending) : "closed its output and lived on";
  if (ending && !ending->in_good_order()) return blame(outcome, Verdict::crash, with_last_words(how));
  if (!rest.empty()) return blame(outcome, Verdict::garbage, with_last_words("a line that was cut off: " + shown(rest)));
  blame(outcome, Verdict::silent, with_last_words(how));
}

}  // namespace fathom::harness
