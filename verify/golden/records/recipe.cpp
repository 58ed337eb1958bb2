// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/recipe.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include "kernels/float_environment.hpp"
#include "kernels/number/dyadic.hpp"
#include "verify/families/catalogue.hpp"
#include "verify/families/families.hpp"
#include "verify/golden/records/nearest.hpp"
#include "verify/golden/release/real_cases.hpp"

namespace fathom::golden {
namespace {

std::string suffix(Form form) { return form == Form::binary64 ? ".b64" : form == Form::binary32 ? ".b32" : ""; }

using Triple = std::array<double, 3>;

bool in_binary32(double value) { return kernels::nearest_binary32(value) == value; }

double nearest(double value, Form format) { return format == Form::binary32 ? kernels::nearest_binary32(value) : value; }

/// Not finite where a coordinate overflows.
template <class P>
std::vector<Triple> rounded(std::span<const P> points, Form form) {
  std::vector<Triple> result;
  result.reserve(points.size());
  for (const auto& [x, y, z] : points) result.push_back({nearest(x, form), nearest(y, form), nearest(z, form)});
  return result;
}

std::optional<GivenPoints> rounded_points(const GivenPoints& points, Form form) {
  std::vector<Triple> result = points.in_binary64() ? rounded(points.binary64(), form) : rounded(std::span<const Point>(points), form);
  const auto finite = [](double c) { return std::isfinite(c); };
  for (const Triple& p : result)
    if (!std::ranges::all_of(p, finite)) return std::nullopt;
  return GivenPoints(std::move(result));
}

bool one_point(const GivenPoints& points) {
  if (!points.in_binary64()) return std::ranges::all_of(points, [&](const Point& p) { return p == points.front(); });
  const std::span<const Triple> all = points.binary64();
  return std::ranges::all_of(all, [&](const Triple& p) { return p == all.front(); });
}

}  // namespace

std::string_view name_of(Source source) {
  switch (source) {
    case Source::family: return "family";
    case Source::catalogue: return "catalogue";
    case Source::real: return "real";
    case Source::shape_family: return "shape_family";
    case Source::shape_catalogue: return "shape_catalogue";
    case Source::union_family: return "union_family";
    case Source::union_catalogue: break;
  }
  return "union_catalogue";
}

std::string id_of(const Recipe& recipe, Form form) {
  if (!from_family(recipe.source)) return std::string(name_of(recipe.source)) + "-" + recipe.name + suffix(form);
  return recipe.name + "-n" + std::to_string(recipe.size) + "-s" + std::to_string(recipe.seed) + suffix(form);
}

GivenPoints in_simplest_form(const GivenPoints& points) {
  if (points.in_binary64()) return points;
  std::vector<Triple> same;
  same.reserve(points.size());
  for (const Point& p : points) {
    const std::optional<double> x = kernels::in_binary64(p.x), y = x ? kernels::in_binary64(p.y) : x, z = y ? kernels::in_binary64(p.z) : y;
    if (!z) return points;
    same.push_back({*x, *y, *z});
  }
  return GivenPoints(std::move(same));
}

Case base_case(const Recipe& recipe) {
  const kernels::DefaultFloatEnvironment environment;
  const auto named = [&recipe](const auto* found) {
    if (found == nullptr) throw std::invalid_argument("there is nothing called '" + recipe.name + "' to make a case from");
    return found;
  };
  Case result;
  switch (recipe.source) {
    case Source::family: result = named(families::find_family(recipe.name))->make(recipe.seed, recipe.size); break;
    case Source::catalogue: result = named(families::find_catalogue_entry(recipe.name))->pair; break;
    case Source::real: result = *named(find_real_case(recipe.name)); break;
    case Source::shape_family:
    case Source::shape_catalogue: throw std::invalid_argument("'" + recipe.name + "' names shapes, not points");
    case Source::union_family:
    case Source::union_catalogue: throw std::invalid_argument("'" + recipe.name + "' names unions, not points");
  }
  result.id = id_of(recipe);
  for (Body* body : {&result.a, &result.b}) body->points = in_simplest_form(body->points);
  return result;
}

std::optional<Case> rounded_case(const Case& base, Form form) {
  const kernels::DefaultFloatEnvironment environment;
  std::optional<GivenPoints> a = rounded_points(base.a.points, form), b = rounded_points(base.b.points, form);
  if (!a || !b) return std::nullopt;
  if ((one_point(*a) && !one_point(base.a.points)) || (one_point(*b) && !one_point(base.b.points))) return std::nullopt;
  return Case{base.id + suffix(form), {*std::move(a)}, {*std::move(b)}};
}

bool in_format(const Case& points, Form format) {
  const kernels::DefaultFloatEnvironment environment;
  const auto fits = [format](const Body& body) {
    const GivenPoints given = in_simplest_form(body.points);
    if (format != Form::binary32) return given.in_binary64();
    return given.in_binary64() &&
           std::ranges::all_of(given.binary64(), [](const Triple& p) { return std::ranges::all_of(p, in_binary32); });
  };
  return format == Form::given || (fits(points.a) && fits(points.b));
}

std::vector<FormedCase> cases_of(const Recipe& recipe) {
  std::vector<FormedCase> cases;
  cases.push_back({Form::given, base_case(recipe)});
  for (const Form form : {Form::binary64, Form::binary32}) {
    if (in_format(cases.back().points, form)) continue;  // it holds the very points that rounding would give
    if (std::optional<Case> rounded = rounded_case(cases.front().points, form)) cases.push_back({form, *std::move(rounded)});
  }
  return cases;
}

}  // namespace fathom::golden
