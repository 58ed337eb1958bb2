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

std::vector<kernels::PointCloud> parted(const kernels::PointCloud& whole, const Pieces& pieces,
                                        const std::string& body) {
  std::vector<kernels::PointCloud> clouds;
  auto from = whole.points().begin();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto to = std::next(from, static_cast<std::ptrdiff_t>(pieces[i].size()));
    std::vector<Vector> points(from, to);
    if (polytope::affine_rank(points) < 3)
      throw std::invalid_argument("piece " + std::to_string(i) + " of " + body +
                                  " is flat: the pieces of a union need interiors");
    clouds.emplace_back(std::move(points), whole.exponent());
    from = to;
  }
  return clouds;
}

constexpr std::size_t most_separations = 14;

using kernels::AnyNumbers;
using kernels::as;
using kernels::FixedNumbers;

template <class Integer>
Vec3<Integer> axis(int k, long sign) {
  return {Integer(k == 0 ? sign : 0), Integer(k == 1 ? sign : 0), Integer(k == 2 ? sign : 0)};
}

polytope::Differences differences_of(AnyNumbers, const kernels::PointCloud& a, const kernels::PointCloud& b,
                                     kernels::ScanMemory&) {
  return {a, b};
}
polytope::NarrowDifferences<polytope::NarrowInteger> differences_of(FixedNumbers, const kernels::PointCloud& a,
                                                                    const kernels::PointCloud& b,
                                                                    kernels::ScanMemory& memory) {
  return {{a, memory}, {b, memory}};
}

}  // namespace

PlacedPieces place_pieces(const Pieces& a, const Pieces& b) {
  require_points(a, "A");
  require_points(b, "B");
  PlacedPieces placed;
  placed.whole = polytope::place(polytope::joined(a), polytope::joined(b));
  placed.a = parted(placed.whole.a, a, "A");
  placed.b = parted(placed.whole.b, b, "B");
  return placed;
}

polytope::PlacedPair PlacedPieces::pair(std::uint32_t i, std::uint32_t j) const {
  return {whole.denominator, whole.origin, a[i], b[j]};
}

Point PlacedPieces::translation(const kernels::RationalPoint& p) const {
  const mpz_class w = p.w * whole.denominator;
  return {kernels::ratio(p.v.x, w), kernels::ratio(p.v.y, w), kernels::ratio(p.v.z, w)};
}

kernels::RationalPoint PlacedPieces::point(const Point& t) const {
  const mpz_class w = lcm(lcm(t.x.get_den(), t.y.get_den()), t.z.get_den());
  const auto over_w = [&](const mpq_class& x) {
    return mpz_class(x.get_num() * (w / x.get_den()) * whole.denominator);
  };
  return kernels::rational_point({over_w(t.x), over_w(t.y), over_w(t.z)}, w, exponent());
}

mpq_class PlacedPieces::squared(const mpz_class& numerator, const mpz_class& denominator) const {
  return kernels::ratio(numerator, denominator * whole.denominator * whole.denominator);
}

template <class Numbers>
PiecePairIn<Numbers>::PiecePairIn(const kernels::PointCloud& a, const kernels::PointCloud& b)
    : differences_(differences_of(Numbers{}, a, b, memory_)) {
  using Integer = typename DifferencesIn<Numbers>::Integer;
  for (int k = 0; k < 3; ++k) {
    for (const long sign : {1L, -1L}) {
      const Vec3<Integer> u = axis<Integer>(k, sign);
      const Integer height = dot(u, differences_[differences_.extreme(u)]);
      using OfPlane = typename Numbers::OfPlane;
      separations_.push_back(kernels::oriented_plane<Numbers>(as<OfPlane>(u), as<OfPlane>(height), a.exponent()));
    }
  }
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
  for (const expanding::TriangleId t : surface_.triangles().ids()) add(t);
}

template <class Numbers>
void PiecePairIn<Numbers>::add(expanding::TriangleId triangle) {
  const expanding::ExactPlane<typename Numbers::OfPlane>& exact = surface_.plane(triangle);
  Plane plane = kernels::oriented_plane<Numbers>(exact.normal, exact.height, differences_.exponent());
  Plane reversed = plane.reversed();
  facets_.push_back(&all_.emplace_back(Facet{triangle, std::move(plane), std::move(reversed)}));
}

template <class Numbers>
void PiecePairIn<Numbers>::grow(const Corner& corner, const Facet& facet) {
  const std::vector<expanding::TriangleId>& fresh = surface_.insert(corner, facet.triangle);
  std::erase_if(facets_, [&](const Facet* f) { return !surface_.triangles()[f->triangle].alive; });
  for (const expanding::TriangleId t : fresh) add(t);
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
  const Plane& plane = facet.plane;
  using OfPlane = typename Numbers::OfPlane;
  const Product of_p = dot(as<Product>(plane.normal), as<Product>(p.v));
  const auto inside = [&](const OfPlane& height) {
    return cmp(of_p, Product(as<Product>(height) * as<Product>(p.w))) < 0;
  };
  Corner next = corner(differences_.likely_extreme(plane.image.normal));
  OfPlane height = dot(plane.normal, next.exact);
  if (!inside(height) || cmp(height, plane.height) <= 0) {
    next = corner(differences_.extreme(as<typename DifferencesIn<Numbers>::Integer>(plane.normal)));
    height = dot(plane.normal, next.exact);
    if (!inside(height)) {
      facet.supports = height == plane.height;
      remember(kernels::oriented_plane<Numbers>(plane.normal, height, differences_.exponent()));
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
  const Plane& plane = facet.plane;
  const auto is_above = [&](const Corner& c) { return cmp(dot(plane.normal, c.exact), plane.height) > 0; };
  Corner next = corner(differences_.likely_extreme(plane.image.normal));
  if (!is_above(next)) next = corner(differences_.extreme(as<typename DifferencesIn<Numbers>::Integer>(plane.normal)));
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
    Vector normal = as<mpz_class>(f->plane.normal);
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
