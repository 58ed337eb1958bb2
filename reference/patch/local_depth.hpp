// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies by their points, a direction v, and a point x.
// Output  how deep they overlap along the lines in this direction that pass near x.
//
// On a line in the direction v let A begin at a and B end at b: b - a = f v, and f |v| is the local
// depth, the way of A along v after which the line meets them in one point at most. It is concave
// on the lines that meet both bodies, and negative where they are apart.
//                                                                     [proofs/judge.md, "Contacts"]
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "fathom/point.hpp"

namespace fathom::patch {

/// A line that meets both bodies.
struct LineOverlap {
  Point a, b;        ///< where A begins and B ends on it
  mpq_class factor;  ///< f: b - a = f v
};

/// Two linear functions, <u,v> = <w,v>. Where a line meets both bodies and passes x within a length
/// in the maximum norm, they bound <u,v> f: see `bound`.
struct TwoPlanes {
  Point u, w;
};

/// The greatest overlap near x, and planes that prove it: <u,v> = 1, and their bound is the factor.
/// If no line meets both bodies there, <u,v> = 0, and their bound is negative.
struct GreatestOverlap {
  std::optional<LineOverlap> overlap;
  TwoPlanes planes;
};

/// The bodies, seen along v. A line is near x if one of its points differs from x by at most
/// `within` in each coordinate. All is exact.
class LinesAlong {
 public:
  /// v is not zero, and the bodies are not empty.
  LinesAlong(const Vector& v, std::span<const Point> a, std::span<const Point> b);

  /// Of all lines near x, by a linear program over the points.
  [[nodiscard]] GreatestOverlap greatest(const Point& x, const mpq_class& within) const;
  /// On the line through x; nullopt if it misses a body.
  [[nodiscard]] std::optional<LineOverlap> at(const Point& x) const { return greatest(x, 0).overlap; }
  /// On the lines near x that are corners of the set of those that meet both bodies, each once:
  /// the least factor near x is among theirs. Empty if there are none.
  [[nodiscard]] std::vector<LineOverlap> corners(const Point& x, const mpq_class& within) const;

  /// On the lines that are corners of the set of those whose factor is at least `least`, each once:
  /// where v is an optimal direction n, the patch with slack, of all pairs of points one over the
  /// other that are no more than (sigma - least |n|) short of the depth. Empty if there are none.
  [[nodiscard]] std::vector<LineOverlap> at_least(const mpq_class& least) const;
  /// The patch with slack e, where v is an optimal direction and `support` its h(v): the corners of
  /// the lines whose local depth is at most e short of the depth. e is given by its square, and
  /// rounded up by 2^-40 of itself if e / |v| is no rational.
  [[nodiscard]] std::vector<LineOverlap> with_slack(const mpq_class& support, const mpq_class& squared) const;

  /// Along v into a plane, and how far, in multiples of v.
  struct SeenAlong {
    mpq_class x, y, height;
  };

 private:
  [[nodiscard]] SeenAlong seen(const Point& p) const;
  [[nodiscard]] Point lifted(const mpq_class& x, const mpq_class& y, const mpq_class& height) const;
  [[nodiscard]] std::vector<LineOverlap> lines_at(const std::vector<SeenAlong>& corners) const;
  [[nodiscard]] std::vector<SeenAlong> box(const Point& x, const mpq_class& within) const;

  Vector v_;
  std::array<int, 3> axes_;  ///< of x, y, and of the height, along which v is not 0
  std::vector<SeenAlong> a_, b_;
};

/// max <u,b> - min <w,a> + <w - u, x> + within |w - u|_1 over the points of the bodies. For each
/// line near x that meets both, at a and b, it is at least <u, b - a>: so planes prove what follows
/// from them by a few products.
mpq_class bound(const TwoPlanes& planes, std::span<const Point> a, std::span<const Point> b, const Point& x,
                const mpq_class& within);

/// The least and the greatest factor of the lines near x that meet both bodies; nullopt if none
/// does. It tries all places where segments between points of a body, or corners of the box, cross
/// those of another, seen along v. The naive twin: O(n^7) for n points.
std::optional<std::array<mpq_class, 2>> overlaps_naive(const Vector& v, std::span<const Point> a,
                                                       std::span<const Point> b, const Point& x,
                                                       const mpq_class& within);

/// A point of each of some lines whose factor is at least `least`, all corners of their set among
/// them: the naive twin of `at_least`. O(n^8) for n points.
std::vector<Point> at_least_naive(const Vector& v, std::span<const Point> a, std::span<const Point> b,
                                  const mpq_class& least);

}  // namespace fathom::patch
