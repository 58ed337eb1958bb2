// SPDX-License-Identifier: GPL-3.0-or-later
// Proofs that pairs of pieces are apart, for blocks of them at once: part of union_prover.hpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "kernels/filters/plane.hpp"
#include "kernels/number/rational.hpp"
#include "reference/polytope/position.hpp"
#include "reference/unions/box_tree.hpp"
#include "reference/unions/separating.hpp"
#include "reference/unions/union_prover.hpp"

namespace fathom::unions {
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
