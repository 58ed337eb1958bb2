// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/shapes/shape_facts.hpp"

namespace fathom::golden {
namespace {

constexpr unsigned first_bits = 40, most_bits = 80;

}  // namespace

SignedDepth answer_about(const Shape& a, const Shape& b, const Options& options) {
  SignedDepthOptions asked;
  asked.cores = options;
  for (asked.bits = first_bits;; asked.bits *= 2) {
    SignedDepth answer = signed_depth(a, b, asked);
    if (answer.status() || asked.bits == most_bits) return answer;
  }
}

ShapeStatement truth_of(const SignedDepth& answer) {
  return {answer.exact() ? std::variant<Surd, Bounds>(*answer.exact()) : *answer.bounds(), answer.direction(), answer.translations(),
          answer.cone};
}

}  // namespace fathom::golden
