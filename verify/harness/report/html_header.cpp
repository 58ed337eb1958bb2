// SPDX-License-Identifier: GPL-3.0-or-later
// The head of the page: what became of all cases, and how they were judged.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "verify/harness/report/html.hpp"
#include "verify/harness/report/text.hpp"
#include "view/picture/markup.hpp"

namespace fathom::harness {
namespace {

/// What a reader must know before any number.
std::string warning(const std::string& text) {
  return text.empty() ? "" : fmt::format("<p class=\"warning\" role=\"note\">{}</p>\n", markup(text));
}

const char* style_of(Verdict verdict) {
  if (verdict == Verdict::pass) return "good";
  if (verdict == Verdict::touching_by_convention) return "fair";
  if (verdict == Verdict::unsupported) return "left";
  return verdict < Verdict::nan ? "lost" : "wrong";
}

std::string settings_list(const SubjectInfo& subject, const Tally& tally, const Tolerance& tolerance, const RunInfo& from) {
  const TallyRow& all = tally.all();
  std::string rows;
  const auto add = [&](const char* what, const std::string& text) { rows += fmt::format("<dt>{}</dt><dd>{}</dd>", what, markup(text)); };
  if (const std::vector<std::string> classes = accuracy_entries(all); !classes.empty())
    add("passes", fmt::format("{}", fmt::join(classes, "; ")));
  add("judged", fmt::format("{}", fmt::join(coverage_entries(all.judged), "; ")));
  if (const std::vector<std::string> times = time_entries(tally.times()); !times.empty())
    add("time", fmt::format("{}", fmt::join(times, "; ")));
  if (const std::vector<std::string> hulls = hull_entries(tally.hulls()); !hulls.empty())
    add("hulls", fmt::format("{}", fmt::join(hulls, "; ")));
  if (const std::vector<std::string> unions = union_entries(tally.unions()); !unions.empty())
    add("unions", fmt::format("{}", fmt::join(unions, "; ")));
  if (const std::vector<std::string> prices = price_entries(all); !prices.empty())
    add("prices of directions", fmt::format("{}", fmt::join(prices, "; ")));
  add("conventions", conventions_text(subject.conventions));
  for (const std::string& rounding : rounding_text(subject)) add("rounding", rounding);
  for (const std::string& setting : settings_text(subject)) add("setting", setting);
  add("tolerance", tolerance_text(tolerance));
  if (from.fit) add("fit", fit_text(*from.fit));
  return fmt::format("<details><summary>How they were judged</summary><dl class=\"settings\">{}</dl></details>", rows);
}

}  // namespace

std::size_t place_on_page(Verdict verdict) {
  constexpr auto without_answer = static_cast<std::size_t>(Verdict::nan);
  constexpr auto wrong = static_cast<std::size_t>(Verdict::unsupported) - without_answer;
  const auto rank = static_cast<std::size_t>(verdict);
  if (!fails(verdict)) return rank;
  return rank < without_answer ? wrong + rank : rank - without_answer;
}

std::vector<picture::Share> verdict_shares(const TallyRow& all, const std::set<Verdict>& shown) {
  std::vector<picture::Share> shares;
  const auto add = [&](Verdict verdict) {
    const std::string link = shown.contains(verdict) ? std::string(name(verdict)) : "";
    shares.push_back({std::string(name(verdict)), all[verdict], style_of(verdict), link});
  };
  for (const Verdict verdict : {Verdict::pass, Verdict::touching_by_convention}) add(verdict);
  std::vector<Verdict> failures;
  for (std::size_t i = 0; i < verdict_count; ++i)
    if (fails(static_cast<Verdict>(i))) failures.push_back(static_cast<Verdict>(i));
  std::ranges::stable_sort(failures, {}, place_on_page);
  for (const Verdict verdict : failures) add(verdict);
  add(Verdict::unsupported);
  return shares;
}

std::string html_header(const SubjectInfo& subject, const Tally& tally, const Tolerance& tolerance, const RunInfo& from,
                        const std::set<Verdict>& shown) {
  const TallyRow& all = tally.all();
  const std::string cut_short = from.cut_short.empty() ? "" : from.cut_short + "; this is what was judged";
  const std::string bar = picture::share_bar(verdict_shares(all, shown), "shares", "Cases by verdict");
  const std::string both = all[Verdict::touching_by_convention] == 0
                               ? ""
                               : fmt::format("<p class=\"soft\">Passes are pass and touching-by-convention: {} + {}.</p>\n",
                                             all[Verdict::pass], all[Verdict::touching_by_convention]);
  return fmt::format("<header><h1>{}</h1>\n<p class=\"answer\">{}</p>\n{}{}{}{}{}{}</header>\n", markup(title(subject)),
                     totals_text(all.total, all.passes(), all.failures(), sum(from.unattributed)), warning(dwarfed_text(all)),
                     warning(cut_short), warning(coverage_warning(all.judged)), bar, both, settings_list(subject, tally, tolerance, from));
}

}  // namespace fathom::harness
