// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/coverage.hpp"

#include <fmt/format.h>

namespace fathom::harness {

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

}  // namespace fathom::harness
