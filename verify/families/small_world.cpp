// SPDX-License-Identifier: GPL-3.0-or-later
// The small world of polytope_pairs.hpp, in orbits of pairs: A runs over the tetrahedra that are
// least among their images; to each belong the tetrahedra B that are least among their images under
// the symmetries that keep A.

#include <algorithm>
#include <bit>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "verify/families/polytope_pairs.hpp"

namespace fathom::families {
namespace {

// ---- the tetrahedra, their images, and the pairs ----

using SmallVector = std::array<int, 3>;
constexpr int world_side = 3, world_points = world_side * world_side * world_side;
constexpr std::size_t small_corners = 4, symmetries = 48;

constexpr SmallVector point_of(int index) {
  return {index / (world_side * world_side), index / world_side % world_side, index % world_side};
}

/// Returns the image of each point under each symmetry of the cube: an order of the axes, and which
/// of them are reflected.
std::array<std::array<std::uint8_t, world_points>, symmetries> all_symmetries() {
  std::array<std::array<std::uint8_t, world_points>, symmetries> result;
  SmallVector order{0, 1, 2};
  std::size_t symmetry = 0;
  do {
    for (unsigned reflected = 0; reflected < 8; ++reflected, ++symmetry) {
      for (int i = 0; i < world_points; ++i) {
        const SmallVector p = point_of(i);
        int image = 0;
        for (unsigned axis = 0; axis < 3; ++axis) {
          const int x = p[order[axis]];
          image = world_side * image + ((reflected >> axis & 1) != 0 ? world_side - 1 - x : x);
        }
        result[symmetry][i] = static_cast<std::uint8_t>(image);
      }
    }
  } while (std::ranges::next_permutation(order).found);
  return result;
}

using Corners = std::array<std::uint8_t, small_corners>;  ///< indices of points, ascending

/// All pairs, by the ranks of their tetrahedra in lexicographic order.
class SmallWorld {
 public:
  SmallWorld() {
    for (std::uint8_t i = 0; i < world_points; ++i)
      for (std::uint8_t j = i + 1; j < world_points; ++j)
        for (std::uint8_t k = j + 1; k < world_points; ++k)
          for (std::uint8_t l = k + 1; l < world_points; ++l) tetrahedra_.push_back({i, j, k, l});
    find_images();
    for (std::uint16_t a = 0; a < tetrahedra_.size(); ++a) add_pairs_with(a);
  }

  [[nodiscard]] std::uint64_t size() const { return size_; }

  [[nodiscard]] SmallPair pair(std::uint64_t number) const {
    if (number >= size_) throw std::out_of_range("the small world has pairs 0 to " + std::to_string(size_ - 1));
    const Block& block = *(std::ranges::upper_bound(blocks_, number, {}, &Block::begin) - 1);
    const std::uint64_t place = number - block.begin;
    return {tetrahedron(block.a), tetrahedron(block.b.empty() ? place : block.b[place])};
  }

 private:
  /// The pairs with one A; b is empty if every B belongs to it.
  struct Block {
    std::uint64_t begin;
    std::uint16_t a;
    std::vector<std::uint16_t> b;
  };

  void find_images() {
    const auto maps = all_symmetries();
    for (std::size_t s = 0; s < symmetries; ++s) {
      for (const Corners& from : tetrahedra_) {
        Corners to;
        std::ranges::transform(from, to.begin(), [&](std::uint8_t i) { return maps[s][i]; });
        std::ranges::sort(to);
        images_[s].push_back(
            static_cast<std::uint16_t>(std::ranges::lower_bound(tetrahedra_, to) - tetrahedra_.begin()));
      }
    }
  }

  void add_pairs_with(std::uint16_t a) {
    std::vector<const std::vector<std::uint16_t>*> keep_a;
    for (const std::vector<std::uint16_t>& image : images_) {
      if (image[a] < a) return;
      if (image[a] == a) keep_a.push_back(&image);
    }
    Block block{size_, a, {}};
    if (keep_a.size() > 1) {
      for (std::uint16_t b = 0; b < tetrahedra_.size(); ++b)
        if (std::ranges::all_of(keep_a, [b](const auto* image) { return (*image)[b] >= b; })) block.b.push_back(b);
    }
    size_ += keep_a.size() > 1 ? block.b.size() : tetrahedra_.size();
    blocks_.push_back(std::move(block));
  }

  [[nodiscard]] SmallTetrahedron tetrahedron(std::uint64_t rank) const {
    SmallTetrahedron result;
    std::ranges::transform(tetrahedra_[rank], result.begin(), point_of);
    return result;
  }

  std::vector<Corners> tetrahedra_;
  std::array<std::vector<std::uint16_t>, symmetries> images_;  ///< of each tetrahedron, by its rank
  std::vector<Block> blocks_;
  std::uint64_t size_ = 0;
};

const SmallWorld& small_world() {
  static const SmallWorld world;
  return world;
}

Body body_of(const SmallTetrahedron& tetrahedron) {
  std::vector<Point> vertices;
  for (const auto& [x, y, z] : tetrahedron) vertices.push_back({x, y, z});
  return {std::move(vertices)};
}

// ---- kinds, by integers: of four points each there are so few normals that all can be tried ----

constexpr SmallVector minus(const SmallVector& p, const SmallVector& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
constexpr int dot(const SmallVector& p, const SmallVector& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
constexpr SmallVector cross(const SmallVector& p, const SmallVector& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
constexpr SmallVector zero{0, 0, 0};
constexpr SmallVector negative(const SmallVector& p) { return minus(zero, p); }

SmallVector primitive(const SmallVector& p) {
  const int divisor = std::gcd(std::gcd(p[0], p[1]), p[2]);
  return divisor == 0 ? p : SmallVector{p[0] / divisor, p[1] / divisor, p[2] / divisor};
}

using Directions = std::vector<SmallVector>;  ///< ascending, each once

Directions sorted(Directions directions) {
  std::ranges::sort(directions);
  directions.erase(std::unique(directions.begin(), directions.end()), directions.end());
  return directions;
}

void add_both(Directions& directions, const SmallVector& u) {
  const SmallVector v = primitive(u);
  if (v == zero) return;
  directions.push_back(v);
  directions.push_back(negative(v));
}

/// Returns the differences of any two of the corners, primitive, in both directions.
Directions differences(const SmallTetrahedron& body) {
  Directions result;
  for (std::size_t i = 0; i < small_corners; ++i)
    for (std::size_t j = i + 1; j < small_corners; ++j) add_both(result, minus(body[i], body[j]));
  return sorted(std::move(result));
}

/// Returns the vectors across any two of these, which hold the negative of each, in the same way.
Directions across(const Directions& directions) {
  Directions lines, result;
  for (const SmallVector& p : directions)
    if (p > zero) lines.push_back(p);
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t j = i + 1; j < lines.size(); ++j) add_both(result, cross(lines[i], lines[j]));
  return sorted(std::move(result));
}

/// A face of a body: its corners as bits, and its dimension.
struct Face {
  unsigned bits = 0;
  int dimension = 0;
};

int dimension_of(const SmallTetrahedron& body, unsigned bits) {
  std::vector<SmallVector> chosen;
  for (std::size_t i = 0; i < small_corners; ++i)
    if ((bits >> i & 1) != 0) chosen.push_back(minus(body[i], body[std::countr_zero(bits)]));
  if (chosen.size() < 2) return 0;
  SmallVector normal = zero;
  for (const SmallVector& p : chosen)
    if (normal == zero) normal = cross(chosen[1], p);
  if (normal == zero) return 1;
  return std::ranges::all_of(chosen, [&](const SmallVector& p) { return dot(normal, p) == 0; }) ? 2 : 3;
}

/// Returns the face of a body in a direction; the whole body in direction 0.
Face face(const SmallTetrahedron& body, const SmallVector& u) {
  int most = dot(body[0], u);
  for (const SmallVector& p : body) most = std::max(most, dot(p, u));
  Face result;
  for (std::size_t i = 0; i < small_corners; ++i)
    if (dot(body[i], u) == most) result.bits |= 1U << i;
  result.dimension = dimension_of(body, result.bits);
  return result;
}

/// A body with its facets, by outward normals, and the directions of its edges. A flat body has its
/// plane as a facet on both sides, as in its Gaussian diagram.
struct Studied {
  explicit Studied(const SmallTetrahedron& given) : body(given), all(differences(given)) {
    flat = dimension_of(body, (1U << small_corners) - 1) < 3;
    for (const SmallVector& n : across(all))
      if (face(body, n).dimension == 2) facets.push_back(n);
    edges = all;
    if (flat)  // a difference is an edge if it lies in a side of the polygon
      std::erase_if(edges, [this](const SmallVector& e) {
        return face(body, cross(facets[0], e)).dimension != 1 && face(body, cross(e, facets[0])).dimension != 1;
      });
  }

  const SmallTetrahedron& body;
  Directions all, facets, edges;
  bool flat;
};

/// Returns h(u), how far B - A reaches along u, times the length of u.
int reach(const SmallPair& pair, const SmallVector& u) {
  int most = dot(pair.b[0], u), least = dot(pair.a[0], u);
  for (std::size_t i = 1; i < small_corners; ++i) {
    most = std::max(most, dot(pair.b[i], u));
    least = std::min(least, dot(pair.a[i], u));
  }
  return most - least;
}

/// Returns all normals that facets of B - A can have; if that is flat, of its sides as well.
Directions normals_of_difference(const Studied& a, const Studied& b) {
  Directions directions = a.all;
  directions.insert(directions.end(), b.all.begin(), b.all.end());
  directions = sorted(std::move(directions));
  Directions normals = across(directions);
  constexpr std::size_t of_one_plane = 2;
  if (normals.size() > of_one_plane) return normals;
  const SmallVector across_plane = normals[0];
  for (const SmallVector& e : directions) add_both(normals, cross(across_plane, e));
  return sorted(std::move(normals));
}

constexpr std::string_view disjoint = "disjoint", ties = "ties";
/// By the dimensions of the faces of A and of B.
constexpr std::string_view touching_words[3][3] = {
    {"touching_vertex_vertex", "touching_vertex_edge", "touching_vertex_face"},
    {"touching_edge_vertex", "touching_edge_edge", "touching_edge_face"},
    {"touching_face_vertex", "touching_face_edge", "touching_face_face"}};
constexpr std::string_view contact_words[3][3] = {
    {"", "", "contact_vertex_facet"},
    {"", "contact_edge_edge", "contact_edge_facet"},
    {"contact_facet_vertex", "contact_facet_edge", "contact_facet_facet"}};

/// Returns how the bodies meet. They touch in the faces of a direction inside the cone of all that
/// separate them; the sum of the cone's normals is one.
std::string_view meeting(const SmallPair& pair, const Directions& normals) {
  const auto faces_in = [&](const auto& words, const SmallVector& u) {
    return words[face(pair.a, negative(u)).dimension][face(pair.b, u).dimension];
  };
  SmallVector separating = zero;
  bool touch = false;
  std::vector<SmallVector> nearest;
  int least = 0;  // h(u) of the nearest
  for (const SmallVector& u : normals) {
    const int h = reach(pair, u);
    if (h < 0) return disjoint;
    if (h == 0) {
      touch = true;
      separating = minus(separating, negative(u));
    } else if (!touch) {
      const int farther =
          nearest.empty() ? -1 : h * h * dot(nearest[0], nearest[0]) - least * least * dot(u, u);  // below 2^21
      if (farther < 0) nearest.clear();
      if (farther <= 0) nearest.push_back(u);
      if (farther < 0) least = h;
    }
  }
  if (touch) return faces_in(touching_words, separating);
  return nearest.size() > 1 ? ties : faces_in(contact_words, nearest[0]);
}

bool meet(const Directions& x, const Directions& y) {
  return std::ranges::any_of(x, [&](const SmallVector& u) { return std::ranges::binary_search(y, u); });
}

Directions reflected(Directions directions) {
  for (SmallVector& u : directions) u = negative(u);
  return sorted(std::move(directions));
}

constexpr std::string_view coincidences[] = {
    "flat_a", "flat_b", "shared_vertices", "parallel_edges", "coincident_normals", "equal_normals", "coplanar_facets"};

}  // namespace

std::uint64_t small_world_size() { return small_world().size(); }

SmallPair small_pair(std::uint64_t number) { return small_world().pair(number); }

Case small_case(std::uint64_t number) {
  const SmallPair pair = small_pair(number);
  return {"small_world::" + std::to_string(number), body_of(pair.a), body_of(pair.b)};
}

std::vector<std::string_view> small_kinds(const SmallPair& pair) {
  const Studied a(pair.a), b(pair.b);
  const auto coplanar = [&](const SmallVector& u) {  // facets of A and B with parallel normals
    return std::ranges::any_of(std::array{u, negative(u)}, [&](const SmallVector& v) {
      const auto height = [](const SmallTetrahedron& body, const SmallVector& n) {
        return dot(body[std::countr_zero(face(body, n).bits)], n);
      };
      return std::ranges::binary_search(b.facets, v) &&
             dot(u, pair.b[std::countr_zero(face(pair.b, v).bits)]) == height(pair.a, u);
    });
  };
  const bool holds[] = {
      a.flat,
      b.flat,
      std::ranges::any_of(pair.a, [&](const SmallVector& p) { return std::ranges::count(pair.b, p) > 0; }),
      meet(a.edges, b.edges),
      meet(a.facets, reflected(b.facets)),
      meet(a.facets, b.facets),
      std::ranges::any_of(a.facets, coplanar)};
  std::vector<std::string_view> result{meeting(pair, normals_of_difference(a, b))};
  for (std::size_t i = 0; i < std::size(holds); ++i)
    if (holds[i]) result.push_back(coincidences[i]);
  return result;
}

std::vector<std::string_view> all_small_kinds() {
  std::vector<std::string_view> result{disjoint, ties};
  for (const auto& words : {std::span(touching_words), std::span(contact_words)})
    for (const auto& row : words)
      for (const std::string_view word : row)
        if (!word.empty()) result.push_back(word);
  result.insert(result.end(), std::begin(coincidences), std::end(coincidences));
  return result;
}

}  // namespace fathom::families
