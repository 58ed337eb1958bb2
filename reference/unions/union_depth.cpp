// SPDX-License-Identifier: GPL-3.0-or-later
// The answer about two unions: where O lies, the search, and what touches at each optimum.
//                                                                                [proofs/unions.md]
#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>
#include <utility>

#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "reference/depth/apart.hpp"
#include "reference/depth/contact.hpp"
#include "reference/solve/depth.hpp"
#include "reference/unions/union_search.hpp"

namespace fathom::unions {
namespace {

// ---- whether translations near an optimum leave a gap ----

/// The outward normals of a cone's facets, which lie in planes through O. Without facets it is the
/// whole space.
using TangentCone = std::vector<Vector>;

// The tangent cones of the P_ij that touch a point cover space if and only if the point lies in the
// interior of the union of these P_ij: then no translation near it leaves a gap. A point outside a
// cone lies strictly beyond one of its planes. Points strictly beyond given planes through O exist
// if and only if some are beyond these planes moved out by 1: the nearest of these stands for all.
class Covering {
 public:
  explicit Covering(const std::vector<TangentCone>& cones) {
    for (const TangentCone& cone : cones) {
      std::vector<Facet>& facets = cones_.emplace_back();
      for (const Vector& normal : cone) {
        kernels::OrientedPlane through = kernels::oriented_plane(normal, 0, 0);
        facets.push_back({through, kernels::oriented_plane(normal, 1, 0), through.reversed()});
      }
    }
  }

  bool run() { return covered(); }

 private:
  struct Facet {
    kernels::OrientedPlane through, moved, reversed;
  };

  static bool holds(const std::vector<Facet>& cone, const kernels::RationalPoint& p) {
    return std::all_of(cone.begin(), cone.end(), [&](const Facet& f) { return kernels::side(f.through, p) <= 0; });
  }

  // Whether the cones cover the cell of all `beyond_`.
  bool covered() {
    kernels::RationalPoint p;
    if (nearest_in_cell(beyond_, 0, p) != CellEnd::found) return true;
    const auto cone =
        std::find_if(cones_.begin(), cones_.end(), [&](const std::vector<Facet>& c) { return holds(c, p); });
    if (cone == cones_.end()) return false;
    const std::size_t before = beyond_.size();
    bool all = true;
    for (const Facet& f : *cone) {
      beyond_.push_back(&f.moved);
      all = covered();
      beyond_.pop_back();
      if (!all) break;
      beyond_.push_back(&f.reversed);  // the rest is not beyond it
    }
    beyond_.resize(before);
    return all;
  }

  std::deque<std::vector<Facet>> cones_;
  std::vector<Barrier> beyond_;
};

/// Whether every point lies in one of the cones. Exact.
bool cover_space(const std::vector<TangentCone>& cones) { return Covering(cones).run(); }

// ---- the answer ----

using kernels::AnyNumbers;
using kernels::FixedNumbers;
using kernels::RationalPoint;

// Of the hulls of A and B, with its optima as points of the lattice: no P_ij holds one in its
// interior.
struct HullDepth {
  mpq_class squared;
  std::vector<RationalPoint> optima;
};

template <class Numbers>
class UnionRun {
 public:
  UnionRun(kernels::Context& context, const Pieces& a, const Pieces& b, const PlacedPieces& pieces, bool bounds,
           bool all_pairs)
      : context_(context), a_(a), b_(b), pieces_(pieces), bounds_(bounds), search_(pieces, all_pairs) {}

  UnionDepth run() {
    if (search_.starts_free()) {
      answer_free();
    } else {
      answer_overlap();
    }
    const std::uint64_t distances = result_.counters.pairs_touched;
    result_.counters = search_.counts();
    result_.counters.pairs_touched += distances;
    return std::move(result_);
  }

 private:
  using Place = kernels::RationalPointIn<Numbers>;

  // Pieces meet, or they are apart.
  void answer_free() {
    UnionOptimum here = optimum(Place{});
    if (bounds_) result_.bounds = UnionBounds{0, 0, 0, hull_depth().squared};
    if (!here.contacts.empty()) {
      result_.status = Status::touching;
      result_.optima.push_back(std::move(here));
      return;
    }
    find_nearest_pair();
  }

  // Boxes tell which pairs cannot be nearer; nor can one that comes later and is as near at best.
  void find_nearest_pair() {
    std::optional<UnionDistance>& apart = result_.apart;
    const auto is_nearer = [&](const RankedPair& pair, const mpq_class& squared) {
      if (!apart || squared < apart->distance.squared) return true;
      return squared == apart->distance.squared && std::pair(pair.a, pair.b) < std::pair(apart->a, apart->b);
    };
    double least = 0;
    RankedPairs pairs = search_.table().ranked(Place{});
    for (auto ranked = pairs.next(); ranked && !(apart && -ranked->bound > least); ranked = pairs.next()) {
      context_.check();
      if (apart && std::isfinite(ranked->bound) &&
          !is_nearer(*ranked, std::max<mpq_class>(0, -pieces_.squared_of_boxes(ranked->a, ranked->b))))
        continue;
      if (!search_.table().has(*ranked)) ++result_.counters.pairs_touched;
      const Depth depth = depth::apart_depth(context_, pieces_.pair(ranked->a, ranked->b), true);
      if (!is_nearer(*ranked, depth.distance()->squared)) continue;
      apart = UnionDistance{ranked->a, ranked->b, *depth.distance()};
      least = pieces_.image_above(apart->distance.squared);
    }
  }

  void answer_overlap() {
    result_.status = Status::penetrating;
    const HullDepth hulls = hull_depth();
    for (const RationalPoint& p : hulls.optima) search_.offer(kernels::converted<Numbers>(p));
    if (bounds_) result_.bounds = UnionBounds{0, 0, 0, hulls.squared};
    result_.complete = !bounds_ || find_deepest_pair();
    if (result_.complete) {
      search_.dive();
      result_.complete = search_.run(context_);
    }
    result_.high = *search_.squared_best();
    result_.low = result_.complete ? result_.high : search_.squared_low();
    if (result_.bounds) result_.low = std::max(result_.low, result_.bounds->deepest_pair);
    for (const Place& p : search_.optima()) result_.optima.push_back(optimum(p));
    std::sort(result_.optima.begin(), result_.optima.end(), [](const UnionOptimum& x, const UnionOptimum& y) {
      return lexicographically_less(x.translation, y.translation);
    });
  }

  HullDepth hull_depth() {
    const std::vector<Point> a = polytope::joined(a_), b = polytope::joined(b_);
    const Depth depth = pieces_.on_one_lattice() ? solve::depth_by_method(context_, pieces_.whole, {})
                                                 : solve::placed_depth(context_, a, b, {}).depth;
    HullDepth result{depth.squared(), {}};
    for (const Optimum& o : depth.optima()) result.optima.push_back(pieces_.point(o.translation()));
    return result;
  }

  // Returns false if it was stopped; then the deepest pair so far is known.
  bool find_deepest_pair() try {
    UnionBounds& bounds = *result_.bounds;
    const auto is_deeper = [&](const RankedPair& pair, const mpq_class& squared) {
      if (squared != bounds.deepest_pair) return squared > bounds.deepest_pair;
      return squared > 0 && std::pair(pair.a, pair.b) < std::pair(bounds.a, bounds.b);
    };
    double most = 0;
    RankedPairs pairs = search_.table().ranked(Place{});
    for (auto ranked = pairs.next(); ranked && ranked->bound >= most; ranked = pairs.next()) {
      context_.check();
      const auto& [bound, i, j] = *ranked;
      if (std::isfinite(bound) && !is_deeper(*ranked, pieces_.squared_of_boxes(i, j))) continue;
      PiecePairIn<Numbers>* pair = search_.table().find(*ranked, Place{});
      if (pair == nullptr || !pair->contains(Place{})) continue;
      Options options;
      options.optima = 1;
      mpq_class squared = solve::depth_by_method(context_, pieces_.pair(i, j), options).squared();
      if (!is_deeper(*ranked, squared)) continue;
      bounds = {std::move(squared), i, j, bounds.hulls};
      most = pieces_.image_below(bounds.deepest_pair);
    }
    return true;
  } catch (const Interrupted&) {
    return false;
  }

  // A free point, and all that touches there.
  UnionOptimum optimum(const Place& p) {
    UnionOptimum optimum{pieces_.translation(kernels::converted<AnyNumbers>(p)), true, {}};
    std::vector<TangentCone> cones;
    for (PiecePairIn<Numbers>* pair : near(p)) {
      if (pair->contains(p)) throw std::logic_error("a translation out of a union lies inside");
      if (kernels::side(pair->separation(), p) > 0) continue;
      TangentCone cone = pair->normals_at(p);
      if (cone.empty()) continue;
      optimum.contacts.push_back(contact(pair->a, pair->b, cone));
      cones.push_back(std::move(cone));
    }
    optimum.clearance = !cover_space(cones);
    return optimum;
  }

  // All pairs that may touch at a point, in their order.
  std::vector<PiecePairIn<Numbers>*> near(const Place& p) {
    std::vector<PiecePairIn<Numbers>*> found;
    RankedPairs pairs = search_.table().ranked(p);
    for (auto ranked = pairs.next(); ranked && ranked->bound >= 0; ranked = pairs.next())
      if (PiecePairIn<Numbers>* pair = search_.table().find(*ranked, p)) found.push_back(pair);
    std::sort(found.begin(), found.end(),
              [](const auto* x, const auto* y) { return std::pair(x->a, x->b) < std::pair(y->a, y->b); });
    return found;
  }

  // The sum of the normals of the facets that meet at a point lies in the interior of the cone of
  // all planes through it.
  PieceContact contact(std::uint32_t i, std::uint32_t j, const TangentCone& cone) {
    Vector n{0, 0, 0};
    for (const Vector& normal : cone) n = n + normal;
    n = primitive(n);
    return {i, j, n, depth::contact_of(depth::facing_faces(pieces_.pair(i, j), n))};
  }

  kernels::Context& context_;
  const Pieces &a_, &b_;
  const PlacedPieces& pieces_;
  bool bounds_;
  UnionSearchIn<Numbers> search_;
  UnionDepth result_;
};

}  // namespace

// With integers that hold everything.
UnionDepth union_depth_twin(const UnionWork& work, const Pieces& a, const Pieces& b, const UnionOptions& options) {
  const kernels::DefaultFloatEnvironment environment;
  kernels::Context context(options.monitor);
  const PlacedPieces pieces = place_pieces(a, b, work.lattices);
  if (!work.any_size && pieces.on_one_lattice() && pieces.exponent() <= FixedNumbers::most_bits)
    return UnionRun<FixedNumbers>(context, a, b, pieces, options.bounds, work.all_pairs).run();
  return UnionRun<AnyNumbers>(context, a, b, pieces, options.bounds, work.all_pairs).run();
}

}  // namespace fathom::unions

namespace fathom {

const mpq_class& UnionDepth::squared() const {
  if (!complete) throw std::logic_error("the depth of unions is not known: the search was stopped");
  return low;
}

Pieces pieces_of(const Body& body) {
  if (body.shape) throw std::invalid_argument("a shape that is no polytope is no union of pieces");
  return body.pieces ? *body.pieces : Pieces{body.points.exact()};
}

UnionDepth union_depth(const Pieces& a, const Pieces& b, const UnionOptions& options) {
  return unions::union_depth_twin({}, a, b, options);
}

}  // namespace fathom
