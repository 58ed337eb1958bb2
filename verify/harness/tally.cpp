// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/tally.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string_view>
#include <tuple>
#include <utility>

#include "fathom/numbers.hpp"
#include "verify/harness/outcome.hpp"
#include "verify/harness/report/reports.hpp"

namespace fathom::harness {
namespace {

/// Returns the number of digits at the end of the text.
std::size_t digits_behind(std::string_view text) {
  const std::size_t last = text.find_last_not_of("0123456789");
  return last == text.npos ? text.size() : text.size() - last - 1;
}

/// Returns `text` without "<mark><digits>" at its end; empty if it has no such end.
std::string_view before_number(std::string_view text, std::string_view mark) {
  const std::size_t digits = digits_behind(text);
  const std::string_view rest = text.substr(0, text.size() - digits);
  return digits > 0 && rest.ends_with(mark) ? rest.substr(0, rest.size() - mark.size()) : std::string_view();
}

std::string name_of(const Outcome& outcome) {
  return outcome.variant.empty() ? outcome.id : outcome.id + '~' + outcome.variant;
}

std::string at(const Most& most) { return fmt::format("{:.4g} ({})", most.amount, most.id); }

constexpr std::size_t longest_label = 32;

template <std::size_t N>
void add_counts(std::array<std::size_t, N>& to, const std::array<std::size_t, N>& counts) {
  for (std::size_t i = 0; i < N; ++i) to[i] += counts[i];
}

/// Returns a rank of failures; larger is worse. An answer without a depth, and one with a depth for
/// bodies that have none, has no relative error and ranks first.
double badness(const Outcome& outcome) {
  constexpr double beyond = std::numeric_limits<double>::infinity();
  if (!outcome.judgement || !outcome.judgement->error_relative) return beyond;
  const double error = std::abs(*outcome.judgement->error_relative);
  return std::isnan(error) ? beyond : error;
}

}  // namespace

std::string family_of(const std::string& id) {
  if (const std::size_t colons = id.find("::"); colons != std::string::npos) return id.substr(0, colons);
  return std::string(before_number(before_number(id, "-s"), "-n"));
}

void Coverage::add(const Outcome& outcome) {
  ++cases;
  if (!outcome.reply || !outcome.judgement) return;
  ++overlap;
  derivative += outcome.judgement->derivative && outcome.judgement->derivative->squared ? 1 : 0;
  const Reply& reply = *outcome.reply;
  if (!reply.overlap) {
    distance += reply.distance ? 1 : 0;
    return;
  }
  ++overlapping;
  const bool witnesses = reply.witness_a && reply.witness_b;
  if (reply.depth) {
    ++depth;
    direction += reply.direction ? 1 : 0;
    witness += witnesses ? 1 : 0;
    contacts += reply.contacts.empty() ? 0 : 1;
  } else if (reply.direction || reply.witness_a || reply.witness_b || !reply.contacts.empty()) {
    ++without_depth;
  }
}

void Coverage::add(const Coverage& other) {
  cases += other.cases;
  overlap += other.overlap;
  overlapping += other.overlapping;
  depth += other.depth;
  direction += other.direction;
  witness += other.witness;
  contacts += other.contacts;
  distance += other.distance;
  derivative += other.derivative;
  without_depth += other.without_depth;
}

std::vector<std::string> coverage_entries(const Coverage& coverage) {
  std::vector<std::string> result{fmt::format("overlap in {} of {} cases", coverage.overlap, coverage.cases)};
  if (coverage.distance > 0)
    result.push_back(fmt::format("distance in {} of {} said to be apart", coverage.distance,
                                 coverage.overlap - coverage.overlapping));
  if (coverage.derivative > 0) result.push_back(fmt::format("derivative in {}", coverage.derivative));
  if (coverage.overlapping == 0) return result;
  result.push_back(fmt::format("depth in {} of {} said to overlap", coverage.depth, coverage.overlapping));
  result.push_back(fmt::format("direction in {}", coverage.direction));
  result.push_back(fmt::format("witness in {}", coverage.witness));
  if (coverage.contacts > 0) result.push_back(fmt::format("contacts in {}", coverage.contacts));
  return result;
}

std::string coverage_warning(const Coverage& coverage) {
  if (coverage.overlapping == 0 || coverage.depth > 0) return "";
  std::string result =
      fmt::format("depth judged 0 of {}: no answer that says the bodies overlap has a \"depth\"", coverage.overlapping);
  if (coverage.without_depth > 0) result += ", and without one no direction and no witness is judged";
  return result + "; a pass means the classification alone";
}

void Most::add(double other, const std::string& of) {
  if (!id.empty() && (other < amount || (other == amount && of >= id))) return;
  amount = other;
  id = of;
}

void Times::add(const Outcome& outcome) {
  if (!outcome.microseconds) return;
  all_.push_back(*outcome.microseconds);
  worst_.add(*outcome.microseconds, name_of(outcome));
}

double Times::median() const {
  std::vector<double> sorted = all_;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) / 2);
  std::ranges::nth_element(sorted, middle);
  return *middle;
}

void HullCount::add(const Outcome& outcome) {
  if (!outcome.hulls) return;
  ++count;
  passed += passes(outcome.hulls->query.verdict) ? 1 : 0;
  lost.add(root_binary64(outcome.hulls->lost_squared, Rounding::rn), name_of(outcome));
  grown.add(root_binary64(outcome.hulls->grown_squared, Rounding::rn), name_of(outcome));
}

void UnionCount::add(const Outcome& outcome) {
  if (!outcome.judgement || !outcome.judgement->bounds) return;
  const Judgement& judgement = *outcome.judgement;
  ++count;
  enough += judgement.bounds->deepest_pair == judgement.depth_squared ? 1 : 0;
  if (!judgement.deeper_squared) return;
  ++answers;
  if (std::ranges::find(judgement.findings, Verdict::too_shallow) == judgement.findings.end()) return;
  ++deeper;
  times.add(root_binary64(*judgement.deeper_squared, Rounding::rn), name_of(outcome));
  by.add(-*judgement.error, name_of(outcome));
}

void ContactCount::add(const Outcome& outcome) {
  if (!outcome.judgement) return;
  const std::vector<Verdict>& all = outcome.judgement->findings;
  answers += std::ranges::any_of(all, judging::is_of_contacts) ? 1 : 0;
  for (const Verdict finding : all)
    if (judging::is_of_contacts(finding)) ++findings[finding];
}

std::vector<std::string> contact_entries(const ContactCount& contacts) {
  if (contacts.answers == 0) return {};
  std::vector<std::string> result{
      fmt::format("wrong in {} answer{}", contacts.answers, contacts.answers == 1 ? "" : "s")};
  for (const auto& [finding, count] : contacts.findings)
    result.push_back(fmt::format("{} in {}", name(finding), count));
  return result;
}

std::vector<std::string> time_entries(const Times& times) {
  if (times.empty()) return {};
  return {fmt::format("median {:.4g} us", times.median()),
          fmt::format("worst {:.4g} us ({})", times.worst().amount, times.worst().id)};
}

std::vector<std::string> hull_entries(const HullCount& hulls) {
  if (hulls.count == 0) return {};
  return {fmt::format("told in {} answers", hulls.count), fmt::format("by them {} pass", hulls.passed),
          "lost at most " + at(hulls.lost), "grown at most " + at(hulls.grown)};
}

std::vector<std::string> union_entries(const UnionCount& unions) {
  if (unions.count == 0) return {};
  std::vector<std::string> result{
      fmt::format("the deepest pair of pieces is enough in {} of {}", unions.enough, unions.count)};
  if (unions.answers == 0) return result;
  result.push_back(fmt::format("deeper than {} of {} answers", unions.deeper, unions.answers));
  if (unions.deeper == 0) return result;
  result.push_back(fmt::format("up to {:.4g} times as deep ({})", unions.times.amount, unions.times.id));
  result.push_back("deeper by up to " + at(unions.by));
  return result;
}

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
  if (judgement.accuracy && fathom::passes(outcome.verdict))
    ++accuracies[static_cast<std::size_t>(*judgement.accuracy)];
  if (judgement.error_relative) relative.add(*judgement.error_relative);
  if (judgement.error_u_r) u_r.add(*judgement.error_u_r);
  if (judgement.relative_excess) relative_excess.add(*judgement.relative_excess);
  excess_allowed += judgement.excess_allowed && fathom::passes(outcome.verdict) ? 1 : 0;
}

void TallyRow::add(const TallyRow& other) {
  total += other.total;
  add_counts(verdicts, other.verdicts);
  add_counts(accuracies, other.accuracies);
  judged.add(other.judged);
  relative.add(other.relative);
  u_r.add(other.u_r);
  relative_excess.add(other.relative_excess);
  excess_allowed += other.excess_allowed;
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
  contacts_.add(outcome);
  if (outcome.solid) parts_[0].row.add(outcome);
  if (outcome.metre_sized) parts_[1].row.add(outcome);
  if (outcome.solid && outcome.metre_sized) parts_[2].row.add(outcome);
  (outcome.variant.empty() ? families_[family_of(outcome.id)] : variants_["~" + outcome.variant]).add(outcome);
}

/// All families, the worst first.
std::vector<Tally::Line> Tally::ordered() const {
  std::vector<Line> result;
  for (const auto& [name, row] : families_)
    result.push_back({name.empty() ? "(no family)" : ascii(name, longest_label), row});
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
  for (Line& line : ordered())
    (line.row.failures() > 0 ? result : line.row.passes() > 0 ? passing : declined).push_back(std::move(line));
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

std::vector<std::size_t> worst_first(std::span<const Outcome> outcomes) {
  std::vector<std::size_t> failures;
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    if (fails(outcomes[i].verdict)) failures.push_back(i);
  std::ranges::sort(failures, {}, [&](std::size_t i) {
    const Outcome& outcome = outcomes[i];
    return std::tuple(-badness(outcome), std::string_view(outcome.id), std::string_view(outcome.variant), i);
  });
  return failures;
}

std::map<Verdict, std::vector<std::size_t>> worst_failures(std::span<const Outcome> outcomes) {
  std::map<Verdict, std::vector<std::size_t>> result;
  for (const std::size_t i : worst_first(outcomes)) result[outcomes[i].verdict].push_back(i);
  return result;
}

}  // namespace fathom::harness
