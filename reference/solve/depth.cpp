// SPDX-License-Identifier: GPL-3.0-or-later
// The methods, the choice of one and of the integers that it computes with, and what users call.
#include "reference/solve/depth.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/float_environment.hpp"
#include "reference/depth/apart.hpp"
#include "reference/depth/contact.hpp"
#include "reference/depth/penetration_depth.hpp"
#include "reference/expanding/expander.hpp"
#include "reference/expanding/expanding_polytope.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::solve {
namespace {

/// Whether an expanding polytope is to be tried first.
bool expands_first(const Options& options) {
  return options.method == Method::certificate || (options.method == Method::automatic && !options.closest_lines);
}

// The answer that a proved expansion gives, which needs no hulls.
template <class Integer>
Depth certified_depth(kernels::Context& context, const polytope::PlacedPairIn<Integer>& pair,
                      expanding::Expansion&& expansion, const Options& options) {
  context.counters.expansions = expansion.points;
  context.counters.inner_facets = expansion.inner.facets.size();
  Penetration answer = depth::penetration_along(pair, expansion.nearest.directions(), options.optima);
  answer.inner = std::move(expansion.inner);
  return {depth::facts_of(pair), std::move(answer), Method::certificate, context.counters};
}

Depth naive_depth_of(kernels::Context& context, const polytope::PlacedPair& pair, const Options& options) {
  depth::Beginning made{.pair = &pair};
  made.depth.method = Method::naive;
  if (depth::begin(context, made, options.validate)) {
    context.report("hull of all differences");
    const std::vector<Vector> nearest = depth::naive_depth(made.hulls.a.vertices, made.hulls.b.vertices).directions;
    made.depth.outcome = depth::penetration_along(pair, nearest, options.optima);
  }
  made.depth.counters = context.counters;
  return std::move(made.depth);
}

Depth exact_depth(kernels::Context& context, const polytope::PlacedPair& pair, const Options& options) {
  return depth::penetration_depth(
      context, pair,
      {options.closest_lines.value_or(ClosestLines::cutting), options.seed, options.optima, options.validate, {}});
}

}  // namespace

std::size_t expansion_budget(const Options& options, std::size_t points) {
  if (options.method == Method::certificate) return expanding::unlimited;
  return options.expansion_budget.value_or(std::min<std::size_t>(200 + 2 * points, 20000));
}

Depth depth_by_method(kernels::Context& context, const polytope::PlacedPair& pair, const Options& options) {
  context.counters = Counters{};
  if (options.method == Method::naive) return naive_depth_of(context, pair, options);
  if (!expands_first(options)) return exact_depth(context, pair, options);
  expanding::Expansion expansion = expanding::nearest_by_expansion(
      context, pair.a, pair.b, expansion_budget(options, pair.a.size() + pair.b.size()), options.workspace);
  const bool apart = expansion.end == expanding::ExpansionEnd::not_inside && !options.validate;
  if (apart) return depth::apart_depth(context, pair, expansion.outside);
  // The budget is exhausted, or each stage is to be validated.
  if (expansion.end != expanding::ExpansionEnd::proved) return exact_depth(context, pair, options);
  if (options.validate) kernels::insist(expanding::validate(expansion, pair.a, pair.b));
  return certified_depth(context, pair, std::move(expansion), options);
}

NarrowResult depth_on_narrow_lattice(kernels::Context& context, const polytope::Points& a, const polytope::Points& b,
                                     const Options& options) {
  NarrowResult result;
  // Stages are validated on the lattice of `place`.
  if (!expands_first(options) || options.validate) return result;
  std::optional<Workspace> own;
  Workspace& workspace = options.workspace != nullptr ? *options.workspace : own.emplace();
  Workspace::Parts& parts = *workspace.parts;
  if (!polytope::place_narrow(a, b, parts.placed)) return result;
  polytope::with_pair(parts.placed, a, b, parts.scan, [&](const auto& pair) {
    expanding::Expansion expansion =
        expanding::nearest_by_expansion(context, pair, expansion_budget(options, a.size() + b.size()), &workspace);
    if (expansion.end == expanding::ExpansionEnd::proved)
      result.depth = certified_depth(context, pair, std::move(expansion), options);
    if (expansion.end == expanding::ExpansionEnd::not_inside)
      result.depth = polytope::with_searched_pair(parts.placed, a, b, parts.scan, [&](const auto& searched) {
        return depth::apart_depth(context, searched, expansion.outside);
      });
  });
  if (!result.depth) result.pair = polytope::widened(parts.placed, b[0].exact());
  return result;
}

// On a narrow lattice an expanding polytope answers if it can, else the exact method on the same
// one. On any other lattice the method decides; if one would be too fine, the deciding points do.
PlacedDepth placed_depth(kernels::Context& context, const polytope::Points& a, const polytope::Points& b,
                         const Options& options) {
  depth::require_listed(options.optima);
  const auto answer = [&](auto method, polytope::PlacedPair pair) {
    Depth depth = method(context, pair, options);
    return PlacedDepth{std::move(depth), std::move(pair)};
  };
  NarrowResult narrow = depth_on_narrow_lattice(context, a, b, options);
  if (narrow.depth) return {std::move(*narrow.depth), std::nullopt};
  if (narrow.pair) return answer(exact_depth, std::move(*narrow.pair));
  std::vector<Point> room_a, room_b;
  const polytope::Positions exact_a = a.exact(room_a), exact_b = b.exact(room_b);
  if (std::optional<polytope::PlacedPair> slim = polytope::place_if_slim(exact_a, exact_b, &context))
    return answer(depth_by_method, std::move(*slim));
  if (std::optional<Depth> depth = depth_by_deciding_points(context, exact_a, exact_b, options))
    return {std::move(*depth), std::nullopt};
  return answer(depth_by_method, polytope::place(exact_a, exact_b, &context));
}

}  // namespace fathom::solve

namespace fathom {
namespace {

Depth depth_of(const polytope::Points& a, const polytope::Points& b, const Options& options) {
  const kernels::DefaultFloatEnvironment environment;
  kernels::Context context(options.monitor);
  return solve::placed_depth(context, a, b, options).depth;
}

}  // namespace

Depth penetration_depth(std::span<const Point> a, std::span<const Point> b, const Options& options) {
  return depth_of(a, b, options);
}

Depth penetration_depth(std::span<const std::array<double, 3>> a, std::span<const std::array<double, 3>> b,
                        const Options& options) {
  return depth_of(a, b, options);
}

Depth penetration_depth(const Body& a, const Body& b, const Options& options) {
  solve::require_space(a, b, "penetration_depth");
  return depth_of(a.points, b.points, options);
}

// The width is the depth of a body against itself.
Depth width(std::span<const Point> points, const Options& options) { return depth_of(points, points, options); }

}  // namespace fathom

// Where the answers of two methods differ.

namespace fathom::solve {
namespace {

std::string shown(bool value) { return value ? "yes" : "no"; }
std::string shown(std::size_t count) { return std::to_string(count); }
std::string shown(Status status) { return std::string(name(status)); }
std::string shown(const mpq_class& value) { return exact_text(value); }
std::string shown(const Vector& v) { return fmt::format("({}, {}, {})", v.x.get_str(), v.y.get_str(), v.z.get_str()); }
std::string shown(const Point& p) {
  return fmt::format("({}, {}, {})", exact_text(p.x), exact_text(p.y), exact_text(p.z));
}
std::string shown(const Contact& contact) {
  return fmt::format("{}: points {} of A, {} of B", name(contact.kind), fmt::join(contact.a, " "),
                     fmt::join(contact.b, " "));
}
std::string shown(const std::optional<Witness>& witness) {
  return witness ? fmt::format("{} and {}", shown(witness->a), shown(witness->b)) : "none";
}

/// Keeps the first difference.
class Comparison {
 public:
  template <class Value>
  void same(const std::string& field, const Value& x, const Value& y) {
    if (!found_ && !(x == y)) found_ = fmt::format("{}: {} and {}", field, shown(x), shown(y));
  }
  [[nodiscard]] bool differs() const { return found_.has_value(); }
  std::optional<std::string> take() { return std::move(found_); }

 private:
  std::optional<std::string> found_;
};

void compare(Comparison& comparison, const std::vector<Optimum>& x, const std::vector<Optimum>& y) {
  comparison.same("number of optima listed", x.size(), y.size());
  for (std::size_t i = 0; i < x.size() && !comparison.differs(); ++i) {
    const std::string place = fmt::format("optima[{}].", i);
    comparison.same(place + "direction", x[i].direction, y[i].direction);
    comparison.same(place + "translation", x[i].translation(), y[i].translation());
    comparison.same(place + "contact", x[i].contact, y[i].contact);
  }
}

void compare(Comparison& comparison, const Distance& x, const Distance& y) {
  comparison.same("distance.squared", x.squared, y.squared);
  comparison.same("distance.translation", x.translation, y.translation);
  comparison.same("distance.witness", std::optional(x.witness), std::optional(y.witness));
  comparison.same("distance.contact", x.contact, y.contact);
}

}  // namespace

std::optional<std::string> disagreement(const Depth& x, const Depth& y) {
  Comparison comparison;
  comparison.same("status", x.status(), y.status());
  comparison.same("flat_a", x.flat_a, y.flat_a);
  comparison.same("flat_b", x.flat_b, y.flat_b);
  comparison.same("squared", x.squared(), y.squared());
  comparison.same("number of optima", x.optima_count(), y.optima_count());
  compare(comparison, x.optima(), y.optima());
  if (comparison.differs()) return comparison.take();
  comparison.same("direction", x.direction(), y.direction());
  comparison.same("witness", x.witness(), y.witness());
  if (x.distance()) compare(comparison, *x.distance(), *y.distance());
  return comparison.take();
}

std::optional<Method> second_method(std::string_view word) {
  for (const Method method : {Method::exact, Method::naive})
    if (word == name(method)) return method;
  return std::nullopt;
}

}  // namespace fathom::solve
