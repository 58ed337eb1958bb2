// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/examiner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <iostream>
#include <iterator>
#include <mutex>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <variant>

#include "fathom/shape.hpp"
#include "kernels/messages.hpp"
#include "reference/answer/plane.hpp"
#include "reference/files/file_io.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/shapes/core.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/journal.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/harness/variants.hpp"
#include "verify/judge/measures.hpp"
#include "verify/judge/scene.hpp"

namespace fathom::harness {
namespace {

using Clock = Process::Clock;

constexpr auto grace = std::chrono::seconds(1);          // to end after it closed its output
constexpr auto grace_to_stop = std::chrono::seconds(5);  // to end after "stop"
constexpr int most_starts = 3;                           // in a row, of a subject that had sent a hello before
constexpr int most_faults = 4;                           // of one case; the last of them is its outcome

Clock::duration duration(double seconds) {
  constexpr double longest = 1e8;  // three years; the clock counts nanoseconds in 64 bits
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(std::clamp(seconds, 0.0, longest)));
}

/// Returns the beginning of a line of the subject, in quotes.
std::string excerpt(std::string_view line) {
  constexpr std::size_t shown_bytes = 200;
  return '\'' + kernels::printable(line, shown_bytes) + '\'';
}

/// Returns an integer that is different for each run of a process. Its last six digits come from
/// the case, so that a process cannot know them before it reads the case: an unasked line, such as
/// a second copy of a reply, does not answer the next case.
std::string ticket_of(std::uint64_t number, const std::string& digest) {
  constexpr std::uint64_t most = 1'000'000;
  return fmt::format("{}{:06}", number, std::stoull(digest, nullptr, 16) % most);
}

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

mpq_class extent_of(const Body& body) {
  if (body.pieces) return judging::sizes_of(*body.pieces, *body.pieces).extent;
  if (body.shape) return judging::sizes_of(*body.shape, *body.shape, judging::usual_bits, body.dimension).extent;
  return judging::sizes_of(body.points, body.points).extent;
}

bool has_usual_size(const Body& body) {
  if (shapes::is_halfspace(body)) return true;
  const mpq_class longest = extent_of(body);
  return longest >= mpq_class(1, 100) && longest <= 100;
}

// Reports count separately the cases for which every engine is made. [docs/certify.md]

/// Returns whether both bodies have a volume, or in the plane an area, exactly.
bool is_solid(const Case& pair) { return !answer::is_flat_body(pair.a) && !answer::is_flat_body(pair.b); }

/// Returns whether the length exceeds the longest side of the bodies' bounding boxes.
bool is_dwarfed_by(const mpq_class& length, const Case& pair) { return length > 0 && length > sizes_of(pair).extent; }

/// Returns whether the longest side of each body's bounding box is from 1/100 to 100, in the
/// numbers of the case. Exact for points; sides of shapes are rounded up by a factor of at most 1 +
/// 2^-40. A half-space has any size.
bool is_metre_sized(const Case& pair) { return has_usual_size(pair.a) && has_usual_size(pair.b); }

class Run {
 public:
  explicit Run(const RunPlan& plan) : plan_(plan) {}

  void work() {
    try {
      const Worker worker = make_worker();
      while (const std::optional<Case> pair = next()) examine_guarded(*pair, worker.examine);
      if (worker.finish) worker.finish();
    } catch (...) {
      const std::lock_guard lock(results_);
      if (!error_) error_ = std::current_exception();
      ended_ = true;
    }
  }

  void finish() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  Worker make_worker() {
    const std::lock_guard lock(source_);
    return plan_.worker();
  }

  std::optional<Case> next() {
    const std::lock_guard lock(source_);
    if (ended_) return std::nullopt;
    std::optional<Case> pair = plan_.next();
    if (!pair) ended_ = true;
    return pair;
  }

  void examine_guarded(const Case& pair, const ExamineInUnit& examine) {
    try {
      examine_all(pair, examine);
    } catch (...) {
      const std::lock_guard lock(results_);
      plan_.fault(pair, std::current_exception());
    }
  }

  /// Examines the case and its variants.
  void examine_all(const Case& pair, const ExamineInUnit& examine) {
    std::string why;
    const long exponent = exponent_to_fit(pair, plan_.fit);
    const NumberFormat format = in_unit(plan_.format, exponent);
    const std::optional<Case> seen = as_seen(pair, format, plan_.shapes, &why, plan_.dimension);
    if (!seen) {
      outcome_of(pair, pair, "", [&] { return declined(pair, why); });
      return;
    }
    bool fresh = exponent == 0;  // in another unit a report may have fewer digits of an answer
    const auto ask = [&] {
      fresh = true;
      return examine(*seen, exponent);
    };
    Outcome original = outcome_of(*seen, *seen, "", ask);
    if (plan_.variants.empty()) return;
    std::vector<std::string> sentences;
    for (const Variant& variant : variants(*seen, format, plan_.variants, &sentences)) {
      outcome_of(*seen, variant.seen, variant.name, [&] {
        if (!fresh) original = ask();
        return compare_variant(original, examine(variant.seen, exponent), variant, plan_.tolerance, plan_.manifold);
      });
    }
    const std::lock_guard lock(results_);
    for (const std::string& sentence : sentences) plan_.left_out(pair, sentence);
  }

  template <class Find>
  Outcome outcome_of(const Case& original, const Case& seen, const std::string& variant, const Find& find) {
    const Outcome* known = plan_.known ? plan_.known(seen.id, variant, digest_of(seen)) : nullptr;
    Outcome outcome = known ? *known : find();
    outcome.variant = variant;
    tell(original, seen, outcome, known != nullptr);
    return outcome;
  }

  void tell(const Case& original, const Case& seen, Outcome& outcome, bool known) {
    outcome.solid = is_solid(original);
    outcome.metre_sized = is_metre_sized(original);
    outcome.dwarfed = is_dwarfed_by(outcome.radii, original);
    const std::lock_guard lock(results_);
    plan_.found(original, seen, outcome, known);
  }

  const RunPlan& plan_;
  std::mutex source_, results_;
  std::atomic<bool> ended_ = false;
  std::exception_ptr error_;
};

}  // namespace

Examiner::Examiner(SubjectCommand command, Settings settings)
    : command_(std::move(command)), settings_(std::move(settings)) {
  start();
}

Examiner::~Examiner() {
  if (!process_) return;
  process_->send(stop_message());
  process_->close_input();
  process_->ending(Clock::now() + grace);
}

void Examiner::finish() {
  if (!process_) return;
  process_->send(stop_message());
  process_->close_input();
  std::string line;
  const Process::Got got = process_->read_line(line, Clock::now() + grace_to_stop);
  std::optional<Fault> found;
  if (got == Process::Got::line) found = fault(Verdict::garbage, "wrote " + excerpt(line));
  if (got == Process::Got::end) found = fault_of_end(line);
  // The process ended normally, without an answer: silent.
  const bool is_well = found && found->verdict == Verdict::silent && !found->unread;
  // If it wrote a line, it is not known how it ended.
  if (found && !is_well)
    report_unattributed(*found, found->unread || found->verdict == Verdict::garbage ? "" : "after stop: ");
  process_.reset();
}

/// Returns "; last words: ...", with the end of its standard error, or "".
std::string Examiner::last_words() {
  constexpr std::size_t shown_bytes = 300;
  std::string words = process_->last_words();
  words.erase(words.find_last_not_of(" \r\n\t") + 1);
  if (words.empty()) return "";
  if (words.size() > shown_bytes) words.erase(0, words.size() - shown_bytes);
  std::replace(words.begin(), words.end(), '\n', ' ');
  return "; last words: " + kernels::printable(words, shown_bytes);
}

/// Returns "; 7 bytes came, no end of line: '...'".
std::string Examiner::unfinished_line() {
  const std::string& line = process_->waiting();
  return line.empty() ? "; no byte came: does it flush its output?"
                      : fmt::format("; {} bytes came, no end of line: {}", line.size(), excerpt(line));
}

/// Reads up to the first line that begins as a JSON object does. Other lines cannot be messages,
/// and are skipped.
Process::Got Examiner::read_message(std::string& line, Clock::time_point deadline) {
  passed_over_.clear();
  while (true) {
    const Process::Got got = process_->read_line(line, deadline);
    if (got != Process::Got::line || line.substr(0, line.find_first_not_of(" \t\r") + 1).ends_with('{')) return got;
    if (passed_over_.empty())
      passed_over_ = "what the subject wrote before its hello is no JSON object, and passed over: " + excerpt(line);
    else if (!passed_over_.ends_with(", ...")) passed_over_ += ", ...";
    if (settings_.stop && settings_.stop()) return Process::Got::stopped;
    if (Clock::now() >= deadline) return Process::Got::time_out;  // the process may write for ever
  }
}

void Examiner::start() {
  process_.reset();
  try {
    process_ = std::make_unique<Process>(command_.shell, settings_.stop);
  } catch (const std::system_error& error) {
    throw SubjectError(std::string("the subject cannot be started: ") + error.what());
  }
  ++starts_;
  asked_ = 0;
  answered_.reset();
  const double patience = std::max(settings_.time_out, settings_.hello_time_out);
  process_->send(hello_message());
  std::string line;
  const Process::Got got = read_message(line, Clock::now() + duration(patience));
  const auto beside = [this] { return (passed_over_.empty() ? "" : "; " + passed_over_) + last_words(); };
  if (got == Process::Got::stopped) throw Interrupted();
  if (got == Process::Got::time_out)
    throw SubjectError(fmt::format("the subject said no hello within {} s", patience) + unfinished_line() + beside());
  if (got == Process::Got::too_long) throw SubjectError("the subject's first line is no hello: it does not end");
  if (got == Process::Got::end) {
    const std::optional<Ending> ending = process_->ending(Clock::now() + grace);
    throw SubjectError(
        "the subject said no hello: " + (ending ? described(*ending) : "closed its output") +
        (line.empty() ? "" : fmt::format("; {} bytes came, no end of line: {}", line.size(), excerpt(line))) +
        beside());
  }
  try {
    SubjectInfo info = read_hello(line);
    if (starts_ > 1 && hello_text(info) != hello_text(info_))
      throw SubjectError("the subject says something else of itself each time that it is started: first " +
                         hello_text(info_) + ", then " + hello_text(info));
    info_ = std::move(info);
  } catch (const ProtocolError& error) {
    throw SubjectError(std::string("the subject's hello is wrong: ") + error.what() + beside());
  }
}

Outcome Examiner::examine(const Case& pair) { return examine(pair, exponent_to_fit(pair, settings_.fit)); }

Outcome Examiner::examine(const Case& pair, long exponent) {
  Outcome otherwise;
  const std::optional<Case> seen = put(pair, exponent, otherwise);
  if (!seen) return otherwise;
  const auto ask_pair = [&](const Case& one, std::optional<SubjectAnswer>& answer) {
    return ask(one, exponent, answer);
  };
  if (is_asked_in_pairs(*seen, info_)) return examine_pairs(*seen, exponent, info_, judging(), ask_pair);
  std::optional<SubjectAnswer> answer;
  Outcome outcome = ask(*seen, exponent, answer);
  if (answer) judge_answer(outcome, *seen, *answer, info_, judging());
  return outcome;
}

std::optional<Case> Examiner::put(const Case& pair, long exponent, Outcome& otherwise) const {
  std::string why;
  std::optional<Case> seen = as_seen(pair, in_unit(info_.format, exponent), info_.shapes, &why, info_.dimension);
  if (!seen) otherwise = declined(pair, why);
  else if (const std::string obstacle = obstacle_to(*seen, info_, exponent); !obstacle.empty())
    otherwise = declined(*seen, obstacle);
  else return seen;
  return std::nullopt;
}

void Examiner::note_runs(const Case& pair, const std::function<void(const Case&, long, const std::string&)>& take) {
  const long exponent = exponent_to_fit(pair, settings_.fit);
  Outcome otherwise;
  const std::optional<Case> seen = put(pair, exponent, otherwise);
  if (!seen) throw InputError(pair.id, 0, "it cannot be put to the subject: " + otherwise.detail);
  const auto note = [&](const Case& one, std::optional<SubjectAnswer>& answer) {
    Outcome outcome = outcome_for(one, exponent);
    take(one, exponent,
         run_message(ticket_of(++asked_, outcome.digest), in_unit(one, exponent), info_.format.points,
                     info_.wants_faces));
    answer = SubjectAnswer{"", Unsupported{"only noted"}};
    return outcome;
  };
  std::optional<SubjectAnswer> answer;
  if (is_asked_in_pairs(*seen, info_)) examine_pairs(*seen, exponent, info_, judging(), note);
  else note(*seen, answer);
}

std::vector<std::string> Examiner::input_for(const Case& pair) {
  std::vector<std::string> lines{hello_message()};
  note_runs(pair, [&](const Case&, long, const std::string& run) { lines.push_back(run); });
  lines.push_back(stop_message());
  return lines;
}

std::vector<std::string> Examiner::requests_for(const Case& pair) {
  std::vector<std::string> lines;
  note_runs(pair, [&](const Case& one, long exponent, const std::string& run) {
    const judging::AnyTruth truth = truth_to_judge_by(one, info_, exponent, judging());
    const NumberFormat format = in_unit(info_.format, exponent);
    lines.push_back(request_line(one.id, run,
                                 judging::judged(truth, Reply{}, info_.conventions, format, settings_.tolerance),
                                 judging::accepted(truth, info_.conventions, format, settings_.tolerance)));
  });
  return lines;
}

Judging Examiner::judging() { return {settings_.tolerance, settings_.second, settings_.stop, &workspace_}; }

void Examiner::start_again() {
  process_.reset();
  for (int tries = 1; !process_; ++tries) {
    try {
      start();
    } catch (const SubjectError&) {
      process_.reset();
      if (tries == most_starts) throw;
    }
  }
}

/// Puts the case. A failure counts as one of the case if it happens twice, the second time in a
/// fresh process.
Outcome Examiner::ask(const Case& seen, long exponent, std::optional<SubjectAnswer>& answer) {
  std::optional<Fault> before;
  for (int faults = 1;; ++faults) {
    if (!process_) start_again();
    Outcome outcome = outcome_for(seen, exponent);
    const std::optional<Fault> found = ask_once(seen, outcome, answer);
    if (found) process_.reset();
    const bool leftover_before = before && before->after;
    const bool again =
        before && found && before->verdict == found->verdict && (!leftover_before || before->seen == found->seen);
    if (before && !again) report_unattributed(*before);
    if (!found) return outcome;
    if (is_nobodys(*found)) {
      before.reset();
      continue;
    }
    if (again || found->verdict == Verdict::time_out || faults >= most_faults) {
      outcome.verdict = found->verdict;
      outcome.detail = (found->reason.empty() ? found->seen : found->reason) + found->words;
      return outcome;
    }
    before = found;
  }
}

/// Returns whether the process failed before it read a byte of the case; if so, reports the failure
/// as unattributed.
bool Examiner::is_nobodys(const Fault& fault) {
  const bool ended = fault.verdict == Verdict::crash || fault.verdict == Verdict::silent;
  if (!fault.unread || (!ended && !fault.after)) {
    unread_ = 0;
    return false;
  }
  report_unattributed(fault);
  unread_ = fault.after ? 0 : unread_ + 1;
  if (unread_ == most_starts)
    throw SubjectError("the subject ends each time before it reads a case: " + fault.seen + fault.words);
  return true;
}

void Examiner::report_unattributed(const Fault& fault, const char* when) {
  if (settings_.unattributed)
    settings_.unattributed({fault.after, when + fault.seen + (fault.verdict == Verdict::garbage ? "" : fault.words)});
}

/// Puts the case once. Returns nullopt if it was answered.
std::optional<Examiner::Fault> Examiner::ask_once(const Case& seen, Outcome& outcome,
                                                  std::optional<SubjectAnswer>& answer) {
  ticket_ = ticket_of(++asked_, outcome.digest);
  const std::string message = run_message(ticket_, in_unit(seen, outcome.fit), info_.format.points, info_.wants_faces);
  const Clock::time_point begin = Clock::now();
  process_->send(message);
  std::string line;
  const Process::Got got = process_->read_line(line, begin + duration(settings_.time_out));
  outcome.seconds = seconds_since(begin);
  switch (got) {
    case Process::Got::line: return understand(line, seen, answer);
    case Process::Got::stopped: throw Interrupted();
    case Process::Got::end: return fault_of_end(line);
    case Process::Got::too_long:
      return fault(Verdict::garbage,
                   fmt::format("a line of more than {} bytes: {}", longest_line, excerpt(process_->waiting())));
    case Process::Got::time_out: break;
  }
  std::string detail = fmt::format("no answer within {} s", settings_.time_out);
  if (process_->unsent() > 0)
    detail += fmt::format("; it has not read the last {} of the case's {} bytes", process_->unsent(), message.size());
  return fault(Verdict::time_out, detail + unfinished_line());
}

std::optional<Examiner::Fault> Examiner::understand(const std::string& line, const Case& seen,
                                                    std::optional<SubjectAnswer>& understood) {
  const std::string what = "wrote " + excerpt(line);
  std::optional<SubjectAnswer> answer;
  try {
    answer = read_reply(line, info_.format, info_.dimension);
    demand_sent_as_vertices(seen, *answer);
  } catch (const ProtocolError& error) {
    const std::string reason = error.what();
    return fault(Verdict::garbage, what,
                 reason.find(excerpt(line)) == reason.npos ? reason + "; the line: " + excerpt(line) : reason);
  }
  if (answer->ticket != ticket_)
    return fault(Verdict::garbage, what,
                 fmt::format("expected the reply to run {}, found one to {}; the line: {}", ticket_,
                             kernels::shown(answer->ticket), excerpt(line)));
  answered_ = seen.id;
  unread_ = 0;
  understood = std::move(answer);
  return std::nullopt;
}

Examiner::Fault Examiner::fault(Verdict verdict, std::string seen, std::string reason) {
  return {verdict, std::move(seen), std::move(reason), last_words(), answered_, process_->last_is_unread()};
}

Examiner::Fault Examiner::fault_of_end(const std::string& rest) {
  const std::optional<Ending> ending = process_->ending(Clock::now() + grace);
  const std::string how = ending ? described(*ending) : "closed its output and lived on";
  if (ending && !ending->in_good_order()) return fault(Verdict::crash, how);
  if (rest.empty()) return fault(Verdict::silent, how);
  return fault(Verdict::garbage, "wrote " + excerpt(rest), "a line that was cut off: " + excerpt(rest));
}

Replay Replay::read(const std::string& given) {
  const bool standard = given == "-";
  const std::string path = standard ? "<stdin>" : given;
  const std::string text =
      standard ? std::string(std::istreambuf_iterator<char>(std::cin), {}) : files::read_file(path);
  Replay replay;
  replay.info_.name = "replay";
  std::size_t number = 0;
  bool any = false;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t newline = std::min(text.find('\n', begin), text.size());
    const std::string_view line = std::string_view(text).substr(begin, newline - begin);
    begin = newline + 1;
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    try {
      if (!any && is_hello(line)) replay.info_ = read_hello(line);
      else replay.take(line, path, number);
    } catch (const ProtocolError& error) {
      throw InputError(path, number, error.what());
    }
    any = true;
  }
  if (replay.answers_.empty() && replay.faults_.empty()) throw InputError(path, 0, "expected replies, found none");
  return replay;
}

void Replay::take(std::string_view line, const std::string& path, std::size_t number) {
  try {
    SubjectAnswer answer = read_reply(line, info_.format, info_.dimension);
    std::string id = answer.ticket;
    answers_[std::move(id)].push_back(std::move(answer));
  } catch (const ProtocolError& error) {
    faults_.emplace_back(path, number, error.what());
  }
}

Outcome Replay::ask(const Case& seen, long exponent, std::optional<SubjectAnswer>& answer) const {
  const auto found = answers_.find(seen.id);
  if (found == answers_.end()) throw NoReply("no reply to case " + kernels::shown(seen.id));
  Outcome outcome = outcome_for(seen, exponent);
  outcome.detail = fmt::format("{} replies to one case", found->second.size());  // the verdict stays garbage
  if (found->second.size() > 1) return outcome;
  try {
    demand_sent_as_vertices(seen, found->second[0]);
  } catch (const ProtocolError& error) {
    outcome.detail = error.what();
    return outcome;
  }
  outcome.detail.clear();
  answer = found->second[0];
  return outcome;
}

Outcome Replay::examine(const Case& pair, long exponent, const Judging& judging) const {
  std::string why;
  const std::optional<Case> seen = as_seen(pair, in_unit(info_.format, exponent), info_.shapes, &why, info_.dimension);
  if (!seen) return declined(pair, why);
  if (const std::string obstacle = obstacle_to(*seen, info_, exponent); !obstacle.empty())
    return declined(*seen, obstacle);
  const auto ask_pair = [&](const Case& one, std::optional<SubjectAnswer>& answer) {
    return ask(one, exponent, answer);
  };
  if (is_asked_in_pairs(*seen, info_) && !answers_.contains(seen->id))
    return examine_pairs(*seen, exponent, info_, judging, ask_pair);
  std::optional<SubjectAnswer> answer;
  Outcome outcome = ask(*seen, exponent, answer);
  if (answer) judge_answer(outcome, *seen, *answer, info_, judging);
  return outcome;
}

std::vector<std::string> Replay::unasked(const std::function<bool(const std::string&)>& is_asked) const {
  std::vector<std::string> result;
  for (const auto& [id, answers] : answers_)
    if (!is_asked(id)) result.push_back(id);
  return result;
}

void run(const RunPlan& plan) {
  Run run(plan);
  const unsigned jobs = std::max(plan.jobs, 1U);
  std::vector<std::thread> others;
  others.reserve(jobs);
  try {
    while (others.size() + 1 < jobs) others.emplace_back([&run] { run.work(); });
  } catch (const std::system_error&) {  // the system cannot start more threads: those that run do the work
  }
  run.work();
  for (std::thread& other : others) other.join();
  run.finish();
}

}  // namespace fathom::harness
