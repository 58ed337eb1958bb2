// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate proves status, depth and every optimal direction; all else follows from these and the bodies (proved_truth.cpp). Then the
// record is written anew, and must be the same text: so no field can be wrong, missing, repeated or unknown.
#include "verify/golden/records/prove.hpp"

#include <algorithm>
#include <utility>

#include "verify/digest/sha256.hpp"

namespace fathom::golden {

const FormedCase& case_in(const std::vector<FormedCase>& cases, Form form) {
  const auto made = std::ranges::find(cases, form, &FormedCase::form);
  if (made == cases.end()) throw NotProved("source: it has no such form");
  return *made;
}

/// The bodies that the source names: an id stands for one pair of bodies only.
const FormedCase& Prover::source_of(const Claimed& claimed) {
  if (claimed.id != id_of(claimed.recipe, claimed.form)) throw NotProved("id: it is not that of its source");
  constexpr unsigned largest_size = 10'000;  // nobody's text may ask for more work
  if (claimed.recipe.size > largest_size) throw NotProved("source.size: it is larger than that of any record");
  if (recipe_ != claimed.recipe) {
    recipe_.reset();
    cases_ = cases_of(claimed.recipe);
    recipe_ = claimed.recipe;
  }
  if (!claimed.hulls) return case_in(cases_, claimed.form);
  const auto made = std::ranges::find(cases_, claimed.form, &FormedCase::form);
  const HullPair* const hulls = made == cases_.end() ? nullptr : &std::get<HullPair>(made->bodies);
  if (!hulls || hulls->a.points != claimed.hulls->a.points || hulls->b.points != claimed.hulls->b.points)
    throw NotProved("source: it does not yield these points");
  return *made;
}

std::optional<std::string> Prover::faults(std::string_view line, std::string_view certificate) {
  const Claimed claimed = read_record(line);
  const FormedCase& made = source_of(claimed);
  RecordStatement truth = proved_truth(made, claimed.witness, certificate, &workspace_);
  const Facts facts = facts_of(claimed.recipe, made, std::move(truth), digest::digest_of(certificate).sha256);
  const std::string expected = line_of(facts);
  if (expected != line) return first_difference(expected, line);
  id_ = claimed.id;
  row_ = csv_row(facts);
  return std::nullopt;
}

std::optional<std::string> Prover::faults_of(std::string_view line, std::string_view certificate) {
  try {
    return faults(line, certificate);
  } catch (const std::exception& fault) {
    return fault.what();
  }
}

std::vector<std::string> Prover::ids() const {
  std::vector<std::string> ids;
  for (const FormedCase& made : cases_) ids.push_back(made.id);
  return ids;
}

std::optional<std::string> faults_of(std::string_view line, std::string_view certificate) { return Prover().faults_of(line, certificate); }

}  // namespace fathom::golden
