// SPDX-License-Identifier: Apache-2.0
// The parser's parts of unions. Each begins on the line at hand; when it has been read, the line
// behind it is at hand.
#include "parser.hpp"

namespace fathom_check {

void Parser::read_unions(Certificate& result) {
  read_pieces(result.a, "a");
  read_pieces(result.b, "b");
  read_claim(result);
  if (result.claim == Claim::depth) {
    read_optima(result.of_unions);
    read_polytopes(result);
    read_tree(result.of_unions.tree);
  } else {
    read_separations(result.of_unions);
    read_nearest(result);
  }
}

void Parser::read_pieces(Body& body, const std::string& name) {
  body.core = Body::Core::pieces;
  body.line = lines_->number();
  std::size_t left = header("pieces_" + name, "the number of its pieces");
  for (advance(); left > 0; --left) {
    const std::size_t line = lines_->number();
    count_numbers(1);
    read_points(body, name);
    body.pieces.push_back({body.points.items.size(), line});
  }
}

void Parser::read_separations(UnionParts& parts) {
  const std::size_t line = lines_->number();
  read_vectors(parts.separations, header("separations"));
  parts.separation_lists.push_back({parts.separations.items.size(), line});
}

void Parser::read_optima(UnionParts& parts) {
  constexpr const char* expected = "'optimum' and a translation: three rational numbers";
  parts.optima.line = lines_->number();
  std::size_t left = header("optima");
  for (advance(); left > 0; --left) {
    require_line(expected);
    demand(4, expected);
    if (fields_[0] != "optimum") throw wrong(expected);
    parts.optima.items.push_back(point(1));
    parts.optima.lines.push_back(lines_->number());
    count_numbers(3);
    advance();
    read_separations(parts);
  }
}

void Parser::read_polytopes(Certificate& result) {
  constexpr const char* expected = "'polytope', a piece of a and a piece of b";
  std::size_t left = header("polytopes");
  for (advance(); left > 0; --left) {
    require_line(expected);
    demand(3, expected);
    if (fields_[0] != "polytope") throw wrong(expected);
    InnerPolytope polytope{index_number(fields_[1]), index_number(fields_[2]), lines_->number(), {}, {}};
    count_numbers(2);
    advance();
    read_pairs(result.vertices, "vertices");
    polytope.vertices = {result.vertices.items.size(), result.vertices.line};
    read_facets(result.facets);
    polytope.facets = {result.facets.items.size(), result.facets.line};
    result.of_unions.polytopes.push_back(polytope);
  }
}

void Parser::read_tree(Part<Nodes>& part) {
  constexpr const char* expected = "a node: 'split', a polytope and facets of it, or 'leaf' and constraints";
  part.line = lines_->number();
  for (std::size_t left = header("tree", "the number of its nodes"); left > 0; --left) {
    next(expected);
    const bool split = fields_[0] == "split";
    if (split ? fields_.size() < 2 : fields_[0] != "leaf") throw wrong(expected);
    count_numbers(fields_.size());
    for (std::size_t k = 1; k < fields_.size(); ++k) part.items.indices.push_back(index_number(fields_[k]));
    part.items.ends.push_back(part.items.indices.size());
    part.items.splits.push_back(split);
    part.lines.push_back(lines_->number());
  }
  advance();
}

void Parser::read_nearest(Certificate& result) {
  constexpr const char* expected = "'nearest', a piece of a and a piece of b";
  require_line(expected);
  demand(3, expected);
  if (fields_[0] != "nearest") throw wrong(expected);
  UnionParts& parts = result.of_unions;
  parts.nearest_line = lines_->number();
  parts.nearest_a = index_number(fields_[1]);
  parts.nearest_b = index_number(fields_[2]);
  count_numbers(2);
  advance();
  read_weights(result.weights_a, "weights_a");
  read_weights(result.weights_b, "weights_b");
}

}  // namespace fathom_check
