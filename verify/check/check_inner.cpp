// SPDX-License-Identifier: Apache-2.0
// The polytope inside P that holds the ball. Facets are polygons; no hull code, no topology, no tolerance.   [FORMAT.md, sections 4 and 5]
#include <algorithm>
#include <limits>

#include "budget.hpp"
#include "checks.hpp"
#include "vectors.hpp"

namespace fathom_check {
namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// Finds facets by their edges. Sorted, not hashed: no input can make it slow.
class EdgeTable {
 public:
  explicit EdgeTable(const Facets& facets) {
    entries_.reserve(facets.corners.size());  // what has been read, not what was announced
    for (std::size_t f = 0; f < facets.size(); ++f) {
      const std::size_t begin = facets.begin_of(f), end = facets.ends[f];
      for (std::size_t k = begin; k < end; ++k)
        entries_.push_back({key(facets.corners[k], facets.corners[k + 1 == end ? begin : k + 1]), f});
    }
    std::sort(entries_.begin(), entries_.end());
  }
  /// The first facet that has the edge from u to v, or `none`.
  [[nodiscard]] std::size_t facet(std::uint32_t u, std::uint32_t v) const {
    const auto found = std::lower_bound(entries_.begin(), entries_.end(), Entry{key(u, v), 0});
    return found != entries_.end() && found->first == key(u, v) ? found->second : none;
  }

 private:
  using Entry = std::pair<std::uint64_t, std::size_t>;
  static std::uint64_t key(std::uint32_t u, std::uint32_t v) { return std::uint64_t{u} << 32 | v; }
  std::vector<Entry> entries_;
};

class Inner {
 public:
  Inner(const Certificate& certificate, const Scaled& bodies, const Rational& squared)
      : c_(&certificate), facets_(&certificate.facets.items), squared_(&squared) {
    make_vertices(bodies);
  }

  void check() {
    const Part<Facets>& part = c_->facets;
    if (part.items.size() == 0) throw refused(part.line, "there is no facet");
    for (std::size_t f = 0; f < part.items.size(); ++f) check_facet(f);
    const EdgeTable edges(part.items);
    for (std::size_t f = 0; f < part.items.size(); ++f) check_edges(f, edges);
    const auto opposite = [this](const Plane& g) { return dot(g.normal, planes_.front().normal) < 0; };
    if (std::none_of(planes_.begin(), planes_.end(), opposite)) throw refused(part.line, "no facet faces away from the first");
  }

 private:
  struct Plane {
    Vector normal;  ///< outward
    mpz_class c;    ///< <normal, corner>
  };

  void make_vertices(const Scaled& bodies);
  void check_facet(std::size_t f);
  void check_plane(std::size_t f, const Plane& plane, const std::vector<Vector>& crosses) const;
  void check_listed(const Vector& normal, std::size_t line) const;
  void check_edges(std::size_t f, const EdgeTable& edges) const;
  [[nodiscard]] bool turns_inward(std::size_t f, std::size_t k, const Plane& across) const;

  [[nodiscard]] std::size_t corners(std::size_t f) const { return facets_->ends[f] - facets_->begin_of(f); }
  /// The number of corner k of facet f, cyclically.
  [[nodiscard]] std::uint32_t number(std::size_t f, std::size_t k) const { return facets_->corners[facets_->begin_of(f) + k % corners(f)]; }
  [[nodiscard]] const Vector& corner(std::size_t f, std::size_t k) const { return vertices_[number(f, k)]; }
  [[nodiscard]] std::size_t line(std::size_t f) const { return c_->facets.lines[f]; }

  const Certificate* c_;
  const Facets* facets_;
  const Rational* squared_;
  std::vector<Vector> vertices_;
  std::vector<Plane> planes_;
};

void Inner::make_vertices(const Scaled& bodies) {
  const Part<std::vector<Pair>>& part = c_->vertices;
  for (std::size_t k = 0; k < part.items.size(); ++k) {
    const Pair pair = part.items[k];
    if (pair.j >= bodies.b.size()) throw refused(part.lines[k], "b has no point of this number");
    if (pair.i >= bodies.a.size()) throw refused(part.lines[k], "a has no point of this number");
    vertices_.push_back(difference(bodies.b[pair.j], bodies.a[pair.i]));
  }
}

// The normal, and all that concerns this facet alone.
void Inner::check_facet(std::size_t f) {
  const std::size_t count = corners(f);
  if (count < 3) throw refused(line(f), "a facet has at least three corners");
  for (std::size_t k = 0; k < count; ++k)
    if (number(f, k) >= vertices_.size()) throw refused(line(f), "there is no vertex " + std::to_string(number(f, k)));
  std::vector<Vector> crosses(count);
  Plane plane;
  for (std::size_t k = 0; k < count; ++k) {
    crosses[k] = cross(corner(f, k), corner(f, k + 1));
    add(plane.normal, crosses[k]);
  }
  plane.c = dot(plane.normal, corner(f, 0));
  check_plane(f, plane, crosses);
  planes_.push_back(std::move(plane));
}

void Inner::check_plane(std::size_t f, const Plane& plane, const std::vector<Vector>& crosses) const {
  if (plane.c <= 0) throw refused(line(f), "O does not lie below this facet");
  const mpz_class reached = plane.c * plane.c * squared_->den, needed = squared_->num * dot(plane.normal, plane.normal);
  if (reached < needed) throw refused(line(f), "this facet is nearer to O than claimed");
  if (c_->all && reached == needed) check_listed(plane.normal, line(f));
  for (std::size_t k = 1; k < crosses.size(); ++k)
    if (dot(plane.normal, corner(f, k)) != plane.c) throw refused(line(f), "the corners of this facet do not lie on one plane");
  for (std::size_t k = 1; k + 1 < crosses.size(); ++k)
    if (dot(corner(f, 0), crosses[k]) <= 0) throw refused(line(f), "the corners of this facet do not turn one way around O");
}

void Inner::check_listed(const Vector& normal, std::size_t line) const {
  const mpz_class common = gcd(gcd(normal.x, normal.y), normal.z);
  const auto less = [&common](const Vector& n, const Vector& facet) {
    const mpz_class x = n.x * common, y = n.y * common;
    if (x != facet.x) return x < facet.x;
    return y != facet.y ? y < facet.y : mpz_class(n.z * common) < facet.z;
  };
  const std::vector<Vector>& listed = c_->directions.items;  // primitive and ascending, as check_directions found
  const auto found = std::lower_bound(listed.begin(), listed.end(), normal, less);
  const bool equal =
      found != listed.end() && found->x * common == normal.x && found->y * common == normal.y && found->z * common == normal.z;
  if (!equal) throw refused(line, "this facet is as near as the depth, and its direction is not among all directions");
}

// Across each edge, the neighbour's plane leaves this facet below.
void Inner::check_edges(std::size_t f, const EdgeTable& edges) const {
  for (std::size_t k = 0; k < corners(f); ++k) {
    const std::uint32_t u = number(f, k), v = number(f, k + 1);
    const std::size_t g = edges.facet(v, u);
    const auto edge = [u, v] { return "the edge " + std::to_string(u) + " " + std::to_string(v); };
    if (g == none) throw refused(line(f), "no facet lies across " + edge());
    // Both ends are corners of g, so they lie on its plane: check_plane has seen to that.
    if (!turns_inward(f, k, planes_[g])) throw refused(line(f), "not convex across " + edge());
  }
}

/// Whether some corner w of f has det(u, v, w) > 0 and lies strictly below the plane across the edge uv that begins at corner k.
bool Inner::turns_inward(std::size_t f, std::size_t k, const Plane& across) const {
  const Vector inward = cross(corner(f, k), corner(f, k + 1));
  for (std::size_t step = 2; step < corners(f); ++step) {
    const Vector& w = corner(f, k + step);
    if (dot(inward, w) > 0 && dot(across.normal, w) < across.c) return true;
  }
  return false;
}

}  // namespace

void check_inner(const Certificate& certificate, const Scaled& bodies, const Rational& squared) {
  Inner(certificate, bodies, squared).check();
}

}  // namespace fathom_check
