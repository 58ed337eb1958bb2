// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the coincidences of two shapes, decided in rationals and square roots. Every search
// compares all features of one body with all of the other; only for parallel faces, of which
// polytopes have many, it finds them by their normals.

#include <algorithm>
#include <map>
#include <utility>

#include "kernels/context.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/nearest.hpp"
#include "reference/rounded/optimal_cone.hpp"
#include "reference/shapes/core.hpp"
#include "verify/study/solid.hpp"
#include "verify/study/study.hpp"

namespace fathom::studies {
namespace {

using Kind = ShapeCoincidence;

Point point(const RationalVector& v) { return {v.x, v.y, v.z}; }

ShapeFeature feature(std::string_view what) { return {what, {}, std::nullopt, std::nullopt}; }
ShapeFeature centre(const ShapeSolid& solid) { return {"centre", {}, point(*solid.centre), std::nullopt}; }
ShapeFeature line(std::string_view what, const Line& line) {
  return {what, line.direction, point(line.point), std::nullopt};
}
ShapeFeature face(const FlatFace& face) { return {"face", face.normal, std::nullopt, std::nullopt}; }
ShapeFeature radius(const Surd& length) { return {"radius", {}, std::nullopt, length}; }

bool are_parallel(const Vector& u, const Vector& v) { return is_zero(cross(u, v)); }
bool on(const Line& line, const RationalVector& p) {
  return is_zero(cross(RationalVector(p - line.point), rational_vector(line.direction)));
}

/// The bodies, and their coincidences.
class Search {
 public:
  Search(kernels::Context& context, const ShapeSolid& a, const ShapeSolid& b, std::size_t listed, ShapeStudy& study)
      : context_(context), a_(a), b_(b), listed_(listed), study_(study) {}

  void run() {
    context_.report("coincidences");
    if (a_.shape == b_.shape) add(Kind::equal_bodies, feature("body"), feature("body"));
    find_centres_and_axes();
    find_radii();
    find_parallel_faces();
    find_what_faces_meet(a_, b_, true);
    find_what_faces_meet(b_, a_, false);
    find_sides();
    find_contact();
  }

 private:
  void add(Kind kind, ShapeFeature of_a, ShapeFeature of_b) {
    ShapeCoincidences& all = study_.coincidences[static_cast<std::size_t>(kind)];
    ++all.count;
    if (all.listed.size() < listed_) all.listed.push_back({std::move(of_a), std::move(of_b)});
  }

  void find_centres_and_axes() {
    if (a_.centre && b_.centre && *a_.centre == *b_.centre) add(Kind::concentric, centre(a_), centre(b_));
    const bool coaxial =
        a_.axis && b_.axis && are_parallel(a_.axis->direction, b_.axis->direction) && on(*a_.axis, b_.axis->point);
    if (a_.axis && b_.axis) find_axes(*a_.axis, *b_.axis, coaxial);
    if (coaxial) return;
    if (a_.centre && b_.axis && on(*b_.axis, *a_.centre)) add(Kind::centre_on_axis, centre(a_), line("axis", *b_.axis));
    if (b_.centre && a_.axis && on(*a_.axis, *b_.centre)) add(Kind::centre_on_axis, line("axis", *a_.axis), centre(b_));
  }

  void find_axes(const Line& p, const Line& q, bool coaxial) {
    const auto both = [&](Kind kind) { add(kind, line("axis", p), line("axis", q)); };
    if (coaxial) both(Kind::coaxial);
    if (are_parallel(p.direction, q.direction)) {
      both(Kind::parallel_axes);
      return;
    }
    if (dot(p.direction, q.direction) == 0) both(Kind::orthogonal_axes);
    if (dot(RationalVector(q.point - p.point), rational_vector(cross(p.direction, q.direction))) == 0)
      both(Kind::intersecting_axes);
  }

  void find_radii() {
    for (const Surd& r : a_.radii)
      for (const Surd& s : b_.radii)
        if (compare(r, s) == 0) add(Kind::equal_radii, radius(r), radius(s));
  }

  void find_parallel_faces() {
    std::map<Vector, const FlatFace*, LexicographicOrder> of_b;
    for (const FlatFace& g : b_.faces) of_b.emplace(g.normal, &g);
    for (const FlatFace& f : a_.faces) {
      for (const int sense : {1, -1}) {
        const auto found = of_b.find(sense > 0 ? f.normal : -f.normal);
        if (found == of_b.end()) continue;
        add(Kind::parallel_faces, face(f), face(*found->second));
        RootSum difference = f.height;
        difference.add(found->second->height, -sense);
        if (difference.is_zero()) add(Kind::coplanar_faces, face(f), face(*found->second));
      }
    }
  }

  /// Finds, for each face of `flat`, the features of `other` that face it.
  void find_what_faces_meet(const ShapeSolid& flat, const ShapeSolid& other, bool flat_is_a) {
    if (other.half_space() != nullptr) return;
    for (std::size_t i = 0; i < flat.faces.size(); ++i) {
      context_.report("faces", static_cast<double>(i) / static_cast<double>(flat.faces.size()));
      const FlatFace& f = flat.faces[i];
      const SupportFace facing = support_face(other.terms(), -f.normal);
      const ShapeFeature its{word_of(other, facing), -f.normal, std::nullopt, std::nullopt};
      const auto both = [&](Kind kind) { flat_is_a ? add(kind, face(f), its) : add(kind, its, face(f)); };
      if (facing.spanning.size() == 1) both(Kind::generators_along_faces);
      RootSum gap = facing.height;
      gap.add(other.shape.radius, dot(f.normal, f.normal));
      gap.add(f.height);
      if (gap.is_zero()) both(Kind::supporting_faces);
    }
  }

  void find_sides() {
    for (const Generators& s : a_.sides) {
      for (const Generators& t : b_.sides) {
        if (!are_parallel(s.axis.direction, t.axis.direction)) continue;
        add(Kind::parallel_generators, line("generator", s.axis), line("generator", t.axis));
        if (s.radius && t.radius && are_tangent(s, t))
          add(Kind::tangent_generators, line("generator", s.axis), line("generator", t.axis));
      }
    }
    if (study_[Kind::tangent_generators].count == 0) find_tangent_cones();
  }

  /// Finds planes that are tangent to both bodies along generators. A common direction of the
  /// generators is that from apex to apex, or that of a cylinder; the plane's normal is orthogonal
  /// to it, in the plane of it and the axis.
  void find_tangent_cones() {
    std::vector<RationalVector> generators;
    for (const ShapeSolid* solid : {&a_, &b_})
      for (const Generators& side : solid->sides) generators.push_back(rational_vector(side.axis.direction));
    for (const RationalVector& p : a_.apexes)
      for (const RationalVector& q : b_.apexes) generators.push_back(q - p);
    for (const RationalVector& g : generators) {
      for (const ShapeSolid* solid : {&a_, &b_}) {
        if (!solid->axis) continue;
        const RationalVector n = cross(g, cross(rational_vector(solid->axis->direction), g));
        if (is_zero(n)) continue;
        if (add_if_tangent(primitive_along(n)) || add_if_tangent(-primitive_along(n))) return;
      }
    }
  }

  bool add_if_tangent(const Vector& n) {
    const SupportFace of_a = support_face(a_.terms(), -n), of_b = support_face(b_.terms(), n);
    if (of_a.spanning.size() != 1 || of_b.spanning.size() != 1) return false;
    RootSum gap = of_a.height;
    gap.add(of_b.height);
    gap.add(a_.shape.radius + b_.shape.radius, dot(n, n));
    if (!gap.is_zero() || !parallel(of_a.spanning.front(), of_b.spanning.front())) return false;
    add(Kind::tangent_generators, {word_of(a_, of_a), -n, std::nullopt, std::nullopt},
        {word_of(b_, of_b), n, std::nullopt, std::nullopt});
    return true;
  }

  /// Returns whether the cylinders about parallel axes touch along a line, from outside or from
  /// inside.
  static bool are_tangent(const Generators& s, const Generators& t) {
    const RationalVector d = rational_vector(s.axis.direction),
                         c = cross(RationalVector(t.axis.point - s.axis.point), d);
    if (is_zero(c)) return false;
    const mpq_class square = dot(c, c) / dot(d, d);
    for (const auto& [of_s, of_t] : {std::pair(1, 1), std::pair(1, -1), std::pair(-1, 1)}) {
      RootSum gap;
      gap.add(-1, square);
      for (const auto& [sign, radius] : {std::pair(of_s, &*s.radius), std::pair(of_t, &*t.radius)}) {
        gap.add(sign * radius->rational);
        gap.add(sign, radius->root);
      }
      if (gap.is_zero()) return true;
    }
    return false;
  }

  void find_contact() {
    const SignedDepth& depth = study_.depth;
    const mpq_class rho = depth.radius_a + depth.radius_b;
    const Depth* const cores = std::get_if<Depth>(&depth.core);
    if (depth.cone && rho > 0) add(Kind::touching_cores, feature("core"), feature("core"));
    if (!depth.exact()) return;
    const Vector n = depth.cone ? rounded::inner_direction(*depth.cone) : depth.direction();
    const bool touching = depth.status() == Status::touching;
    if (touching && rho > 0 && cores != nullptr && cores->distance())
      add(Kind::distance_of_radii, radius({depth.radius_a, 0}), radius({depth.radius_b, 0}));
    const auto face_of = [](const ShapeSolid& solid, const Vector& u) { return support_face(solid.terms(), u); };
    const SupportFace of_a = a_.half_space() ? SupportFace{} : face_of(a_, -n),
                      of_b = b_.half_space() ? SupportFace{} : face_of(b_, n);
    const std::string_view word_a = a_.half_space() ? "face" : word_of(a_, of_a),
                           word_b = b_.half_space() ? "face" : word_of(b_, of_b);
    study_.contact = ShapeInvolved{{word_a, -n, std::nullopt, std::nullopt}, {word_b, n, std::nullopt, std::nullopt}};
    if (!touching) return;
    add(Kind::touching_features, study_.contact->a, study_.contact->b);
    if (const auto kind = name_of(word_a, word_b)) add(*kind, study_.contact->a, study_.contact->b);
    const bool lines = of_a.spanning.size() == 1 && of_b.spanning.size() == 1;
    const bool known = study_[Kind::tangent_generators].count > 0;
    if (lines && !known && parallel(of_a.spanning.front(), of_b.spanning.front()))
      add(Kind::tangent_generators, study_.contact->a, study_.contact->b);
  }

  static std::optional<Kind> name_of(std::string_view a, std::string_view b) {
    if (a != "face" && b != "face") return std::nullopt;
    const std::string_view other = a == "face" ? b : a;
    if (other == "apex") return Kind::apex_on_face;
    if (other == "rim point") return Kind::rim_on_face;
    if (other == "vertex") return Kind::vertex_on_face;
    if (other == "smooth point") return Kind::tangent_to_face;
    return other == "face" ? Kind::face_on_face : Kind::generator_on_face;
  }

  kernels::Context& context_;
  const ShapeSolid &a_, &b_;
  std::size_t listed_;
  ShapeStudy& study_;
};

ShapeSize size_of(const Shape& shape) {
  ShapeSize size;
  size.radius = shape.radius;
  const auto* const terms = std::get_if<std::vector<Term>>(&shape.core);
  size.half_space = terms == nullptr;
  if (size.half_space) return size;
  size.terms = terms->size();
  for (const Term& term : *terms)
    for (const Atom& atom : term.atoms)
      ++(atom.axes.empty() ? size.points : atom.axes.size() == 2 ? size.discs : size.balls);
  return size;
}

ShapeStudy study_shapes(kernels::Context& context, const Shape& a, const Shape& b, const StudyOptions& options) {
  SignedDepthOptions how;
  how.cores.monitor = options.monitor;
  how.support_calls = options.support_calls;
  ShapeStudy result;
  result.depth = signed_depth(a, b, how);
  result.a = size_of(a);
  result.b = size_of(b);
  context.report("features");
  const ShapeSolid solid_a = solid_of(a), solid_b = solid_of(b);
  Search(context, solid_a, solid_b, options.listed, result).run();
  if (std::holds_alternative<Depth>(result.depth.core)) {
    const auto points_a = shapes::polytope_points(shapes::simplified(a), most_expanded_points),
               points_b = shapes::polytope_points(shapes::simplified(b), most_expanded_points);
    result.cores = study(context, *points_a, *points_b, options);
  }
  return result;
}

}  // namespace
}  // namespace fathom::studies

namespace fathom {

ShapeStudy study(const Shape& a, const Shape& b, const StudyOptions& options) {
  const kernels::DefaultFloatEnvironment environment;
  kernels::Context context(options.monitor);
  return studies::study_shapes(context, a, b, options);
}

}  // namespace fathom
