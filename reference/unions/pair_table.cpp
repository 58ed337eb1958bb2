// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/unions/pair_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "kernels/filters/support.hpp"

namespace fathom::unions {

namespace {

BoxTree::Node leaf(const PlacedPiece& piece, std::uint32_t number) {
  BoxTree::Node node;
  node.first = number;
  const kernels::Images images = piece.cloud.images();
  for (std::size_t k = 0; const std::span<const double>& axis : {images.x, images.y, images.z}) {
    const auto [low, high] = std::minmax_element(axis.begin(), axis.end());
    node.low[k] = piece.scale * *low;
    node.high[k] = piece.scale * *high;
    node.widest[k] = node.high[k] - node.low[k];
    ++k;
  }
  return node;
}

std::vector<BoxTree::Node> leaves_of(const std::vector<PlacedPiece>& pieces) {
  std::vector<BoxTree::Node> leaves;
  for (std::uint32_t i = 0; i < pieces.size(); ++i) leaves.push_back(leaf(pieces[i], i));
  return leaves;
}

BoxTree::Node about(const BoxTree::Node& p, const BoxTree::Node& q) {
  BoxTree::Node node;
  node.first = std::min(p.first, q.first);
  for (std::size_t k = 0; k < 3; ++k) {
    node.low[k] = std::min(p.low[k], q.low[k]);
    node.high[k] = std::max(p.high[k], q.high[k]);
    node.widest[k] = std::max(p.widest[k], q.widest[k]);
  }
  return node;
}

// Puts those below the median of the middles, where these spread most, into the first half.
void part(const std::vector<BoxTree::Node>& nodes, std::span<std::uint32_t> leaves) {
  const auto middle = [&](std::uint32_t leaf, std::size_t k) { return nodes[leaf].low[k] + nodes[leaf].high[k]; };
  std::size_t axis = 0;
  double most = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto before = [&](std::uint32_t x, std::uint32_t y) { return middle(x, k) < middle(y, k); };
    const auto [low, high] = std::minmax_element(leaves.begin(), leaves.end(), before);
    const double spread = middle(*high, k) - middle(*low, k);
    if (spread > most) {
      most = spread;
      axis = k;
    }
  }
  std::nth_element(
      leaves.begin(), leaves.begin() + static_cast<std::ptrdiff_t>(leaves.size() / 2), leaves.end(),
      [&](std::uint32_t x, std::uint32_t y) { return std::pair(middle(x, axis), x) < std::pair(middle(y, axis), y); });
}

// The node of the leaves in the range.
std::uint32_t build(std::vector<BoxTree::Node>& nodes, std::span<std::uint32_t> leaves, BoxTree::Halves halves) {
  if (leaves.size() == 1) return leaves[0];
  if (halves == BoxTree::Halves::of_space) part(nodes, leaves);
  const std::size_t half = leaves.size() / 2;
  const std::uint32_t left = build(nodes, leaves.first(half), halves),
                      right = build(nodes, leaves.subspan(half), halves);
  BoxTree::Node node = about(nodes[left], nodes[right]);
  node.left = left;
  node.right = right;
  nodes.push_back(node);
  return static_cast<std::uint32_t>(nodes.size() - 1);
}

}  // namespace

double BoxTree::Node::size() const {
  double most = 0;
  for (std::size_t k = 0; k < 3; ++k) most = std::max(most, high[k] - low[k]);
  return most;
}

BoxTree::BoxTree(const std::vector<PlacedPiece>& pieces, Halves halves) : BoxTree(leaves_of(pieces), halves) {}

BoxTree::BoxTree(std::vector<Node> leaves, Halves halves) : nodes(std::move(leaves)) {
  std::vector<std::uint32_t> numbers(nodes.size());
  std::iota(numbers.begin(), numbers.end(), 0U);
  nodes.reserve(2 * nodes.size());
  root = build(nodes, numbers, halves);
}

std::vector<std::uint32_t> BoxTree::order() const {
  std::vector<std::uint32_t> numbers, todo{root};
  while (!todo.empty()) {
    const Node& node = nodes[todo.back()];
    todo.pop_back();
    if (node.is_leaf()) numbers.push_back(node.first);
    else todo.insert(todo.end(), {node.right, node.left});
  }
  return numbers;
}

namespace {

// Bounds on errors, in any rounding mode.             [proofs/unions.md, "Pairs on demand"]
constexpr double of_margin = 0x1p-46;      // of a box's margin, times 1 + |p|
constexpr double of_separation = 0x1p-43;  // of <u, p> - h(u), times |u| (1 + |p|)
constexpr double of_gap = 0x1p-36;         // of d |u|, relative
constexpr int most_turns = 24;

double largest(const Vec3<double>& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }
double length(const Vec3<double>& v) { return std::sqrt(dot(v, v)); }

struct Farthest {
  Vec3<double> at{};
  double height = -std::numeric_limits<double>::infinity();
};

// The image farthest in direction u.
Farthest farthest(std::span<const PlacedPiece> pieces, const Vec3<double>& u) {
  Farthest most;
  for (const PlacedPiece& piece : pieces) {
    const kernels::Images images = piece.cloud.images();
    Farthest found;
    for (std::size_t i = 0; i < images.size(); ++i) {
      const Vec3<double> at{images.x[i], images.y[i], images.z[i]};
      if (const double height = dot(u, at); height > found.height) found = {at, height};
    }
    if (piece.scale * found.height > most.height) most = {piece.scale * found.at, piece.scale * found.height};
  }
  return most;
}

struct Above {
  Vec3<double> corner;   // of all P_ij, the farthest in the direction
  double height, error;  // <u, p> - h(u) - d |u|, and a bound on its error
};

Above above(const PairBlock& block, const Vec3<double>& at, double d, const Vec3<double>& u) {
  const Farthest of_a = farthest(block.a, -u), of_b = farthest(block.b, u);
  const double away = d == 0 ? 0 : d * length(u);
  return {of_b.at - of_a.at, dot(u, at) - (of_a.height + of_b.height) - away,
          of_separation * largest(u) * (1 + largest(at)) + of_gap * away};
}

constexpr double most_size = 0x1p40;  // of p, for which bounds are useful

}  // namespace

double margin_error(const Vec3<double>& at) { return of_margin * (1 + largest(at)); }

std::optional<bool> keeps_apart(const PairBlock& block, const Vec3<double>& at, double d, const Vec3<double>& u) {
  if (!(largest(at) < most_size && d < most_size)) return std::nullopt;
  const Above found = above(block, at, d, u);
  if (found.height > found.error) return true;
  if (found.height < -found.error) return false;
  return std::nullopt;
}

bool surely_apart(const PairBlock& block, const Vec3<double>& at, double d, Vec3<double>& u) {
  if (!(largest(at) < most_size && d < most_size)) return false;
  if (largest(u) == 0) {
    const PlacedPiece &a = block.a.front(), &b = block.b.front();
    const kernels::Images of_a = a.cloud.images(), of_b = b.cloud.images();
    u = at - (b.scale * Vec3<double>{of_b.x[0], of_b.y[0], of_b.z[0]} -
              a.scale * Vec3<double>{of_a.x[0], of_a.y[0], of_a.z[0]});
    const double size = largest(u);
    if (!(size > 0x1p-40)) return false;
    u = (1 / size) * u;
  }
  for (int turn = 0; turn < most_turns; ++turn) {
    const Above found = above(block, at, d, u);
    if (found.height > found.error) return true;
    Vec3<double> away = at - found.corner;
    if (d > 0) away = away - (d / length(u)) * u;
    const double square = dot(away, away);
    if (!(square > 0x1p-100)) return false;
    u = u - (2 * dot(u, away) / square) * away;
  }
  return false;
}

namespace {

// Bounds on errors, in any rounding mode.             [proofs/unions.md, "Pairs on demand"]
constexpr double of_distance = 0x1p-46;  // of a distance of boxes, relative

}  // namespace

RankedPairs::RankedPairs(const BoxTree& a, const BoxTree& b, const Vec3<double>& at, bool all)
    : a_(a), b_(b), at_{at.x, at.y, at.z}, error_(margin_error(at)), all_(all) {
  push(a.root, b.root);
}

bool RankedPairs::comes_after(const Block& x, const Block& y) {
  if (x.bound != y.bound) return x.bound < y.bound;
  return std::pair(x.first_a, x.first_b) > std::pair(y.first_a, y.first_b);
}

// That of a pair in two nodes is at most theirs, also as computed. What is not a number bounds
// nothing.
double RankedPairs::bound(const BoxTree::Node& a, const BoxTree::Node& b) const {
  if (all_) return std::numeric_limits<double>::infinity();
  double least = std::numeric_limits<double>::infinity(), gaps = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double half = (a.widest[k] + b.widest[k]) / 2;
    for (const double margin : {b.high[k] - a.low[k] - at_[k], at_[k] - (b.low[k] - a.high[k]), half}) {
      const double raised = margin + error_;
      if (raised < least) least = raised;
      if (raised < 0) gaps += raised * raised;
    }
  }
  return least < 0 ? -(std::sqrt(gaps) * (1 - of_distance)) : least;
}

void RankedPairs::push(std::uint32_t node_a, std::uint32_t node_b) {
  const BoxTree::Node &a = a_.nodes[node_a], &b = b_.nodes[node_b];
  heap_.push_back({bound(a, b), a.first, b.first, node_a, node_b});
  std::push_heap(heap_.begin(), heap_.end(), comes_after);
}

std::optional<RankedPair> RankedPairs::next() {
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end(), comes_after);
    const Block block = heap_.back();
    heap_.pop_back();
    const BoxTree::Node &a = a_.nodes[block.node_a], &b = b_.nodes[block.node_b];
    if (a.is_leaf() && b.is_leaf()) return RankedPair{block.bound, block.first_a, block.first_b};
    if (b.is_leaf() || (!a.is_leaf() && a.size() >= b.size())) {
      push(a.left, block.node_b);
      push(a.right, block.node_b);
    } else {
      push(block.node_a, b.left);
      push(block.node_a, b.right);
    }
  }
  return std::nullopt;
}

template <class Numbers>
PairTableIn<Numbers>::PairTableIn(const PlacedPieces& pieces, bool all)
    : pieces_(pieces), tree_a_(pieces.a), tree_b_(pieces.b), all_(all) {}

template <class Numbers>
typename PairTableIn<Numbers>::Pair* PairTableIn<Numbers>::find(const RankedPair& ranked, const Place& p) {
  if (ranked.bound < 0) return nullptr;
  const auto& [bound, i, j] = ranked;
  Entry& entry = entries_[std::uint64_t{i} * pieces_.b.size() + j];
  if (!entry.pair) {
    if (!all_ && surely_apart({{&pieces_.a[i], 1}, {&pieces_.b[j], 1}}, p.image, 0, entry.separating)) return nullptr;
    entry.pair = std::make_unique<Pair>(pieces_, i, j);
    ++made_;
  }
  return entry.pair.get();
}

template <class Numbers>
bool PairTableIn<Numbers>::has(const RankedPair& pair) const {
  const auto entry = entries_.find(std::uint64_t{pair.a} * pieces_.b.size() + pair.b);
  return entry != entries_.end() && entry->second.pair;
}

template class PairTableIn<kernels::AnyNumbers>;
template class PairTableIn<kernels::FixedNumbers>;

}  // namespace fathom::unions
