// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "fathom/numbers.hpp"
#include "verify/harness/report/reports.hpp"
#include "verify/harness/tally.hpp"
#include "verify/judge/truth.hpp"

namespace fathom::harness {
namespace {

using Lines = std::vector<std::string>;

constexpr std::size_t narrowest = 40;
constexpr std::size_t enough_for_errors = 70;  // columns that suffice for all errors in one block
constexpr std::size_t column_gap = 2;
constexpr std::size_t label_width = 13, verdict_width = 20;
constexpr std::size_t most_named = 5;  // failing cases of a verdict

/// A column: its heading, in as many lines as it has parts, and a cell for each row. The first
/// column is flush left.
struct Column {
  Lines head, cells;

  [[nodiscard]] std::size_t width() const {
    std::size_t result = 0;
    for (const std::string& text : head) result = std::max(result, text.size());
    for (const std::string& text : cells) result = std::max(result, text.size());
    return result;
  }
};

/// Splits "touching-by-convention" into "touching-", "by-", "convention".
Lines broken_name(std::string_view name) {
  Lines result(1);
  for (const char c : name) {
    result.back() += c;
    if (c == '-') result.emplace_back();
  }
  return result;
}

/// Adds the columns side by side.
void add_block(Lines& lines, const std::vector<const Column*>& columns) {
  std::size_t deepest = 0;
  for (const Column* column : columns) deepest = std::max(deepest, column->head.size());
  const auto add_line = [&](const std::function<std::string(const Column&)>& text) {
    std::string line = fmt::format("{:<{}}", text(*columns.front()), columns.front()->width());
    for (std::size_t i = 1; i < columns.size(); ++i)
      line += fmt::format("{:>{}}", text(*columns[i]), columns[i]->width() + column_gap);
    lines.push_back(line.substr(0, line.find_last_not_of(' ') + 1));
  };
  for (std::size_t i = 0; i < deepest; ++i) {  // headings are aligned at the bottom
    add_line([&](const Column& column) {
      const std::size_t empty = deepest - column.head.size();
      return i < empty ? "" : column.head[i - empty];
    });
  }
  for (std::size_t i = 0; i < columns.front()->cells.size(); ++i)
    add_line([&](const Column& column) { return column.cells[i]; });
}

/// Columns to be kept in one block.
using Group = std::vector<Column>;

/// Adds blocks, one below the other, as many as the width requires; each begins with the first
/// column.
void add_blocks(Lines& lines, const Column& first, const std::vector<Group>& groups, std::size_t widest) {
  std::vector<const Column*> block{&first};
  std::size_t width = first.width();
  for (const Group& group : groups) {
    std::size_t more = 0;
    for (const Column& column : group) more += column_gap + column.width();
    if (width + more > widest) {
      add_block(lines, block);
      lines.emplace_back();
      block = {&first};
      width = first.width();
    }
    for (const Column& column : group) block.push_back(&column);
    width += more;
  }
  add_block(lines, block);
}

void add_table(Lines& lines, const Tally& tally, std::size_t widest, bool all_rows) {
  std::vector<Tally::Line> rows = all_rows ? tally.lines(std::string::npos) : tally.failing_lines();
  rows.push_back({"all", tally.all()});
  for (const Tally::Line& part : shown_parts(tally)) rows.push_back(part);
  const auto column = [&](Lines head, const auto& cell) {
    Column result{std::move(head), {}};
    for (const Tally::Line& line : rows) result.cells.push_back(cell(line.row));
    return result;
  };
  Column labels{{"family"}, {}};
  for (const Tally::Line& line : rows) labels.cells.push_back(line.label);
  std::vector<Group> groups{{column({"cases"}, [](const TallyRow& row) { return fmt::format("{}", row.total); })}};
  for (const Verdict verdict : tally.verdicts()) {
    const auto cell = [verdict](const TallyRow& row) {
      return row[verdict] > 0 ? fmt::format("{}", row[verdict]) : ".";
    };
    groups.push_back({column(broken_name(name(verdict)), cell)});
  }
  groups.emplace_back();
  const auto add_errors = [&](const std::string& unit, Errors TallyRow::*errors) {
    if ((tally.all().*errors).empty()) return;
    const auto worst = [errors](const TallyRow& row) {
      return (row.*errors).empty() ? "." : error_text((row.*errors).worst());
    };
    const auto median = [errors](const TallyRow& row) {
      return (row.*errors).empty() ? "." : error_text((row.*errors).median());
    };
    if (widest < enough_for_errors && !groups.back().empty()) groups.emplace_back();
    groups.back().push_back(column({"worst", unit}, worst));
    groups.back().push_back(column({"median", unit}, median));
  };
  add_errors("relative", &TallyRow::relative);
  add_errors("in uR", &TallyRow::u_r);
  add_blocks(lines, labels, groups, widest);
}

/// Adds the text after the label, broken at spaces; a word that is longer than a line is broken at
/// the end of the line.
void add_words(Lines& lines, std::size_t widest, std::string line, std::string_view text, std::size_t indent) {
  const std::size_t room = widest - indent;
  while (text.size() > room) {
    const std::size_t space = text.rfind(' ', room);
    const std::size_t end = space == text.npos || space == 0 ? room : space;
    lines.push_back(line.append(text.substr(0, end)));
    line.assign(indent, ' ');
    text.remove_prefix(std::min(text.find_first_not_of(' ', end), text.size()));
  }
  lines.push_back(line.append(text));
}

/// "settings     a = 1; b = 2", broken between entries; what is too long for a line of its own, at
///               spaces.
void add_entries(Lines& lines, std::size_t widest, const std::string& label, const Lines& entries,
                 std::size_t indent = label_width) {
  const std::string margin(indent, ' ');
  std::string line = fmt::format("{:<{}}", label, indent), text;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string entry = ascii(entries[i]) + (i + 1 < entries.size() ? ";" : "");
    if (!text.empty() && indent + text.size() + 1 + entry.size() > widest) {
      add_words(lines, widest, line, text, indent);
      line = margin;
      text.clear();
    }
    text += (text.empty() ? "" : " ") + entry;
  }
  if (!entries.empty()) add_words(lines, widest, line, text, indent);
}

/// Returns explanations of the table's technical words.
Lines legend(const TallyRow& all) {
  Lines result;
  if (!all.relative.empty()) result.emplace_back("relative: the error of a depth or distance, over its true value");
  if (!all.u_r.empty())
    result.emplace_back(
        "uR: u, the unit roundoff of the subject's precision, times R, the largest coordinate of a case");
  if (!all.relative_excess.empty())
    result.emplace_back("excess: of the answered direction's separating distance over the depth");
  if (!result.empty()) result.emplace_back("more in docs/glossary.md");
  return result;
}

/// Adds "too-deep          a::7; a::2; 12 more" for each verdict.
void add_failures(Lines& lines, std::span<const Outcome> outcomes, std::size_t widest) {
  const auto worst = worst_failures(outcomes);
  if (worst.empty()) return;
  lines.emplace_back("failing cases, the worst of each verdict first");
  for (const auto& [verdict, indices] : worst) {
    Lines entries;
    for (const std::size_t i : indices) {
      if (entries.size() == most_named) break;
      entries.push_back(ascii(shown_id(outcomes[i].id, outcomes[i].variant), longest_id));
    }
    if (indices.size() > most_named) entries.push_back(fmt::format("{} more", indices.size() - most_named));
    add_entries(lines, widest, fmt::format("  {}", name(verdict)), entries, verdict_width);
  }
}

}  // namespace

std::string shown_id(std::string_view id, std::string_view variant) {
  return variant.empty() ? std::string(id) : fmt::format("{} ~{}", id, variant);
}

std::string precision_text(const NumberFormat& format) {
  const std::string_view points = name(format.points), answers = name(format.answers);
  return points == answers ? std::string(points) : fmt::format("points {}, answers {}", points, answers);
}

std::string title(const SubjectInfo& subject) {
  const std::string precision = precision_text(subject.format);
  const std::string library = subject.library.empty() ? "" : subject.library + ", ";
  return fmt::format("{}{}{} ({}{})", subject.name, subject.version.empty() ? "" : " ", subject.version, library,
                     precision);
}

std::string conventions_text(const Conventions& conventions) {
  using Touching = Conventions::Touching;
  const char* touching = conventions.touching == Touching::overlap    ? "bodies that touch overlap"
                         : conventions.touching == Touching::separate ? "bodies that touch are separate"
                                                                      : "bodies that touch are either";
  const auto manifold = [](const ContactLimits& limits) {
    return fmt::format("; contacts reach as far as bodies touch{}{}",
                       limits.most ? fmt::format(", at most {}", *limits.most) : "",
                       limits.margin == 0 ? "" : fmt::format(", less deep by {} at most", limits.margin));
  };
  return fmt::format("{}; the depth is {}; {} moves; directions {}{}{}", touching,
                     conventions.depth == Conventions::Sign::positive ? "positive" : "negative",
                     moving_body(conventions), conventions.unit ? "have length 1" : "may have any length",
                     conventions.claims == Conventions::Claims::separating ? "; claims: separating" : "",
                     conventions.manifold ? manifold(*conventions.manifold) : "");
}

const char* moving_body(const Conventions& conventions) {
  return conventions.moves == Conventions::Body::a ? "A" : "B";
}

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
  return all.dwarfed == 0 ? ""
                          : fmt::format("its own radii are larger than the bodies in {} of {}", all.dwarfed,
                                        counted(all.total, "case", "cases"));
}

std::string tolerance_text(const Tolerance& tolerance) {
  std::string result = fmt::format("relative {}, absolute {} of the extent", exact_text(tolerance.relative),
                                   exact_text(tolerance.absolute));
  if (tolerance.ulps > 0) result += fmt::format(", {} ulp", tolerance.ulps);
  if (tolerance.patch_slack) result += fmt::format("; patches with a slack of {}", exact_text(*tolerance.patch_slack));
  result += "; the largest counts";
  return tolerance.policy == Policy() ? result : result + "; policy " + judging::policy_text(tolerance.policy);
}

std::vector<std::string> excess_entries(const TallyRow& row) {
  std::vector<std::string> result;
  if (!row.relative_excess.empty())
    result.push_back(fmt::format("median {} above the depth, worst {}, of {}", error_text(row.relative_excess.median()),
                                 error_text(row.relative_excess.worst()),
                                 counted(row.relative_excess.size(), "direction", "directions")));
  if (row.excess_allowed > 0)
    result.push_back(counted(row.excess_allowed, "longer translation passes", "longer translations pass") +
                     " by the policy");
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
  return fmt::format("every case by a power of two: its longest side is less than {}, and at least half of that",
                     exact_text(fit));
}

std::string sentence_of(const Outcome& outcome) {
  std::string result = outcome.judgement ? outcome.judgement->sentence : "";
  if (!outcome.detail.empty()) result += (result.empty() ? "" : "; ") + outcome.detail;
  return result.empty() ? std::string(name(outcome.verdict)) : result;
}

std::string error_text(double error) { return error == 0 ? "0" : fmt::format("{:.3g}", error); }

std::string totals_text(std::size_t total, std::size_t passes, std::size_t failures, std::size_t unattributed) {
  std::string result = fmt::format("{}: {} pass, {} fail", counted(total, "case", "cases"), passes, failures);
  if (total > passes + failures) result += fmt::format(", {} unsupported", total - passes - failures);
  if (unattributed > 0) result += fmt::format("; {} unattributed", unattributed);
  return result;
}

std::vector<std::string> accuracy_entries(const TallyRow& row) {
  std::vector<std::string> result;
  if (row[Verdict::touching_by_convention] > 0)
    result.push_back(
        fmt::format("{} pass + {} touching-by-convention", row[Verdict::pass], row[Verdict::touching_by_convention]));
  for (std::size_t i = 0; i < accuracy_count; ++i)
    if (row.accuracies[i] > 0)
      result.push_back(fmt::format("{}: {}", name(static_cast<Accuracy>(i)), row.accuracies[i]));
  return result;
}

std::string Summary::table(const SubjectInfo& subject, std::span<const Outcome> outcomes, const Lines& where,
                           std::size_t columns, bool all_rows) const {
  const std::size_t widest = std::max(columns, narrowest);
  Lines lines;
  const std::string dwarfed = dwarfed_text(tally_.all());
  add_words(lines, widest, "", ascii(title(subject) + (dwarfed.empty() ? "" : "; " + dwarfed)), 0);
  add_entries(lines, widest, "conventions", {conventions_text(subject.conventions)});
  add_entries(lines, widest, "settings", settings_text(subject));
  add_entries(lines, widest, "rounding", rounding_text(subject));
  if (fit) add_entries(lines, widest, "fit", {fit_text(*fit)});
  lines.emplace_back();
  add_table(lines, tally_, widest, all_rows);
  lines.emplace_back();
  add_failures(lines, outcomes, widest);
  if (failures() > 0) add_entries(lines, widest, "see", where);
  add_entries(lines, widest, "passes", accuracy_entries(tally_.all()));
  add_entries(lines, widest, "judged", coverage_entries(tally_.all().judged));
  add_entries(lines, widest, "excess", excess_entries(tally_.all()));
  add_entries(lines, widest, "time", time_entries(tally_.times()));
  add_entries(lines, widest, "hulls", hull_entries(tally_.hulls()));
  add_entries(lines, widest, "unions", union_entries(tally_.unions()));
  add_entries(lines, widest, "contacts", contact_entries(tally_.contacts()));
  Lines things;
  for (const auto& [detail, count] : unattributed_) things.push_back(fmt::format("{} x {}", count, detail));
  add_entries(lines, widest, "unattributed", things);
  add_entries(lines, widest, "words", legend(tally_.all()));
  lines.push_back(totals_text(total(), passes(), failures(), unattributed()));
  return fmt::format("{}\n", fmt::join(lines, "\n"));
}

}  // namespace fathom::harness
