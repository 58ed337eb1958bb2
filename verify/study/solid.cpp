// SPDX-License-Identifier: GPL-3.0-or-later

#include "verify/study/solid.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "fathom/numbers.hpp"
#include "fathom/signed_depth.hpp"
#include "kernels/nearest.hpp"
#include "kernels/number/irrational.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/polytope.hpp"
#include "reference/shapes/core.hpp"

namespace fathom::studies {

void RootSum::add(const mpq_class& factor, const mpq_class& square) {
  if (factor == 0 || square == 0) return;
  for (Part& part : parts_) {
    if (const auto ratio = kernels::rational_root(square / part.square)) {
      part.factor += factor * *ratio;
      return;
    }
  }
  parts_.push_back({square, factor});
}

void RootSum::add(const RootSum& sum, const mpq_class& times) {
  for (const Part& part : sum.parts_) add(times * part.factor, part.square);
}

bool RootSum::is_zero() const {
  return std::all_of(parts_.begin(), parts_.end(), [](const Part& part) { return part.factor == 0; });
}

Vector primitive_along(const RationalVector& v) { return fathom::primitive_along(Point{v.x, v.y, v.z}); }

bool parallel(const RootVector& u, const RootVector& v) {
  const RationalVector rr = cross(u.rational, v.rational), ri = cross(u.rational, v.irrational),
                       ir = cross(u.irrational, v.rational), ii = cross(u.irrational, v.irrational);
  for (const auto axis : {&RationalVector::x, &RationalVector::y, &RationalVector::z}) {
    RootSum component;
    component.add(rr.*axis);
    component.add(ri.*axis, v.square);
    component.add(ir.*axis, u.square);
    component.add(ii.*axis, u.square * v.square);
    if (!component.is_zero()) return false;
  }
  return true;
}

// ---- faces ----

// The support of an atom c + M y is <n,c> + |M^T n|. It is attained by the whole atom if M^T n = 0,
// else by the one point c + M s/|s|, s = M^T n.

namespace {

/// The part of an atom that is farthest in a direction.
struct Farthest {
  const Atom* atom;
  Surd height;
  std::vector<mpq_class> slopes;  ///< s

  Farthest(const Atom& of, const RationalVector& n) : atom(&of), height{dot(n, rational_vector(of.center)), 0} {
    for (const Point& axis : of.axes) {
      slopes.push_back(dot(n, rational_vector(axis)));
      height.root += slopes.back() * slopes.back();
    }
  }
  [[nodiscard]] bool whole() const { return height.root == 0; }

  /// Returns the one point, or the centre of the whole atom.
  [[nodiscard]] RootVector place() const {
    RootVector result{rational_vector(atom->center), {}, height.root};
    for (std::size_t k = 0; k < slopes.size() && !whole(); ++k)
      result.irrational = result.irrational + scaled(slopes[k] / height.root, rational_vector(atom->axes[k]));
    return result;
  }
};

// Two points of the same height have the same square under the root, or rational roots: c1 +
// sqrt(q1) = c2 + sqrt(q2) with rationals c and q implies q1 = q2 if one of the roots is
// irrational.
RootVector between(const RootVector& p, const RootVector& q) {
  if (p.square == q.square) return {q.rational - p.rational, q.irrational - p.irrational, p.square};
  const auto plain = [](const RootVector& v) {
    return v.square == 0 ? v.rational : v.rational + scaled(*kernels::rational_root(v.square), v.irrational);
  };
  return {plain(q) - plain(p), {}, 0};
}

void add_spanning(SupportFace& face, const RootVector& v) {
  const RootVector one_x{{1, 0, 0}, {}, 0}, one_y{{0, 1, 0}, {}, 0};
  if (parallel(v, one_x) && parallel(v, one_y)) return;  // v is 0
  if (face.spanning.size() < 2 &&
      std::none_of(face.spanning.begin(), face.spanning.end(), [&](const auto& u) { return parallel(u, v); }))
    face.spanning.push_back(v);
}

Corner corner_of(const Term& term, const std::vector<Farthest>& tight) {
  Corner sharpest = Corner::smooth;
  for (const Farthest& part : tight) {
    if (part.whole()) {
      const bool pointed =
          std::all_of(term.atoms.begin(), term.atoms.end(), [](const Atom& atom) { return atom.axes.empty(); });
      return pointed ? Corner::vertex : Corner::apex;
    }
    if (part.atom->axes.size() == 2) sharpest = Corner::rim;
  }
  return sharpest;
}

void add_term(SupportFace& face, const Term& term, const RationalVector& n) {
  std::vector<Farthest> tight;
  for (const Atom& atom : term.atoms) {
    Farthest part(atom, n);
    const int order = tight.empty() ? 1 : compare(part.height, tight.front().height);
    if (order < 0) continue;
    if (order > 0) tight.clear();
    tight.push_back(std::move(part));
  }
  face.height.add(tight.front().height.rational);
  face.height.add(1, tight.front().height.root);
  const RootVector first = tight.front().place();
  for (const Farthest& part : tight) {
    add_spanning(face, between(first, part.place()));
    if (part.whole())
      for (const Point& axis : part.atom->axes) add_spanning(face, {rational_vector(axis), {}, 0});
    face.of_points = face.of_points && part.atom->axes.empty();
  }
  face.corner = std::max(face.corner, corner_of(term, tight));
}

}  // namespace

SupportFace support_face(std::span<const Term> terms, const Vector& direction) {
  SupportFace face;
  for (const Term& term : terms) add_term(face, term, rational_vector(direction));
  return face;
}

// ---- revolution ----

std::optional<mpq_class> round_square(const Atom& atom) {
  if (atom.axes.empty()) return std::nullopt;
  const mpq_class square = dot(rational_vector(atom.axes[0]), rational_vector(atom.axes[0]));
  for (std::size_t i = 0; i < atom.axes.size(); ++i) {
    if (dot(rational_vector(atom.axes[i]), rational_vector(atom.axes[i])) != square) return std::nullopt;
    for (std::size_t j = 0; j < i; ++j)
      if (dot(rational_vector(atom.axes[i]), rational_vector(atom.axes[j])) != 0) return std::nullopt;
  }
  return square;
}

std::optional<Line> axis_of(std::span<const Term> terms) {
  const std::optional<shapes::AxisLine> axis = shapes::axis_of(terms);
  if (!axis || !axis->direction) return std::nullopt;
  return Line{rational_vector(axis->point), *axis->direction};
}

// ---- solids ----

namespace {

using Directions = std::set<Vector, LexicographicOrder>;

std::vector<Point> points_of(const Term& term) {
  std::vector<Point> points;
  for (const Atom& atom : term.atoms)
    if (atom.axes.empty()) points.push_back(atom.center);
  return points;
}

Term term_of(const std::vector<Point>& points) {
  Term term;
  for (const std::uint32_t i : polytope::hull_of(points).input_ids) term.atoms.push_back({points[i], {}});
  return term;
}

/// The line directions of the terms, and the outward normals of facets of single terms.
struct Candidates {
  Directions normals, lines;

  void add_both(const RationalVector& n) {
    if (is_zero(n)) return;
    normals.insert(primitive_along(n));
    normals.insert(-primitive_along(n));
  }

  void add(const Term& term) {
    if (const std::vector<Point> points = points_of(term); !points.empty()) {
      const polytope::Polytope hull = polytope::hull_of(points);
      for (const polytope::Facet& facet : hull.facets) normals.insert(facet.normal);
      for (const polytope::Edge& edge : hull.edges)
        lines.insert(primitive(hull.vertices[edge.to] - hull.vertices[edge.from]));
    }
    for (const Atom& atom : term.atoms) {
      if (atom.axes.empty()) continue;
      for (std::size_t k = 1; k < atom.axes.size(); ++k)
        for (std::size_t j = 0; j < k; ++j)
          add_both(cross(rational_vector(atom.axes[j]), rational_vector(atom.axes[k])));
      for (const Atom& other : term.atoms) {
        const RationalVector d = rational_vector(other.center) - rational_vector(atom.center);
        if (other.axes == atom.axes && !is_zero(d)) lines.insert(primitive_along(d));
      }
    }
  }
};

void find_faces(ShapeSolid& solid) {
  if (const HalfSpace* half = solid.half_space()) {
    const Vector n = primitive_along(rational_vector(half->normal));
    const RationalVector m = rational_vector(half->normal);
    FlatFace face{n, {}};
    face.height.add(dot(rational_vector(n), m) / dot(m, m) * half->offset);
    face.height.add(solid.shape.radius, dot(n, n));
    solid.faces.push_back(std::move(face));
    return;
  }
  Candidates all;
  for (const Term& term : solid.terms()) all.add(term);
  if (solid.terms().size() > 1 && all.lines.size() <= most_line_directions)
    for (const Vector& u : all.lines)
      for (const Vector& v : all.lines) all.add_both(rational_vector(cross(u, v)));
  for (const Vector& n : all.normals) {
    SupportFace face = support_face(solid.terms(), n);
    if (face.spanning.size() < 2) continue;
    face.height.add(solid.shape.radius, dot(n, n));
    solid.faces.push_back({n, std::move(face.height)});
  }
}

// ---- symmetry ----

/// Returns whether two atoms about one centre are equal as sets: M M^T = N N^T.
bool same_form(const Atom& p, const Atom& q) { return shapes::gram_of(p) == shapes::gram_of(q); }

/// Returns the centre of a term in which each atom has its mirror image.
std::optional<RationalVector> centre_of(const Term& term) {
  std::vector<const Atom*> atoms;
  for (const Atom& atom : term.atoms)
    if (std::none_of(atoms.begin(), atoms.end(),
                     [&](const Atom* p) { return p->center == atom.center && same_form(*p, atom); }))
      atoms.push_back(&atom);
  RationalVector sum;
  for (const Atom* atom : atoms) sum = sum + rational_vector(atom->center);
  const RationalVector centre = scaled(mpq_class(1, static_cast<unsigned long>(atoms.size())), sum);
  const auto mirrored = [&](const Atom* p) {
    const RationalVector image = scaled(2, centre) - rational_vector(p->center);
    return std::any_of(atoms.begin(), atoms.end(),
                       [&](const Atom* q) { return rational_vector(q->center) == image && same_form(*p, *q); });
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

void add_radius(ShapeSolid& solid, Surd radius) {
  if (std::none_of(solid.radii.begin(), solid.radii.end(), [&](const Surd& r) { return compare(r, radius) == 0; }))
    solid.radii.push_back(std::move(radius));
}

void find_radii(ShapeSolid& solid) {
  if (solid.half_space() != nullptr) return;
  if (solid.shape.radius > 0) add_radius(solid, {solid.shape.radius, 0});
  if (solid.terms().size() > 1) return;
  for (const Atom& atom : solid.terms().front().atoms)
    if (const std::optional<mpq_class> square = round_square(atom)) add_radius(solid, {solid.shape.radius, *square});
}

void find_sides(ShapeSolid& solid) {
  if (solid.half_space() != nullptr || solid.terms().size() > 1) return;
  const std::vector<Atom>& atoms = solid.terms().front().atoms;
  const auto line = [](const Atom& p, const Atom& q) {
    return Line{rational_vector(p.center), primitive_along(rational_vector(q.center) - rational_vector(p.center))};
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
      const RationalVector normal = cross(rational_vector(atoms[i].axes[0]), rational_vector(atoms[i].axes[1]));
      if (square && is_zero(cross(normal, rational_vector(side.axis.direction))))
        side.radius = Surd{solid.shape.radius, *square};
      solid.sides.push_back(std::move(side));
    }
  }
}

/// Returns the factor, other than 1, between the axes of two discs, if there is one.
std::optional<mpq_class> factor_between(const Atom& p, const Atom& q) {
  const RationalVector u = rational_vector(p.axes[0]), v = rational_vector(q.axes[0]);
  const mpq_class factor = dot(u, v) / dot(u, u);
  for (std::size_t k = 0; k < 2; ++k)
    if (scaled(factor, rational_vector(p.axes[k])) != rational_vector(q.axes[k])) return std::nullopt;
  return factor == 1 ? std::nullopt : std::optional(factor);
}

void find_apexes(ShapeSolid& solid) {
  if (solid.half_space() != nullptr || solid.terms().size() > 1 || solid.is_polytope) return;
  const std::vector<Atom>& atoms = solid.terms().front().atoms;
  for (const Atom& p : atoms) {
    if (p.axes.empty()) solid.apexes.push_back(rational_vector(p.center));
    for (const Atom& q : atoms) {
      if (&p >= &q || p.axes.size() != 2 || q.axes.size() != 2) continue;
      if (const std::optional<mpq_class> factor = factor_between(p, q))
        solid.apexes.push_back(rational_vector(p.center) +
                               scaled(1 / (1 - *factor), rational_vector(q.center) - rational_vector(p.center)));
    }
  }
}

}  // namespace

ShapeSolid solid_of(const Shape& shape) {
  ShapeSolid solid{shapes::simplified(shape), false, {}, {}, {}, {}, {}, {}};
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

std::string_view word_of(const ShapeSolid& solid, const SupportFace& face) {
  const bool rounded = solid.shape.radius > 0;
  if (face.spanning.size() == 2) return "face";
  if (face.spanning.size() == 1) return face.of_points && !rounded ? "edge" : "generator";
  if (rounded) return "smooth point";
  constexpr std::string_view corners[] = {"vertex", "apex", "rim point", "smooth point"};
  return corners[static_cast<std::size_t>(face.corner)];
}

}  // namespace fathom::studies
