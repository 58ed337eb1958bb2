// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/record_facts.hpp"

#include <utility>

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

Facts facts_of_answer(const Recipe& recipe, Form form, const Case& points, Depth answer, Monitor* monitor) {
  Facts facts = facts_of_points(recipe, form, points);
  facts.answer = std::move(answer);
  if (const Penetration* penetration = facts.answer.penetration()) {
    facts.gap = second_nearest_squared(points.a.points, points.b.points, *penetration, monitor);
  }
  facts.flags = flags_of(facts);
  return facts;
}

}  // namespace fathom::golden
