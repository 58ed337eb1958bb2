// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/study/solid.hpp"

#include <algorithm>
#include <set>

#include "fathom/signed_depth.hpp"
#include "kernels/nearest.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "reference/shapes/core.hpp"

namespace fathom::studies {
namespace {

using Directions = std::set<Vector, kernels::NearestPlanes::LexicographicOrder>;

polytope::Polytope hull_of(std::span<const Point> points) { return polytope::convex_hull(polytope::place(points, points).b.points()); }

std::vector<Point> points_of(const Term& term) {
  std::vector<Point> points;
  for (const Atom& atom : term.atoms)
    if (atom.axes.empty()) points.push_back(atom.center);
  return points;
}

Term term_of(std::span<const Point> points) {
  Term term;
  for (const std::uint32_t i : hull_of(points).input_ids) term.atoms.push_back({points[i], {}});
  return term;
}

/// Directions in which the terms are straight, and outward normals that one term has.
struct Candidates {
  Directions normals, lines;

  void add_both(const RationalVector& n) {
    if (is_zero(n)) return;
    normals.insert(primitive_along(n));
    normals.insert(-primitive_along(n));
  }

  void add(const Term& term) {
    if (const std::vector<Point> points = points_of(term); !points.empty()) {
      const polytope::Polytope hull = hull_of(points);
      for (const polytope::Facet& facet : hull.facets) normals.insert(facet.normal);
      for (const polytope::Edge& edge : hull.edges) lines.insert(primitive(hull.vertices[edge.to] - hull.vertices[edge.from]));
    }
    for (const Atom& atom : term.atoms) {
      if (atom.axes.empty()) continue;
      for (std::size_t k = 1; k < atom.axes.size(); ++k)
        for (std::size_t j = 0; j < k; ++j) add_both(cross(rational(atom.axes[j]), rational(atom.axes[k])));
      for (const Atom& other : term.atoms) {
        const RationalVector d = rational(other.center) - rational(atom.center);
        if (other.axes == atom.axes && !is_zero(d)) lines.insert(primitive_along(d));
      }
    }
  }
};

void find_faces(Solid& solid) {
  if (const HalfSpace* half = solid.half_space()) {
    const Vector n = primitive_along(rational(half->normal));
    const RationalVector m = rational(half->normal);
    FlatFace face{n, {}};
    face.height.add(dot(rational(n), m) / dot(m, m) * half->offset);
    face.height.add(solid.shape.radius, dot(n, n));
    solid.faces.push_back(std::move(face));
    return;
  }
  Candidates all;
  for (const Term& term : solid.terms()) all.add(term);
  if (solid.terms().size() > 1 && all.lines.size() <= most_line_directions)
    for (const Vector& u : all.lines)
      for (const Vector& v : all.lines) all.add_both(rational(cross(u, v)));
  for (const Vector& n : all.normals) {
    SupportFace face = support_face(solid.terms(), n);
    if (face.spanning.size() < 2) continue;
    face.height.add(solid.shape.radius, dot(n, n));
    solid.faces.push_back({n, std::move(face.height)});
  }
}

// ---- symmetry ----

/// Whether two atoms about one centre are equal as sets: M M^T = N N^T.
bool same_form(const Atom& p, const Atom& q) { return gram_of(p) == gram_of(q); }

/// The centre of a term whose atoms are each mirrored in another one.
std::optional<RationalVector> centre_of(const Term& term) {
  std::vector<const Atom*> atoms;
  for (const Atom& atom : term.atoms)
    if (std::none_of(atoms.begin(), atoms.end(), [&](const Atom* p) { return p->center == atom.center && same_form(*p, atom); }))
      atoms.push_back(&atom);
  RationalVector sum;
  for (const Atom* atom : atoms) sum = sum + rational(atom->center);
  const RationalVector centre = scaled(mpq_class(1, static_cast<unsigned long>(atoms.size())), sum);
  const auto mirrored = [&](const Atom* p) {
    const RationalVector image = scaled(2, centre) - rational(p->center);
    return std::any_of(atoms.begin(), atoms.end(), [&](const Atom* q) { return rational(q->center) == image && same_form(*p, *q); });
  };
  return std::all_of(atoms.begin(), atoms.end(), mirrored) ? std::optional(centre) : std::nullopt;
}

std::optional<RationalVector> centre_of(std::span<const Term> terms) {
  RationalVector sum;
  for (const Term& term : terms) {
    const std::optional<RationalVector> centre = centre_of(term);
    if (!centre) return std::nullopt;
    sum = sum + *centre;
  }
  return sum;
}

// ---- radii, generators ----

void add_radius(Solid& solid, Surd radius) {
  if (std::none_of(solid.radii.begin(), solid.radii.end(), [&](const Surd& r) { return compare(r, radius) == 0; }))
    solid.radii.push_back(std::move(radius));
}

void find_radii(Solid& solid) {
  if (solid.half_space() != nullptr) return;
  if (solid.shape.radius > 0) add_radius(solid, {solid.shape.radius, 0});
  if (solid.terms().size() > 1) return;
  for (const Atom& atom : solid.terms().front().atoms)
    if (const std::optional<mpq_class> square = round_square(atom)) add_radius(solid, {solid.shape.radius, *square});
}

void find_sides(Solid& solid) {
  if (solid.half_space() != nullptr || solid.terms().size() > 1) return;
  const std::vector<Atom>& atoms = solid.terms().front().atoms;
  const auto line = [](const Atom& p, const Atom& q) {
    return Line{rational(p.center), primitive_along(rational(q.center) - rational(p.center))};
  };
  if (solid.is_polytope && atoms.size() == 2 && solid.shape.radius > 0) {
    solid.sides.push_back({line(atoms[0], atoms[1]), Surd{solid.shape.radius, 0}});
    return;
  }
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    for (std::size_t j = i + 1; j < atoms.size(); ++j) {
      if (atoms[i].axes.size() != 2 || atoms[j].axes.size() != 2 || !same_form(atoms[i], atoms[j])) continue;
      if (atoms[i].center == atoms[j].center) continue;
      Generators side{line(atoms[i], atoms[j]), std::nullopt};
      const std::optional<mpq_class> square = round_square(atoms[i]);
      const RationalVector normal = cross(rational(atoms[i].axes[0]), rational(atoms[i].axes[1]));
      if (square && is_zero(cross(normal, rational(side.axis.direction)))) side.radius = Surd{solid.shape.radius, *square};
      solid.sides.push_back(std::move(side));
    }
  }
}

/// The factor, other than 1, between the axes of two discs, if there is one.
std::optional<mpq_class> factor_between(const Atom& p, const Atom& q) {
  const RationalVector u = rational(p.axes[0]), v = rational(q.axes[0]);
  const mpq_class factor = dot(u, v) / dot(u, u);
  for (std::size_t k = 0; k < 2; ++k)
    if (scaled(factor, rational(p.axes[k])) != rational(q.axes[k])) return std::nullopt;
  return factor == 1 ? std::nullopt : std::optional(factor);
}

void find_apexes(Solid& solid) {
  if (solid.half_space() != nullptr || solid.terms().size() > 1 || solid.is_polytope) return;
  const std::vector<Atom>& atoms = solid.terms().front().atoms;
  for (const Atom& p : atoms) {
    if (p.axes.empty()) solid.apexes.push_back(rational(p.center));
    for (const Atom& q : atoms) {
      if (&p >= &q || p.axes.size() != 2 || q.axes.size() != 2) continue;
      if (const std::optional<mpq_class> factor = factor_between(p, q))
        solid.apexes.push_back(rational(p.center) + scaled(1 / (1 - *factor), rational(q.center) - rational(p.center)));
    }
  }
}

}  // namespace

Solid solid_of(const Shape& shape) {
  Solid solid{shapes::simplified(shape), false, {}, {}, {}, {}, {}, {}};
  if (const auto points = shapes::polytope_points(solid.shape, most_expanded_points)) {
    solid.is_polytope = true;
    solid.shape.core = std::vector<Term>{term_of(*points)};
  }
  find_faces(solid);
  if (solid.half_space() != nullptr) return solid;
  solid.centre = centre_of(solid.terms());
  solid.axis = axis_of(solid.terms());
  find_radii(solid);
  find_sides(solid);
  find_apexes(solid);
  return solid;
}

std::string_view word_of(const Solid& solid, const SupportFace& face) {
  const bool rounded = solid.shape.radius > 0;
  if (face.spanning.size() == 2) return "face";
  if (face.spanning.size() == 1) return face.of_points && !rounded ? "edge" : "generator";
  if (rounded) return "smooth point";
  constexpr std::string_view corners[] = {"vertex", "apex", "rim point", "smooth point"};
  return corners[static_cast<std::size_t>(face.corner)];
}

}  // namespace fathom::studies
