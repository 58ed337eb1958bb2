// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/stages/stages.hpp"

#include "kernels/float_environment.hpp"
#include "reference/solve/depth.hpp"
#include "view/stages/parts.hpp"
#include "view/stages/stage_times.hpp"

namespace fathom::stages {
namespace {

// The answer of penetration_depth. Where a common lattice would be too fine, that one takes another way, and may name another of several
// right directions of touching bodies.
Depth answer_of(const StagesSource& subject, bool slim) {
  if (slim) return subject.exact.depth;
  kernels::Context context = subject.context.worker();
  return solve::placed_depth(context, subject.a.points.exact(), subject.b.points.exact(), {.method = Method::exact}).depth;
}

void fill(const StagesSource& subject, const Depth& depth, Stages& stages) {
  add_bodies(subject, stages);
  add_contact(depth, subject.placing, stages);
  add_charts(subject, stages);
  add_pairs(subject, stages);
  add_winner(subject, depth, stages);
  add_cutting(subject, stages);
  stages.counters = subject.exact.depth.counters;
  if (!depth.penetration())
    stages.left_out.emplace_back(
        "The bodies do not penetrate: the exact method ends before the search for closest lines, so pairs have no closest lines.");
  add_sum(subject, stages);
  add_coincidences(subject, stages);
  add_bounds(subject, stages);
}

}  // namespace

Stages stages_of(const Body& a, const Body& b, const StageOptions& options) {
  const kernels::DefaultFloatEnvironment environment;
  if (a.shape || b.shape) return stages_of_shapes(a, b, options);
  StageTimes times(options.monitor);
  kernels::Context context(&times);
  const std::optional<polytope::PlacedPair> slim = polytope::place_if_slim(a.points.exact(), b.points.exact());
  const polytope::PlacedPair pair = slim ? *slim : polytope::place(a.points.exact(), b.points.exact());
  const std::unique_ptr<depth::ExactStages> exact = depth::exact_stages(context, pair);
  times.end();
  const Placing placing(pair);
  const StagesSource subject{a, b, pair, *exact, placing, context};
  Stages stages;
  if (options.times) stages.seconds = times.seconds();
  fill(subject, answer_of(subject, slim.has_value()), stages);
  return stages;
}

}  // namespace fathom::stages
