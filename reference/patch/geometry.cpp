// SPDX-License-Identifier: GPL-3.0-or-later
// The patches of an answer, for every kind of bodies, and whether the signed depth is smooth there.
#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <utility>

#include "fathom/patch.hpp"
#include "fathom/plane.hpp"
#include "kernels/context.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/patch/local_depth.hpp"
#include "reference/patch/patch.hpp"
#include "reference/rounded/coordinates.hpp"
#include "reference/rounded/optimal_cone.hpp"
#include "reference/shapes/core.hpp"
#include "reference/solve/depth.hpp"

namespace fathom::patch {
namespace {

const CorePoints& require_known(const CorePoints& points) {
  if (!points.known()) throw std::invalid_argument("the answer is about other bodies");
  return points;
}

void add_kink(ContactGeometry& geometry, Kink kink) { geometry.kinks.push_back(kink); }

/// Of convex bodies with so many shortest ways out, whose patches and cone are known.
void find_kinks(ContactGeometry& geometry, std::size_t optima) {
  if (optima > 1) add_kink(geometry, Kink::ties);
  if (std::ranges::any_of(geometry.patches, [](const Patch& patch) { return patch.rank() > 0; }))
    add_kink(geometry, Kink::extended);
  if (geometry.cone && (geometry.cone->lineality != Lineality::none || geometry.cone->rays.size() > 1))
    add_kink(geometry, Kink::cone);
}

/// All directions that separate two bodies by points that touch, and the faces in one of these.
rounded::PlanesBetween between(const CorePoints& a, const CorePoints& b, unsigned dimension, const Touch& touch,
                               Monitor* monitor) {
  if (dimension == 3) {
    kernels::Context context(monitor);
    return rounded::planes_between(context, std::nullopt, a.exact(), b.exact(), touch);
  }
  // Of shapes the answer has these, as those of the plane.
  const auto as_shape = [](const CorePoints& points) {
    Body body;
    body.shape = Shape{hull(points.exact()).core, 0};
    return in_plane(std::move(body));
  };
  Question question;
  question.options.monitor = monitor;
  Answer answer = exact_answer(as_shape(a), as_shape(b), question);
  SignedDepth& found = std::get<SignedDepth>(answer.found);
  return {*std::move(found.cone), *found.contact()};
}

ContactGeometry of_polytopes(const Body& body_a, const Body& body_b, const Depth& depth, const OptimalCone* cone,
                             const Contact* contact, Monitor* monitor) {
  const CorePoints a(body_a), b(body_b);
  const polytope::Points points_a = require_known(a).points(), points_b = require_known(b).points();
  ContactGeometry geometry;
  geometry.cores = depth.status();
  const auto require_faces = [&](const Contact& contact) {
    if (contact.a.back() >= points_a.size() || contact.b.back() >= points_b.size())
      throw std::invalid_argument("the answer is about other bodies");
  };
  if (depth.contact() != nullptr) require_faces(*depth.contact());
  std::size_t optima = 1;
  if (const Penetration* const penetration = depth.penetration()) {
    geometry.patches.reserve(penetration->optima.size());
    for (const Optimum& optimum : penetration->optima) {
      const MeetingFaces faces{optimum.direction, points_a, optimum.contact.a, points_b, optimum.contact.b};
      // In the plane edges are parallel.
      geometry.patches.push_back(body_a.dimension == 2 ? shared(faces, optimum.support)
                                                       : shared_inside(faces, optimum.support));
      geometry.patches.back().way = geometry.patches.size() - 1;
    }
    optima = penetration->optima.size() + penetration->unlisted;
    if (penetration->unlisted > 0) geometry.no_first_order = LeftOut::unlisted;
  } else if (const Distance* const apart = depth.distance()) {
    geometry.patches.push_back(shared({apart->direction, points_a, apart->contact.a, points_b, apart->contact.b},
                                      dot(apart->direction, apart->translation)));
  } else {
    std::optional<rounded::PlanesBetween> planes;
    if (cone == nullptr || contact == nullptr) planes = between(a, b, body_a.dimension, *depth.touch(), monitor);
    geometry.cone = planes ? std::move(planes->cone) : *cone;
    const Contact& faces = planes ? planes->contact : *contact;
    const Vector n = geometry.cone->direction();
    geometry.patches.push_back(shared({n, points_a, faces.a, points_b, faces.b}, 0));
  }
  find_kinks(geometry, optima);
  return geometry;
}

ContactGeometry of_half_space(const Body& a, const Body& b, const PlaneSupport& plane) {
  if (shapes::is_halfspace(a) == shapes::is_halfspace(b))
    throw std::invalid_argument("the answer is about other bodies");
  const bool half_space_is_a = shapes::is_halfspace(a);
  const CorePoints own(half_space_is_a ? b : a);
  ContactGeometry geometry;
  geometry.cores = sgn(plane.support) > 0   ? Status::penetrating
                   : sgn(plane.support) < 0 ? Status::disjoint
                                            : Status::touching;
  if (!own.known()) {
    geometry.no_patches = geometry.no_first_order = LeftOut::too_large;
    return geometry;
  }
  const std::vector<std::uint32_t> face =
      solve::extreme_points(own.exact(), half_space_is_a ? plane.direction : -plane.direction);
  geometry.patches.push_back(on_plane(plane.direction, own.points(), face, plane.support, half_space_is_a));
  if (geometry.cores == Status::touching) geometry.cone = OptimalCone{Lineality::none, {}, {plane.direction}};
  find_kinks(geometry, 1);
  return geometry;
}

// ---- unions ----

/// Whether the faces span a plane, in the plane a line: then it is the only one between pieces that
/// touch there.
bool span_a_plane(const Contact& contact, const std::vector<Point>& a, const std::vector<Point>& b,
                  unsigned dimension) {
  const std::vector<std::uint32_t>&of_a = contact.a, &of_b = contact.b;
  if (dimension == 2) return of_a.size() > 1 || of_b.size() > 1;
  if (of_a.size() > 2 || of_b.size() > 2) return true;
  return of_a.size() == 2 && of_b.size() == 2 && cross(a[of_a[1]] - a[of_a[0]], b[of_b[1]] - b[of_b[0]]) != Point{};
}

mpq_class squared_gap(const CornerBox& a, const CornerBox& b) {
  const auto gap = [](const mpq_class& low, const mpq_class& high, const mpq_class& other_low,
                      const mpq_class& other_high) -> mpq_class {
    if (high < other_low) return other_low - high;
    return other_high < low ? mpq_class(low - other_high) : mpq_class(0);
  };
  const Point d{gap(a.low.x, a.high.x, b.low.x, b.high.x), gap(a.low.y, a.high.y, b.low.y, b.high.y),
                gap(a.low.z, a.high.z, b.low.z, b.high.z)};
  return dot(d, d);
}

/// The patches of all pairs of pieces that are nearest.
void add_nearest(ContactGeometry& geometry, const Pieces& a, const Pieces& b, const UnionDistance& apart,
                 Monitor* monitor) {
  kernels::Context context(monitor);
  Options options;
  options.monitor = monitor;
  const mpq_class& squared = apart.distance.squared;
  std::vector<CornerBox> boxes_a(a.begin(), a.end()), boxes_b(b.begin(), b.end());
  for (std::uint32_t i = 0; i < a.size(); ++i)
    for (std::uint32_t j = 0; j < b.size(); ++j) {
      context.check();
      if (squared_gap(boxes_a[i], boxes_b[j]) > squared) continue;
      const Depth depth = penetration_depth(a[i], b[j], options);
      const Distance& found = *depth.distance();
      if (found.squared != squared) continue;
      geometry.patches.push_back(shared({found.direction, a[i], found.contact.a, b[j], found.contact.b},
                                        dot(found.direction, found.translation)));
      geometry.patches.back().pieces = {i, j};
    }
}

ContactGeometry of_unions(const Pieces& a, const Pieces& b, const UnionDepth& depth, unsigned dimension,
                          Monitor* monitor) {
  ContactGeometry geometry;
  geometry.of_unions = true;
  geometry.cores = depth.status;
  if (!depth.complete) {
    geometry.no_patches = geometry.no_first_order = LeftOut::incomplete;
    return geometry;
  }
  if (depth.apart) add_nearest(geometry, a, b, *depth.apart, monitor);
  for (std::size_t way = 0; way < depth.optima.size(); ++way) {
    const Point& t = depth.optima[way].translation;
    for (const PieceContact& c : depth.optima[way].contacts) {
      Patch& patch =
          geometry.patches.emplace_back(shared_after(t, {c.direction, a[c.a], c.contact.a, b[c.b], c.contact.b}));
      patch.pieces = {c.a, c.b};
      patch.way = way;
      patch.one_plane = span_a_plane(c.contact, a[c.a], b[c.b], dimension);
    }
    geometry.clearance.push_back(depth.optima[way].clearance);
  }
  if (depth.status == Status::touching) geometry.no_first_order = LeftOut::touching;
  return geometry;
}

/// Whether the core is a half-space, or every atom of it a point.
bool of_points(const Body& body) {
  const auto* const terms = body.shape ? std::get_if<std::vector<Term>>(&body.shape->core) : nullptr;
  return terms == nullptr || std::ranges::all_of(*terms, [](const Term& term) {
           return std::ranges::all_of(term.atoms, [](const Atom& atom) { return atom.axes.empty(); });
         });
}

ContactGeometry of_shapes(const Body& a, const Body& b, const SignedDepth& shapes, Monitor* monitor) {
  ContactGeometry geometry;
  if (const Depth* const cores = std::get_if<Depth>(&shapes.core)) {
    geometry = of_polytopes(a, b, *cores, shapes.cone ? &*shapes.cone : nullptr, shapes.contact(), monitor);
  } else if (const PlaneSupport* const plane = std::get_if<PlaneSupport>(&shapes.core)) {
    geometry = of_half_space(a, b, *plane);
  } else {
    const bool polytopes = of_points(a) && of_points(b);
    geometry.no_patches = geometry.no_first_order = polytopes ? LeftOut::too_large : LeftOut::curved;
  }
  for (Patch& patch : geometry.patches) (patch.radius_a = shapes.radius_a, patch.radius_b = shapes.radius_b);
  return geometry;
}

// ---- weights ----

/// The weights of the body's points in a face that make up the point p, which lies inside the least
/// face `on`; nullopt unless there is one way alone.
std::optional<std::vector<Weight>> only_weights(polytope::Positions body, const Vector& u,
                                                const std::vector<std::uint32_t>& on, const Point& p) {
  if (on.empty()) return std::vector<Weight>();
  if (on.size() > 3) return std::nullopt;
  const Point& first = body[on[0]];
  std::size_t in_face = 0;
  for (const std::uint32_t i : solve::extreme_points(body, u)) {
    const bool there = on.size() == 1   ? body[i] == first
                       : on.size() == 2 ? cross(body[on[1]] - first, body[i] - first) == Point{}
                                        : true;
    if (there && ++in_face > on.size()) return std::nullopt;
  }
  return weights_in(body, on, p);
}

}  // namespace

CorePoints::CorePoints(const Body& body) : body_(body) {
  if (body.shape) expanded_ = shapes::polytope_points(shapes::simplified(*body.shape), most_expanded_points);
}

std::optional<std::vector<RoundedWitness>> with_slack(const Body& a, const Body& b, const Patch& patch,
                                                      const mpq_class& slack) {
  const CorePoints of_a(a), of_b(b);
  const mpq_class* const support = std::get_if<mpq_class>(&patch.by);
  if (!support || !of_a.known() || !of_b.known()) return std::nullopt;
  const Vector& n = patch.direction;
  std::vector<RoundedWitness> corners;
  for (const LineOverlap& line : LinesAlong(n, of_a.exact(), of_b.exact()).with_slack(*support, slack * slack))
    corners.push_back({{line.a, n, -patch.radius_a}, {line.b, n, patch.radius_b}});
  return corners;
}

std::vector<Weight> weights_in(polytope::Positions body, const std::vector<std::uint32_t>& corners, const Point& p) {
  const Point& first = body[corners[0]];
  if (corners.size() == 1) return {{corners[0], 1}};
  const auto kept = [](std::vector<Weight> weights) {
    std::erase_if(weights, [](const Weight& w) { return w.weight == 0; });
    std::ranges::sort(weights, {}, &Weight::index);
    return weights;
  };
  const Point to = p - first;
  if (corners.size() == 2) {
    const Point along = body[corners[1]] - first;
    const mpq_class share = dot(along, to) / dot(along, along);
    return kept({{corners[0], 1 - share}, {corners[1], share}});
  }
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const Point e = body[corners[k]] - first, f = body[corners[k + 1]] - first, area = cross(e, f);
    const mpq_class whole = dot(area, area), second = dot(area, cross(to, f)) / whole,
                    third = dot(area, cross(e, to)) / whole;
    if (second >= 0 && third >= 0 && second + third <= 1)
      return kept({{corners[0], 1 - second - third}, {corners[k], second}, {corners[k + 1], third}});
  }
  throw std::logic_error("a corner of a patch outside its face");
}

}  // namespace fathom::patch

namespace fathom {

ContactGeometry contact_geometry(const Body& a, const Body& b, const Answer& answer, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  const unsigned dimension = answer.dimension();
  if (a.dimension != dimension || b.dimension != dimension)
    throw std::invalid_argument("the answer is about other bodies");
  ContactGeometry geometry;
  if (const Depth* const depth = std::get_if<Depth>(&answer.found))
    geometry = patch::of_polytopes(a, b, *depth, nullptr, nullptr, monitor);
  else if (const SignedDepth* const shapes = std::get_if<SignedDepth>(&answer.found))
    geometry = patch::of_shapes(a, b, *shapes, monitor);
  else geometry = patch::of_unions(pieces_of(a), pieces_of(b), std::get<UnionDepth>(answer.found), dimension, monitor);
  geometry.dimension = dimension;
  if (!a.solid && !b.solid) return geometry;
  const patch::SolidSurfaces surfaces(a, b);
  for (Patch& patch : geometry.patches) surfaces.name(patch, patch);
  return geometry;
}

std::optional<VertexWeights> vertex_weights(const Body& body_a, const Body& body_b, const ContactGeometry& geometry) {
  if (!geometry.smooth()) return std::nullopt;
  const kernels::DefaultFloatEnvironment environment;
  const Patch& patch = geometry.patches.front();
  const patch::CorePoints a(body_a), b(body_b);
  const auto of = [](const patch::CorePoints& points, const Vector& u, const std::vector<std::uint32_t>& on,
                     const Point& p) {
    return on.empty() ? std::vector<Weight>() : patch::only_weights(points.exact(), u, on, p);
  };
  std::optional<std::vector<Weight>> of_a = of(a, -patch.direction, patch.corners[0].on_a, patch.a(0).core);
  std::optional<std::vector<Weight>> of_b = of(b, patch.direction, patch.corners[0].on_b, patch.b(0).core);
  if (!of_a || !of_b) return std::nullopt;
  return VertexWeights{std::move(*of_a), std::move(*of_b)};
}

std::optional<Gradient> ContactGeometry::gradient() const {
  return smooth() ? std::optional(Gradient{patches.front().direction, patches.front().a(0).core}) : std::nullopt;
}

SurdPoint Gradient::by_translation() const { return rounded::coordinates(AlongNormal{normal, 0, -1}); }

SurdPoint Gradient::by_rotation() const {
  const Point moment = cross(rational(normal), point);  // -(p x n)
  const mpq_class square(dot(normal, normal));
  const auto coordinate = [&](const mpq_class& c) { return Surd{0, mpq_class(c * abs(c) / square)}; };
  return {coordinate(moment.x), coordinate(moment.y), coordinate(moment.z)};
}

std::string_view name(Kink kink) {
  constexpr std::array<std::string_view, 3> names{"ties", "extended", "cone"};
  return names.at(static_cast<std::size_t>(kink));
}

std::string_view name(LeftOut reason) {
  constexpr std::array<std::string_view, 7> names{"curved",    "unlisted",  "incomplete", "touching",
                                                  "too-large", "exact-fit", "many-planes"};
  return names.at(static_cast<std::size_t>(reason));
}

}  // namespace fathom
