// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/report/html.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "verify/harness/report/html_parts.hpp"
#include "verify/harness/report/markup.hpp"
#include "verify/harness/report/subject_text.hpp"

namespace fathom::harness {
namespace {

constexpr std::size_t most_listed = 5000;

/// What a reader must know before any number.
std::string warning(const std::string& text) {
  return text.empty() ? "" : fmt::format("<p class=\"warning\" role=\"note\">{}</p>\n", markup(text));
}

std::string header(const SubjectInfo& subject, const Tally& tally, const Tolerance& tolerance, const RunInfo& from) {
  const TallyRow& all = tally.all();
  const std::string cut_short = from.cut_short.empty() ? "" : from.cut_short + "; this is what was judged";
  std::string result = fmt::format("<header><h1>{}</h1>\n<p><strong>{}</strong></p>\n{}{}<dl>", markup(title(subject)),
                                   totals_text(all.total, all.passes(), all.failures(), sum(from.unattributed)), warning(cut_short),
                                   warning(coverage_warning(all.judged)));
  const auto add = [&](const char* what, const std::string& text) { result += fmt::format("<dt>{}</dt><dd>{}</dd>", what, markup(text)); };
  add("conventions", conventions_text(subject.conventions));
  for (const std::string& setting : settings_text(subject)) add("setting", setting);
  add("tolerance", tolerance_text(tolerance));
  if (const std::vector<std::string> classes = accuracy_entries(all); !classes.empty())
    add("passes", fmt::format("{}", fmt::join(classes, "; ")));
  add("judged", fmt::format("{}", fmt::join(coverage_entries(all.judged), "; ")));
  return result + "</dl></header>\n";
}

/// Failures in the order of failures_to_show, at most as many as are shown.
std::vector<const HtmlFailure*> chosen(std::span<const HtmlFailure> failures) {
  std::vector<Outcome> outcomes;
  for (const HtmlFailure& failure : failures) outcomes.push_back(failure.outcome);
  std::vector<const HtmlFailure*> result;
  for (const std::size_t i : failures_to_show(outcomes)) result.push_back(&failures[i]);
  return result;
}

/// What tells outcomes apart; those of repeated cases are counted.
using Key = std::tuple<std::string, std::string, std::string, Verdict>;
Key key_of(const Outcome& outcome) { return {outcome.id, outcome.variant, outcome.digest, outcome.verdict}; }

std::vector<const Outcome*> not_shown(std::span<const Outcome> outcomes, const std::vector<const HtmlFailure*>& shown) {
  std::map<Key, std::size_t> left;
  for (const HtmlFailure* failure : shown) ++left[key_of(failure->outcome)];
  std::vector<const Outcome*> result;
  for (const Outcome& outcome : outcomes) {
    if (!fails(outcome.verdict)) continue;
    const auto found = left.find(key_of(outcome));
    if (found != left.end() && found->second > 0) --found->second;
    else result.push_back(&outcome);
  }
  return result;
}

/// One section for each verdict, in order of rank.
std::string shown_failures(const SubjectInfo& subject, const std::vector<const HtmlFailure*>& shown, const Tally& tally) {
  std::map<Verdict, std::string> articles;
  std::map<Verdict, std::size_t> counts;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    articles[shown[i]->outcome.verdict] += failure_article(subject, *shown[i], fmt::format("f{}", i + 1));
    ++counts[shown[i]->outcome.verdict];
  }
  std::string links, sections;
  for (const auto& [verdict, text] : articles) {
    links += fmt::format("{}<a href=\"#{}\">{}</a>", links.empty() ? "" : ", ", name(verdict), name(verdict));
    sections += fmt::format("<section id=\"{0}\" aria-labelledby=\"{0}-h\"><h3 id=\"{0}-h\">{0}: {1} of {2}</h3>\n{3}</section>\n",
                            name(verdict), counts[verdict], tally.all()[verdict], text);
  }
  return links.empty() ? "" : fmt::format("<nav aria-label=\"Verdicts\"><p>{}</p></nav>\n{}", links, sections);
}

std::string listed_failures(const std::vector<const Outcome*>& rest) {
  if (rest.empty()) return "";
  std::string rows;
  for (std::size_t i = 0; i < std::min(rest.size(), most_listed); ++i)
    rows += fmt::format("<tr><th scope=\"row\" class=\"id\">{}</th><td class=\"text\">{}</td><td class=\"text\">{}</td></tr>\n",
                        markup(shown_id(rest[i]->id, rest[i]->variant)), name(rest[i]->verdict), markup(sentence_of(*rest[i])));
  const std::string more =
      rest.size() > most_listed ? fmt::format("<p>{} further failures are not listed here.</p>\n", rest.size() - most_listed) : "";
  return fmt::format(
      "<section><h2 id=\"others\">The other failures</h2>\n<div class=\"wide\" tabindex=\"0\" role=\"region\" "
      "aria-labelledby=\"others\"><table>"
      "<thead><tr><th scope=\"col\" class=\"text\">case</th><th scope=\"col\" class=\"text\">verdict</th>"
      "<th scope=\"col\" class=\"text\">what is wrong</th></tr></thead>\n<tbody>\n{}</tbody></table></div>\n{}</section>\n",
      rows, more);
}

/// How many failures are shown how.
std::string account(std::size_t failures, std::size_t shown, std::size_t rest) {
  if (failures == 0) return "<p>There are none.</p>\n";
  if (failures == 1 && rest == 0) return "<p>The only one is shown in full.</p>\n";
  if (rest == 0) return fmt::format("<p>All {} are shown in full, the worst of each verdict first.</p>\n", failures);
  return fmt::format(
      "<p>{} of {} are shown in full: the worst of each verdict and of each family, then the largest errors. {}.</p>\n", shown, failures,
      rest > most_listed
          ? fmt::format("Of the others, <a href=\"#others\">{} are listed below</a>, and {} are left out", most_listed, rest - most_listed)
          : fmt::format("The other {} are <a href=\"#others\">listed below</a>", rest));
}

/// What the subject did that is no case's fault.
std::string unattributed_section(const UnattributedCounts& unattributed) {
  if (unattributed.empty()) return "";
  std::string items;
  for (const auto& [detail, count] : unattributed) items += fmt::format("<li>{} x {}</li>\n", count, markup(detail));
  return "<section><h2>No case's fault</h2>\n<ul>\n" + items + "</ul></section>\n";
}

std::string footer(const RunInfo& from) {
  const std::string version = from.version.empty() ? "" : " " + from.version;
  const std::string command = from.command.empty() ? "" : fmt::format("\n<p class=\"soft\"><code>{}</code></p>", markup(from.command));
  return fmt::format("<footer><p class=\"soft\">Judged by fathom{}. Truths are exact; errors are correctly rounded.</p>{}</footer>\n",
                     markup(version), command);
}

}  // namespace

std::string html_page(const SubjectInfo& subject, std::span<const Outcome> outcomes, std::span<const HtmlFailure> failures,
                      const Tolerance& tolerance, const RunInfo& from) {
  Tally tally;
  for (const Outcome& outcome : outcomes) tally.add(outcome);
  const std::vector<const HtmlFailure*> shown = chosen(failures);
  const std::vector<const Outcome*> rest = not_shown(outcomes, shown);
  std::string result = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>"
      "<title>{}: verdicts</title><style>{}</style></head>\n<body>\n",
      markup(title(subject)), page_style());
  result += header(subject, tally, tolerance, from) + "<main>\n<section><h2>Verdicts</h2>\n" + tally_table(tally) + "</section>\n";
  result += unattributed_section(from.unattributed);
  const std::string charts = histogram(outcomes, false, tolerance.relative.get_d()) + histogram(outcomes, true, 0);
  if (!charts.empty()) result += "<section><h2>Errors</h2>\n" + charts + "</section>\n";
  result += "<section><h2>Failures</h2>\n" + account(tally.all().failures(), shown.size(), rest.size());
  result += shown_failures(subject, shown, tally) + "</section>\n" + listed_failures(rest);
  return result + "</main>\n" + footer(from) + "</body></html>\n";
}

}  // namespace fathom::harness
