// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/unions/piece_pair.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "kernels/filters/double_images.hpp"
#include "reference/expanding/start.hpp"

namespace fathom::unions {
namespace {

constexpr std::size_t most_separations = 14;

Vector axis(int k, long sign) { return {k == 0 ? sign : 0, k == 1 ? sign : 0, k == 2 ? sign : 0}; }

}  // namespace

PiecePair::PiecePair(const kernels::PointCloud& a, const kernels::PointCloud& b) : differences_{a, b} {
  for (int k = 0; k < 3; ++k) {
    for (const long sign : {1L, -1L}) {
      const Vector u = axis(k, sign);
      separations_.push_back(kernels::oriented_plane(u, dot(u, differences_[differences_.extreme(u)]), a.exponent()));
    }
  }
}

PiecePair::Corner PiecePair::corner(polytope::Difference d) const {
  Vector exact = differences_[d];
  const Vec3<double> rounded = kernels::image(exact, differences_.exponent());
  return {d, std::move(exact), rounded};
}

void PiecePair::start() {
  if (std::exchange(started_, true)) return;
  const auto first = expanding::starting_tetrahedron(differences_);
  if (!first) throw std::logic_error("a piece of a union is flat");
  surface_.start({corner((*first)[0]), corner((*first)[1]), corner((*first)[2]), corner((*first)[3])});
  for (const expanding::TriangleId t : surface_.triangles().ids()) add(t);
}

void PiecePair::add(expanding::TriangleId triangle) {
  const expanding::ExactPlane<mpz_class>& exact = surface_.plane(triangle);
  kernels::OrientedPlane plane = kernels::oriented_plane(exact.normal, exact.height, differences_.exponent());
  kernels::OrientedPlane reversed = plane.reversed();
  facets_.push_back(&all_.emplace_back(PieceFacet{triangle, std::move(plane), std::move(reversed)}));
}

void PiecePair::grow(const Corner& corner, const PieceFacet& facet) {
  const std::vector<expanding::TriangleId>& fresh = surface_.insert(corner, facet.triangle);
  std::erase_if(facets_, [&](const PieceFacet* f) { return !surface_.triangles()[f->triangle].alive; });
  for (const expanding::TriangleId t : fresh) add(t);
}

// The facet that the point is farthest above, by its image, of those that do not have it strictly below.
PieceFacet* PiecePair::worst(const kernels::RationalPoint& p) {
  PieceFacet* found = nullptr;
  double most = -std::numeric_limits<double>::infinity();
  for (PieceFacet* f : facets_) {
    if (kernels::side(f->plane, p) < 0) continue;
    const Vec3<double>& n = f->plane.image_normal;
    const double height = (dot(n, p.image) - f->plane.image_height) / std::sqrt(dot(n, n));
    if (found == nullptr || height > most) {
      found = f;
      most = height;
    }
  }
  return found;
}

bool PiecePair::separated(const kernels::RationalPoint& p) {
  for (std::size_t i = 0; i < separations_.size(); ++i) {
    if (kernels::side(separations_[i], p) < 0) continue;
    if (i > 0) std::swap(separations_[0], separations_[i]);
    return true;
  }
  return false;
}

void PiecePair::remember(kernels::OrientedPlane plane) {
  if (separations_.size() == most_separations) separations_.pop_back();
  separations_.insert(separations_.begin(), std::move(plane));
}

// A step for a point that is not strictly below the facet: Q grows in the facet's direction, unless a plane in that direction separates
// the point from P_ij; then it returns false.
bool PiecePair::step_towards(const kernels::RationalPoint& p, PieceFacet& facet) {
  const kernels::OrientedPlane& plane = facet.plane;
  const mpz_class of_p = dot(plane.normal, p.v);
  const auto inside = [&](const mpz_class& height) { return of_p < height * p.w; };
  Corner next = corner(differences_.likely_extreme(plane.image_normal));
  mpz_class height = dot(plane.normal, next.exact);
  if (!inside(height) || height <= plane.height) {
    next = corner(differences_.extreme(plane.normal));
    height = dot(plane.normal, next.exact);
    if (!inside(height)) {
      facet.supports = height == plane.height;
      remember(kernels::oriented_plane(plane.normal, height, differences_.exponent()));
      return false;
    }
  }
  grow(next, facet);
  return true;
}

bool PiecePair::contains(const kernels::RationalPoint& p) {
  if (separated(p)) return false;
  start();
  while (PieceFacet* facet = worst(p)) {
    if (facet->supports) {
      remember(facet->plane);
      return false;
    }
    if (!step_towards(p, *facet)) return false;
  }
  return true;
}

double PiecePair::margin(const kernels::RationalPoint& p) const {
  double least = std::numeric_limits<double>::infinity();
  for (const PieceFacet* f : facets_) {
    const Vec3<double>& n = f->plane.image_normal;
    least = std::min(least, (f->plane.image_height - dot(n, p.image)) / std::sqrt(dot(n, n)));
  }
  return least;
}

bool PiecePair::settle(PieceFacet& facet) {
  if (facet.supports) return true;
  const kernels::OrientedPlane& plane = facet.plane;
  Corner next = corner(differences_.likely_extreme(plane.image_normal));
  if (dot(plane.normal, next.exact) <= plane.height) next = corner(differences_.extreme(plane.normal));
  if (dot(plane.normal, next.exact) <= plane.height) return facet.supports = true;
  grow(next, facet);
  return false;
}

std::vector<const kernels::OrientedPlane*> PiecePair::planes_through(const kernels::RationalPoint& p) {
  start();
  for (bool settled = false; !settled;) {
    settled = true;
    for (std::size_t i = 0; i < facets_.size() && settled; ++i)
      if (kernels::side(facets_[i]->plane, p) >= 0) settled = settle(*facets_[i]);
  }
  std::vector<const kernels::OrientedPlane*> planes;
  for (const PieceFacet* f : facets_) {
    const int above = kernels::side(f->plane, p);
    if (above > 0) return {};
    const auto same = [&](const kernels::OrientedPlane* plane) { return plane->normal == f->plane.normal; };
    if (above == 0 && std::none_of(planes.begin(), planes.end(), same)) planes.push_back(&f->plane);
  }
  return planes;
}

InnerPolytope PiecePair::inner(std::vector<std::uint32_t>& facet_of) {
  start();
  InnerPolytope inner = expanding::inner_polytope(surface_, merge_);
  facet_of.clear();
  for (const PieceFacet* f : facets_) facet_of.push_back(merge_.facet_of[f->triangle]);
  return inner;
}

}  // namespace fathom::unions
