// SPDX-License-Identifier: Apache-2.0
#include "solids.hpp"

#include <algorithm>
#include <numeric>

namespace fathom_check {

PiecedBody::PiecedBody(const Body& body) : points_(homogeneous(body)), is_union_(body.core == Body::Core::pieces) {
  if (is_union_) {
    corners_.resize(points_.size());
    std::iota(corners_.begin(), corners_.end(), 0);
    for (const List& piece : body.pieces) ends_.push_back(piece.end);
    return;
  }
  const Facets& facets = body.solid.facets.items;
  const auto at = [&facets](std::size_t f) {
    return facets.corners.begin() + static_cast<std::ptrdiff_t>(facets.begin_of(f));
  };
  for (std::size_t k = 0; k < body.solid.pieces.size(); ++k) {
    std::vector<std::uint32_t> named(at(fathom_check::begin_of(body.solid.pieces, k)), at(body.solid.pieces[k].end));
    std::sort(named.begin(), named.end());
    named.erase(std::unique(named.begin(), named.end()), named.end());
    corners_.insert(corners_.end(), named.begin(), std::lower_bound(named.begin(), named.end(), points_.size()));
    ends_.push_back(corners_.size());
  }
}

std::optional<std::uint32_t> PiecedBody::corner(std::size_t piece, std::uint32_t number) const {
  const std::uint32_t *const begin = corners_.data() + begin_of(piece), *const end = corners_.data() + ends_[piece];
  if (!is_union_) return std::binary_search(begin, end, number) ? std::optional(number) : std::nullopt;
  return number < corners(piece) ? std::optional(begin[number]) : std::nullopt;
}

std::optional<Fault> for_each_vector(
    const UnionParts& parts, std::size_t list, std::size_t pieces_a, std::size_t pieces_b,
    const std::function<void(std::size_t block, const PieceRange& of_a, const PieceRange& of_b)>& take) {
  struct Ranges {
    PieceRange a, b;
  };
  std::vector<Ranges> left{{{0, pieces_a}, {0, pieces_b}}};
  const List& blocks = parts.separation_lists[list];
  for (std::size_t k = begin_of(parts.separation_lists, list); k < blocks.end; ++k) {
    const Block& block = parts.blocks.items[k];
    if (left.empty()) return refused(parts.blocks.lines[k], "the tree of blocks ends before this one");
    Ranges ranges = left.back();
    left.pop_back();
    if (block.kind == Block::Kind::vector) {
      take(k, ranges.a, ranges.b);
      continue;
    }
    PieceRange& split = block.kind == Block::Kind::splits_a ? ranges.a : ranges.b;
    if (split.size() < 2) return refused(parts.blocks.lines[k], "fewer than two pieces cannot be split");
    const PieceRange whole = split;
    const std::size_t middle = (whole.first + whole.last) / 2;
    split = {middle, whole.last};
    left.push_back(ranges);
    split = {whole.first, middle};
    left.push_back(ranges);
  }
  if (!left.empty()) return refused(blocks.line, "a block of this tree is missing");
  return std::nullopt;
}

}  // namespace fathom_check
