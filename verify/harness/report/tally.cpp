// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/tally.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "verify/harness/report/text.hpp"

namespace fathom::harness {
namespace {

constexpr std::size_t longest_label = 32;

template <std::size_t N>
void add_counts(std::array<std::size_t, N>& to, const std::array<std::size_t, N>& counts) {
  for (std::size_t i = 0; i < N; ++i) to[i] += counts[i];
}

}  // namespace

void Errors::add(double error) {
  if (!std::isnan(error)) errors_.push_back(error);
}

void Errors::add(const Errors& other) { errors_.insert(errors_.end(), other.errors_.begin(), other.errors_.end()); }

double Errors::worst() const {
  return *std::ranges::max_element(errors_, {}, [](double e) { return std::pair(std::abs(e), e); });
}

double Errors::median() const {
  std::vector<double> magnitudes(errors_.size());
  std::ranges::transform(errors_, magnitudes.begin(), [](double e) { return std::abs(e); });
  const auto middle = magnitudes.begin() + static_cast<std::ptrdiff_t>((magnitudes.size() - 1) / 2);
  std::ranges::nth_element(magnitudes, middle);
  return *middle;
}

void TallyRow::add(const Outcome& outcome) {
  ++total;
  ++verdicts[static_cast<std::size_t>(outcome.verdict)];
  dwarfed += outcome.dwarfed ? 1 : 0;
  judged.add(outcome);
  if (!outcome.judgement) return;
  const Judgement& judgement = *outcome.judgement;
  if (judgement.accuracy && fathom::passes(outcome.verdict)) ++accuracies[static_cast<std::size_t>(*judgement.accuracy)];
  if (judgement.error_relative) relative.add(*judgement.error_relative);
  if (judgement.error_u_r) u_r.add(*judgement.error_u_r);
  if (judgement.dearer) dearer.add(*judgement.dearer);
  longer += judgement.longer && fathom::passes(outcome.verdict) ? 1 : 0;
}

void TallyRow::add(const TallyRow& other) {
  total += other.total;
  add_counts(verdicts, other.verdicts);
  add_counts(accuracies, other.accuracies);
  judged.add(other.judged);
  relative.add(other.relative);
  u_r.add(other.u_r);
  dearer.add(other.dearer);
  longer += other.longer;
  dwarfed += other.dwarfed;
}

std::size_t TallyRow::failures() const {
  std::size_t result = 0;
  for (std::size_t i = 0; i < verdict_count; ++i) result += fails(static_cast<Verdict>(i)) ? verdicts[i] : 0;
  return result;
}

std::size_t TallyRow::passes() const { return total - failures() - (*this)[Verdict::unsupported]; }

void Tally::add(const Outcome& outcome) {
  all_.add(outcome);
  times_.add(outcome);
  hulls_.add(outcome);
  unions_.add(outcome);
  if (outcome.solid) parts_[0].row.add(outcome);
  if (outcome.metre_sized) parts_[1].row.add(outcome);
  if (outcome.solid && outcome.metre_sized) parts_[2].row.add(outcome);
  (outcome.variant.empty() ? families_[family_of(outcome.id)] : variants_["~" + outcome.variant]).add(outcome);
}

/// All families, the worst first.
std::vector<Tally::Line> Tally::ordered() const {
  std::vector<Line> result;
  for (const auto& [name, row] : families_) result.push_back({name.empty() ? "(no family)" : ascii(name, longest_label), row});
  std::ranges::stable_sort(result, std::greater(), [](const Line& line) { return line.row.failures(); });
  return result;
}

void Tally::add_variants(std::vector<Line>& to) const {
  for (const auto& [name, row] : variants_) to.push_back({ascii(name, longest_label), row});
}

std::vector<Tally::Line> Tally::lines(std::size_t most) const {
  std::vector<Line> result = ordered();
  if (result.size() > most) {
    Line rest{fmt::format("({} more)", result.size() - most), {}};
    for (std::size_t i = most; i < result.size(); ++i) rest.row.add(result[i].row);
    result.resize(most);
    result.push_back(std::move(rest));
  }
  add_variants(result);
  return result;
}

std::vector<Tally::Line> Tally::failing_lines() const {
  std::vector<Line> result, passing, declined;
  for (Line& line : ordered()) (line.row.failures() > 0 ? result : line.row.passes() > 0 ? passing : declined).push_back(std::move(line));
  const auto add_in_one = [&](const std::vector<Line>& lines, const std::string& label) {
    Line all{label, {}};
    for (const Line& line : lines) all.row.add(line.row);
    if (lines.size() == 1) all.label = lines.front().label;
    if (!lines.empty()) result.push_back(std::move(all));
  };
  add_in_one(passing, fmt::format("{} families pass", passing.size()));
  add_in_one(declined, fmt::format("({} not judged)", declined.size()));
  add_variants(result);
  return result;
}

std::vector<Verdict> Tally::verdicts() const {
  std::vector<Verdict> result;
  const auto add = [&](std::size_t i) {
    if (all_.verdicts[i] > 0) result.push_back(static_cast<Verdict>(i));
  };
  constexpr auto first_pass = static_cast<std::size_t>(Verdict::touching_by_convention);
  for (std::size_t i = verdict_count; i-- > first_pass;) add(i);
  for (std::size_t i = 0; i < first_pass; ++i) add(i);
  return result;
}

}  // namespace fathom::harness
