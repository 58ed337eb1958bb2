// SPDX-License-Identifier: GPL-3.0-or-later
// The page from its head to its foot; each failure in full is in html_failure.cpp.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "verify/harness/report/reports.hpp"
#include "verify/harness/tally.hpp"
#include "view/picture/markup.hpp"

namespace fathom::harness {
namespace {

// ---- the head: the verdicts of all cases, and the rules of judging ----

/// Returns a box with a warning that concerns all numbers.
std::string warning(const std::string& text) {
  return text.empty() ? "" : fmt::format("<p class=\"warning\" role=\"note\">{}</p>\n", markup(text));
}

const char* style_of(Verdict verdict) {
  if (verdict == Verdict::pass) return "good";
  if (verdict == Verdict::touching_by_convention) return "fair";
  if (verdict == Verdict::unsupported) return "left";
  return verdict < Verdict::nan ? "lost" : "wrong";
}

std::string settings_list(const SubjectInfo& subject, const Tally& tally, const Tolerance& tolerance,
                          const RunInfo& from) {
  const TallyRow& all = tally.all();
  std::string rows;
  const auto add = [&](const char* what, const std::string& text) {
    rows += fmt::format("<dt>{}</dt><dd>{}</dd>", what, markup(text));
  };
  if (const std::vector<std::string> classes = accuracy_entries(all); !classes.empty())
    add("passes", fmt::format("{}", fmt::join(classes, "; ")));
  add("judged", fmt::format("{}", fmt::join(coverage_entries(all.judged), "; ")));
  if (const std::vector<std::string> times = time_entries(tally.times()); !times.empty())
    add("time", fmt::format("{}", fmt::join(times, "; ")));
  if (const std::vector<std::string> hulls = hull_entries(tally.hulls()); !hulls.empty())
    add("hulls", fmt::format("{}", fmt::join(hulls, "; ")));
  if (const std::vector<std::string> unions = union_entries(tally.unions()); !unions.empty())
    add("unions", fmt::format("{}", fmt::join(unions, "; ")));
  if (const std::vector<std::string> contacts = contact_entries(tally.contacts()); !contacts.empty())
    add("contacts", fmt::format("{}", fmt::join(contacts, "; ")));
  if (const std::vector<std::string> excess = excess_entries(all); !excess.empty())
    add("excess of directions", fmt::format("{}", fmt::join(excess, "; ")));
  add("conventions", conventions_text(subject.conventions));
  for (const std::string& rounding : rounding_text(subject)) add("rounding", rounding);
  for (const std::string& setting : settings_text(subject)) add("setting", setting);
  add("tolerance", tolerance_text(tolerance));
  if (from.fit) add("fit", fit_text(*from.fit));
  return fmt::format("<details><summary>How they were judged</summary><dl class=\"settings\">{}</dl></details>", rows);
}

// ---- the table of verdicts by family ----

constexpr std::size_t few_families = 12;  // shown without opening anything

std::string cell(const std::string& text) { return "<td>" + text + "</td>"; }

/// Returns a link to the table of cases, which scripts then filter by family and verdict.
std::string to_cases(const std::string& text, const std::string& find, const std::string& verdict) {
  return fmt::format("<a href=\"#all-cases\" data-of=\"cases\" data-find=\"{}\" data-choice=\"{}\">{}</a>", find,
                     verdict, text);
}

std::string error_cells(const Errors& errors) {
  return errors.empty() ? cell("") + cell("") : cell(error_text(errors.worst())) + cell(error_text(errors.median()));
}

bool has_two_passes(const Tally& tally) { return tally.all()[Verdict::touching_by_convention] > 0; }

std::string row_element(const Tally::Line& line, const Tally& tally, const std::string& style) {
  const bool one_family = style.empty() && !line.label.starts_with('(');
  const std::string find = one_family ? markup(line.label) : "";
  const std::string label = one_family ? to_cases(markup(line.label), find, "") : markup(line.label);
  std::string result =
      fmt::format("<tr{}><th scope=\"row\">{}</th>{}", style, label, cell(fmt::format("{}", line.row.total)));
  if (has_two_passes(tally)) result += cell(fmt::format("{}", line.row.passes()));
  for (const Verdict verdict : tally.verdicts()) {
    const std::string count = line.row[verdict] > 0 ? fmt::format("{}", line.row[verdict]) : "";
    const bool linked = !count.empty() && (one_family || !style.empty());
    result += cell(linked ? to_cases(count, find, std::string(name(verdict))) : count);
  }
  if (!tally.all().relative.empty()) result += error_cells(line.row.relative);
  if (!tally.all().u_r.empty()) result += error_cells(line.row.u_r);
  return result + "</tr>\n";
}

// ---- the table of all cases, folded ----

/// The fields that identify outcomes; repeated cases, which share them, get the pictures one after
/// another.
using Key = std::tuple<std::string, std::string, std::string, Verdict>;
Key key_of(const Outcome& outcome) { return {outcome.id, outcome.variant, outcome.digest, outcome.verdict}; }

/// Returns the failures, worst first, then declined cases and passes by name. The order does not
/// depend on the order of the answers.
std::vector<const Outcome*> in_order(std::span<const Outcome> outcomes) {
  std::vector<const Outcome*> result;
  for (const std::size_t i : worst_first(outcomes)) result.push_back(&outcomes[i]);
  const auto failures = static_cast<std::ptrdiff_t>(result.size());
  for (const Outcome& outcome : outcomes)
    if (!fails(outcome.verdict)) result.push_back(&outcome);
  std::sort(result.begin() + failures, result.end(), [](const Outcome* left, const Outcome* right) {
    return std::tie(left->id, left->variant, left->digest) < std::tie(right->id, right->variant, right->digest);
  });
  std::ranges::stable_sort(result, {}, [](const Outcome* outcome) { return place_on_page(outcome->verdict); });
  return result;
}

std::string row(const Outcome& outcome, const std::string& anchor) {
  const std::string id = markup(shown_id(outcome.id, outcome.variant));
  const std::string named = anchor.empty() ? id : fmt::format("<a href=\"#{}\">{}</a>", anchor, id);
  const bool judged = outcome.judgement && outcome.judgement->error_relative;
  return fmt::format(
      "<tr data-kind=\"{0}\"><th scope=\"row\" class=\"id\">{1}</th><td class=\"name\">{0}</td><td>{2}</td><td "
      "class=\"text\">{3}</td></tr>\n",
      name(outcome.verdict), named, judged ? error_text(*outcome.judgement->error_relative) : "",
      markup(sentence_of(outcome)));
}

std::vector<picture::Choice> choices(const std::vector<const Outcome*>& outcomes) {
  std::map<std::size_t, std::pair<Verdict, std::size_t>> counts;
  for (const Outcome* outcome : outcomes) {
    auto& [verdict, count] = counts[place_on_page(outcome->verdict)];
    verdict = outcome->verdict;
    ++count;
  }
  std::vector<picture::Choice> result;
  for (const auto& [place, counted] : counts) {
    const std::string label(name(counted.first));
    result.push_back({label, fmt::format("{} ({})", label, counted.second)});
  }
  return result;
}

// ---- the histogram of errors by decade, as SVG ----

constexpr int lowest = -18, highest = 18;  // decades; errors beyond are counted in the outermost ones
constexpr double left = 190, top = 8, row_height = 46, bar_height = 34, chart_width = 700, gap = 3;

/// Counts of one verdict: exact zeros, and by decade.
struct Row {
  std::size_t zeros = 0, total = 0;
  std::map<int, std::size_t> decades;
};

/// Returns floor(log10 |error|), kept within bounds; for infinity the highest.
int decade_of(double error) {
  const double exponent = std::floor(std::log10(std::abs(error)));
  return static_cast<int>(std::clamp(exponent, static_cast<double>(lowest), static_cast<double>(highest)));
}

std::map<Verdict, Row> rows_of(std::span<const Outcome> outcomes, bool in_u_r) {
  std::map<Verdict, Row> result;
  for (const Outcome& outcome : outcomes) {
    if (!outcome.judgement) continue;
    const std::optional<double> error = in_u_r ? outcome.judgement->error_u_r : outcome.judgement->error_relative;
    if (!error || std::isnan(*error)) continue;
    Row& row = result[outcome.verdict];
    ++row.total;
    ++(*error == 0 ? row.zeros : row.decades[decade_of(*error)]);
  }
  return result;
}

/// The decades of the axis, and their places: slot 0 is that of zeros.
struct Axis {
  int first, last;

  explicit Axis(const std::map<Verdict, Row>& rows) : first(highest), last(lowest) {
    for (const auto& [verdict, row] : rows) {
      if (row.decades.empty()) continue;
      first = std::min(first, row.decades.begin()->first);
      last = std::max(last, row.decades.rbegin()->first);
    }
    if (first > last) first = last = 0;
  }
  [[nodiscard]] double slot_width() const { return (chart_width - left) / (last - first + 3); }
  [[nodiscard]] double start(int decade) const {
    return left + slot_width() * (decade - first + 2);
  }  // one slot is left free after the zeros
};

std::string bar(double x, double width, double ground, std::size_t count, std::size_t most, Verdict verdict,
                const std::string& what) {
  const double height = std::max(2.0, bar_height * static_cast<double>(count) / static_cast<double>(most));
  return fmt::format(
      "<rect class=\"bar{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"><title>{}: {} "
      "{}</title></rect>",
      fails(verdict) ? " failing" : "", x, ground - height, width - gap, height, name(verdict),
      counted(count, "case", "cases"), what);
}

std::string decade_text(int decade) {
  if (decade == lowest) return fmt::format("below 1e{}", decade + 1);
  return decade == highest ? fmt::format("from 1e{} on", decade) : fmt::format("from 1e{} to 1e{}", decade, decade + 1);
}

std::string row_elements(const Axis& axis, Verdict verdict, const Row& row, double ground) {
  std::size_t most = row.zeros;
  for (const auto& [decade, count] : row.decades) most = std::max(most, count);
  std::string result = fmt::format(
      "<text x=\"0\" y=\"{0:.1f}\">{2}</text><text class=\"soft\" x=\"0\" y=\"{1:.1f}\">{3}, at most {4} in a "
      "bar</text>",
      ground - 16, ground - 2, name(verdict), row.total, most);
  if (row.zeros > 0) result += bar(left, axis.slot_width(), ground, row.zeros, most, verdict, "with no error at all");
  for (const auto& [decade, count] : row.decades)
    result += bar(axis.start(decade), axis.slot_width(), ground, count, most, verdict, decade_text(decade));
  return result +
         fmt::format("<line x1=\"{}\" x2=\"{}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>\n", left, chart_width, ground, ground);
}

std::string axis_elements(const Axis& axis, double ground, double tolerance) {
  const int step = axis.last - axis.first > 20 ? 3 : axis.last - axis.first > 10 ? 2 : 1;
  std::string result = fmt::format("<text class=\"soft\" x=\"{}\" y=\"{}\">0</text>", left, ground + 16);
  for (int decade = axis.first; decade <= axis.last + 1; decade += step) {
    const double x = axis.start(decade) - gap / 2;
    result += fmt::format("<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\"/>", x, ground, ground + 4);
    result += fmt::format("<text class=\"soft\" text-anchor=\"middle\" x=\"{:.1f}\" y=\"{}\">1e{}</text>", x,
                          ground + 16, decade);
  }
  if (!(tolerance > 0)) return result;
  const double exponent = std::log10(tolerance);
  if (exponent < axis.first || exponent > axis.last + 1) return result;
  const double x = axis.start(axis.first) + (exponent - axis.first) * axis.slot_width() - gap / 2;
  return result + fmt::format(
                      "<line class=\"limit\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\"><title>relative "
                      "tolerance {3}</title></line>",
                      x, top, ground, error_text(tolerance));
}

/// Returns the failures with their ids, the worst of each verdict first, in the order of the page.
std::vector<Anchored> chosen(std::span<const HtmlFailure> failures) {
  std::vector<Outcome> outcomes;
  for (const HtmlFailure& failure : failures) outcomes.push_back(failure.outcome);
  std::vector<Anchored> result;
  for (const std::size_t i : failures_to_show(outcomes)) result.push_back({&failures[i], ""});
  std::ranges::stable_sort(result, {},
                           [](const Anchored& each) { return place_on_page(each.failure->outcome.verdict); });
  for (std::size_t i = 0; i < result.size(); ++i) result[i].anchor = fmt::format("f{}", i + 1);
  return result;
}

/// Returns the worst failure of one verdict, and folded the others.
std::string verdict_section(const SubjectInfo& subject, std::span<const Anchored> shown, std::size_t all) {
  const std::string_view verdict = name(shown.front().failure->outcome.verdict);
  std::string result =
      fmt::format("<section id=\"{0}\" aria-labelledby=\"{0}-h\"><h3 id=\"{0}-h\">{0}: {1} of {2}</h3>\n{3}", verdict,
                  shown.size(), all, failure_article(subject, *shown.front().failure, shown.front().anchor));
  if (shown.size() > 1) {
    result += fmt::format("<details class=\"part\"><summary>{} more of {}, the worst first</summary>\n",
                          shown.size() - 1, verdict);
    for (const Anchored& each : shown.subspan(1)) result += failure_article(subject, *each.failure, each.anchor);
    result += "</details>\n";
  }
  return result + "</section>\n";
}

/// Returns one section for each verdict.
std::string shown_failures(const SubjectInfo& subject, const std::vector<Anchored>& shown, const Tally& tally) {
  std::string result;
  for (auto begin = shown.begin(); begin != shown.end();) {
    const Verdict verdict = begin->failure->outcome.verdict;
    const auto end = std::find_if(begin, shown.end(),
                                  [&](const Anchored& each) { return each.failure->outcome.verdict != verdict; });
    result += verdict_section(subject, {begin, end}, tally.all()[verdict]);
    begin = end;
  }
  return result;
}

/// Returns a sentence on how many failures are shown, and how.
std::string account(std::size_t failures, std::size_t shown) {
  if (failures == 0) return "<p>There are none.</p>\n";
  if (failures == 1 && shown == 1) return "<p>The only one is shown in full.</p>\n";
  if (failures == shown)
    return fmt::format("<p>All {} are shown in full, the worst of each verdict first.</p>\n", failures);
  return fmt::format(
      "<p>{} of {} are shown in full: the worst of each verdict and of each family, then the largest errors. The "
      "others are among the "
      "<a href=\"#all-cases\">cases</a>.</p>\n",
      shown, failures);
}

/// Returns the section on failures that no case caused.
std::string unattributed_section(const UnattributedCounts& unattributed) {
  if (unattributed.empty()) return "";
  std::string items;
  for (const auto& [detail, count] : unattributed)
    items += fmt::format("<li>{} x {}</li>\n", count, markup(picture::without_folders(detail)));
  return "<section><h2>No case's fault</h2>\n<ul>\n" + items + "</ul></section>\n";
}

std::string footer(const RunInfo& from) {
  const std::string version = from.version.empty() ? "" : " " + from.version;
  const std::string command = from.command.empty() ? ""
                                                   : fmt::format("\n<p class=\"soft\"><code>{}</code></p>",
                                                                 markup(picture::without_folders(from.command)));
  return fmt::format(
      "<footer><p class=\"soft\">Judged by fathom{}. Truths are exact; errors are correctly rounded.</p>{}</footer>\n",
      markup(version), command);
}

/// Returns the table of cases with their verdicts, in the order of the page and worst first, up to
/// the limit of a page; rows of `shown` link to the pictures.
std::string cases_table(std::span<const Outcome> outcomes, const std::vector<Anchored>& shown) {
  if (outcomes.empty()) return "";
  std::multimap<Key, std::string> anchors;
  for (const Anchored& each : shown) anchors.emplace(key_of(each.failure->outcome), each.anchor);
  const std::vector<const Outcome*> all = in_order(outcomes);
  const std::size_t listed = std::min(all.size(), most_listed);
  std::string rows;
  for (std::size_t i = 0; i < listed; ++i) {
    const auto found = anchors.find(key_of(*all[i]));
    rows += row(*all[i], found == anchors.end() ? "" : found->second);
    if (found != anchors.end()) anchors.erase(found);
  }
  const std::string table = fmt::format(
      "<thead><tr><th scope=\"col\" class=\"text\">case</th><th scope=\"col\" class=\"text\">verdict</th><th "
      "scope=\"col\">relative "
      "error</th>"
      "<th scope=\"col\" class=\"text\">what the judge says</th></tr></thead>\n<tbody id=\"cases\">\n{}</tbody>",
      rows);
  const std::string more =
      all.size() > listed
          ? fmt::format("<p>{} further cases are not listed here; --report FILE holds every verdict.</p>\n",
                        all.size() - listed)
          : "";
  return fmt::format(
      "<details class=\"part\" id=\"all-cases\"><summary>Cases: {} of {}, failures first</summary>\n{}{}{}</details>\n",
      listed, all.size(),
      picture::filter_bar("cases", "verdict",
                          choices({all.begin(), all.begin() + static_cast<std::ptrdiff_t>(listed)})),
      picture::table_box("Cases", table, true), more);
}

/// Returns the numbers of errors by magnitude, one row for each verdict; empty if no depth was
/// claimed. `in_u_r`: in units of uR, else relative. `tolerance`: draws a line there if positive.
std::string histogram(std::span<const Outcome> outcomes, bool in_u_r, double tolerance) {
  const std::map<Verdict, Row> rows = rows_of(outcomes, in_u_r);
  if (rows.empty()) return "";
  const Axis axis(rows);
  const double ground = top + row_height * static_cast<double>(rows.size());
  const std::string what = in_u_r ? "in units of uR" : "relative to the depth", id = in_u_r ? "errors-u" : "errors-r";
  std::string body, described;
  double at = top;
  for (const auto& [verdict, row] : rows) {
    body += row_elements(axis, verdict, row, at += row_height);
    described += fmt::format("{}{} {}", described.empty() ? "" : ", ", row.total, name(verdict));
  }
  return fmt::format(
      "<figure><div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Errors {0}\"><svg class=\"chart\" "
      "viewBox=\"0 0 {1} {2}\" "
      "width=\"{1}\" "
      "height=\"{2}\" role=\"img\" aria-labelledby=\"{3}-t {3}-d\"><title id=\"{3}-t\">Errors of the claimed depths, "
      "{0}</title>"
      "<desc id=\"{3}-d\">Numbers of cases by verdict and by the decade of the error: {4}.</desc>\n{5}{6}</svg></div>"
      "<figcaption>Magnitudes of the errors {0}, by decade; bars are as high as cases are many, in each row for "
      "itself{7}."
      "</figcaption></figure>\n",
      what, chart_width + 20, ground + 24, id, described, body, axis_elements(axis, ground, tolerance),
      tolerance > 0 ? "; dashed: the relative tolerance" : "");
}

/// Returns the subject, the result in one line, warnings, a bar of all verdicts, and the rules of
/// judging. `shown`: the verdicts that have a section.
std::string html_header(const SubjectInfo& subject, const Tally& tally, const Tolerance& tolerance, const RunInfo& from,
                        const std::set<Verdict>& shown) {
  const TallyRow& all = tally.all();
  const std::string cut_short = from.cut_short.empty() ? "" : from.cut_short + "; this is what was judged";
  const std::string bar = picture::share_bar(verdict_shares(all, shown), "shares", "Cases by verdict");
  const std::string both =
      all[Verdict::touching_by_convention] == 0
          ? ""
          : fmt::format("<p class=\"soft\">Passes are pass and touching-by-convention: {} + {}.</p>\n",
                        all[Verdict::pass], all[Verdict::touching_by_convention]);
  return fmt::format("<header><h1>{}</h1>\n<p class=\"answer\">{}</p>\n{}{}{}{}{}{}</header>\n", markup(title(subject)),
                     totals_text(all.total, all.passes(), all.failures(), sum(from.unattributed)),
                     warning(dwarfed_text(all)), warning(cut_short), warning(coverage_warning(all.judged)), bar, both,
                     settings_list(subject, tally, tolerance, from));
}

/// Returns the counts and errors of each family.
std::string tally_table(const Tally& tally) {
  if (tally.all().total == 0) return "";
  std::string head = "<th scope=\"col\" class=\"text\">family</th><th scope=\"col\">cases</th>";
  const auto add = [&](std::string_view text) { head += fmt::format("<th scope=\"col\">{}</th>", text); };
  if (has_two_passes(tally)) add("passes, of both kinds");
  for (const Verdict verdict : tally.verdicts()) add(name(verdict));
  if (!tally.all().relative.empty()) add("worst, relative"), add("median, relative");
  if (!tally.all().u_r.empty()) add("worst, in uR"), add("median, in uR");
  const std::vector<Tally::Line> lines = tally.lines();
  std::string rows = row_element({"all", tally.all()}, tally, " class=\"all\"");
  for (const Tally::Line& part : shown_parts(tally)) rows += row_element({"(" + part.label + ")", part.row}, tally, "");
  for (const Tally::Line& line : lines) rows += row_element(line, tally, "");
  const std::string table = fmt::format(
      "<caption>Cases by family and verdict</caption>\n<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody>", head, rows);
  return fmt::format(
      "<details class=\"part\"{}><summary>Families: {}</summary>\n<p class=\"soft\">Errors are those of the claimed "
      "depths, below 0 where "
      "the "
      "depth is too small; medians are of their magnitudes. u is the unit roundoff of the subject's precision, R the "
      "largest coordinate of "
      "a "
      "case.</p>\n{}</details>\n",
      lines.size() <= few_families ? " open=\"open\"" : "", lines.size(),
      picture::table_box("Verdicts by family", table, true));
}

}  // namespace

std::vector<std::size_t> failures_to_show(std::span<const Outcome> outcomes, std::size_t most) {
  const std::vector<std::size_t> worst = worst_first(outcomes);
  std::set<std::size_t> chosen;  // indices into `worst`
  const auto choose = [&](const auto& is_new) {
    for (std::size_t k = 0; k < worst.size(); ++k)
      if (chosen.size() < most && !chosen.contains(k) && is_new(outcomes[worst[k]])) chosen.insert(k);
  };
  std::set<Verdict> verdicts;
  std::set<std::string> families;
  choose([&](const Outcome& outcome) {
    const bool is_new = verdicts.insert(outcome.verdict).second;
    if (is_new) families.insert(family_of(outcome.id));
    return is_new;
  });
  choose([&](const Outcome& outcome) { return families.insert(family_of(outcome.id)).second; });
  choose([](const Outcome&) { return true; });
  std::vector<std::size_t> result;
  for (const std::size_t k : chosen) result.push_back(worst[k]);
  return result;
}

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

std::string html_page(const SubjectInfo& subject, std::span<const Outcome> outcomes,
                      std::span<const HtmlFailure> failures, const Tolerance& tolerance, const RunInfo& from) {
  Tally tally;
  for (const Outcome& outcome : outcomes) tally.add(outcome);
  const std::vector<Anchored> shown = chosen(failures);
  std::set<Verdict> with_section;
  for (const Anchored& each : shown) with_section.insert(each.failure->outcome.verdict);
  std::string body =
      html_header(subject, tally, tolerance, from, with_section) + "<main>\n" + unattributed_section(from.unattributed);
  body += "<section><h2>Failures</h2>\n" + account(tally.all().failures(), shown.size());
  body += shown_failures(subject, shown, tally) + "</section>\n";
  if (!outcomes.empty())
    body += "<section><h2>All cases</h2>\n" + tally_table(tally) + cases_table(outcomes, shown) + "</section>\n";
  const std::string charts = histogram(outcomes, false, tolerance.relative.get_d()) + histogram(outcomes, true, 0);
  if (!charts.empty()) body += "<section><h2>Errors</h2>\n" + charts + "</section>\n";
  return picture::page(markup(title(subject)) + ": verdicts", body + "</main>\n" + footer(from));
}

}  // namespace fathom::harness
