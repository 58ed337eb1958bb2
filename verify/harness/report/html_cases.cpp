// SPDX-License-Identifier: GPL-3.0-or-later
// The table of all cases, folded.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "verify/harness/report/html.hpp"
#include "verify/harness/report/text.hpp"
#include "verify/harness/tally.hpp"
#include "view/picture/markup.hpp"

namespace fathom::harness {
namespace {

constexpr std::size_t most_listed = 5000;

/// What tells outcomes apart; those of repeated cases share their pictures one by one.
using Key = std::tuple<std::string, std::string, std::string, Verdict>;
Key key_of(const Outcome& outcome) { return {outcome.id, outcome.variant, outcome.digest, outcome.verdict}; }

/// Failures worst first, then what was declined and passes by name: an order that does not depend on which answer came first.
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
      name(outcome.verdict), named, judged ? error_text(*outcome.judgement->error_relative) : "", markup(sentence_of(outcome)));
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

}  // namespace

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
      "<thead><tr><th scope=\"col\" class=\"text\">case</th><th scope=\"col\" class=\"text\">verdict</th><th scope=\"col\">relative "
      "error</th>"
      "<th scope=\"col\" class=\"text\">what the judge says</th></tr></thead>\n<tbody id=\"cases\">\n{}</tbody>",
      rows);
  const std::string more =
      all.size() > listed
          ? fmt::format("<p>{} further cases are not listed here; --report FILE holds every verdict.</p>\n", all.size() - listed)
          : "";
  return fmt::format("<details class=\"part\" id=\"all-cases\"><summary>Cases: {} of {}, failures first</summary>\n{}{}{}</details>\n",
                     listed, all.size(),
                     picture::filter_bar("cases", "verdict", choices({all.begin(), all.begin() + static_cast<std::ptrdiff_t>(listed)})),
                     picture::table_box("Cases", table, true), more);
}

}  // namespace fathom::harness
