// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "fathom/numbers.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/judge/allowance.hpp"
#include "verify/judge/claim.hpp"

namespace fathom::harness {
namespace {

/// A reply about a pair of pieces.
struct Told {
  std::uint32_t a, b;
  SubjectAnswer answer;
  Case pair;

  [[nodiscard]] const Reply& reply() const { return std::get<Reply>(answer.said); }
};

/// How much a reply weighs: the depth, or minus the distance; what is not finite weighs most. nullopt without a number.
std::optional<double> weight(const Reply& reply, const Conventions& conventions) {
  const double* const length = judging::length_of(reply);
  if (!length) return std::nullopt;
  if (!std::isfinite(*length)) return std::numeric_limits<double>::infinity();
  const bool negative = !reply.overlap || conventions.depth == Conventions::Sign::negative;
  return negative ? -*length : *length;
}

/// The reply that is the answer about the unions, of those that claim an overlap, or of all if none does: the first of the greatest weight.
const Told& deepest(const std::vector<Told>& all, const Conventions& conventions) {
  const bool overlap = std::ranges::any_of(all, [](const Told& told) { return told.reply().overlap; });
  const Told* best = nullptr;
  std::optional<double> most;
  for (const Told& told : all) {
    if (told.reply().overlap != overlap) continue;
    const std::optional<double> other = weight(told.reply(), conventions);
    if (best && (!other || (most && *other <= *most))) continue;
    best = &told;
    most = other;
  }
  return *best;
}

bool all_have_distances(const std::vector<Told>& all) {
  return std::ranges::all_of(all, [](const Told& told) { return told.reply().distance.has_value(); });
}

std::string of_pair(std::uint32_t a, std::uint32_t b, const std::string& detail) {
  return fmt::format("piece {} of A, piece {} of B: {}", a, b, detail);
}

/// The sum, if each answer says it.
std::optional<double> microseconds_of(const std::vector<Told>& all) {
  double sum = 0;
  for (const Told& told : all) {
    if (!told.answer.microseconds) return std::nullopt;
    sum += *told.answer.microseconds;
  }
  return sum;
}

void judge_pairs(Outcome& outcome, const Case& seen, const std::vector<Told>& all, const SubjectInfo& info, const Judging& judging) {
  const Told& chosen = deepest(all, info.conventions);
  SubjectAnswer whole{{}, chosen.reply(), microseconds_of(all)};
  for (const Told& told : all)
    if (whole.remark.empty()) whole.remark = told.answer.remark;
  Reply& reply = std::get<Reply>(whole.said);
  const bool bare = !reply.overlap && !all_have_distances(all);
  if (bare) reply = Reply{};
  SubjectInfo lenient = info;  // each reply is held to its promises
  lenient.promises.clear();
  judge_answer(outcome, seen, whole, lenient, judging);
  Outcome query = outcome_for(chosen.pair, outcome.fit);
  judge_answer(query, chosen.pair, {{}, chosen.reply()}, info, judging);
  outcome.pieces = {all.size(), {chosen.a, chosen.b}, std::move(*query.judgement)};
  for (const Told& told : all) {
    const bool is_held = std::ranges::find(outcome.judgement->findings, Verdict::inconsistent) != outcome.judgement->findings.end();
    if (!is_held) hold_to_promises(*outcome.judgement, told.reply(), info.promises);
  }
  outcome.verdict = outcome.judgement->verdict;
}

}  // namespace

std::string pair_id(const std::string& id, std::uint32_t a, std::uint32_t b) { return fmt::format("{}[{},{}]", id, a, b); }

std::string obstacle_to(const Case& seen, const SubjectInfo& info, long exponent) {
  constexpr unsigned long fewest_numbers = 1000;  // of the format, over the length of the bodies
  if (has_union(seen))
    return rounds_pieces(info) ? "the subject rounds bodies by a radius, and the depth of unions with radii is not known" : "";
  const auto [of_a, of_b] = rounding_radii(seen, info, exponent);
  const mpq_class radii = of_a + of_b;
  if (radii == 0) return "";
  const mpq_class extent = sizes_of(seen).extent, step = judging::ulp_at_root(radii * radii, in_unit(info.format, exponent));
  if (extent == 0 || fewest_numbers * step <= extent) return "";
  return fmt::format("the subject rounds bodies by radii of {:.3g}, beside which numbers of {} do not tell bodies as long as {:.3g}",
                     round_binary64(radii), name(info.format.answers), round_binary64(extent));
}

bool is_asked_in_pairs(const Case& seen, const SubjectInfo& info) { return has_union(seen) && !info.shapes.contains(pieces_word); }

bool is_pair_of(std::string_view text, const Case& pair) {
  if (!has_union(pair) || !text.starts_with(pair.id + '[')) return false;
  const auto count = [](const Body& body) { return body.pieces ? body.pieces->size() : 1; };
  const char* const end = text.data() + text.size();
  std::uint32_t a = 0, b = 0;
  const auto [comma, fault] = std::from_chars(text.data() + pair.id.size() + 1, end, a);
  if (fault != std::errc() || comma == end) return false;
  if (std::from_chars(comma + 1, end, b).ec != std::errc()) return false;
  return a < count(pair.a) && b < count(pair.b) && text == pair_id(pair.id, a, b);
}

Outcome examine_pairs(const Case& seen, long exponent, const SubjectInfo& info, const Judging& judging, const AskPair& ask) {
  const Pieces a = pieces_of(seen.a), b = pieces_of(seen.b);
  Outcome outcome = outcome_for(seen, exponent);
  std::vector<Told> all;
  std::string declined_why;
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    for (std::uint32_t j = 0; j < b.size(); ++j) {
      const Case pair{pair_id(seen.id, i, j), Body{a[i]}, Body{b[j]}};
      std::optional<SubjectAnswer> answer;
      const Outcome asked = ask(pair, answer);
      outcome.seconds += asked.seconds;
      if (!answer || std::holds_alternative<Failed>(answer->said)) {
        outcome.verdict = answer ? Verdict::failed : asked.verdict;
        outcome.detail = of_pair(i, j, answer ? std::get<Failed>(answer->said).why : asked.detail);
        return outcome;
      }
      if (const auto* unsupported = std::get_if<Unsupported>(&answer->said)) {
        if (declined_why.empty()) declined_why = of_pair(i, j, unsupported->why);
        continue;
      }
      all.push_back({i, j, *std::move(answer), pair});
    }
  }
  if (!declined_why.empty()) {
    outcome.verdict = Verdict::unsupported;
    outcome.detail = declined_why;
    return outcome;
  }
  judge_pairs(outcome, seen, all, info, judging);
  return outcome;
}

}  // namespace fathom::harness
