// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/unions/union_facts.hpp"

#include <utility>

namespace fathom::golden {

UnionDepth answer_about(const Case& unions, Monitor* monitor) {
  UnionOptions options;
  options.monitor = monitor;
  options.bounds = false;
  UnionDepth answer = union_depth(*unions.a.pieces, *unions.b.pieces, options);
  if (!answer.complete) throw Interrupted();
  return answer;
}

UnionStatement truth_of(const UnionDepth& answer) {
  UnionStatement truth{answer.status, answer.squared(), {}, std::nullopt};
  if (answer.status == Status::penetrating)
    for (const UnionOptimum& optimum : answer.optima) truth.optima.push_back(optimum.translation);
  if (answer.apart) truth.gap = {answer.apart->distance.squared, answer.apart->a, answer.apart->b, answer.apart->distance.translation};
  return truth;
}

}  // namespace fathom::golden
