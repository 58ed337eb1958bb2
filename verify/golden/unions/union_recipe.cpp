// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/unions/union_recipe.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

#include "kernels/float_environment.hpp"
#include "reference/polytope/joined.hpp"
#include "verify/families/union_catalogue.hpp"
#include "verify/families/union_cuts.hpp"
#include "verify/families/union_families.hpp"
#include "verify/golden/records/nearest.hpp"

namespace fathom::golden {
namespace {

/// The hull of all pieces.
Body hull_of(const Body& body) { return {polytope::joined(*body.pieces)}; }

KnownUnion known_of_hulls(const Case& unions) {
  const Depth depth = penetration_depth(hull_of(unions.a), hull_of(unions.b));
  return {depth.status(), depth.distance() ? depth.distance()->squared : depth.squared(), depth.optima().size()};
}

FormedUnions base_unions(const Recipe& recipe) {
  if (recipe.source == Source::union_family) {
    if (const families::UnionFamily* family = families::find_union_family(recipe.name)) {
      FormedUnions made{Form::given, family->make(recipe.seed, recipe.size), std::nullopt};
      if (recipe.name.starts_with("cut_")) made.known = known_of_hulls(made.unions);
      return made;
    }
  } else if (recipe.source == Source::union_catalogue) {
    const auto all = families::union_catalogue();
    const auto found = std::ranges::find(all, recipe.name, [](const families::UnionCatalogueEntry& entry) { return entry.pair.id; });
    if (found != all.end()) {
      const std::size_t ways = found->status == Status::penetrating ? found->optima : 0;
      return {Form::given, found->pair, KnownUnion{found->status, found->squared, ways}};
    }
  }
  throw std::invalid_argument("there is nothing called '" + recipe.name + "' to make unions from");
}

/// Returns whether no coordinate overflows and no piece becomes flat.
bool round(Body& body, Form form) {
  Pieces pieces = *body.pieces;
  for (std::vector<Point>& piece : pieces) {
    for (Point& p : piece)
      if (!round_to_nearest(p.x, form) || !round_to_nearest(p.y, form) || !round_to_nearest(p.z, form)) return false;
    if (families::is_flat(piece)) return false;
  }
  body.pieces = std::make_shared<const Pieces>(std::move(pieces));
  return true;
}

}  // namespace

bool unions_in_format(const Case& unions, Form format) {
  const kernels::DefaultFloatEnvironment environment;
  const auto fits = [format](const Point& p) { return is_in(p.x, format) && is_in(p.y, format) && is_in(p.z, format); };
  for (const Body* body : {&unions.a, &unions.b})
    for (const std::vector<Point>& piece : *body->pieces)
      if (format != Form::given && !std::ranges::all_of(piece, fits)) return false;
  return true;
}

std::optional<Case> rounded_unions(const Case& base, Form form) {
  const kernels::DefaultFloatEnvironment environment;
  Case result = base;
  if (!round(result.a, form) || !round(result.b, form)) return std::nullopt;
  return result;
}

std::vector<FormedUnions> union_cases_of(const Recipe& recipe) {
  std::vector<FormedUnions> cases;
  cases.push_back(base_unions(recipe));
  cases.front().unions.id = id_of(recipe);
  for (const Form form : {Form::binary64, Form::binary32}) {
    if (unions_in_format(cases.back().unions, form)) continue;  // it holds the very points that rounding would give
    if (std::optional<Case> rounded = rounded_unions(cases.front().unions, form)) {
      rounded->id = id_of(recipe, form);
      cases.push_back({form, *std::move(rounded), std::nullopt});
    }
  }
  return cases;
}

}  // namespace fathom::golden
