// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/shapes/shape_recipe.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "kernels/float_environment.hpp"
#include "verify/families/shape_catalogue.hpp"
#include "verify/golden/records/nearest.hpp"

namespace fathom::golden {
namespace {

/// Calls visit with each number of a body.
template <class Named, class Visit>
void for_each_number(Named& body, const Visit& visit) {
  for (auto& [name, values] : body.fields.numbers)
    for (auto& value : values) visit(value);
  const auto of_point = [&visit](auto& p) { visit(p.x), visit(p.y), visit(p.z); };
  for (auto& vertex : body.fields.vertices) of_point(vertex);
  visit(body.turn.w);
  of_point(body.turn);
  of_point(body.place);
  for (auto& term : body.terms) for_each_number(term, visit);
}

/// Returns whether no number overflows.
bool round(families::NamedBody& body, Form format) {
  bool finite = true;
  for_each_number(body, [&](mpq_class& value) { finite = round_to_nearest(value, format) && finite; });
  return finite;
}

families::NamedPair base_shapes(const Recipe& recipe) {
  if (recipe.source == Source::shape_family) {
    if (const families::ShapeFamily* family = families::find_shape_family(recipe.name)) return family->make(recipe.seed, recipe.size).pair;
  } else if (recipe.source == Source::shape_catalogue) {
    const auto all = families::shape_catalogue();
    const auto found = std::ranges::find(all, recipe.name, [](const families::ShapeCatalogueEntry& entry) { return entry.shapes.id; });
    if (found != all.end()) return found->shapes.pair;
  }
  throw std::invalid_argument("there is nothing called '" + recipe.name + "' to make shapes from");
}

}  // namespace

bool in_format(const families::NamedPair& shapes, Form format) {
  const kernels::DefaultFloatEnvironment environment;
  bool fits = true;
  for (const families::NamedBody* body : {&shapes.a, &shapes.b})
    for_each_number(*body, [&](const mpq_class& value) { fits = fits && (format == Form::given || is_in(value, format)); });
  return fits;
}

std::optional<families::NamedPair> rounded_shapes(const families::NamedPair& base, Form form) {
  const kernels::DefaultFloatEnvironment environment;
  families::NamedPair result{base.a, base.b};
  if (!round(result.a, form) || !round(result.b, form)) return std::nullopt;
  try {
    for (const families::NamedBody* body : {&result.a, &result.b}) static_cast<void>(families::shape_of(*body));
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
  return result;
}

std::vector<FormedShapes> shape_cases_of(const Recipe& recipe) {
  std::vector<FormedShapes> cases;
  cases.push_back({Form::given, {id_of(recipe), base_shapes(recipe)}});
  for (const Form form : {Form::binary64, Form::binary32}) {
    if (in_format(cases.back().shapes.pair, form)) continue;  // it holds the very numbers that rounding would give
    if (std::optional<families::NamedPair> rounded = rounded_shapes(cases.front().shapes.pair, form))
      cases.push_back({form, {id_of(recipe, form), *std::move(rounded)}});
  }
  return cases;
}

}  // namespace fathom::golden
