// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "cli/commands/certify_results.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "cli/io/terminal.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/judged_bodies.hpp"
#include "verify/harness/report/markup.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/harness/shrink/shrink.hpp"
#include "verify/harness/shrink/write_shrunk.hpp"
#include "verify/harness/variants.hpp"

namespace fathom::cli {
namespace {

using harness::Outcome;
using harness::Shrunk;

std::size_t points_of(const Case& pair) { return pair.a.points.size() + pair.b.points.size(); }

/// "5 points are left", or that bodies have names.
std::string left_of(const Case& pair) {
  return harness::has_words(pair) ? "with simpler shapes" : fmt::format("{} points are left", points_of(pair));
}

/// By verdict and variant, the failing case with the fewest points, of points alone or else of shapes rather than of unions; of several the
/// one with the least id.
std::map<std::pair<Verdict, std::string>, const FailedCase*> starts(const Collector& found) {
  std::map<std::pair<Verdict, std::string>, const FailedCase*> best;
  for (const FailedCase& failed : found.failed()) {
    const Outcome& outcome = found.outcomes()[failed.outcome];
    const FailedCase*& so_far = best[{outcome.verdict, outcome.variant}];
    const auto smaller = [&](const FailedCase& than) {
      const auto size = [](const FailedCase& of) {
        return std::tuple(harness::has_union(of.seen), harness::has_words(of.seen), points_of(of.seen));
      };
      return std::pair(size(failed), outcome.id) < std::pair(size(than), found.outcomes()[than.outcome].id);
    };
    if (!so_far || smaller(*so_far)) so_far = &failed;
  }
  return best;
}

/// Whether the subject sees these bodies, and not rounded ones.
bool is_seen_as_it_is(const Case& pair, const harness::SubjectInfo& info, long exponent) {
  const std::optional<Case> seen = harness::as_seen(pair, harness::in_unit(info.format, exponent), info.shapes);
  return seen && harness::digest_of(*seen) == harness::digest_of(pair);
}

void report(const Request& request, const Shrunk& shrunk, const std::string& title, const std::vector<std::string>& files) {
  if (!shrunk.reproduced) return talk(title + ": the verdict did not come again on the same case, so nothing was shrunk");
  const std::string sentence =
      fmt::format("{}: {}; {} of {} tries made it smaller", title, left_of(shrunk.pair), shrunk.kept, shrunk.tried);
  if (request.json) return talk(fmt::format("{}; {}", sentence, fmt::join(files, ", ")));
  print('\n' + fitted(sentence));
  for (const std::string& file : files) print("  " + file);
}

}  // namespace

void shrink_failures(const Request& request, harness::Examiner& examiner, Collector& found) {
  const harness::SubjectInfo& info = examiner.info();
  std::optional<harness::HarnessTemplate> own;
  if (!request.certify.harness.empty()) own = harness::read_harness(request.certify.harness);
  for (const auto& [kind, failed] : starts(found)) {
    const auto& [verdict, variant] = kind;
    const Outcome& outcome = found.outcomes()[failed->outcome];
    const std::string title = fmt::format("{} of {}", name(verdict), harness::ascii(harness::shown_id(outcome.id, variant)));
    const std::optional<mpq_class>& fit = request.certify.fit;
    const harness::ExamineInUnit in_unit = [&](const Case& pair, long exponent) {
      return is_seen_as_it_is(pair, info, exponent) ? examiner.examine(pair, exponent) : harness::declined(pair, "rounded");
    };
    harness::Examine examine = [&](const Case& pair) { return in_unit(pair, harness::exponent_to_fit(pair, fit)); };
    // Only a comparison with the original needs both; a variant that fails by itself is a case like any other.
    if (verdict == Verdict::not_invariant)
      examine = harness::examine_variant(in_unit, variant, info.format, request.certify.tolerance, fit);
    std::vector<std::string> files;
    if (harness::has_union(failed->seen)) {
      const std::string path = harness::write_case(request.certify.shrink, std::string(name(verdict)), failed->seen, title);
      talk(fmt::format("{}: cases of unions are not made smaller; the case as it was seen: {}", title, path));
      continue;
    }
    const auto better = [&](const Shrunk& best) {
      files = harness::write_shrunk(request.certify.shrink, best, info, own);
      found.progress().report(fmt::format("shrinking {}: {}", title, left_of(best.pair)), -1);
    };
    harness::ShrinkSettings settings;
    settings.precision = info.format.points;
    settings.judged = [&info](const Case& pair, const Outcome& of) { return harness::judged_bodies(pair, info, of.fit); };
    const Case begin = harness::in_unit(verdict == Verdict::not_invariant ? failed->original : failed->seen, outcome.fit);
    const Shrunk shrunk = harness::shrink(begin, verdict, examine, better, interrupt_requested, settings);
    found.progress().clear();
    if (interrupt_requested()) throw Interrupted();
    report(request, shrunk, title, files);
  }
}

void shrink_disagreement(const std::string& folder, const harness::Disagreement& found, Progress& progress) {
  progress.report(fmt::format("shrinking {}", found.pair.id), -1);
  const harness::KeptDifference kept =
      harness::keep_difference(folder, found.pair, found.what(), harness::solver_by(Method::automatic), found.second, interrupt_requested);
  progress.clear();
  if (interrupt_requested()) throw Interrupted();
  talk(
      fmt::format("{} and {} differ: {} points are left; {}", name(Method::automatic), found.second.name, points_of(kept.pair), kept.path));
}

}  // namespace fathom::cli
