// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/unions/pieces.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "kernels/filters/plane.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/predicates/direction.hpp"
#include "reference/expanding/surface.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::unions {
namespace {

void require_points(const Pieces& pieces, const std::string& body) {
  if (pieces.empty()) throw std::invalid_argument("body " + body + " has no pieces");
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (pieces[i].empty()) throw std::invalid_argument("piece " + std::to_string(i) + " of " + body + " has no points");
}

void require_interior(const std::vector<Vector>& points, std::size_t i, const std::string& body) {
  if (polytope::affine_rank(points) < 3)
    throw std::invalid_argument("piece " + std::to_string(i) + " of " + body +
                                " is flat: the pieces of a union need interiors");
}

std::vector<PlacedPiece> parted(const kernels::PointCloud& whole, const Pieces& pieces, const std::string& body) {
  std::vector<PlacedPiece> placed;
  auto from = whole.points().begin();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto to = std::next(from, static_cast<std::ptrdiff_t>(pieces[i].size()));
    std::vector<Vector> points(from, to);
    require_interior(points, i, body);
    placed.push_back({kernels::PointCloud(std::move(points), whole.exponent())});
    from = to;
  }
  return placed;
}

// ---- lattices of their own ----

constexpr long most_shared_bits = 128;

template <class F>
void for_each_coordinate(const Pieces& pieces, F f) {
  for (const std::vector<Point>& piece : pieces)
    for (const Point& p : piece)
      for (const mpq_class* c : {&p.x, &p.y, &p.z}) f(*c);
}

// A multiple of the shortest denominators: what most pieces share when some of their points were
// there before they were cut.
mpz_class shared_denominator(const Pieces& a, const Pieces& b) {
  std::vector<mpz_class> all;
  for (const Pieces* body : {&a, &b}) {
    for_each_coordinate(*body, [&](const mpq_class& c) {
      if (kernels::bit_length(c.get_den()) <= most_shared_bits) all.push_back(c.get_den());
    });
  }
  std::sort(all.begin(), all.end());
  mpz_class shared = 1;
  for (const mpz_class& denominator : all) {
    mpz_class both = lcm(shared, denominator);
    if (kernels::bit_length(both) <= most_shared_bits) shared = std::move(both);
  }
  return shared;
}

mpz_class floored(const mpq_class& q) {
  mpz_class n;
  mpz_fdiv_q(n.get_mpz_t(), q.get_num_mpz_t(), q.get_den_mpz_t());
  return n;
}

PlacedPiece placed_alone(const std::vector<Point>& piece, const mpz_class& denominator, const Point& origin) {
  std::vector<Point> moved;
  mpz_class factor = 1;
  for (const Point& p : piece) {
    moved.push_back(denominator * (p - origin));
    for (const mpq_class* c : {&moved.back().x, &moved.back().y, &moved.back().z}) factor = lcm(factor, c->get_den());
  }
  const auto over = [](const Point& p, const mpz_class& w) {
    const auto multiple = [&](const mpq_class& c) { return mpz_class(c.get_num() * (w / c.get_den())); };
    return Vector{multiple(p.x), multiple(p.y), multiple(p.z)};
  };
  std::vector<Vector> points;
  std::vector<Homogeneous> reduced;
  for (const Point& p : moved) {
    mpz_class w = lcm(lcm(p.x.get_den(), p.y.get_den()), p.z.get_den());
    points.push_back(over(p, factor));
    reduced.push_back({over(p, w), std::move(w)});
  }
  const long exponent = kernels::binary_exponent(points);
  return {kernels::PointCloud(std::move(points), exponent), std::move(factor), 1, std::move(reduced)};
}

// An upper bound of the exponent of a piece's coordinates in the common unit.
long common_exponent(const PlacedPiece& piece) {
  return piece.cloud.exponent() - kernels::bit_length(piece.factor) + 1;
}

PlacedPieces place_each(const Pieces& a, const Pieces& b) {
  PlacedPieces placed;
  mpz_class& denominator = placed.whole.denominator = shared_denominator(a, b);
  const auto on_lattice = [&](const mpq_class& c) { return kernels::ratio(floored(c * denominator), denominator); };
  long exponent = -1;
  while (exponent < 0) {
    const Point& first = b[0][0];
    placed.whole.origin = {on_lattice(first.x), on_lattice(first.y), on_lattice(first.z)};
    for (const auto& [from, to] : {std::pair(&a, &placed.a), std::pair(&b, &placed.b)}) {
      to->clear();
      for (std::size_t i = 0; i < from->size(); ++i) {
        to->push_back(placed_alone((*from)[i], denominator, placed.whole.origin));
        require_interior(to->back().cloud.points(), i, from == &a ? "A" : "B");
        exponent = std::max(exponent, common_exponent(to->back()));
      }
    }
    if (exponent < 0) denominator <<= static_cast<unsigned long>(-exponent);
  }
  for (std::vector<PlacedPiece>* body : {&placed.a, &placed.b}) {
    for (PlacedPiece& piece : *body) {
      long power = 0;
      const double mantissa = mpz_get_d_2exp(&power, piece.factor.get_mpz_t());
      piece.scale = std::ldexp(1 / mantissa, static_cast<int>(piece.cloud.exponent() - power - exponent));
    }
  }
  placed.whole.a = placed.whole.b = kernels::PointCloud({}, exponent);
  return placed;
}

std::vector<Vector> multiples(const PlacedPiece& piece, const mpz_class& factor) {
  const mpz_class by = factor / piece.factor;
  std::vector<Vector> points;
  for (const Vector& p : piece.cloud.points()) points.push_back(by * p);
  return points;
}

// The least and the greatest coordinate of a piece along an axis, in the common unit.
std::pair<mpq_class, mpq_class> extent(const PlacedPiece& piece, int axis) {
  const auto before = [&](const Vector& p, const Vector& q) {
    return kernels::coordinate(p, axis) < kernels::coordinate(q, axis);
  };
  const auto [low, high] = std::minmax_element(piece.cloud.points().begin(), piece.cloud.points().end(), before);
  return {kernels::ratio(kernels::coordinate(*low, axis), piece.factor),
          kernels::ratio(kernels::coordinate(*high, axis), piece.factor)};
}

// ---- pairs ----

constexpr std::size_t most_separations = 14;

using kernels::AnyNumbers;
using kernels::as;
using kernels::FixedNumbers;

template <class Integer>
Vec3<Integer> axis(int k, long sign) {
  return {Integer(k == 0 ? sign : 0), Integer(k == 1 ? sign : 0), Integer(k == 2 ? sign : 0)};
}

// The plane <normal, x> = height / w of a primitive normal, without fractions.
kernels::OrientedPlane over(const Vector& normal, const mpz_class& height, const mpz_class& w, long exponent) {
  const mpz_class shared = gcd(w, height);
  kernels::OrientedPlane plane{mpz_class(w / shared) * normal, height / shared, {}};
  const long bits = kernels::bit_length(plane.normal);
  plane.image = {kernels::image(plane.normal, bits), kernels::image(plane.height, bits + exponent)};
  return plane;
}

// b - a.
Homogeneous difference(const Homogeneous& a, const Homogeneous& b) { return {a.w * b.v - b.w * a.v, a.w * b.w}; }

// The points of both pieces whose difference is a corner of Q.
struct Ends {
  const Homogeneous &a, &b;
};

// A multiple, by a positive number, of the way from one corner to another.
Vector way(const Ends& from, const Ends& to) {
  if (&from.a == &to.a) return difference(from.b, to.b).v;
  if (&from.b == &to.b) return difference(to.a, from.a).v;
  return difference(difference(from.a, from.b), difference(to.a, to.b)).v;
}

}  // namespace

PlacedPieces place_pieces(const Pieces& a, const Pieces& b, Lattices lattices) {
  require_points(a, "A");
  require_points(b, "B");
  const std::vector<Point> all_a = polytope::joined(a), all_b = polytope::joined(b);
  polytope::require_bodies(all_a, all_b);
  std::optional<polytope::PlacedPair> whole;
  if (lattices == Lattices::one) whole = polytope::place(all_a, all_b);
  if (lattices == Lattices::fitting) whole = polytope::place_if_slim(all_a, all_b);
  if (!whole) return place_each(a, b);
  return {*whole, parted(whole->a, a, "A"), parted(whole->b, b, "B")};
}

mpz_class PlacedPieces::factor(std::uint32_t i, std::uint32_t j) const { return lcm(a[i].factor, b[j].factor); }

polytope::PlacedPair PlacedPieces::pair(std::uint32_t i, std::uint32_t j) const {
  if (on_one_lattice()) return {whole.denominator, whole.origin, a[i].cloud, b[j].cloud};
  const mpz_class finer = factor(i, j);
  return polytope::place_integers(multiples(a[i], finer), multiples(b[j], finer), whole.denominator * finer,
                                  whole.origin);
}

mpq_class PlacedPieces::squared_of_boxes(std::uint32_t i, std::uint32_t j) const {
  std::optional<mpq_class> least;
  mpq_class gaps = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low_a, high_a] = extent(a[i], axis);
    const auto [low_b, high_b] = extent(b[j], axis);
    for (const mpq_class& margin : {mpq_class(high_a - low_b), mpq_class(high_b - low_a)}) {
      if (!least || margin < *least) least = margin;
      if (margin < 0) gaps += margin * margin;
    }
  }
  return (gaps > 0 ? mpq_class(-gaps) : mpq_class(*least * *least)) / (whole.denominator * whole.denominator);
}

Point PlacedPieces::translation(const kernels::RationalPoint& p) const {
  const mpz_class w = p.w * whole.denominator;
  return {kernels::ratio(p.v.x, w), kernels::ratio(p.v.y, w), kernels::ratio(p.v.z, w)};
}

kernels::RationalPoint PlacedPieces::point(const Point& t) const {
  const Point p = whole.denominator * t;
  const mpz_class w = lcm(lcm(p.x.get_den(), p.y.get_den()), p.z.get_den());
  const auto over_w = [&](const mpq_class& x) { return mpz_class(x.get_num() * (w / x.get_den())); };
  return kernels::rational_point({over_w(p.x), over_w(p.y), over_w(p.z)}, w, exponent());
}

mpq_class PlacedPieces::squared(const mpz_class& numerator, const mpz_class& denominator) const {
  return kernels::ratio(numerator, denominator * whole.denominator * whole.denominator);
}

double PlacedPieces::image_above(const mpq_class& squared) const {
  const mpq_class in_units = squared * whole.denominator * whole.denominator;
  return kernels::root_from_above(in_units.get_num(), in_units.get_den(), exponent());
}

// root_from_above is off by a factor below 1 + 2^-40 + 2^-50.
double PlacedPieces::image_below(const mpq_class& squared) const { return image_above(squared) * (1 - 0x1p-39); }

template <class Numbers>
PiecePairIn<Numbers>::PiecePairIn(const PlacedPieces& pieces, std::uint32_t i, std::uint32_t j)
    : a(i),
      b(j),
      factor_(pieces.factor(i, j)),
      pieces_(pieces),
      own_(pieces.on_one_lattice() ? std::nullopt : std::optional(pieces.pair(i, j))),
      differences_(polytope::differences_in<IntegerOfScans<Numbers>>(own_ ? own_->a : pieces.a[i].cloud,
                                                                     own_ ? own_->b : pieces.b[j].cloud, memory_)) {
  using Integer = IntegerOfScans<Numbers>;
  for (int k = 0; k < 3; ++k) {
    for (const long sign : {1L, -1L}) {
      const Vec3<Integer> u = axis<Integer>(k, sign);
      const Integer height = dot(u, differences_[differences_.extreme(u)]);
      using OfPlane = typename Numbers::OfPlane;
      separations_.push_back(outwards(as<OfPlane>(u), as<OfPlane>(height)));
    }
  }
}

// A plane on the pair's lattice as one on the common lattice: <n, factor x> = h, reduced.
template <class Numbers>
typename PiecePairIn<Numbers>::Plane PiecePairIn<Numbers>::outwards(const Vec3<typename Numbers::OfPlane>& normal,
                                                                    const typename Numbers::OfPlane& height) const {
  Plane plane = kernels::oriented_plane<Numbers>(normal, height, differences_.exponent());
  if constexpr (std::is_same_v<Numbers, AnyNumbers>) {
    if (!own_) return plane;
    return over(plane.normal, plane.height, factor_, pieces_.exponent());
  }
  return plane;
}

// That of a triangle of Q. Its corners are computed with as they are in the common unit: on the
// pair's lattice a plane has several times as many digits before it is reduced.
template <class Numbers>
typename PiecePairIn<Numbers>::Plane PiecePairIn<Numbers>::plane_of(expanding::TriangleId triangle) {
  if constexpr (std::is_same_v<Numbers, AnyNumbers>) {
    if (own_) {
      const auto corner = [&](int k) {
        const polytope::Difference d = surface_.vertices()[surface_.triangles()[triangle].corners[k]].from;
        return Ends{pieces_.a[a].points[d.first], pieces_.b[b].points[d.second]};
      };
      const Ends p = corner(0);
      const Vector normal = primitive(cross(way(p, corner(1)), way(p, corner(2))));
      const Homogeneous at = difference(p.a, p.b);
      return over(normal, dot(normal, at.v), at.w, pieces_.exponent());
    }
  }
  const expanding::ExactPlane<typename Numbers::OfPlane>& exact = surface_.plane(triangle);
  return outwards(exact.normal, exact.height);
}

// The way back; in `room`, if it is another plane.
template <class Numbers>
const typename PiecePairIn<Numbers>::Plane& PiecePairIn<Numbers>::inwards(const Plane& plane, Plane& room) const {
  if constexpr (std::is_same_v<Numbers, AnyNumbers>) {
    if (factor_ == 1) return plane;
    const mpz_class shared = gcd(gcd(plane.normal.x, plane.normal.y), plane.normal.z);
    room = {primitive(plane.normal), plane.height * factor_ / shared, plane.image};
    return room;
  }
  return plane;
}

template <class Numbers>
typename PiecePairIn<Numbers>::Corner PiecePairIn<Numbers>::corner(polytope::Difference d) const {
  Vec3<typename Numbers::OfPlane> exact = as<typename Numbers::OfPlane>(differences_[d]);
  const Vec3<double> rounded = kernels::image(exact, differences_.exponent());
  return {d, std::move(exact), rounded};
}

template <class Numbers>
void PiecePairIn<Numbers>::start() {
  if (std::exchange(started_, true)) return;
  const auto first = expanding::starting_tetrahedron(differences_);
  if (!first) throw std::logic_error("a piece of a union is flat");
  surface_.start({corner((*first)[0]), corner((*first)[1]), corner((*first)[2]), corner((*first)[3])});
  for (const expanding::TriangleId t : surface_.triangles().ids())
    facets_.push_back(&all_.emplace_back(t, plane_of(t)));
}

template <class Numbers>
void PiecePairIn<Numbers>::grow(const Corner& corner, const Facet& facet) {
  const std::vector<expanding::TriangleId>& fresh = surface_.insert(corner, facet.triangle);
  std::erase_if(facets_, [&](const Facet* f) { return !surface_.triangles()[f->triangle].alive; });
  for (const expanding::TriangleId t : fresh) facets_.push_back(&all_.emplace_back(t, plane_of(t)));
}

// The facet that the point is farthest above, by its image, of those that do not have it strictly
// below.
template <class Numbers>
typename PiecePairIn<Numbers>::Facet* PiecePairIn<Numbers>::worst(const Place& p) {
  Facet* found = nullptr;
  double most = -std::numeric_limits<double>::infinity();
  for (Facet* f : facets_) {
    if (kernels::side(f->plane, p) < 0) continue;
    const Vec3<double>& n = f->plane.image.normal;
    const double height = (dot(n, p.image) - f->plane.image.height) / std::sqrt(dot(n, n));
    if (found == nullptr || height > most) {
      found = f;
      most = height;
    }
  }
  return found;
}

template <class Numbers>
bool PiecePairIn<Numbers>::separated(const Place& p) {
  for (std::size_t i = 0; i < separations_.size(); ++i) {
    if (kernels::side(separations_[i], p) < 0) continue;
    if (i > 0) std::swap(separations_[0], separations_[i]);
    return true;
  }
  return false;
}

template <class Numbers>
void PiecePairIn<Numbers>::remember(Plane plane) {
  if (separations_.size() == most_separations) separations_.pop_back();
  separations_.insert(separations_.begin(), std::move(plane));
}

// A step for a point that is not strictly below the facet: Q grows in the facet's direction, unless
// a plane in that direction separates the point from P_ij; then it returns false.
template <class Numbers>
bool PiecePairIn<Numbers>::step_towards(const Place& p, Facet& facet) {
  Plane room;
  const Plane& plane = inwards(facet.plane, room);
  using OfPlane = typename Numbers::OfPlane;
  Product of_p = dot(as<Product>(plane.normal), as<Product>(p.v));
  if constexpr (std::is_same_v<Numbers, AnyNumbers>) of_p *= factor_;
  const auto inside = [&](const OfPlane& height) {
    return cmp(of_p, Product(as<Product>(height) * as<Product>(p.w))) < 0;
  };
  Corner next = corner(differences_.likely_extreme(plane.image.normal));
  OfPlane height = dot(plane.normal, next.exact);
  if (!inside(height) || cmp(height, plane.height) <= 0) {
    next = corner(differences_.extreme(as<IntegerOfScans<Numbers>>(plane.normal)));
    height = dot(plane.normal, next.exact);
    if (!inside(height)) {
      facet.supports = height == plane.height;
      remember(outwards(plane.normal, height));
      return false;
    }
  }
  grow(next, facet);
  return true;
}

template <class Numbers>
bool PiecePairIn<Numbers>::contains(const Place& p) {
  if (separated(p)) return false;
  start();
  while (Facet* facet = worst(p)) {
    if (facet->supports) {
      remember(facet->plane);
      return false;
    }
    if (!step_towards(p, *facet)) return false;
  }
  return true;
}

template <class Numbers>
double PiecePairIn<Numbers>::margin(const Place& p) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Facet* f : facets_) {
    const Vec3<double>& n = f->plane.image.normal;
    least = std::min(least, (f->plane.image.height - dot(n, p.image)) / std::sqrt(dot(n, n)));
  }
  return least;
}

template <class Numbers>
bool PiecePairIn<Numbers>::settle(Facet& facet) {
  if (facet.supports) return true;
  Plane room;
  const Plane& plane = inwards(facet.plane, room);
  const auto is_above = [&](const Corner& c) { return cmp(dot(plane.normal, c.exact), plane.height) > 0; };
  Corner next = corner(differences_.likely_extreme(plane.image.normal));
  if (!is_above(next)) next = corner(differences_.extreme(as<IntegerOfScans<Numbers>>(plane.normal)));
  if (!is_above(next)) return facet.supports = true;
  grow(next, facet);
  return false;
}

template <class Numbers>
std::vector<Vector> PiecePairIn<Numbers>::normals_at(const Place& p) {
  start();
  for (bool settled = false; !settled;) {
    settled = true;
    for (std::size_t i = 0; i < facets_.size() && settled; ++i)
      if (kernels::side(facets_[i]->plane, p) >= 0) settled = settle(*facets_[i]);
  }
  std::vector<Vector> normals;
  for (const Facet* f : facets_) {
    const int above = kernels::side(f->plane, p);
    if (above > 0) return {};
    if (above < 0) continue;
    Vector normal = primitive(as<mpz_class>(f->plane.normal));
    if (std::find(normals.begin(), normals.end(), normal) == normals.end()) normals.push_back(std::move(normal));
  }
  return normals;
}

template <class Numbers>
InnerPolytope PiecePairIn<Numbers>::inner(std::vector<std::uint32_t>& facet_of) {
  start();
  InnerPolytope inner = expanding::inner_polytope(surface_, merge_);
  facet_of.clear();
  for (const Facet* f : facets_) facet_of.push_back(merge_.facet_of[f->triangle]);
  return inner;
}

template class PiecePairIn<AnyNumbers>;
template class PiecePairIn<FixedNumbers>;

}  // namespace fathom::unions
