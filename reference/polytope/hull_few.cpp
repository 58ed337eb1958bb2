// SPDX-License-Identifier: GPL-3.0-or-later
// The hull of few points: one after another joins a surface of triangles, each of which is asked whether it sees the point. A triangle does
// if the point lies strictly above it, so the surface stays that of the hull, with coplanar triangles side by side.
//                                                                                                        [proofs/polytope.md, lemma 1]
#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "kernels/filters/plane.hpp"
#include "reference/polytope/hull.hpp"

namespace fathom::polytope {
namespace {

using Index = std::uint32_t;

/// The corner of a triangle after corner k.
constexpr std::size_t next(std::size_t k) { return k == 2 ? 0 : k + 1; }

struct Face {
  HullTriangle corners;
  std::array<Index, 3> across;  // the face beyond the edge from corner k to the next one
  kernels::Plane plane;
  bool seen = false;  // from the point that is being added
};

class GrowingHull {
 public:
  explicit GrowingHull(std::span<const Vector> points) : points_(points), fan_(points.size()) {}

  std::vector<HullTriangle> of(std::vector<Index> ids) {
    start(ids);
    for (std::size_t i = 4; i < ids.size(); ++i) add(ids[i]);
    std::vector<HullTriangle> triangles;
    triangles.reserve(faces_.size());
    for (const Face& face : faces_) triangles.push_back(face.corners);
    return triangles;
  }

 private:
  struct HorizonEdge {
    Index from, to, beyond;
  };

  [[nodiscard]] Face face(const HullTriangle& t) const { return {t, {}, kernels::Plane(points_, t[0], t[1], t[2])}; }

  /// Brings four points to the front that do not lie in one plane.
  void start(std::vector<Index>& ids) {
    const auto off_line = [&](Index r) { return !kernels::Plane(points_, ids[0], ids[1], r).degenerate(); };
    std::iter_swap(ids.begin() + 2, std::find_if(ids.begin() + 2, ids.end(), off_line));
    const kernels::Plane plane(points_, ids[0], ids[1], ids[2]);
    const auto off_plane = [&](Index s) { return plane.side(s) != kernels::Sign::zero; };
    std::iter_swap(ids.begin() + 3, std::find_if(ids.begin() + 3, ids.end(), off_plane));
    if (plane.side(ids[3]) == kernels::Sign::positive) std::swap(ids[1], ids[2]);
    const auto [a, b, c, d] = std::array{ids[0], ids[1], ids[2], ids[3]};
    faces_ = {face({a, b, c}), face({a, d, b}), face({b, d, c}), face({c, d, a})};
    faces_[0].across = {1, 2, 3};
    faces_[1].across = {3, 2, 0};
    faces_[2].across = {1, 3, 0};
    faces_[3].across = {2, 1, 0};
  }

  void add(Index point) {
    horizon_.clear();
    free_.clear();
    for (Index f = 0; f < faces_.size(); ++f) {
      faces_[f].seen = faces_[f].plane.side(point) == kernels::Sign::positive;
      if (faces_[f].seen) free_.push_back(f);
    }
    for (const Index f : free_)
      for (std::size_t k = 0; k < 3; ++k)
        if (const Index beyond = faces_[f].across[k]; !faces_[beyond].seen)
          horizon_.push_back({faces_[f].corners[k], faces_[f].corners[next(k)], beyond});
    for (const HorizonEdge& edge : horizon_) put(edge, point);
    for (const HorizonEdge& edge : horizon_) {
      const Index mine = fan_[edge.from], following = fan_[edge.to];
      faces_[mine].across[1] = following;
      faces_[following].across[2] = mine;
    }
    drop_free();
  }

  /// The triangle from the edge to the point, where a seen one was if there is one left.
  void put(const HorizonEdge& edge, Index point) {
    Face fresh = face({edge.from, edge.to, point});
    fresh.across[0] = edge.beyond;
    Index place = static_cast<Index>(faces_.size());
    if (free_.empty()) {
      faces_.push_back(std::move(fresh));
    } else {
      place = free_.back();
      free_.pop_back();
      faces_[place] = std::move(fresh);
    }
    Face& beyond = faces_[edge.beyond];
    for (std::size_t k = 0; k < 3; ++k)
      if (beyond.corners[k] == edge.to && beyond.corners[next(k)] == edge.from) beyond.across[k] = place;
    fan_[edge.from] = place;
  }

  /// Fills the places that were not taken again from the end.
  void drop_free() {
    std::ranges::sort(free_, std::greater());
    for (const Index place : free_) {
      const auto last = static_cast<Index>(faces_.size() - 1);
      if (place != last) {
        faces_[place] = std::move(faces_[last]);
        for (std::size_t k = 0; k < 3; ++k) {
          std::array<Index, 3>& back = faces_[faces_[place].across[k]].across;
          std::ranges::replace(back, last, place);
        }
      }
      faces_.pop_back();
    }
  }

  kernels::BoxedPoints points_;
  std::vector<Face> faces_;
  std::vector<HorizonEdge> horizon_;
  std::vector<Index> free_;  // places of faces that are seen
  std::vector<Index> fan_;   // of each point on the horizon: the new face whose edge on the horizon begins there
};

}  // namespace

std::vector<HullTriangle> hull_triangles_of_few(std::span<const Vector> points, std::span<const std::uint32_t> ids) {
  return GrowingHull(points).of({ids.begin(), ids.end()});
}

}  // namespace fathom::polytope
