// SPDX-License-Identifier: GPL-3.0-or-later
// The search once more, depth first, with the answer as its limit. Each cell that is split gets a
// polytope that is as coarse as it can be: every facet that is not far away costs a leaf.
#include "reference/unions/union_prover.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "kernels/filters/plane.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/position.hpp"
#include "reference/unions/pair_table.hpp"
#include "reference/unions/union_search.hpp"

namespace fathom::unions {

namespace {

// ---- of the half-spaces whose planes go through the nearest point, three that decide it: Karush,
// Kuhn and Tucker; Caratheodory ----

// Weights are found by Cramer's rule; only their signs are needed.

bool in_cone(const Vector& u, const Vector& direction) { return is_zero(cross(u, direction)) && dot(u, direction) > 0; }

// For u and v that are not parallel.
bool in_cone(const Vector& u, const Vector& v, const Vector& direction) {
  const Vector n = cross(u, v);
  return dot(n, direction) == 0 && det(direction, v, n) >= 0 && det(u, direction, n) >= 0;
}

bool in_cone(const Vector& u, const Vector& v, const Vector& w, const Vector& direction) {
  const int turn = sgn(det(u, v, w));
  const auto weighs = [&](const mpz_class& minor) { return sgn(minor) * turn >= 0; };
  return turn != 0 && weighs(det(direction, v, w)) && weighs(det(u, direction, w)) && weighs(det(u, v, direction));
}

/// The first one, two or three barriers such that `direction` is a combination of their normals
/// with weights >= 0. Throws std::logic_error if there are none.
std::vector<Barrier> deciding(const std::vector<Barrier>& tight, const Vector& direction) {
  for (const Barrier f : tight)
    if (in_cone(f->normal, direction)) return {f};
  for (std::size_t i = 0; i < tight.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vector &u = tight[i]->normal, &v = tight[j]->normal;
      if (!is_zero(cross(u, v)) && in_cone(u, v, direction)) return {tight[i], tight[j]};
    }
  }
  for (std::size_t i = 0; i < tight.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k)
        if (in_cone(tight[i]->normal, tight[j]->normal, tight[k]->normal, direction))
          return {tight[i], tight[j], tight[k]};
  throw std::logic_error("no three barriers hold the nearest point of a cell");
}

// ---- the proof ----

using kernels::RationalPoint;

constexpr std::size_t most_tried = 4;  // polytopes of a pair, the newest first

class Prover {
 public:
  Prover(kernels::Context& context, const PlacedPieces& pieces, UnionSearch& search)
      : context_(context), pieces_(pieces), search_(search) {}

  UnionProof run() {
    prove_cell(RationalPoint{});
    proof_.squared = *search_.squared_best();
    for (const RationalPoint& p : search_.optima()) proof_.optima.push_back(pieces_.translation(p));
    std::sort(proof_.optima.begin(), proof_.optima.end(), lexicographically_less);
    return std::move(proof_);
  }

 private:
  struct Facet {
    kernels::OrientedPlane plane, reversed;
    bool supports = false;  // whether it is known to be one of P_ij
  };
  struct Polytope {
    std::uint32_t index;  // in the proof
    std::vector<Facet> facets;
  };
  using Ids = std::pair<std::uint32_t, std::uint32_t>;  // of a pair's pieces
  // A polytope that splits the cell of the path, and the facets with a child, in their order.
  struct Opened {
    const Polytope* polytope;
    std::vector<std::uint32_t> order;
  };

  // Adds what proves the cell of the path, whose nearest point is p, not farther than the depth.
  void prove_cell(const RationalPoint& p) {
    context_.report("proof of the union");
    const bool known = std::any_of(search_.optima().begin(), search_.optima().end(),
                                   [&](const RationalPoint& o) { return same_point(o, p); });
    if (known) return close_at(p);
    PiecePair* pair = search_.deepest(p);
    if (pair == nullptr) throw std::logic_error("a translation out of a union is shorter than its depth");
    split({pair->a, pair->b}, p);
  }

  // Splits the cell of the path, whose nearest point p lies in the interior of P_ij. The facets
  // that open a cell with points near enough come first: what lies beyond the others is shown with
  // the fewest constraints so.
  void split(Ids ids, const RationalPoint& p) {
    const Opened opened = open(ids, p);
    const std::size_t before = path_.size();
    proof_.nodes.push_back({true, opened.polytope->index, opened.order});
    for (const std::uint32_t f : opened.order) {
      const Facet& facet = opened.polytope->facets[f];
      prove_beyond(facet.plane);
      path_.push_back(&facet.reversed);
    }
    path_.resize(before);
  }

  // A polytope of the proof that splits the cell, or else a new one, as coarse as it can be: that
  // of the search has more facets, which other cells asked for.
  Opened open(Ids ids, const RationalPoint& p) {
    std::deque<Polytope>& known = polytopes_[ids];
    for (std::size_t i = 0; i < known.size() && i < most_tried; ++i)
      if (std::optional<Opened> opened = opened_by(known[known.size() - 1 - i], p)) return *std::move(opened);
    PiecePair pair(pieces_, ids.first, ids.second);
    pair.contains(p);
    search_.open_facets(pair, path_);
    return opened_by(known.emplace_back(add_polytope(pair)), p).value();
  }

  // Returns nullopt if p does not lie inside, or a facet that opens a cell is none of P_ij.
  std::optional<Opened> opened_by(const Polytope& polytope, const RationalPoint& p) {
    const auto is_above = [&](const Facet& f) { return kernels::side(f.plane, p) >= 0; };
    if (std::any_of(polytope.facets.begin(), polytope.facets.end(), is_above)) return std::nullopt;
    std::vector<std::pair<double, std::uint32_t>> open;
    for (std::uint32_t f = 0; f < polytope.facets.size(); ++f) {
      const Facet& facet = polytope.facets[f];
      if (kernels::farther(facet.plane, *search_.best())) continue;
      RationalPoint nearest;
      const bool opens = search_.cut(path_, &facet.plane, nearest) == CellEnd::found;
      if (opens && !facet.supports) return std::nullopt;
      open.emplace_back(opens ? nearest.image_square : std::numeric_limits<double>::infinity(), f);
    }
    std::sort(open.begin(), open.end());
    Opened opened{&polytope, {}};
    for (const auto& [distance, f] : open) opened.order.push_back(f);
    return opened;
  }

  Polytope add_polytope(PiecePair& pair) {
    std::vector<std::uint32_t> facet_of;
    Polytope polytope{static_cast<std::uint32_t>(proof_.polytopes.size()), {}};
    proof_.polytopes.push_back({pair.a, pair.b, pair.inner(facet_of)});
    polytope.facets.resize(proof_.polytopes.back().inner.facets.size());
    for (std::size_t i = 0; i < facet_of.size(); ++i) {
      const PieceFacet& part = *pair.facets()[i];
      Facet& facet = polytope.facets[facet_of[i]];
      facet = {part.plane, part.plane.reversed(), facet.supports || part.supports};
    }
    return polytope;
  }

  // The same for the cell of the path and the facet.
  void prove_beyond(const kernels::OrientedPlane& plane) {
    RationalPoint nearest;
    std::vector<Barrier> conflict;
    const CellEnd end = nearest_on_wall(&plane, path_, nullptr, pieces_.exponent(), nearest, &conflict);
    path_.push_back(&plane);
    if (end == CellEnd::infeasible) {
      close(without_spare(conflict));
    } else if (kernels::compare(nearest, *search_.best()) > 0) {
      close_at(nearest);
    } else {
      prove_cell(nearest);
    }
    path_.pop_back();
  }

  void close(const std::vector<Barrier>& active) {
    std::vector<std::uint32_t>& numbers = proof_.nodes.emplace_back().numbers;
    for (const Barrier barrier : active)
      numbers.push_back(static_cast<std::uint32_t>(std::find(path_.begin(), path_.end(), barrier) - path_.begin()));
  }

  // Barriers without a common point, of which none can go: then only one combination of them is a
  // contradiction, which checkers find.
  [[nodiscard]] std::vector<Barrier> without_spare(std::vector<Barrier> barriers) const {
    for (std::size_t i = 0; i < barriers.size();) {
      std::vector<Barrier> fewer = barriers;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
      RationalPoint p;
      if (nearest_in_cell(fewer, pieces_.exponent(), p) == CellEnd::infeasible) barriers = std::move(fewer);
      else ++i;
    }
    return barriers;
  }

  void close_at(const RationalPoint& p) {
    std::vector<Barrier> tight;
    for (const Barrier barrier : path_)
      if (kernels::side(*barrier, p) == 0) tight.push_back(barrier);
    close(deciding(tight, p.v));
  }

  kernels::Context& context_;
  const PlacedPieces& pieces_;
  UnionSearch& search_;
  UnionProof proof_;
  std::vector<Barrier> path_;
  std::map<Ids, std::deque<Polytope>> polytopes_;  // the path holds their planes
};

}  // namespace

// Pair by pair, without keeping them.
std::vector<Vector> separations(kernels::Context& context, const PlacedPieces& pieces, const RationalPoint& p) {
  std::vector<Vector> directions;
  for (std::uint32_t i = 0; i < pieces.a.size(); ++i) {
    for (std::uint32_t j = 0; j < pieces.b.size(); ++j) {
      context.check();
      PiecePair pair(pieces, i, j);
      if (pair.contains(p)) throw std::logic_error("a translation out of a union lies inside");
      directions.push_back(primitive(pair.separation().normal));
    }
  }
  return directions;
}

UnionProof prove(kernels::Context& context, const PlacedPieces& pieces, const std::vector<UnionOptimum>& optima) {
  UnionSearch search(pieces);
  for (const UnionOptimum& o : optima) search.offer(pieces.point(o.translation));
  if (search.starts_free() || search.optima().size() != optima.size())
    throw std::logic_error("translations that are not the optima of a union");
  return Prover(context, pieces, search).run();
}

// Proofs that pairs of pieces are apart, for blocks of them at once: part of union_prover.hpp.

namespace {

using Node = BoxTree::Node;

constexpr std::uint32_t most_together = 64;  // pieces of a body, of a block that more than boxes are asked about
constexpr std::size_t most_known = 32;       // directions

// Bits of a direction's entries, tried in turn: short numbers first.
constexpr std::array<int, 5> entry_bits = {3, 6, 12, 24, 52};

/// The direction with entries of so many bits that is near to u, which is not O.
Vector rounded(const Vec3<double>& u, int bits) {
  const double most = std::max({std::fabs(u.x), std::fabs(u.y), std::fabs(u.z)});
  const auto entry = [&](double c) { return mpz_class(std::nearbyint(std::ldexp(c / most, bits))); };
  return primitive({entry(u.x), entry(u.y), entry(u.z)});
}

Vec3<double> image_of(const Vector& u) { return kernels::image(u, kernels::bit_length(u)); }

class ApartTree {
 public:
  /// If `squared` is given, then p is O.
  ApartTree(kernels::Context& context, const PlacedPieces& pieces, const kernels::RationalPoint& p,
            const std::optional<mpq_class>& squared, std::span<const Vector> known)
      : context_(context),
        pieces_(pieces),
        p_(p),
        tree_a_(pieces.a, BoxTree::Halves::of_numbers),
        tree_b_(pieces.b, BoxTree::Halves::of_numbers),
        error_(margin_error(p.image)) {
    if (squared) {
      squared_ = *squared * pieces.whole.denominator * pieces.whole.denominator;
      distance_ = pieces.image_above(*squared);
    }
    for (const Vector& u : known)
      if (known_.size() < most_known && std::ranges::find(known_, u) == known_.end()) known_.push_back(u);
  }

  std::vector<ApartBlock> run() {
    const auto size = [](const std::vector<PlacedPiece>& of) { return static_cast<std::uint32_t>(of.size()); };
    prove({tree_a_.root, size(pieces_.a)}, {tree_b_.root, size(pieces_.b)}, {});
    return std::move(blocks_);
  }

 private:
  // A node of a tree, and how many pieces it has.
  struct Range {
    std::uint32_t node, count;
  };

  [[nodiscard]] PairBlock block(Range a, Range b) const {
    const std::span<const PlacedPiece> all_a = pieces_.a, all_b = pieces_.b;
    return {all_a.subspan(tree_a_.nodes[a.node].first, a.count), all_b.subspan(tree_b_.nodes[b.node].first, b.count)};
  }

  // `tried` is the direction that was tried last for the block that holds this one.
  void prove(Range a, Range b, Vec3<double> tried) {
    context_.report("proof of pairs apart");
    if (std::optional<Vector> u = direction(a, b, tried)) {
      blocks_.push_back({ApartBlock::Kind::apart, std::move(*u)});
      return;
    }
    const Node &of_a = tree_a_.nodes[a.node], &of_b = tree_b_.nodes[b.node];
    if (of_b.is_leaf() || (!of_a.is_leaf() && of_a.size() >= of_b.size())) {
      blocks_.push_back({ApartBlock::Kind::halves_of_a, {}});
      prove({of_a.left, a.count / 2}, b, tried);
      prove({of_a.right, a.count - a.count / 2}, b, tried);
    } else {
      blocks_.push_back({ApartBlock::Kind::halves_of_b, {}});
      prove(a, {of_b.left, b.count / 2}, tried);
      prove(a, {of_b.right, b.count - b.count / 2}, tried);
    }
  }

  std::optional<Vector> direction(Range a, Range b, Vec3<double>& tried) {
    const PairBlock pairs = block(a, b);
    if (std::optional<Vector> u = between_boxes(tree_a_.nodes[a.node], tree_b_.nodes[b.node], pairs)) return u;
    if (a.count > most_together || b.count > most_together) return std::nullopt;
    if (surely_apart(pairs, p_.image, distance_, tried))
      if (std::optional<Vector> u = near(pairs, tried)) return u;
    for (std::size_t i = 0; i < known_.size(); ++i) {
      if (!shows(pairs, known_[i])) continue;
      std::rotate(known_.begin(), known_.begin() + static_cast<std::ptrdiff_t>(i),
                  known_.begin() + static_cast<std::ptrdiff_t>(i + 1));
      return known_.front();
    }
    if (a.count > 1 || b.count > 1) return std::nullopt;
    Vector u = of_pair(tree_a_.nodes[a.node].first, tree_b_.nodes[b.node].first);
    if (!shows(pairs, u)) throw std::logic_error("two pieces of unions are nearer than the answer says");
    if (known_.size() == most_known) known_.pop_back();
    known_.insert(known_.begin(), u);
    return u;
  }

  // An axis; or the way from box to box, which shows the distance of corners.
  std::optional<Vector> between_boxes(const Node& a, const Node& b, const PairBlock& pairs) {
    constexpr double off = 0x1p-30;  // far more than distance_ is off by
    const std::array<double, 3> at{p_.image.x, p_.image.y, p_.image.z};
    std::array<double, 3> way{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double up = at[k] - (b.high[k] - a.low[k]), down = b.low[k] - a.high[k] - at[k];
      const double margin = std::max(up, down);
      if (margin + error_ < 0) continue;
      way[k] = up > down ? std::max(up, 0.0) : -std::max(down, 0.0);
      Vector u{0, 0, 0};
      (k == 0 ? u.x : k == 1 ? u.y : u.z) = up > down ? 1 : -1;
      if (margin - error_ > distance_ * (1 + off)) return u;
      if (margin + error_ >= distance_ * (1 - off) && shows(pairs, u)) return u;
    }
    const Vec3<double> from_box_to_box{way[0], way[1], way[2]};
    if (distance_ == 0 || dot(from_box_to_box, from_box_to_box) < distance_ * distance_) return std::nullopt;
    return near(pairs, from_box_to_box);
  }

  // A direction near to u with entries as short as can be.
  std::optional<Vector> near(const PairBlock& pairs, const Vec3<double>& u) const {
    for (const int bits : entry_bits)
      if (Vector v = rounded(u, bits); keeps_apart(pairs, p_.image, distance_, image_of(v)) == true) return v;
    return std::nullopt;
  }

  // Exact.
  [[nodiscard]] bool shows(const PairBlock& pairs, const Vector& u) const {
    if (const std::optional<bool> told = keeps_apart(pairs, p_.image, distance_, image_of(u))) return *told;
    const mpq_class h = highest(pairs.b, u) + highest(pairs.a, -u);
    if (squared_ == 0) return dot(u, p_.v) >= h * p_.w;
    return h < 0 && h * h >= squared_ * dot(u, u);
  }

  // The greatest <u, x> of the points of pieces, in the common unit.
  static mpq_class highest(std::span<const PlacedPiece> pieces, const Vector& u) {
    std::optional<mpq_class> most;
    for (const PlacedPiece& piece : pieces) {
      const std::uint32_t k = kernels::extreme_points(piece.cloud, u).front();
      mpq_class height = kernels::ratio(dot(u, piece.cloud[k]), piece.factor);
      if (!most || height > *most) most = std::move(height);
    }
    return most.value();
  }

  [[nodiscard]] Vector of_pair(std::uint32_t i, std::uint32_t j) const {
    if (squared_ != 0) {
      const polytope::PlacedPair pair = pieces_.pair(i, j);
      return polytope::nearest_points(pair.a, pair.b).normal;
    }
    PiecePair pair(pieces_, i, j);
    if (pair.contains(p_)) throw std::logic_error("a translation out of a union lies inside");
    return primitive(pair.separation().normal);
  }

  kernels::Context& context_;
  const PlacedPieces& pieces_;
  const kernels::RationalPoint& p_;
  mpq_class squared_;    // the squared distance that is to be shown, in common units; or 0
  double distance_ = 0;  // its root in units of images, from above
  BoxTree tree_a_, tree_b_;
  double error_;               // of margins of boxes
  std::vector<Vector> known_;  // directions that have shown a block, the last one first
  std::vector<ApartBlock> blocks_;
};

}  // namespace

std::vector<ApartBlock> apart_tree(kernels::Context& context, const PlacedPieces& pieces,
                                   const kernels::RationalPoint& p, std::span<const Vector> known) {
  return ApartTree(context, pieces, p, std::nullopt, known).run();
}

std::vector<ApartBlock> distance_tree(kernels::Context& context, const PlacedPieces& pieces, const mpq_class& squared,
                                      std::span<const Vector> known) {
  return ApartTree(context, pieces, {}, squared, known).run();
}

}  // namespace fathom::unions
