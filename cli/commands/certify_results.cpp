// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include "cli/args/arguments.hpp"
#include "cli/commands/certify.hpp"
#include "cli/commands/command.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "kernels/messages.hpp"
#include "reference/files/cases.hpp"
#include "verify/check/reader.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/report/reports.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/harness/shrink/shrink.hpp"
#include "verify/harness/two_ways.hpp"
#include "verify/harness/variants.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t most_told = 5;  // printed sentences of one kind

using harness::ExpectedFailures;
using harness::HtmlFailure;
using harness::Outcome;

std::vector<HtmlFailure> shown_failures(const Collector& found, const CertificateNames& certificates) {
  std::map<std::size_t, const Case*> cases;
  for (const FailedCase& failed : found.failed()) cases[failed.outcome] = &failed.seen;
  std::vector<HtmlFailure> shown;
  for (const std::size_t index : harness::failures_to_show(found.outcomes())) {
    const auto certificate = certificates.find(index);
    shown.push_back(
        {found.outcomes()[index], *cases.at(index), certificate == certificates.end() ? "" : certificate->second});
  }
  return shown;
}

using harness::Outcome;
using harness::Shrunk;

std::size_t points_of(const Case& pair) {
  std::size_t count = 0;
  for (const Body* body : {&pair.a, &pair.b})
    count += body->dimension == 2 && body->shape ? harness::core_of(*body).size() : body->points.size();
  return count;
}

/// Returns "5 points are left", or "with simpler shapes" for bodies that are described by name.
std::string left_of(const Case& pair) {
  return harness::has_words(pair) ? "with simpler shapes" : fmt::format("{} points are left", points_of(pair));
}

/// Returns the failing case to reduce for each verdict and variant: polytopes before shapes before
/// unions, then the fewest points, then the least id.
std::map<std::pair<Verdict, std::string>, const FailedCase*> starts(const Collector& found) {
  std::map<std::pair<Verdict, std::string>, const FailedCase*> best;
  for (const FailedCase& failed : found.failed()) {
    const Outcome& outcome = found.outcomes()[failed.outcome];
    const FailedCase*& so_far = best[{outcome.verdict, outcome.variant}];
    const auto smaller = [&](const FailedCase& than) {
      const auto size = [](const FailedCase& of) {
        return std::tuple(files::has_union(of.seen), harness::has_words(of.seen), points_of(of.seen));
      };
      return std::pair(size(failed), outcome.id) < std::pair(size(than), found.outcomes()[than.outcome].id);
    };
    if (!so_far || smaller(*so_far)) so_far = &failed;
  }
  return best;
}

/// Returns whether the subject gets exactly these bodies, without rounding.
bool is_seen_as_it_is(const Case& pair, const harness::SubjectInfo& info, long exponent) {
  const std::optional<Case> seen =
      harness::as_seen(pair, harness::in_unit(info.format, exponent), info.shapes, nullptr, info.dimension);
  return seen && harness::digest_of(*seen) == harness::digest_of(pair);
}

void report(const CertifyRequest& request, const Shrunk& shrunk, const std::string& title,
            const std::vector<std::string>& files) {
  if (!shrunk.reproduced)
    return talk(title + ": the verdict did not come again on the same case, so nothing was shrunk");
  const std::string sentence =
      fmt::format("{}: {}; {} of {} tries made it smaller", title, left_of(shrunk.pair), shrunk.kept, shrunk.tried);
  if (request.json) return talk(fmt::format("{}; {}", sentence, fmt::join(files, ", ")));
  print('\n' + fitted(sentence));
  for (const std::string& file : files) print("  " + file);
}

constexpr ExitCode newly_failing = static_cast<ExitCode>(1);
constexpr std::size_t indent = 4;

struct DiffRequest {
  std::vector<std::string> reports;  ///< the old report and the new one
  bool json = false;
  std::string html;          ///< a path; empty: not wanted
  std::string command_line;  ///< quoted for a shell
};

ExitCode compare(const DiffRequest& request) {
  const harness::ReportFile before = harness::read_report(request.reports[0]),
                            after = harness::read_report(request.reports[1]);
  const harness::ReportDiff diff = harness::diff(before, after);
  if (!request.html.empty())
    CertificateFile(request.html, "page")
        .write(harness::diff_page(before, after, diff, FATHOM_VERSION, request.command_line));
  if (request.json) print(harness::diff_json(before, after, diff));
  else
    for (const std::string& line : harness::diff_text(before, after, diff)) print(fitted(line, indent));
  return diff.newly_failing.empty() ? fine : newly_failing;
}

}  // namespace

Collector::Collector(const CertifyRequest& request, const harness::SubjectInfo& info,
                     std::optional<std::size_t> expected)
    : request_(request), expected_(expected) {
  const std::string header = harness::header_line(
      info, request.tolerance, {FATHOM_VERSION, request.command_line, "", {}, request.methods, request.fit});
  summary_.fit = request.fit;
  const auto remember = [this](harness::Outcome outcome) {
    std::tuple key(outcome.id, outcome.variant, outcome.digest);
    known_.insert_or_assign(std::move(key), std::move(outcome));
  };
  std::vector<harness::Unattributed> earlier;
  const auto keep = [&earlier](harness::Unattributed unattributed) { earlier.push_back(std::move(unattributed)); };
  const std::string& report = request.report;
  if (!report.empty())
    journal_.emplace(request.resume ? harness::Journal::resume(report, header, remember, keep)
                                    : harness::Journal::create(report, header, request.overwrite));
  if (request.json) print(header);
  for (const harness::Unattributed& unattributed : earlier) take(unattributed, true);
}

const harness::Outcome* Collector::known(const std::string& id, const std::string& variant,
                                         const std::string& digest) const {
  const auto found = known_.find({id, variant, digest});
  return found == known_.end() ? nullptr : &found->second;
}

void Collector::take(const Case& original, const Case& seen, const harness::Outcome& outcome, bool known) {
  const std::string line = (journal_ && !known) || request_.json ? harness::outcome_line(outcome) : "";
  if (journal_ && !known) journal_->add(line);
  if (request_.json) {
    progress_.answered();
    print(line);
  }
  summary_.add(outcome);
  outcomes_.push_back(outcome);
  if (outcome.variant.empty()) {
    ++cases_;
    if (known) ++cases_before_;
  }
  if (fails(outcome.verdict)) {
    const CertifyRequest& certify = request_;
    const bool needed = !certify.html.empty() || !certify.certificates.empty() || !certify.shrink.empty();
    if (needed) failed_.push_back({outcomes_.size() - 1, seen, original});
  }
  if (outcome.judgement && outcome.judgement->error_relative) {
    const double error = std::abs(*outcome.judgement->error_relative);
    if (error > worst_) worst_ = error;
  }
  show_progress();
}

void Collector::take(const harness::Unattributed& unattributed, bool known) {
  const std::string line = harness::unattributed_line(unattributed);
  if (journal_ && !known) journal_->add(line);
  if (request_.json) {
    progress_.clear();
    print(line);
  }
  summary_.add(unattributed);
}

void Collector::show_progress() {
  progress_.count({cases_, expected_, cases_before_},
                  fmt::format("{} failed, worst error {:.3g}", summary_.failures(), worst_));
}

void Collector::tell(const std::string& kind, const std::string& sentence) {
  if (++told_[kind] > most_told) return;
  progress_.clear();
  talk(sentence);
}

void Collector::close() {
  progress_.clear();
  progress_.end_count();
  for (const auto& [kind, count] : told_)
    if (count > most_told) talk(fmt::format("{}: {} more like these", kind, count - most_told));
}

void Collector::complete() {
  const std::size_t all = summary_.total(), passed = summary_.passes(), failed = summary_.failures();
  const harness::Tally& tally = summary_.tally();
  const std::string line =
      harness::summary_line({all, passed, failed, all - passed - failed, summary_.unattributed(), tally.all().judged,
                             &tally.times(), &tally.hulls(), &tally.unions(), &tally.all(), tally.parts()});
  if (journal_) journal_->add(line);
  if (request_.json) print(line);
}

void probe_reports(const CertifyRequest& certify) {
  for (const std::string* path : {&certify.junit, &certify.html, &certify.write_expect_fail})
    if (!path->empty()) CertificateFile(*path, "report");
  for (const std::string* path : {&certify.certificates, &certify.shrink})
    if (!path->empty()) CertificateFolder{*path};
}

ExpectedFailures earlier_list(const CertifyRequest& certify) {
  std::error_code fault;
  const bool is_there = std::filesystem::is_regular_file(certify.write_expect_fail, fault);
  return is_there ? ExpectedFailures::read(certify.write_expect_fail) : ExpectedFailures();
}

CertificateNames write_certificates(const CertifyRequest& certify, const harness::SubjectInfo& info, Collector& found) {
  CertificateNames names;
  if (certify.certificates.empty()) return names;
  CertificateFolder folder(certify.certificates);
  for (const FailedCase& failed : found.failed()) {
    const Outcome& outcome = found.outcomes()[failed.outcome];
    const std::string path = folder.file(outcome.variant.empty() ? outcome.id : outcome.id + '~' + outcome.variant);
    try {
      const std::string text =
          harness::accepted_certificate(harness::judged_bodies(failed.seen, info, outcome.fit), &found.progress());
      CertificateFile(path).write(text);
      names[failed.outcome] = path;
    } catch (const fathom_check::Unreadable& refusal) {
      found.progress().clear();
      talk(kernels::shown(harness::shown_id(outcome.id, outcome.variant)) + ": " + refusal.what());
    }
    if (interrupt_requested()) throw Interrupted();
  }
  return names;
}

void write_reports(const CertifyRequest& certify, const harness::SubjectInfo& info, Collector& found,
                   const std::optional<ExpectedFailures::Check>& known, const CertificateNames& certificates,
                   const std::string& cut_short) {
  const harness::RunInfo from{
      FATHOM_VERSION, certify.command_line, cut_short, found.summary().unattributed_counts(), {}, certify.fit};
  if (!certify.junit.empty())
    CertificateFile(certify.junit, "report")
        .write(harness::junit_xml(info, found.outcomes(), known.value_or(ExpectedFailures::Check()), from));
  if (!certify.html.empty())
    CertificateFile(certify.html, "report")
        .write(
            harness::html_page(info, found.outcomes(), shown_failures(found, certificates), certify.tolerance, from));
  found.progress().clear();
}

void write_list(const CertifyRequest& certify, const harness::SubjectInfo& info, const Collector& found,
                const ExpectedFailures& earlier) {
  if (!certify.write_expect_fail.empty())
    CertificateFile(certify.write_expect_fail, "list")
        .write(harness::expected_failures_text(info, found.outcomes(), earlier));
}

std::vector<std::string> where_to_look(const CertifyRequest& certify) {
  return {certify.report.empty() ? "--report FILE holds every verdict with its numbers"
                                 : certify.report + " for every verdict with its numbers",
          certify.html.empty() ? "--html FILE shows the failures in pictures"
                               : certify.html + " for pictures of the failures"};
}

ExitCode code_of(const CertifyRequest& certify, Collector& found, const std::optional<ExpectedFailures::Check>& known) {
  const std::size_t allowed = certify.max_errors.value_or(0);
  const harness::Summary& summary = found.summary();
  if (known)
    for (const std::string& surprise : known->surprises) talk(surprise);
  const bool as_listed = !known || known->fixed + known->changed + known->unmet == 0;
  if (!as_listed && certify.write_expect_fail.empty())
    talk("--write-expect-fail " + certify.expect_fail + " brings the list up to date");
  const bool recorded = !known && !certify.write_expect_fail.empty();  // failures are what --write-expect-fail records
  const std::size_t failures = known ? known->unlisted : recorded ? 0 : summary.failures();
  if (!as_listed || failures > allowed || summary.unattributed() > 0) return judged_wrong;
  if (summary.failures() + summary.passes() > 0) return fine;
  const auto was_asked = [&](const Outcome& outcome) { return !certify.replay.empty() || outcome.seconds > 0; };
  if (found.outcomes().empty()) talk("no case was judged");
  else if (std::ranges::any_of(found.outcomes(), was_asked))
    talk("no case was judged: the subject declined all of them");
  else talk("no case was judged: none could be put to the subject: " + found.outcomes().front().detail);
  return incomplete;
}

void shrink_failures(const CertifyRequest& request, harness::Examiner& examiner, Collector& found) {
  const harness::SubjectInfo& info = examiner.info();
  std::optional<harness::HarnessTemplate> own;
  if (!request.harness.empty()) own = harness::read_harness(request.harness);
  for (const auto& [kind, failed] : starts(found)) {
    const auto& [verdict, variant] = kind;
    const Outcome& outcome = found.outcomes()[failed->outcome];
    const std::string title =
        fmt::format("{} of {}", name(verdict), harness::ascii(harness::shown_id(outcome.id, variant)));
    const std::optional<mpq_class>& fit = request.fit;
    const harness::ExamineInUnit in_unit = [&](const Case& pair, long exponent) {
      return is_seen_as_it_is(pair, info, exponent) ? examiner.examine(pair, exponent)
                                                    : harness::declined(pair, "rounded");
    };
    harness::Examine examine = [&](const Case& pair) { return in_unit(pair, harness::exponent_to_fit(pair, fit)); };
    // Only not_invariant is a comparison with the original case. A variant that fails by itself is
    // reduced like any other case.
    if (verdict == Verdict::not_invariant)
      examine =
          harness::examine_variant(in_unit, variant, info.format, request.tolerance, fit, info.conventions.manifold);
    std::vector<std::string> files;
    if (files::has_union(failed->seen)) {
      const std::string path = harness::write_case(request.shrink, std::string(name(verdict)), failed->seen, title);
      talk(fmt::format("{}: cases of unions are not made smaller; the case as it was seen: {}", title, path));
      continue;
    }
    const auto better = [&](const Shrunk& best) {
      files = harness::write_shrunk(request.shrink, best, info, own);
      found.progress().report(fmt::format("shrinking {}: {}", title, left_of(best.pair)), -1);
    };
    harness::ShrinkSettings settings;
    settings.precision = info.format.points;
    settings.judged = [&info](const Case& pair, const Outcome& of) {
      return harness::judged_bodies(pair, info, of.fit);
    };
    const Case begin =
        harness::in_unit(verdict == Verdict::not_invariant ? failed->original : failed->seen, outcome.fit);
    const Shrunk shrunk = harness::shrink(begin, verdict, examine, better, interrupt_requested, settings);
    found.progress().clear();
    if (interrupt_requested()) throw Interrupted();
    report(request, shrunk, title, files);
  }
}

void shrink_disagreement(const std::string& folder, const harness::Disagreement& found, Progress& progress) {
  progress.report(fmt::format("shrinking {}", found.pair.id), -1);
  const harness::KeptDifference kept = harness::keep_difference(
      folder, found.pair, found.what(), harness::solver_by(Method::automatic), found.second, interrupt_requested);
  progress.clear();
  if (interrupt_requested()) throw Interrupted();
  talk(fmt::format("{} and {} differ: {} points are left; {}", name(Method::automatic), found.second.name,
                   points_of(kept.pair), kept.path));
}

// fathom certify diff OLD NEW

ExitCode run_diff(const Given& given) {
  return compare({given.inputs(), given.flag("--json"), given.text("--html"), given.command_line});
}

}  // namespace fathom::cli
