// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "fathom/answer.hpp"
#include "kernels/vector.hpp"
#include "reference/answer/plane.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/harness/shrink/shrink.hpp"
#include "verify/harness/two_ways.hpp"

namespace fathom::harness {
namespace {

constexpr std::size_t small_bits = 10;

/// Returns the length in bits, at least 1, so that a coordinate of 0 counts like one of 1.
std::size_t bits(const mpz_class& value) { return static_cast<std::size_t>(std::max(1L, kernels::bit_length(value))); }

std::size_t parts_of(const files::NamedBody& words) {
  std::size_t parts = words.fields.vertices.size() + words.fields.numbers.size() + (words.matrix ? 1 : 0);
  for (const files::NamedBody& term : words.terms) parts += 1 + parts_of(term);
  return parts;
}

/// Whether it is a body of the plane with a radius.
bool is_rounded(const Body& body) { return body.dimension == 2 && body.shape; }

std::size_t parts_of(const Body& body) {
  if (is_rounded(body)) return core_of(body).size() + 1;
  return body.words ? parts_of(*body.words) : body.points.size();
}

constexpr long ladder[] = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 44};

/// Returns `value` / 2^bits, rounded towards 0.
mpz_class cut(const mpz_class& value, unsigned bits) {
  mpz_class result;
  mpz_tdiv_q_2exp(result.get_mpz_t(), value.get_mpz_t(), bits);
  return result;
}

constexpr std::size_t usual_tries = 4000, slow_tries = 100;

std::string key_of(const Case& pair) {
  if (has_words(pair) || is_rounded(pair.a) || is_rounded(pair.b)) return digest_of(pair);
  std::string key = fmt::format("{};", pair.a.points.size());
  for_each_coordinate(pair, [&](const mpq_class& value) { key += value.get_str(62) + ';'; });
  return key;
}

bool fits(const Case& pair, Precision precision) {
  bool all = true;
  for (const Body* body : {&pair.a, &pair.b})
    if (is_rounded(*body)) all = all && representable(body->shape->radius, precision);
  for_each_number(pair, [&](const mpq_class& value) { all = all && representable(value, precision); });
  return all;
}

/// Returns a certificate of the truth that the checker has accepted.
std::string proved(const Case& pair, const Outcome& outcome) {
  if (pair.a.shape || pair.b.shape) return accepted_certificate(pair, nullptr);
  const Answer answer = exact_answer(pair.a, pair.b);
  const Depth& depth = std::get<Depth>(answer.found);
  std::string text = pair.a.dimension == 2 ? accepted_certificate(pair, nullptr) : accepted_certificate(pair, depth);
  // The truth about a variant is that about the case times a power of 4; the harness judged it by a
  // solution of its own.
  const bool same =
      !outcome.judgement || !outcome.variant.empty() ||
      (outcome.judgement->status == depth.status() && outcome.judgement->depth_squared == depth.squared());
  if (!same) throw std::logic_error(fmt::format("{} was judged by another depth than its certificate proves", pair.id));
  return text;
}

}  // namespace

std::size_t cost(const mpq_class& value) {
  if (value == 0) return 0;
  if (value.get_den() == 1 && bits(value.get_num()) <= small_bits) return bits(value.get_num());
  const std::size_t odd = bits(value.get_num()) - mpz_scan1(value.get_num_mpz_t(), 0);
  return small_bits + odd +
         static_cast<std::size_t>(std::bit_width(static_cast<unsigned long>(std::labs(exponent_of(value)))));
}

Size size_of(const Case& pair) {
  Size size{parts_of(pair.a) + parts_of(pair.b), 0, 0};
  for_each_number(pair, [&](const mpq_class& value) {
    size.bits += cost(value);
    size.signs += value < 0 ? 1 : 0;
  });
  for (const Body* body : {&pair.a, &pair.b})
    if (is_rounded(*body)) size.bits += cost(body->shape->radius);
  return size;
}

mpz_class nearest_integer(const mpq_class& value) {
  mpz_class result;
  const mpz_class numerator = 2 * value.get_num() + value.get_den(), denominator = 2 * value.get_den();
  mpz_fdiv_q(result.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
  return result;
}

mpq_class to_multiple(const mpq_class& value, long exponent) {
  return scaled(mpq_class(nearest_integer(scaled(value, -exponent))), exponent);
}

mpq_class to_bits(const mpq_class& value, long bits) {
  return value == 0 ? value : to_multiple(value, exponent_of(value) + 1 - std::max(bits, 1L));
}

std::vector<mpq_class> simpler(const mpq_class& value) {
  if (value == 0) return {};
  std::vector<mpq_class> result = {0, sgn(value), nearest_integer(value)};
  if (value < 0) result.push_back(-value);
  for (const long bits : ladder) result.push_back(to_bits(value, bits));
  if (value.get_den() == 1) {
    for (const unsigned bits : {1U, 2U, 4U, 8U}) result.emplace_back(cut(value.get_num(), bits));
    result.emplace_back(value - sgn(value));
  }
  const auto worse = [&, own = cost(value)](const mpq_class& other) {
    const std::size_t of_other = cost(other);
    return of_other > own || (of_other == own && (other >= 0) == (value >= 0));
  };
  std::erase_if(result, worse);
  return result;
}

Search::Search(Verdict verdict, const Examine& examine, const std::function<void(const Shrunk&)>& on_better,
               const std::function<bool()>& stop, const ShrinkSettings& settings)
    : verdict_(verdict),
      examine_(examine),
      on_better_(on_better),
      stop_(stop),
      precision_(settings.precision),
      judged_(settings.judged),
      tries_(settings.tries != 0            ? settings.tries
             : verdict == Verdict::time_out ? slow_tries
                                            : usual_tries),
      keep_solid_(settings.keep_solid),
      certify_(settings.certify) {}

bool Search::begin(Case pair) {
  solid_a_ = keep_solid_ && !answer::is_flat_body(pair.a);
  solid_b_ = keep_solid_ && !answer::is_flat_body(pair.b);
  result_.tried = 1;
  examined_.insert(key_of(pair));
  Outcome outcome = examine_(pair);
  result_.reproduced = outcome.verdict == verdict_;
  if (result_.reproduced) return keep(std::move(pair), std::move(outcome));
  result_.pair = std::move(pair);
  result_.outcome = std::move(outcome);
  return false;
}

bool Search::offer(Case candidate) {
  const auto is_none = [](const Body& body) { return !body.shape && body.points.empty(); };
  if (over_ || is_none(candidate.a) || is_none(candidate.b) || size_of(candidate) >= size_) return false;
  if (!fits(candidate, precision_) || !examined_.insert(key_of(candidate)).second) return false;
  if ((solid_a_ && answer::is_flat_body(candidate.a)) || (solid_b_ && answer::is_flat_body(candidate.b))) return false;
  over_ = result_.tried >= tries_ || (stop_ && stop_());
  if (over_) return false;
  ++result_.tried;
  Outcome outcome = examine_(candidate);
  if (outcome.verdict != verdict_) return false;
  ++result_.kept;
  return keep(std::move(candidate), std::move(outcome));
}

bool Search::keep(Case pair, Outcome outcome) {
  if (certify_) result_.certificate = proved(judged_ ? judged_(pair, outcome) : pair, outcome);
  size_ = size_of(pair);
  result_.pair = std::move(pair);
  result_.outcome = std::move(outcome);
  if (on_better_) on_better_(result_);
  return true;
}

}  // namespace fathom::harness
