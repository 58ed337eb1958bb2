// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of shapes: sampled outlines; the contact; a mesh near P, which is the hull of
// differences of samples, each extreme in one of many directions; and coincidences. The topology of
// the exact method exists for polytopes only.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "fathom/signed_depth.hpp"
#include "kernels/context.hpp"
#include "kernels/number/irrational.hpp"
#include "kernels/vector.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/polytope/polytope.hpp"
#include "view/picture/drawn.hpp"
#include "view/stages/parts.hpp"

namespace fathom::stages {
namespace {

using picture::largest;

// The numbers of sampled directions: circles of latitude, and points on each.
constexpr int latitudes = 16, longitudes = 32;
// Samples are rounded to a lattice with this many steps across the body, or across P, so that flat
// parts are exactly flat.
constexpr double steps = 1 << 20;

Place plus(const Place& p, const Place& q) { return {p[0] + q[0], p[1] + q[1], p[2] + q[2]}; }

const std::vector<Term>* terms_of(const Shape& shape) { return std::get_if<std::vector<Term>>(&shape.core); }

// Returns a point of the core: the sum of the first atoms' centers.
Point base_of(const std::vector<Term>& terms) {
  Point base;
  for (const Term& term : terms) base = base + term.atoms.front().center;
  return base;
}

// Returns a bound of the distance of the body's points from the base, in each coordinate.
mpq_class reach_of(const Shape& shape, const std::vector<Term>& terms) {
  return shape.radius + picture::reach_of(terms);
}

// A body in binary64, on the scale of places, relative to its base.
class Outline {
 public:
  Outline(const Shape& shape, const std::vector<Term>& terms, const StagedScale& scale)
      : radius_(scaled(shape.radius, scale)) {
    const auto place = [&](const Point& p) -> Place {
      return {scaled(p.x, scale), scaled(p.y, scale), scaled(p.z, scale)};
    };
    for (const Term& term : terms) {
      std::vector<Piece>& pieces = terms_.emplace_back();
      for (const Atom& atom : term.atoms) {
        Piece& piece = pieces.emplace_back();
        piece.center = place(atom.center - term.atoms.front().center);
        for (const Point& axis : atom.axes) piece.axes.push_back(place(axis));
      }
    }
  }

  // Returns a point of the body that is extreme in a unit direction.
  [[nodiscard]] Place extreme(const Place& u) const {
    Place sum = times(radius_, u);
    for (const std::vector<Piece>& pieces : terms_) {
      const auto best =
          std::ranges::max_element(pieces, {}, [&](const Piece& piece) { return dot(u, piece.extreme(u)); });
      sum = plus(sum, best->extreme(u));
    }
    return sum;
  }

 private:
  struct Piece {
    Place center{};
    std::vector<Place> axes;

    [[nodiscard]] Place extreme(const Place& u) const {
      double square = 0;
      for (const Place& axis : axes) square += dot(axis, u) * dot(axis, u);
      Place point = center;
      if (square == 0) return point;
      for (const Place& axis : axes) point = plus(point, times(dot(axis, u) / std::sqrt(square), axis));
      return point;
    }
  };

  std::vector<std::vector<Piece>> terms_;
  double radius_;
};

constexpr int longitudes_in_plane = 128;

Place at_longitude(int j, int count) {
  const double turn = 2 * std::numbers::pi * j / count;
  return {std::cos(turn), std::sin(turn), 0};
}

std::vector<Place> directions(unsigned dimension) {
  std::vector<Place> result;
  if (dimension == 2) {
    for (int j = 0; j < longitudes_in_plane; ++j) result.push_back(at_longitude(j, longitudes_in_plane));
    return result;
  }
  result = {{0, 0, 1}, {0, 0, -1}};
  for (int i = 1; i < latitudes; ++i) {
    const double polar = std::numbers::pi * i / latitudes;
    for (int j = 0; j < longitudes; ++j) {
      const double turn = 2 * std::numbers::pi * j / longitudes;
      result.push_back({std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)});
    }
  }
  return result;
}

// Returns the hull of the samples.
StagedBody mesh_of(const Shape& shape, const std::vector<Term>& terms, const StagedScale& scale, unsigned dimension) {
  const Outline outline(shape, terms, scale);
  const double reach = scaled(reach_of(shape, terms), scale), step = reach > 0 ? reach / steps : 1;
  std::vector<Vector> samples;
  for (const Place& u : directions(dimension)) {
    const Place p = outline.extreme(u);
    samples.push_back(
        {mpz_class(std::round(p[0] / step)), mpz_class(std::round(p[1] / step)), mpz_class(std::round(p[2] / step))});
  }
  const polytope::Polytope hull = polytope::convex_hull(samples);
  const Point base = base_of(terms) - scale.center;
  const Place at{scaled(base.x, scale), scaled(base.y, scale), scaled(base.z, scale)};
  StagedBody body;
  for (const Vector& v : hull.vertices)
    body.vertices.push_back(plus(at, {v.x.get_d() * step, v.y.get_d() * step, v.z.get_d() * step}));
  for (const polytope::Facet& facet : hull.facets) {
    Indices& corners = body.facets.emplace_back();
    for (std::uint32_t i = facet.begin; i < facet.end; ++i) corners.push_back(hull.corners[i].value);
  }
  if (dimension == 2)
    for (const polytope::Edge& edge : hull.edges) body.edges.push_back({edge.from.value, edge.to.value});
  body.rank = hull.rank;
  return body;
}

StagedBody outline_of(std::string_view name, const Shape& shape, unsigned dimension, Stages& stages) {
  StagedBody body;
  body.rank = 3;
  if (const std::vector<Term>* const terms = terms_of(shape)) {
    body = mesh_of(shape, *terms, stages.scale, dimension);
  } else {
    stages.left_out.push_back(std::string(name) + (dimension == 2 ? " is a half-plane" : " is a half-space") +
                              ", which has no end: it is not drawn.");
  }
  body.sampled = true;
  return body;
}

StagedScale scale_of_shapes(const Shape& a, const Shape& b) {
  const std::vector<Term>*const of_a = terms_of(a), *const of_b = terms_of(b);
  const Point origin = base_of(of_b ? *of_b : *of_a);
  mpq_class extent = of_b ? reach_of(b, *of_b) : mpq_class(0);
  if (of_a) extent = std::max(extent, mpq_class(reach_of(a, *of_a) + largest(base_of(*of_a) - origin)));
  return scale_of(origin, extent);
}

// Returns the exact square of the depth, if it is rational.
std::optional<mpq_class> square_of(const Surd& value) {
  if (value.root == 0) return mpq_class(value.rational * value.rational);
  if (value.rational == 0) return mpq_class(abs(value.root));
  const std::optional<mpq_class> rational = kernels::rational_value(value);
  return rational ? std::optional(mpq_class(*rational * *rational)) : std::nullopt;
}

// Returns the nearest double; nullopt if it is not known, or not finite.
std::optional<double> nearest(const SignedDepth& depth) {
  const double low = depth.exact() ? kernels::nearest_binary64(*depth.exact()) : round_binary64(depth.bounds()->low);
  const double high = depth.exact() ? low : round_binary64(depth.bounds()->high);
  return low == high && std::isfinite(low) && low > 0 ? std::optional(low) : std::nullopt;
}

// Returns the signed depth in the unit of places; for bounds their middle.
double signed_length(const SignedDepth& depth, const StagedScale& scale) {
  if (const Bounds* const bounds = depth.bounds()) return scaled(mpq_class((bounds->low + bounds->high) / 2), scale);
  // Because the two parts may nearly cancel, they are scaled exactly and their sum is rounded once.
  mpq_class factor = 1;
  if (scale.exponent >= 0) factor <<= static_cast<unsigned long>(scale.exponent);
  else factor >>= static_cast<unsigned long>(-scale.exponent);
  const Surd& value = *depth.exact();
  return kernels::nearest_binary64({value.rational * factor, value.root * factor * factor});
}

void add_answer(const SignedDepth& depth, Stages& stages) {
  stages.status = depth.status();
  if (depth.status() == Status::penetrating) {
    stages.depth = nearest(depth);
    if (depth.exact()) stages.squared = square_of(*depth.exact());
  }
  const double length = signed_length(depth, stages.scale);
  StagedContact& contact = stages.contact;
  contact.direction = unit(depth.direction());
  contact.translation = times(depth.status() == Status::touching ? 0 : length, contact.direction);
  if (depth.contact()) contact.features = *depth.contact();
  if (depth.status() != Status::penetrating) return;
  const Depth* const cores = std::get_if<Depth>(&depth.core);
  if (!cores || !cores->penetration()) {
    contact.optima.push_back({contact.direction, contact.translation, contact.features});
    return;
  }
  for (const Optimum& optimum : cores->optima()) {
    const Place direction = unit(optimum.direction);
    contact.optima.push_back({direction, times(length, direction), optimum.contact});
  }
}

Place minus(const Place& p, const Place& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }

const Place& extreme(const std::vector<Place>& points, const Place& u) {
  return *std::ranges::max_element(points, {}, [&](const Place& p) { return dot(p, u); });
}

/// Returns differences b - a that are extreme in directions all around.
std::vector<Place> differences(const std::vector<Place>& a, const std::vector<Place>& b) {
  std::vector<Place> result;
  for (int i = 0; i <= latitudes; ++i) {
    const double polar = std::numbers::pi * i / latitudes;
    for (int j = 0; j < longitudes; ++j) {
      const double turn = 2 * std::numbers::pi * j / longitudes;
      const Place u{std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)};
      result.push_back(minus(extreme(b, u), extreme(a, {-u[0], -u[1], -u[2]})));
    }
  }
  return result;
}

StagedFacet facet_of(const polytope::Polytope& hull, const polytope::Facet& facet, const std::vector<Place>& vertices) {
  StagedFacet result;
  for (std::uint32_t i = facet.begin; i < facet.end; ++i) result.vertices.push_back(hull.corners[i].value);
  result.normal = unit(facet.normal);
  result.distance = std::max(0.0, dot(result.normal, vertices[result.vertices.front()]));
  result.kind = SumFacetKind::merged;
  return result;
}

void add_sampled_sum(Stages& stages) {
  if (stages.status != Status::penetrating || stages.a.vertices.empty() || stages.b.vertices.empty()) {
    stages.left_out.emplace_back("P, the set of all differences b - a, is not drawn.");
    return;
  }
  const std::vector<Place> samples = differences(stages.a.vertices, stages.b.vertices);
  double reach = 0;
  for (const Place& p : samples) reach = std::max({reach, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  const double step = reach > 0 ? reach / steps : 1;
  std::vector<Vector> lattice;
  for (const Place& p : samples)
    lattice.push_back(
        {mpz_class(std::round(p[0] / step)), mpz_class(std::round(p[1] / step)), mpz_class(std::round(p[2] / step))});
  const polytope::Polytope hull = polytope::convex_hull(lattice);
  if (hull.rank < 3) return;
  StagedSum& sum = stages.sum;
  sum.kind = SumKind::sampled;
  for (const Vector& v : hull.vertices)
    sum.vertices.push_back({v.x.get_d() * step, v.y.get_d() * step, v.z.get_d() * step});
  for (const polytope::Facet& facet : hull.facets) sum.facets.push_back(facet_of(hull, facet, sum.vertices));
  std::ranges::stable_sort(sum.facets, {}, &StagedFacet::distance);
  stages.left_out.emplace_back("P is a mesh near the set of all differences: its facets are left out of the ranking.");
}

/// Adds the coincidences under their names in the study.
void add_shape_coincidences(const Shape& a, const Shape& b, const StageOptions& options, Stages& stages) {
  const ShapeStudy found = study(a, b, {.listed = options.listed, .monitor = options.monitor});
  for (std::size_t i = 0; i < found.coincidences.size(); ++i) {
    const auto& [count, listed] = found.coincidences[i];
    if (count == 0) continue;
    StagedCoincidence& kind =
        stages.coincidences.emplace_back(StagedCoincidence{shape_coincidence_names[i], count, {}});
    for (const ShapeInvolved& involved : listed) kind.listed.push_back({{}, {}, {}, involved});
  }
  if (!found.cores) return;
  stages.cores = staged(found.cores->coincidences);
  add_decided(found.cores->predicates, stages);
}

}  // namespace

void add_outlines(const Body& a, const Body& b, const SignedDepth& depth, unsigned dimension, Stages& stages) {
  const Shape shape_a = files::shape_of(a), shape_b = files::shape_of(b);
  stages.scale = scale_of_shapes(shape_a, shape_b);
  stages.a = outline_of("A", shape_a, dimension, stages);
  stages.b = outline_of("B", shape_b, dimension, stages);
  stages.left_out.emplace_back(
      "The outlines are sampled: their facets are near the bodies, and no part of the answer.");
  if (depth.bounds())
    stages.left_out.emplace_back("The depth is known by bounds: the translation is drawn with their middle.");
  add_answer(depth, stages);
}

Stages stages_of_shapes(const Body& a, const Body& b, const StageOptions& options) {
  const Shape shape_a = files::shape_of(a), shape_b = files::shape_of(b);
  SignedDepthOptions wanted;
  wanted.cores.method = Method::exact;
  wanted.cores.monitor = options.monitor;
  const SignedDepth depth = signed_depth(shape_a, shape_b, wanted);
  Stages stages;
  stages.left_out.emplace_back(
      "Of curved bodies there are no diagrams, charts and canonical pairs: those are left out.");
  add_outlines(a, b, depth, 3, stages);
  stages.counters = depth.counters();
  add_sampled_sum(stages);
  add_shape_coincidences(shape_a, shape_b, options, stages);
  return stages;
}

}  // namespace fathom::stages
