// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/record_facts.hpp"

#include <utility>

#include "verify/golden/records/flags.hpp"

namespace fathom::golden {

Facts facts_of_points(const Recipe& recipe, Form form, const Case& points) {
  Facts facts;
  facts.recipe = recipe;
  facts.form = form;
  facts.points = {points.id, {in_simplest_form(points.a.points)}, {in_simplest_form(points.b.points)}};
  facts.in_binary64 = in_format(facts.points, Form::binary64);
  facts.in_binary32 = facts.in_binary64 && in_format(facts.points, Form::binary32);
  return facts;
}

namespace {

RoundedResults rounded_results(const Depth& answer) {
  RoundedResults results;
  results.depth = rounded_root(answer.squared());
  for (const Optimum& optimum : answer.optima()) {
    results.units.push_back(rounded_unit(optimum.direction));
    results.translations.push_back(rounded_point(optimum.translation()));
  }
  if (answer.penetration()) return results;
  results.units.push_back(rounded_unit(answer.direction()));
  if (!answer.distance()) return results;
  results.distance = rounded_root(answer.distance()->squared);
  results.translations.push_back(rounded_point(answer.distance()->translation));
  return results;
}

}  // namespace

Facts facts_of_answer(const Recipe& recipe, Form form, const Case& points, Depth answer, Monitor* monitor, Workspace* workspace) {
  Facts facts = facts_of_points(recipe, form, points);
  facts.answer = std::move(answer);
  if (const Penetration* penetration = facts.answer.penetration())
    facts.gap = second_nearest_squared(points.a, points.b, *penetration, monitor, workspace);
  facts.rounded = rounded_results(facts.answer);
  facts.flags = flags_of(facts);
  return facts;
}

}  // namespace fathom::golden
