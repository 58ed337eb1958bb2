// SPDX-License-Identifier: Apache-2.0
// The parser's parts of unions and solids. Each begins on the line at hand; when it has been read,
// the line behind it is at hand.
#include <utility>

#include "parser.hpp"

namespace fathom_check {

void Parser::read_unions(Certificate& result) {
  read_pieces(result.a, "a");
  read_pieces(result.b, "b");
  read_proof_of_unions(result);
}

void Parser::read_proof_of_unions(Certificate& result) {
  read_claim(result);
  if (result.claim == Claim::depth) {
    read_optima(result);
    read_polytopes(result);
    read_tree(result.of_unions.tree);
  } else {
    read_apart(result);
    read_nearest(result);
  }
}

/// One solid, or two bodies that are solids or unions.
void Parser::read_solids(Certificate& result) {
  for (const auto& [name, body] : {std::pair{"a", &result.a}, std::pair{"b", &result.b}}) {
    if (at(std::string("pieces_") + name)) read_pieces(*body, name);
    else read_solid(*body, name);
    const bool is_all = body == &result.a && body->core == Body::Core::solid && at("claim");
    if (!is_all) continue;
    result.b.core = Body::Core::none;
    result.claim = Claim::solid;
    return read_claim(result);
  }
  read_proof_of_unions(result);
}

void Parser::read_solid(Body& body, const std::string& name) {
  body.core = Body::Core::solid;
  body.line = lines_->number();
  read_rows(body.points, header("solid_" + name, "the number of its points"), 3, "a point: three rational numbers",
            [this](auto& points) { points.push_back(point(0)); });
  SolidParts& parts = body.solid;
  read_rows(parts.mesh, header("mesh", "the number of its triangles"), 3, "a triangle: three indices of points",
            [this](auto& mesh) {
              mesh.push_back({index_number(fields_[0]), index_number(fields_[1]), index_number(fields_[2])});
            });
  parts.line = lines_->number();
  std::size_t left = header("pieces");
  for (advance(); left > 0; --left) {
    count_numbers(1);
    read_facets(parts.facets, "piece");
    parts.pieces.push_back({parts.facets.items.size(), parts.facets.line});
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

/// What shows that a translation is not in the interior of any difference of pieces.
void Parser::read_apart(Certificate& result) {
  UnionParts& parts = result.of_unions;
  const std::size_t line = lines_->number();
  if (result.format == 3) {
    read_vectors(parts.separations, header("separations"));
    parts.separation_lists.push_back({parts.separations.items.size(), line});
    return;
  }
  constexpr const char* expected = "a block: 'a', 'b' or three integers";
  for (std::size_t left = header("apart", "the number of its blocks"); left > 0; --left) {
    next(expected);
    Block block{fields_[0] == "a" ? Block::Kind::splits_a : Block::Kind::splits_b, {}};
    if (fields_.size() > 1 || (fields_[0] != "a" && fields_[0] != "b")) {
      demand(3, expected);
      block = {Block::Kind::vector,
               {integer(fields_[0], expected), integer(fields_[1], expected), integer(fields_[2], expected)}};
    }
    count_numbers(fields_.size());
    parts.blocks.items.push_back(block);
    parts.blocks.lines.push_back(lines_->number());
  }
  advance();
  parts.separation_lists.push_back({parts.blocks.items.size(), line});
}

void Parser::read_optima(Certificate& result) {
  constexpr const char* expected = "'optimum' and a translation: three rational numbers";
  UnionParts& parts = result.of_unions;
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
    read_apart(result);
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
