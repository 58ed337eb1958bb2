// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "fathom/numbers.hpp"
#include "verify/harness/tally.hpp"

namespace fathom::harness {
namespace {

std::string name_of(const Outcome& outcome) { return outcome.variant.empty() ? outcome.id : outcome.id + '~' + outcome.variant; }

std::string at(const Most& most) { return fmt::format("{:.4g} ({})", most.amount, most.id); }

}  // namespace

void Coverage::add(const Outcome& outcome) {
  ++cases;
  if (!outcome.reply || !outcome.judgement) return;
  ++overlap;
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
  without_depth += other.without_depth;
}

std::vector<std::string> coverage_entries(const Coverage& coverage) {
  std::vector<std::string> result{fmt::format("overlap in {} of {} cases", coverage.overlap, coverage.cases)};
  if (coverage.distance > 0)
    result.push_back(fmt::format("distance in {} of {} said to be apart", coverage.distance, coverage.overlap - coverage.overlapping));
  if (coverage.overlapping == 0) return result;
  result.push_back(fmt::format("depth in {} of {} said to overlap", coverage.depth, coverage.overlapping));
  result.push_back(fmt::format("direction in {}", coverage.direction));
  result.push_back(fmt::format("witness in {}", coverage.witness));
  if (coverage.contacts > 0) result.push_back(fmt::format("contacts in {}", coverage.contacts));
  return result;
}

std::string coverage_warning(const Coverage& coverage) {
  if (coverage.overlapping == 0 || coverage.depth > 0) return "";
  std::string result = fmt::format("depth judged 0 of {}: no answer that says the bodies overlap has a \"depth\"", coverage.overlapping);
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

std::vector<std::string> time_entries(const Times& times) {
  if (times.empty()) return {};
  return {fmt::format("median {:.4g} us", times.median()), fmt::format("worst {:.4g} us ({})", times.worst().amount, times.worst().id)};
}

std::vector<std::string> hull_entries(const HullCount& hulls) {
  if (hulls.count == 0) return {};
  return {fmt::format("told in {} answers", hulls.count), fmt::format("by them {} pass", hulls.passed), "lost at most " + at(hulls.lost),
          "grown at most " + at(hulls.grown)};
}

std::vector<std::string> union_entries(const UnionCount& unions) {
  if (unions.count == 0) return {};
  std::vector<std::string> result{fmt::format("the deepest pair of pieces is enough in {} of {}", unions.enough, unions.count)};
  if (unions.answers == 0) return result;
  result.push_back(fmt::format("deeper than {} of {} answers", unions.deeper, unions.answers));
  if (unions.deeper == 0) return result;
  result.push_back(fmt::format("up to {:.4g} times as deep ({})", unions.times.amount, unions.times.id));
  result.push_back("deeper by up to " + at(unions.by));
  return result;
}

}  // namespace fathom::harness
