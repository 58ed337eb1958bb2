// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/record_facts.hpp"

#include <stdexcept>

#include "fathom/depth.hpp"
#include "verify/golden/records/flags.hpp"

namespace fathom::golden {

Facts facts_of_points(const Recipe& recipe, Form form, const Case& points) {
  Facts facts;
  facts.recipe = recipe;
  facts.form = form;
  facts.points = points;
  facts.in_binary64 = in_format(points, Form::binary64);
  facts.in_binary32 = facts.in_binary64 && in_format(points, Form::binary32);
  return facts;
}

Facts facts_of_answer(const Recipe& recipe, Form form, const Case& points, const Depth& answer) {
  Facts facts = facts_of_points(recipe, form, points);
  facts.status = answer.status;
  facts.squared = answer.squared;
  facts.flat_a = answer.flat_a;
  facts.flat_b = answer.flat_b;
  facts.optima = answer.optima;
  facts.witness = answer.witness;
  facts.distance = answer.distance;
  if (answer.status == Status::penetrating) {
    facts.gap = second_nearest_squared(points.a.points, points.b.points, answer);
  } else {
    if (!answer.direction) throw std::logic_error(points.id + ": the answer has no direction");
    facts.direction = answer.distance ? answer.distance->direction : *answer.direction;
  }
  facts.flags = flags_of(facts);
  return facts;
}

}  // namespace fathom::golden
