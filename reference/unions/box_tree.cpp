// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/unions/box_tree.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

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

}  // namespace fathom::unions
