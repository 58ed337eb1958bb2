// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/shrink/shrink.hpp"

#include <stdexcept>
#include <utility>

#include "verify/harness/coordinates.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/harness/shrink/passes.hpp"

namespace fathom::harness {

Shrunk shrink(const Case& pair, Verdict verdict, const Examine& examine, const std::function<void(const Shrunk&)>& on_better,
              const std::function<bool()>& stop, const ShrinkSettings& settings) {
  const bool of_shapes = has_words(pair);
  for (const Body* body : {&pair.a, &pair.b})
    if (!body->words && body->points.empty()) throw std::invalid_argument("shrink: a body without points or words");
  Case seen = pair;
  for_each_coordinate(seen, [&](mpq_class& value) {
    const std::optional<mpq_class> near = rounded(value, settings.precision);
    if (!near) throw std::invalid_argument("shrink: a coordinate is too large for the precision");
    value = *near;
  });
  Search search(verdict, examine, on_better, stop, settings);
  if (!search.begin(std::move(seen))) return search.result();
  // Every kept step makes the size smaller: the loop ends.
  for (std::size_t before = search.result().kept + 1; before != search.result().kept && !search.over();) {
    before = search.result().kept;
    if (of_shapes) simplify_shapes(search);
    else
      for (const auto pass : {drop_points, move_to_origin, rescale, round_together, simplify_values}) pass(search);
  }
  return search.result();
}

}  // namespace fathom::harness
