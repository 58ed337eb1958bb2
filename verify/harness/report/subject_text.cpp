// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "fathom/numbers.hpp"
#include "verify/harness/report/text.hpp"
#include "verify/judge/words.hpp"

namespace fathom::harness {

std::string precision_text(const NumberFormat& format) {
  const std::string_view points = name(format.points), answers = name(format.answers);
  return points == answers ? std::string(points) : fmt::format("points {}, answers {}", points, answers);
}

std::string title(const SubjectInfo& subject) {
  const std::string precision = precision_text(subject.format);
  const std::string library = subject.library.empty() ? "" : subject.library + ", ";
  return fmt::format("{}{}{} ({}{})", subject.name, subject.version.empty() ? "" : " ", subject.version, library, precision);
}

std::string conventions_text(const Conventions& conventions) {
  using Touching = Conventions::Touching;
  const char* touching = conventions.touching == Touching::overlap    ? "bodies that touch overlap"
                         : conventions.touching == Touching::separate ? "bodies that touch are separate"
                                                                      : "bodies that touch are either";
  return fmt::format("{}; the depth is {}; {} moves; directions {}{}", touching,
                     conventions.depth == Conventions::Sign::positive ? "positive" : "negative", moving_body(conventions),
                     conventions.unit ? "have length 1" : "may have any length",
                     conventions.claims == Conventions::Claims::separating ? "; claims: separating" : "");
}

const char* moving_body(const Conventions& conventions) { return conventions.moves == Conventions::Body::a ? "A" : "B"; }

std::vector<std::string> settings_text(const SubjectInfo& subject) {
  std::vector<std::string> result;
  for (const auto& [name, value] : subject.settings) result.push_back(fmt::format("{} = {}", name, value));
  return result;
}

std::vector<std::string> rounding_text(const SubjectInfo& subject) {
  std::vector<std::string> result;
  for (const auto& [word, radius] : subject.rounding)
    result.push_back(fmt::format("{} of {}", round_binary64(radius), word.empty() ? "every body" : word));
  return result;
}

std::string dwarfed_text(const TallyRow& all) {
  return all.dwarfed == 0
             ? ""
             : fmt::format("its own radii are larger than the bodies in {} of {}", all.dwarfed, count_text(all.total, "case", "cases"));
}

std::string tolerance_text(const Tolerance& tolerance) {
  std::string result =
      fmt::format("relative {}, absolute {} of the extent", exact_text(tolerance.relative), exact_text(tolerance.absolute));
  if (tolerance.ulps > 0) result += fmt::format(", {} ulp", tolerance.ulps);
  result += "; the largest counts";
  return tolerance.policy == Policy() ? result : result + "; policy " + judging::policy_text(tolerance.policy);
}

std::vector<std::string> price_entries(const TallyRow& row) {
  std::vector<std::string> result;
  if (!row.dearer.empty())
    result.push_back(fmt::format("median {} above the depth, worst {}, of {}", error_text(row.dearer.median()),
                                 error_text(row.dearer.worst()), count_text(row.dearer.size(), "direction", "directions")));
  if (row.longer > 0) result.push_back(count_text(row.longer, "longer translation passes", "longer translations pass") + " by the policy");
  return result;
}

std::vector<Tally::Line> shown_parts(const Tally& tally) {
  constexpr const char* labels[] = {"solid", "metre-sized", "both"};
  std::vector<Tally::Line> result;
  for (std::size_t i = 0; i < tally.parts().size(); ++i) {
    const TallyRow& row = tally.parts()[i].row;
    if (row.total > 0 && row.total < tally.all().total) result.push_back({labels[i], row});
  }
  return result;
}

std::string fit_text(const mpq_class& fit) {
  return fmt::format("every case by a power of two: its longest side is less than {}, and at least half of that", exact_text(fit));
}

std::string sentence_of(const Outcome& outcome) {
  std::string result = outcome.judgement ? outcome.judgement->sentence : "";
  if (!outcome.detail.empty()) result += (result.empty() ? "" : "; ") + outcome.detail;
  return result.empty() ? std::string(name(outcome.verdict)) : result;
}

std::string error_text(double error) { return error == 0 ? "0" : fmt::format("{:.3g}", error); }

std::string count_text(std::size_t count, const std::string& one, const std::string& more) {
  return fmt::format("{} {}", count, count == 1 ? one : more);
}

std::string totals_text(std::size_t total, std::size_t passes, std::size_t failures, std::size_t unattributed) {
  std::string result = fmt::format("{}: {} pass, {} fail", count_text(total, "case", "cases"), passes, failures);
  if (total > passes + failures) result += fmt::format(", {} unsupported", total - passes - failures);
  if (unattributed > 0) result += fmt::format("; {} unattributed", unattributed);
  return result;
}

std::vector<std::string> accuracy_entries(const TallyRow& row) {
  std::vector<std::string> result;
  if (row[Verdict::touching_by_convention] > 0)
    result.push_back(fmt::format("{} pass + {} touching-by-convention", row[Verdict::pass], row[Verdict::touching_by_convention]));
  for (std::size_t i = 0; i < accuracy_count; ++i)
    if (row.accuracies[i] > 0) result.push_back(fmt::format("{}: {}", name(static_cast<Accuracy>(i)), row.accuracies[i]));
  return result;
}

}  // namespace fathom::harness
