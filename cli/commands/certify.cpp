// SPDX-License-Identifier: GPL-3.0-or-later
// fathom certify --subject COMMAND | --adapter NAME | --replay FILE [OPTIONS] CASES | - | --worst
// Reads the cases, each id once, and runs the subject on them; certify_results.cpp handles the
// results.
#include "cli/commands/certify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <fstream>
#include <functional>
#include <iostream>
#include <istream>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "cli/args/values.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/names.hpp"
#include "cli/io/case_stream.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/certificate.hpp"
#include "fathom/files.hpp"
#include "fathom/union.hpp"
#include "kernels/messages.hpp"
#include "reference/files/cases.hpp"
#include "reference/files/file_io.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/output/result_fields.hpp"
#include "verify/claims/claims.hpp"
#include "verify/harness/examiner.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/harness/two_ways.hpp"
#include "verify/harness/variants.hpp"
#include "verify/judge/truth.hpp"

namespace fathom::cli {

namespace {

class CertifyCases {
 public:
  /// Opens the stream; throws InputError. "-" is standard input, and waiting for it can be
  /// interrupted. With `worst` it reads the cases that are part of the program, and `input` names
  /// them.
  CertifyCases(const std::string& input, bool worst, std::function<void(const std::string&)> tell);

  /// Returns the next good case, or nullopt at the end. Calls `tell` for a bad case, and for one
  /// whose id occurred before. After std::bad_alloc it can be called again, as CaseStream::next.
  std::optional<Case> next();

  [[nodiscard]] std::size_t bad() const { return bad_; }
  /// Returns the position, for messages, of the case that was read last, or that did not fit into
  /// memory.
  [[nodiscard]] std::string place() const;
  /// Returns whether an earlier case has the id, or has unions with two pieces of that id; see
  /// harness::pair_id.
  [[nodiscard]] bool asked(const std::string& id) const;
  /// Returns about how many cases a regular file has; nullopt for other inputs. See cases_in.
  [[nodiscard]] std::optional<std::size_t> expected() const { return expected_; }

 private:
  std::string input_;
  std::function<void(const std::string&)> tell_;
  InterruptibleInput standard_input_;
  std::istream stdin_{&standard_input_};
  std::istringstream worst_{std::string(harness::worst_cases)};
  CaseStream items_;
  std::set<std::string> ids_;
  std::vector<Case> unions_;  // the unions among the cases
  std::size_t bad_ = 0;
  std::optional<std::size_t> expected_;
};

/// Returns what is wrong with the bodies, or "".
std::string wrong_certified(const Case& single) {
  if (std::string wrong = wrong_bodies(single, false, "", "", ""); !wrong.empty()) return wrong;
  for (const auto& [body, name] : {std::pair(&single.a, 'a'), {&single.b, 'b'}}) {
    if (!files::has_union(single)) break;
    const Pieces pieces = pieces_of(*body);
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (harness::is_flat_piece(*body, i))
        return fmt::format("{}: piece {} is flat: the pieces of a union need interiors", name, i);
  }
  return "";
}

CertifyCases::CertifyCases(const std::string& input, bool worst, std::function<void(const std::string&)> tell)
    : input_(input),
      tell_(std::move(tell)),
      items_(worst ? CaseStream(worst_, input) : CaseStream::open(input, stdin_)),
      expected_(worst ? std::nullopt : cases_in(input)) {
  stdin_.exceptions(std::ios::badbit);
}

std::string CertifyCases::place() const {
  return (input_ == "-" ? "<stdin>" : input_) + ":" + std::to_string(items_.case_line());
}

std::optional<Case> CertifyCases::next() {
  while (std::optional<CaseItem> item = items_.next()) {
    std::string fault;
    const std::string name = input_ == "-" ? "<stdin>" : input_;
    if (!item->ok()) fault = item->error().what();
    else if (const std::string wrong = wrong_certified(item->value()); !wrong.empty())
      fault = InputError(name, item->line, wrong).what();
    else if (!ids_.insert(item->id).second)
      fault = InputError(name, item->line, "the id " + kernels::shown(item->id) + " was there before").what();
    if (fault.empty()) {
      Case good = std::get<Case>(std::move(item->outcome));
      if (files::has_union(good)) unions_.push_back(good);
      return good;
    }
    ++bad_;
    tell_(fault);
  }
  return std::nullopt;
}

bool CertifyCases::asked(const std::string& id) const {
  return ids_.contains(id) ||
         std::ranges::any_of(unions_, [&](const Case& pair) { return harness::is_pair_of(id, pair); });
}

// fathom certify --subject COMMAND | --adapter NAME | --replay FILE [OPTIONS] CASES | - | --worst

using harness::Examiner;
using harness::ExpectedFailures;
using harness::Replay;

ExitCode list_adapters() {
  std::size_t column = 0;
  for (const Adapter& adapter : adapters()) column = std::max(column, adapter.name.size());
  bool missing = false;
  for (const Adapter& adapter : adapters()) {
    const bool built = !program_of(adapter).empty();
    missing = missing || !built;
    print(fitted(fmt::format("{:<{}}  {}{}", adapter.name, column, adapter.description, built ? "" : "; not built"),
                 column + 2));
  }
  if (missing) talk(how_adapters_come());
  return fine;
}

/// One run, from the subject's hello to the exit code.
class Certify {
 public:
  Certify(const CertifyRequest& request, const ExaminersElsewhere& elsewhere)
      : certify_(request), elsewhere_(elsewhere) {
    probe_reports(certify_);
    if (!certify_.expect_fail.empty()) expected_ = ExpectedFailures::read(certify_.expect_fail);
    earlier_ = earlier_list(certify_);
    cases_.emplace(request.cases, request.worst, [this](const std::string& fault) { tell("bad cases", fault); });
    if (!certify_.replay.empty()) replay_ = Replay::read(certify_.replay);
    else command_ = subject_of(certify_);
  }

  ExitCode work() {
    try {
      if (!replay_) examiner_ = std::make_shared<Examiner>(command_, settings());
      if (!certify_.print_input.empty()) return print_input();
      if (!certify_.write_requests.empty()) return write_requests();
      if (examiner_ && !examiner_->passed_over().empty()) tell("notes on the subject", examiner_->passed_over());
      found_.emplace(certify_, info(), cases_->expected());
      examine();
      return finish();
    } catch (const harness::SubjectError& error) {
      return cut_short(error.what());
    } catch (const harness::JournalError& error) {
      throw OutputError(error.what());
    } catch (const Interrupted&) {
      take_time_to_write();
      if (found_) found_->close();
      report_so_far("interrupted");
      if (!certify_.report.empty()) talk(certify_.report + " holds every verdict so far; --resume goes on from there");
      throw;
    }
  }

 private:
  /// Prints the lines that the subject reads for one case.
  ExitCode print_input() {
    while (const std::optional<Case> pair = next_case()) {
      if (pair->id != certify_.print_input) continue;
      for (const std::string& line : examiner_->input_for(*pair)) print(line);
      return fine;
    }
    throw InputError(certify_.cases, 0,
                     "expected a case of the id " + kernels::shown(certify_.print_input) + ", found none");
  }

  /// Writes the file of requests. Cases that cannot be put are left out, which is said.
  ExitCode write_requests() {
    CertificateFile file(certify_.write_requests, "file of requests");
    std::string text = harness::header_line(
        info(), certify_.tolerance, {FATHOM_VERSION, certify_.command_line, "", {}, certify_.methods, certify_.fit});
    while (const std::optional<Case> pair = next_case()) {
      try {
        for (const std::string& line : examiner_->requests_for(*pair)) text += "\n" + line;
      } catch (const InputError& error) {
        talk(std::string("left out: ") + error.what());
      }
    }
    file.write(text + "\n");
    return cases_->bad() > 0 ? bad_input : fine;
  }

  [[nodiscard]] const harness::SubjectInfo& info() const { return replay_ ? replay_->info() : examiner_->info(); }

  /// Prints the first few sentences of a kind, from any thread.
  void tell(const std::string& kind, const std::string& sentence) {
    const std::lock_guard lock(telling_);
    if (found_) found_->tell(kind, sentence);
    else talk(sentence);
  }

  /// Takes a failure that no case caused. Once the report is complete, it is only printed.
  void take(const harness::Unattributed& thing) {
    tell("notes on the subject", "no case's fault: the subject, " +
                                     (thing.after ? "after case " + kernels::shown(*thing.after) : "before any case") +
                                     ": " + thing.detail);
    const std::lock_guard lock(telling_);
    if (found_ && !complete_) found_->take(thing);
  }

  harness::Settings settings() {
    harness::Settings settings = examiner_settings(certify_);
    settings.unattributed = [this](const harness::Unattributed& thing) { take(thing); };
    return settings;
  }

  /// Starts another examiner. Its subject gets a second chance, because it has sent its hello once.
  std::shared_ptr<Examiner> one_more() {
    try {
      return std::make_shared<Examiner>(command_, settings());
    } catch (const harness::SubjectError&) {
      return std::make_shared<Examiner>(command_, settings());
    }
  }

  /// The examiner of one thread. The first thread uses the existing one.
  harness::Worker make_worker() {
    if (replay_) {
      const harness::Settings set = examiner_settings(certify_);
      const auto workspace = std::make_shared<Workspace>();
      return {[this, set, workspace](const Case& pair, long exponent) {
                return replay_->examine(pair, exponent, {set.tolerance, set.second, set.stop, workspace.get()});
              },
              {}};
    }
    if (elsewhere_.count > 0)
      return {
          [this](const Case& pair, long exponent) { return elsewhere_.examine(pair, exponent, hello_text(info())); },
          {}};
    const std::shared_ptr<Examiner> examiner = std::exchange(first_is_taken_, true) ? one_more() : examiner_;
    if (hello_text(examiner->info()) != hello_text(info()))
      throw harness::SubjectError("the subject says something else of itself each time that it is started");
    return {[examiner](const Case& pair, long exponent) { return examiner->examine(pair, exponent); },
            [examiner] { examiner->finish(); }};
  }

  void examine() {
    if (replay_)
      for (const InputError& fault : replay_->faults()) tell("bad replies", fault.what());
    if (certify_.motion && !info().wants_twist)
      tell("notes on the subject", "it does not declare \"twist\", and is asked for no derivative");
    harness::RunPlan plan;
    plan.jobs = elsewhere_.count > 0 ? elsewhere_.count
                                     : certify_.jobs.value_or(std::max(std::thread::hardware_concurrency(), 1U));
    plan.variants = certify_.variants;
    if (!info().rounding.empty() && std::erase(plan.variants, "scale") > 0)
      tell("variants left out", "scale is no symmetry of a subject that rounds bodies by a radius of its own");
    plan.format = info().format;
    plan.fit = certify_.fit;
    plan.shapes = info().shapes;
    plan.dimension = info().dimension;
    plan.manifold = info().conventions.manifold;
    plan.tolerance = certify_.tolerance;
    plan.next = [this] { return next_case(); };
    plan.worker = [this] { return make_worker(); };
    if (certify_.resume)
      plan.known = [this](const auto& id, const auto& variant, const auto& digest) {
        return found_->known(id, variant, digest);
      };
    plan.found = [this](const Case& original, const Case& seen, const harness::Outcome& outcome, bool known) {
      const std::lock_guard lock(telling_);
      found_->take(original, seen, outcome, known);
      if (outcome.judgement && !outcome.detail.empty())
        found_->tell("misspelt fields", outcome.id + ": " + outcome.detail);
    };
    plan.fault = [this](const Case& pair, const std::exception_ptr& error) { take_fault(pair, error); };
    plan.left_out = [this](const Case& pair, const std::string& sentence) {
      tell("variants left out", pair.id + ": " + sentence);
    };
    harness::run(plan);
    found_->close();
  }

  std::optional<Case> next_case() {
    while (true) {
      if (interrupt_requested()) throw Interrupted();
      try {
        std::optional<Case> pair = cases_->next();
        if (pair && !info().wants_twist) pair->motion.reset();
        else if (pair && !pair->motion) pair->motion = certify_.motion;
        return pair;
      } catch (const std::bad_alloc& error) {  // the case does not fit into memory; the next one may
        ++faults_;
        tell("faults", cases_->place() + ": " + fault_text(error));
      }
    }
  }

  /// Handles an error that concerns one case, which gets no verdict; any other ends the run.
  void take_fault(const Case& pair, const std::exception_ptr& error) {
    try {
      std::rethrow_exception(error);
    } catch (const harness::NoReply& missing) {
      ++missing_;
      tell("cases without a reply", missing.what());
    } catch (const harness::Disagreement& fault) {
      ++faults_;
      tell("faults", pair.id + ": " + fault_text(fault));
      if (!disagreement_) disagreement_ = fault;
    } catch (const std::logic_error& fault) {
      ++faults_;
      tell("faults", pair.id + ": " + fault_text(fault));
    } catch (const std::bad_alloc& fault) {
      ++faults_;
      tell("faults", pair.id + ": " + fault_text(fault));
    }
  }

  ExitCode finish() {
    const harness::SubjectInfo& subject = info();
    if (replay_)
      for (const std::string& id : replay_->unasked([this](const std::string& id) { return cases_->asked(id); }))
        tell("replies to no case", "the reply to " + kernels::shown(id) + " is to no case");
    std::optional<ExpectedFailures::Check> known;
    if (expected_) known = expected_->check(found_->outcomes());
    const bool whole = missing_ + faults_ == 0;
    if (whole) found_->complete();
    complete_ = true;
    const CertificateNames certificates = write_certificates(certify_, subject, *found_);
    report(known, certificates, whole ? "" : "incomplete: some cases have no verdict");
    write_list(certify_, subject, *found_, earlier_);
    if (!certify_.shrink.empty()) shrink_failures(certify_, *examiner_, *found_);
    if (!certify_.shrink.empty() && disagreement_)
      shrink_disagreement(certify_.shrink, *disagreement_, found_->progress());
    ExitCode code = code_of(certify_, *found_, known);
    if (cases_->bad() > 0 || (replay_ && !replay_->faults().empty())) code = std::max(code, bad_input);
    if (faults_ > 0) code = std::max(code, internal_error);
    if (missing_ > 0) code = std::max(code, incomplete);
    return code;
  }

  /// Writes all reports for people and CI systems. Called once.
  void report(const std::optional<ExpectedFailures::Check>& known, const CertificateNames& certificates,
              const std::string& cut_short) {
    reported_ = true;
    write_reports(certify_, info(), *found_, known, certificates, cut_short);
    if (!certify_.json) print_table();
    if (const std::string warning = coverage_warning(found_->summary().tally().all().judged); !warning.empty())
      talk(warning);
  }

  /// Writes the same for a run that ended early, without comparing the list of expected failures,
  /// as cases are missing.
  void report_so_far(const std::string& why) {
    if (!found_ || reported_ || found_->outcomes().empty()) return;
    std::optional<ExpectedFailures::Check> known;
    if (expected_) {
      known = expected_->check(found_->outcomes());
      known->unmet_lines.clear();
    }
    report(known, {}, why);
  }

  void print_table() {
    const std::size_t width = seen_columns(STDOUT_FILENO);
    constexpr std::size_t of_files = 140;
    std::string table = found_->summary().table(info(), found_->outcomes(), where_to_look(certify_),
                                                width == unlimited ? of_files : width, certify_.all_rows);
    if (!table.empty() && table.back() == '\n') table.pop_back();
    print(fitted(table));
  }

  ExitCode cut_short(const std::string& why) {
    if (found_) found_->close();
    report_so_far("incomplete: " + why);
    talk(why);
    talk(found_ ? fmt::format("incomplete: the run ended after {} verdicts", found_->outcomes().size())
                : "nothing was judged");
    return incomplete;
  }

  const CertifyRequest& certify_;
  const ExaminersElsewhere& elsewhere_;
  std::optional<harness::Disagreement> disagreement_;  // the first
  harness::SubjectCommand command_;
  std::optional<ExpectedFailures> expected_;
  ExpectedFailures earlier_;  // the list that a new one replaces
  std::optional<CertifyCases> cases_;
  std::optional<Replay> replay_;
  std::shared_ptr<Examiner> examiner_;
  std::optional<Collector> found_;
  std::mutex telling_;  // guards found_
  bool first_is_taken_ = false, reported_ = false, complete_ = false;
  std::size_t missing_ = 0;
  std::atomic<std::size_t> faults_ = 0;  // errors in reading and in judging
};

}  // namespace

CertifyRequest::CertifyRequest(const Given& given)
    : worst(given.flag("--worst")),
      cases(worst ? "--worst" : given.inputs().at(0)),
      command_line(given.command_line),
      subject(given.text("--subject")),
      adapter(given.text("--adapter")),
      replay(given.text("--replay")),
      json(given.flag("--json")),
      jobs(given.integer<unsigned>("--jobs")),
      fit(given.number("--fit")),
      motion(given.twists().in(3)),
      methods(typed_methods(given.words("--method"))),
      report(given.text("--report")),
      resume(given.flag("--resume")),
      overwrite(given.flag("--overwrite")),
      all_rows(given.flag("--all-rows")),
      print_input(given.text("--print-input")),
      write_requests(given.text("--write-requests")),
      harness(given.text("--harness")),
      expect_fail(given.text("--expect-fail")),
      write_expect_fail(given.text("--write-expect-fail")),
      junit(given.text("--junit")),
      html(given.text("--html")),
      certificates(given.text("--certificates")),
      shrink(given.text("--shrink")),
      max_errors(given.integer<std::size_t>("--max-errors")) {
  if (const auto time = given.number("--time-out")) time_out = round_binary64(*time, Rounding::ru);
  tolerance.relative = given.number("--tol-rel").value_or(tolerance.relative);
  tolerance.absolute = given.number("--tol-abs").value_or(tolerance.absolute);
  if (const auto ulps = given.integer<std::size_t>("--tol-ulps")) tolerance.ulps = *ulps;
  tolerance.patch_slack = given.number("--patch-slack");
  if (const auto policy = given.value("--policy")) tolerance.policy = judging::policy_of(*policy).value();
  const std::string asked = given.text("--metamorphic");
  if (asked == "all") variants.assign(std::begin(harness::variant_names), std::end(harness::variant_names));
  else if (!asked.empty()) variants = words_of(asked);
}

harness::SubjectCommand subject_of(const CertifyRequest& certify) {
  return {certify.adapter.empty() ? certify.subject : adapter_command(certify.adapter)};
}

harness::Settings examiner_settings(const CertifyRequest& certify) {
  harness::Settings settings;
  settings.time_out = certify.time_out;
  settings.tolerance = certify.tolerance;
  settings.fit = certify.fit;
  for (const Method method : certify.methods) settings.second.push_back(harness::solver_by(method));
  settings.stop = interrupt_requested;
  return settings;
}

ExitCode certify(const CertifyRequest& request, const ExaminersElsewhere& elsewhere) {
  std::ios::sync_with_stdio(false);
  constexpr unsigned patience = 5;  // seconds: subjects get one to end, then results are written
  const InterruptGuard interrupt_guard(patience);
  return Certify(request, elsewhere).work();
}

ExitCode run_certify(const Given& given) {
  if (given.flag("--list-adapters")) return list_adapters();
  return given.has("--claims") ? run_claims(given) : certify(CertifyRequest(given), {});
}

// fathom certify --claims FILE
// Judges what was published about pairs of bodies, as text and as JSON.

namespace {

/// Returns one line, and one more for each statement; without the last newline.
std::string claim_text(const claims::PublishedClaim& claim, const claims::JudgedClaim& judged) {
  std::string text = fmt::format("{}: {}", safe_id(claim.bodies.id), claims::verdict_name(judged.finding()));
  for (const claims::Statement& statement : judged.statements)
    text += fmt::format("\n  {}: {}; {}", statement.text, claims::verdict_name(statement.finding), statement.truth);
  return text;
}

using claims::Finding;
using claims::JudgedClaim;
using claims::PublishedClaim;

/// Writes certificates of the truth for wrong claims, if requested.
class Proofs {
 public:
  explicit Proofs(const std::string& folder) {
    if (!folder.empty()) folder_.emplace(folder);
  }
  void write(const PublishedClaim& claim, const JudgedClaim& judged) {
    if (!folder_ || judged.finding() != Finding::wrong) return;
    const Shape a = files::shape_of(claim.bodies.a), b = files::shape_of(claim.bodies.b);
    const std::string certificate = certificate_text(a, b, judged.truth, claim.bodies.id, ShapeFormat::richest);
    require_readable(claim.bodies.id, certificate);
    CertificateFile(folder_->file(claim.bodies.id)).write(certificate);
  }

 private:
  std::optional<CertificateFolder> folder_;
};

}  // namespace

ExitCode run_claims(const Given& given) {
  const std::string path = given.text("--claims"), name = path == "-" ? "<stdin>" : path;
  const InterruptGuard interrupt_guard;
  Proofs proofs(given.text("--certificates"));
  const bool json = given.flag("--json");
  std::ifstream file;
  if (path != "-") {
    files::require_readable(path);
    file.open(path, std::ios::binary);
  }
  std::istream& input = path == "-" ? std::cin : file;
  std::map<std::string_view, std::size_t> counts;
  ExitCode code = fine;
  std::size_t line = 0, found = 0, judged_claims = 0;
  for (std::string text; std::getline(input, text);) {
    ++line;
    if (interrupt_requested()) throw Interrupted();
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    ++found;
    const auto claim = claims::parse_claim(text, name, line);
    if (const InputError* const fault = std::get_if<InputError>(&claim)) {
      talk(fault->what());
      code = bad_input;
      continue;
    }
    const PublishedClaim& published = std::get<PublishedClaim>(claim);
    const JudgedClaim judged = claims::judge_claim(published);
    proofs.write(published, judged);
    print(json ? output::line_of("fathom/claim/1", FATHOM_VERSION, claims::ClaimLine{published, judged})
               : fitted(claim_text(published, judged), 4));
    ++counts[claims::verdict_name(judged.finding())];
    ++judged_claims;
    if (judged.finding() == Finding::wrong) code = std::max(code, judged_wrong);
  }
  if (found == 0) throw InputError(name, 1, "expected at least one claim, found an empty input");
  if (!json)
    print(fmt::format("{} claims: {} right, {} wrong, {} undecided, {} not judgeable", judged_claims, counts["right"],
                      counts["wrong"], counts["undecided"], counts["not-judgeable"]));
  return code;
}

}  // namespace fathom::cli
