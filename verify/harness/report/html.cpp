// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/report/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "verify/harness/report/text.hpp"
#include "view/picture/markup.hpp"

namespace fathom::harness {
namespace {

/// The failures with their ids, of each verdict the worst first, in the order of the page.
std::vector<Anchored> chosen(std::span<const HtmlFailure> failures) {
  std::vector<Outcome> outcomes;
  for (const HtmlFailure& failure : failures) outcomes.push_back(failure.outcome);
  std::vector<Anchored> result;
  for (const std::size_t i : failures_to_show(outcomes)) result.push_back({&failures[i], ""});
  std::ranges::stable_sort(result, {}, [](const Anchored& each) { return place_on_page(each.failure->outcome.verdict); });
  for (std::size_t i = 0; i < result.size(); ++i) result[i].anchor = fmt::format("f{}", i + 1);
  return result;
}

/// The worst of one verdict, and folded those that follow.
std::string verdict_section(const SubjectInfo& subject, std::span<const Anchored> shown, std::size_t all) {
  const std::string_view verdict = name(shown.front().failure->outcome.verdict);
  std::string result = fmt::format("<section id=\"{0}\" aria-labelledby=\"{0}-h\"><h3 id=\"{0}-h\">{0}: {1} of {2}</h3>\n{3}", verdict,
                                   shown.size(), all, failure_article(subject, *shown.front().failure, shown.front().anchor));
  if (shown.size() > 1) {
    result += fmt::format("<details class=\"part\"><summary>{} more of {}, the worst first</summary>\n", shown.size() - 1, verdict);
    for (const Anchored& each : shown.subspan(1)) result += failure_article(subject, *each.failure, each.anchor);
    result += "</details>\n";
  }
  return result + "</section>\n";
}

/// One section for each verdict.
std::string shown_failures(const SubjectInfo& subject, const std::vector<Anchored>& shown, const Tally& tally) {
  std::string result;
  for (auto begin = shown.begin(); begin != shown.end();) {
    const Verdict verdict = begin->failure->outcome.verdict;
    const auto end = std::find_if(begin, shown.end(), [&](const Anchored& each) { return each.failure->outcome.verdict != verdict; });
    result += verdict_section(subject, {begin, end}, tally.all()[verdict]);
    begin = end;
  }
  return result;
}

/// How many failures are shown how.
std::string account(std::size_t failures, std::size_t shown) {
  if (failures == 0) return "<p>There are none.</p>\n";
  if (failures == 1 && shown == 1) return "<p>The only one is shown in full.</p>\n";
  if (failures == shown) return fmt::format("<p>All {} are shown in full, the worst of each verdict first.</p>\n", failures);
  return fmt::format(
      "<p>{} of {} are shown in full: the worst of each verdict and of each family, then the largest errors. The others are among the "
      "<a href=\"#all-cases\">cases</a>.</p>\n",
      shown, failures);
}

/// What the subject did that is no case's fault.
std::string unattributed_section(const UnattributedCounts& unattributed) {
  if (unattributed.empty()) return "";
  std::string items;
  for (const auto& [detail, count] : unattributed)
    items += fmt::format("<li>{} x {}</li>\n", count, markup(picture::without_folders(detail)));
  return "<section><h2>No case's fault</h2>\n<ul>\n" + items + "</ul></section>\n";
}

std::string footer(const RunInfo& from) {
  const std::string version = from.version.empty() ? "" : " " + from.version;
  const std::string command =
      from.command.empty() ? "" : fmt::format("\n<p class=\"soft\"><code>{}</code></p>", markup(picture::without_folders(from.command)));
  return fmt::format("<footer><p class=\"soft\">Judged by fathom{}. Truths are exact; errors are correctly rounded.</p>{}</footer>\n",
                     markup(version), command);
}

}  // namespace

std::string html_page(const SubjectInfo& subject, std::span<const Outcome> outcomes, std::span<const HtmlFailure> failures,
                      const Tolerance& tolerance, const RunInfo& from) {
  Tally tally;
  for (const Outcome& outcome : outcomes) tally.add(outcome);
  const std::vector<Anchored> shown = chosen(failures);
  std::set<Verdict> with_section;
  for (const Anchored& each : shown) with_section.insert(each.failure->outcome.verdict);
  std::string body = html_header(subject, tally, tolerance, from, with_section) + "<main>\n" + unattributed_section(from.unattributed);
  body += "<section><h2>Failures</h2>\n" + account(tally.all().failures(), shown.size());
  body += shown_failures(subject, shown, tally) + "</section>\n";
  if (!outcomes.empty()) body += "<section><h2>All cases</h2>\n" + tally_table(tally) + cases_table(outcomes, shown) + "</section>\n";
  const std::string charts = histogram(outcomes, false, tolerance.relative.get_d()) + histogram(outcomes, true, 0);
  if (!charts.empty()) body += "<section><h2>Errors</h2>\n" + charts + "</section>\n";
  return picture::page(markup(title(subject)) + ": verdicts", body + "</main>\n" + footer(from));
}

}  // namespace fathom::harness
