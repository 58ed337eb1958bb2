// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/recipe.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "fathom/plane.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/polytope/lattice.hpp"
#include "verify/families/families.hpp"
#include "verify/families/union_pairs.hpp"

namespace fathom::golden {
namespace {

std::vector<Case> read_all() {
  constexpr std::string_view prefix = "real::";
  std::vector<Case> cases;
  std::string_view text = real_cases_text();
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    CaseItem item = parse_case(text.substr(0, length), "real_cases.jsonl", line);
    if (!item.ok()) throw item.error();
    Case& found = cases.emplace_back(std::get<Case>(std::move(item.outcome)));
    if (found.id.starts_with(prefix)) found.id.erase(0, prefix.size());
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return cases;
}

HullPair hulls_of(const Case& points) {
  return {{in_simplest_form(points.a.points)}, {in_simplest_form(points.b.points)}};
}

Unions unions_of(const Case& unions, std::optional<KnownUnion> known = std::nullopt) {
  return {*unions.a.pieces, *unions.b.pieces, std::move(known)};
}

/// Returns the known answer about convex bodies that were cut: that about the hulls of all pieces.
KnownUnion known_of_hulls(const Case& unions) {
  const auto hull_of = [](const Body& body) { return Body{polytope::joined(*body.pieces)}; };
  const Depth depth = penetration_depth(hull_of(unions.a), hull_of(unions.b));
  return {depth.status(), depth.distance() ? depth.distance()->squared : depth.squared(), depth.optima().size()};
}

using Triple = std::array<double, 3>;

double nearest_in(double value, Form format) {
  return format == Form::binary32 ? kernels::nearest_binary32(value) : value;
}

double nearest_in(const mpq_class& value, Form format) {
  return format == Form::binary32 ? double{round_binary32(value)} : round_binary64(value);
}

bool is_in(const mpq_class& value, Form format) {
  const double closest = nearest_in(value, format);
  return std::isfinite(closest) && exact_value(closest) == value;
}

/// Rounds the value. Returns false, without changing it, if it overflows.
bool round_to_nearest(mpq_class& value, Form format) {
  const double closest = nearest_in(value, format);
  if (std::isfinite(closest)) value = exact_value(closest);
  return std::isfinite(closest);
}

bool round_to_nearest(Point& p, Form format) {
  return round_to_nearest(p.x, format) && round_to_nearest(p.y, format) && round_to_nearest(p.z, format);
}

// ---- polytopes: whole bodies in doubles at once, which is faster for the many that there are ----

/// Returns false if a coordinate overflows, or if distinct points all become equal.
bool round(GivenPoints& points, Form form) {
  std::vector<Triple> result;
  result.reserve(points.size());
  const auto add = [&result, form](const auto& p) {
    const auto& [x, y, z] = p;
    result.push_back({nearest_in(x, form), nearest_in(y, form), nearest_in(z, form)});
    return std::ranges::all_of(result.back(), [](double c) { return std::isfinite(c); });
  };
  const auto all_equal = [](const auto& all) {
    return std::ranges::all_of(all, [&](const auto& p) { return p == all.front(); });
  };
  const bool given = points.in_binary64();
  if (!(given ? std::ranges::all_of(points.binary64(), add) : std::ranges::all_of(points.exact(), add))) return false;
  const bool one_point = given ? all_equal(points.binary64()) : all_equal(points.exact());
  if (all_equal(result) && !one_point) return false;
  points = GivenPoints(std::move(result));
  return true;
}

bool round(HullPair& hulls, Form form) { return round(hulls.a.points, form) && round(hulls.b.points, form); }

bool fits(const HullPair& hulls, Form format) {
  const auto in_binary32 = [](const Triple& p) {
    return std::ranges::all_of(p, [](double value) { return kernels::nearest_binary32(value) == value; });
  };
  return std::ranges::all_of(std::array{&hulls.a, &hulls.b}, [&](const Body* body) {
    const GivenPoints given = in_simplest_form(body->points);
    return given.in_binary64() && (format != Form::binary32 || std::ranges::all_of(given.binary64(), in_binary32));
  });
}

// ---- shapes ----

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

/// Returns false if a number overflows, or if no shape is left.
bool round(families::NamedPair& shapes, Form form) {
  bool finite = true;
  for (families::NamedBody* body : {&shapes.a, &shapes.b})
    for_each_number(*body, [&](mpq_class& value) { finite = round_to_nearest(value, form) && finite; });
  if (!finite) return false;
  shapes.known.reset();
  try {
    for (const families::NamedBody* body : {&shapes.a, &shapes.b}) static_cast<void>(families::shape_of(*body));
  } catch (const std::invalid_argument&) {
    return false;
  }
  return true;
}

bool fits(const families::NamedPair& shapes, Form format) {
  bool fits = true;
  for (const families::NamedBody* body : {&shapes.a, &shapes.b})
    for_each_number(*body, [&](const mpq_class& value) { fits = fits && is_in(value, format); });
  return fits;
}

// ---- unions ----

/// Returns false if a coordinate overflows, or a piece becomes flat.
bool round(Unions& unions, Form form) {
  for (Pieces* pieces : {&unions.a, &unions.b}) {
    for (std::vector<Point>& piece : *pieces) {
      for (Point& p : piece)
        if (!round_to_nearest(p, form)) return false;
      if (families::is_flat(piece)) return false;
    }
  }
  unions.known.reset();
  return true;
}

bool fits(const Unions& unions, Form format) {
  const auto point_fits = [format](const Point& p) {
    return is_in(p.x, format) && is_in(p.y, format) && is_in(p.z, format);
  };
  for (const Pieces* pieces : {&unions.a, &unions.b})
    for (const std::vector<Point>& piece : *pieces)
      if (!std::ranges::all_of(piece, point_fits)) return false;
  return true;
}

// ---- bodies of the plane ----

}  // namespace

families::PlanePair plane_of(const Case& bodies) {
  const auto as_shape = [](const Body& body) {
    Body result;
    result.shape = files::shape_of(body);
    return in_plane(std::move(result));
  };
  return {as_shape(bodies.a), as_shape(bodies.b)};
}

namespace {

/// Returns false if a number overflows, distinct points all become equal, or a radius becomes 0.
bool round(families::PlanePair& plane, Form form) {
  for (Body* body : {&plane.a, &plane.b}) {
    GivenPoints core = in_simplest_form(files::points_of(*body->shape).value());
    mpq_class radius = body->shape->radius;
    if (!round(core, form) || !round_to_nearest(radius, form) || sgn(radius) != sgn(body->shape->radius)) return false;
    body->shape = with_margin(hull(core.exact()), radius);
  }
  return true;
}

bool fits(const families::PlanePair& plane, Form format) {
  return std::ranges::all_of(std::array{&plane.a, &plane.b}, [format](const Body* body) {
    const std::vector<Point> core = files::points_of(*body->shape).value();
    return is_in(body->shape->radius, format) &&
           std::ranges::all_of(core, [format](const Point& p) { return is_in(p.x, format) && is_in(p.y, format); });
  });
}

/// Returns nullptr if none has that name.
const Case* find_real_case(std::string_view name) {
  const std::span<const Case> all = real_cases();
  const auto found = std::ranges::find(all, name, &Case::id);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

std::span<const Case> real_cases() {
  static const std::vector<Case> cases = read_all();
  return cases;
}

std::string_view name_of(Source source) {
  switch (source) {
    case Source::family: return "family";
    case Source::catalogue: return "catalogue";
    case Source::real: return "real";
    case Source::shape_family: return "shape_family";
    case Source::shape_catalogue: return "shape_catalogue";
    case Source::union_family: return "union_family";
    case Source::union_catalogue: return "union_catalogue";
    case Source::plane_family: break;
  }
  return "plane_family";
}

std::string id_of(const Recipe& recipe, Form form) {
  const std::string suffix = form == Form::binary64 ? ".b64" : form == Form::binary32 ? ".b32" : "";
  const std::string prefix = recipe.contacts ? "contacts-" : "";
  if (!from_family(recipe.source)) return prefix + std::string(name_of(recipe.source)) + "-" + recipe.name + suffix;
  return prefix + recipe.name + "-n" + std::to_string(recipe.size) + "-s" + std::to_string(recipe.seed) + suffix;
}

// ---- base cases ----

RecordBodies base_bodies(const Recipe& recipe) {
  const kernels::DefaultFloatEnvironment environment;
  const std::string_view name = recipe.name;
  const families::Family* const family = from_family(recipe.source) ? families::find_family(name) : nullptr;
  const bool found = family != nullptr && family->kind() == kind_of(recipe.source);
  switch (recipe.source) {
    case Source::family:
      if (found) return hulls_of(family->make(recipe.seed, recipe.size));
      break;
    case Source::catalogue:
      if (const auto* entry = families::find_catalogue_entry(name)) return hulls_of(entry->pair);
      break;
    case Source::real:
      if (const Case* const real = find_real_case(name)) return hulls_of(*real);
      break;
    case Source::shape_family:
      if (found) return family->make_shapes(recipe.seed, recipe.size).pair;
      break;
    case Source::shape_catalogue:
      for (const families::ShapeCatalogueEntry& entry : families::shape_catalogue())
        if (entry.shapes.id == name) return entry.shapes.pair;
      break;
    case Source::union_family:
      if (found) {
        const Case made = family->make(recipe.seed, recipe.size);
        return name.starts_with("cut_") ? unions_of(made, known_of_hulls(made)) : unions_of(made);
      }
      break;
    case Source::union_catalogue:
      for (const families::UnionCatalogueEntry& entry : families::union_catalogue())
        if (entry.pair.id == name)
          return unions_of(entry.pair, KnownUnion{entry.status, entry.squared,
                                                  entry.status == Status::penetrating ? entry.optima : 0});
      break;
    case Source::plane_family:
      if (found) return plane_of(family->make(recipe.seed, recipe.size));
      break;
  }
  constexpr std::array what{"a case", "shapes", "unions", "bodies of the plane"};
  const char* const made = what.at(static_cast<std::size_t>(kind_of(recipe.source)));
  throw std::invalid_argument("there is nothing called '" + recipe.name + "' to make " + made + " from");
}

GivenPoints in_simplest_form(const GivenPoints& points) {
  if (points.in_binary64()) return points;
  std::vector<std::array<double, 3>> same;
  same.reserve(points.size());
  for (const Point& p : points) {
    const std::optional<double> x = kernels::in_binary64(p.x), y = x ? kernels::in_binary64(p.y) : x,
                                z = y ? kernels::in_binary64(p.z) : y;
    if (!z) return points;
    same.push_back({*x, *y, *z});
  }
  return GivenPoints(std::move(same));
}

// ---- rounding ----

std::optional<RecordBodies> rounded(const RecordBodies& base, Form form) {
  const kernels::DefaultFloatEnvironment environment;
  RecordBodies result = base;
  if (!std::visit([form](auto& bodies) { return round(bodies, form); }, result)) return std::nullopt;
  return result;
}

bool in_format(const RecordBodies& bodies, Form format) {
  const kernels::DefaultFloatEnvironment environment;
  return format == Form::given || std::visit([format](const auto& pair) { return fits(pair, format); }, bodies);
}

std::vector<FormedCase> cases_of(const Recipe& recipe) {
  std::vector<FormedCase> cases;
  cases.push_back({Form::given, id_of(recipe), base_bodies(recipe), recipe.contacts});
  for (const Form form : {Form::binary64, Form::binary32}) {
    if (in_format(cases.back().bodies, form)) continue;  // rounding would give the same numbers
    if (std::optional<RecordBodies> bodies = rounded(cases.front().bodies, form))
      cases.push_back({form, id_of(recipe, form), *std::move(bodies), recipe.contacts});
  }
  return cases;
}

}  // namespace fathom::golden
