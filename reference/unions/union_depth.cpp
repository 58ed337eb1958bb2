// SPDX-License-Identifier: GPL-3.0-or-later
// The answer about two unions: where O lies, the search, and what touches at each optimum.
//                                                                                [proofs/unions.md]
#include <algorithm>
#include <deque>
#include <stdexcept>
#include <utility>

#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "reference/depth/apart.hpp"
#include "reference/depth/contact.hpp"
#include "reference/solve/depth.hpp"
#include "reference/unions/least_norm.hpp"
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
  UnionRun(kernels::Context& context, const PlacedPieces& pieces, bool bounds)
      : context_(context), pieces_(pieces), bounds_(bounds), search_(pieces) {}

  UnionDepth run() {
    if (search_.starts_free()) {
      answer_free();
    } else {
      answer_overlap();
    }
    result_.counters = search_.counts();
    return std::move(result_);
  }

 private:
  using Place = kernels::RationalPointIn<Numbers>;

  [[nodiscard]] std::uint32_t columns() const { return static_cast<std::uint32_t>(pieces_.b.size()); }

  // Pieces meet, or they are apart.
  void answer_free() {
    UnionOptimum here = optimum(Place{});
    if (bounds_) result_.bounds = UnionBounds{0, 0, 0, hull_depth().squared};
    if (!here.contacts.empty()) {
      result_.status = Status::touching;
      result_.optima.push_back(std::move(here));
      return;
    }
    for (std::uint32_t i = 0; i < pieces_.a.size(); ++i) {
      for (std::uint32_t j = 0; j < columns(); ++j) {
        context_.check();
        const Depth depth = depth::apart_depth(context_, pieces_.pair(i, j), true);
        if (result_.apart && depth.distance()->squared >= result_.apart->distance.squared) continue;
        result_.apart = UnionDistance{i, j, *depth.distance()};
      }
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
    std::sort(result_.optima.begin(), result_.optima.end(),
              [](const UnionOptimum& x, const UnionOptimum& y) { return is_before(x.translation, y.translation); });
  }

  HullDepth hull_depth() {
    const Depth depth = solve::depth_by_method(context_, pieces_.whole, {});
    HullDepth result{depth.squared(), {}};
    for (const Optimum& o : depth.optima()) {
      const mpz_class height(o.support * pieces_.whole.denominator);
      const Vector& n = o.direction;
      result.optima.push_back(kernels::rational_point(height * n, dot(n, n), pieces_.exponent()));
    }
    return result;
  }

  // Returns false if it was stopped; then the deepest pair so far is known.
  bool find_deepest_pair() try {
    UnionBounds& bounds = *result_.bounds;
    for (std::uint32_t k = 0; k < search_.pairs().size(); ++k) {
      if (!search_.pairs()[k]->contains(Place{})) continue;
      const std::uint32_t i = k / columns(), j = k % columns();
      Options options;
      options.optima = 1;
      mpq_class squared = solve::depth_by_method(context_, pieces_.pair(i, j), options).squared();
      if (squared > bounds.deepest_pair) bounds = {std::move(squared), i, j, bounds.hulls};
    }
    return true;
  } catch (const Interrupted&) {
    return false;
  }

  // A free point, and all that touches there.
  UnionOptimum optimum(const Place& p) {
    UnionOptimum optimum{pieces_.translation(kernels::converted<AnyNumbers>(p)), true, {}};
    std::vector<TangentCone> cones;
    for (std::uint32_t k = 0; k < search_.pairs().size(); ++k) {
      PiecePairIn<Numbers>& pair = *search_.pairs()[k];
      if (pair.contains(p)) throw std::logic_error("a translation out of a union lies inside");
      if (kernels::side(pair.separation(), p) > 0) continue;
      TangentCone cone = pair.normals_at(p);
      if (cone.empty()) continue;
      optimum.contacts.push_back(contact(k / columns(), k % columns(), cone));
      cones.push_back(std::move(cone));
    }
    optimum.clearance = !cover_space(cones);
    return optimum;
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
  const PlacedPieces& pieces_;
  bool bounds_;
  UnionSearchIn<Numbers> search_;
  UnionDepth result_;
};

// With integers that hold everything.
UnionDepth answer(const Pieces& a, const Pieces& b, const UnionOptions& options, long most_fixed_bits) {
  kernels::Context context(options.monitor);
  const PlacedPieces pieces = place_pieces(a, b);
  if (pieces.exponent() <= most_fixed_bits) return UnionRun<FixedNumbers>(context, pieces, options.bounds).run();
  return UnionRun<AnyNumbers>(context, pieces, options.bounds).run();
}

}  // namespace

UnionDepth union_depth_in_mpz(const Pieces& a, const Pieces& b, const UnionOptions& options) {
  const kernels::DefaultFloatEnvironment environment;
  return answer(a, b, options, -1);
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
  const kernels::DefaultFloatEnvironment environment;
  return unions::answer(a, b, options, kernels::FixedNumbers::most_bits);
}

}  // namespace fathom
