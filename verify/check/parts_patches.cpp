// SPDX-License-Identifier: Apache-2.0
// The parser's parts of format 4. Each begins on the line at hand; when it has been read, the line
// behind it is at hand.
#include "parser.hpp"

namespace fathom_check {

void Parser::read_patches(PatchParts& parts) {
  constexpr const char *expected = "the number of its corners and that of its sides",
                       *side = "a side: 'a' or 'b', three integers, and the index of a corner";
  parts.line = lines_->number();
  std::size_t left = header("patches");
  for (advance(); left > 0; --left) {
    const std::size_t line = lines_->number();
    std::size_t corners = header("patch", expected, 3);
    const std::size_t sides = count(2, expected);
    counts_.push_back(sides);
    count_numbers(2);
    for (; corners > 0; --corners) read_corner(parts);
    parts.corner_lists.push_back({parts.corners.items.size(), line});
    read_rows(parts.sides, sides, 5, side, [&](auto& items) {
      if (fields_[0] != "a" && fields_[0] != "b") throw wrong(side);
      const Vector inward{integer(fields_[1], side), integer(fields_[2], side), integer(fields_[3], side)};
      items.push_back({fields_[0] == "b", inward, index_number(fields_[4])});
    });
    parts.side_lists.push_back({parts.sides.items.size(), line});
  }
  if (at("rates")) read_rates(parts.rates);
}

/// On the line behind the one at hand.
void Parser::read_corner(PatchParts& parts) {
  constexpr const char* expected = "a corner: twice the number of its weights, and for each an index and a rational";
  next(expected);
  const std::size_t end_of_a = read_weights_of_corner(parts.weights, 0), of_a = parts.weights.size();
  if (read_weights_of_corner(parts.weights, end_of_a) != fields_.size()) throw wrong(expected);
  count_numbers(fields_.size());
  parts.corners.items.push_back({of_a, parts.weights.size()});
  parts.corners.lines.push_back(lines_->number());
}

/// From this field on. Returns the field behind them.
std::size_t Parser::read_weights_of_corner(std::vector<Weight>& weights, std::size_t first) {
  constexpr const char* expected = "the number of a corner's weights, and that many indices and rational numbers";
  if (first >= fields_.size()) throw wrong(expected);
  std::size_t left = count(first, expected), field = first + 1;
  if (left > (fields_.size() - field) / 2) throw wrong(expected);
  for (; left > 0; --left, field += 2) weights.push_back({index_number(fields_[field]), rational(fields_[field + 1])});
  return field;
}

void Parser::read_rates(Part<std::vector<PatchParts::Rate>>& part) {
  constexpr const char* expected = "a rate: v and w, six rational numbers, a sign and the root, a rational number";
  read_rows(part, header("rates"), 8, expected, [this](auto& rates) {
    rates.push_back({point(0), point(3), integer(fields_[6], expected), rational(fields_[7])});
  });
}

}  // namespace fathom_check
