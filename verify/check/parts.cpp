// SPDX-License-Identifier: Apache-2.0
// The parser, part by part. Each part begins on the line at hand; when it has been read, the line
// behind it is at hand.
#include <algorithm>
#include <utility>

#include "limits.hpp"
#include "parser.hpp"

namespace fathom_check {

namespace {

bool is_id(std::string_view text) {
  const auto hex = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); };
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] <= ' ' || text[i] > '~') return false;
    if (text[i] != '%') continue;
    if (i + 2 >= text.size() || !hex(text[i + 1]) || !hex(text[i + 2])) return false;
    i += 2;
  }
  return !text.empty();
}

bool is_header(std::string_view line) {
  constexpr std::string_view start = "fathom-certificate ";
  return line.size() == start.size() + 1 && line.substr(0, start.size()) == start && line.back() >= '1' &&
         line.back() <= '6';
}

}  // namespace

void Parser::read(Certificate& result) {
  bytes_ = numbers_ = 0;
  counts_.clear();
  integers_ = &result.integers;
  const bool whole = lines_->kind() == Lines::Kind::whole;
  if (!whole || !is_header(lines_->text())) {
    const Fault fault = wrong("'fathom-certificate' and a format: 1 to 6");
    if (at_header()) lines_->advance();  // it is this certificate's own
    throw fault;
  }
  result.format = lines_->text().back() - '0';
  bytes_ += lines_->text().size();
  advance();
  if (at("id")) read_id(result);
  height_ = nullptr;
  if (at("plane") && result.format != 4 && result.format != 6) read_plane(result);
  switch (result.format) {
    case 3: read_unions(result); break;
    case 4: read_convex(result), read_patches(result.of_patches); break;
    case 5: read_solids(result); break;
    case 6: read_motions(result); break;
    default: read_convex(result);
  }
  read_footer(result);
  require_limits(result, lines_->number(), limits_);
}

void Parser::read_convex(Certificate& result) {
  read_body(result.a, "a", result.format);
  read_body(result.b, "b", result.format);
  read_claim(result);
  read_directions(result);
  const bool shape_a = result.a.core == Body::Core::shape, shape_b = result.b.core == Body::Core::shape;
  if (shape_a) read_heights(result.a, "a");
  if (shape_b) read_heights(result.b, "b");
  if (shape_a) read_inner(result.a, "a");
  if (shape_b) read_inner(result.b, "b");
  read_proof(result);
}

void Parser::read_id(Certificate& result) {
  constexpr std::size_t prefix = 3;
  constexpr const char* expected = "an id in printable ASCII; blanks, other bytes and % as %XX";
  require_line(expected);
  const std::string_view text = lines_->text().substr(std::min(prefix, lines_->text().size()));
  if (!is_id(text)) throw wrong(expected);
  result.id = text;
  advance();
}

void Parser::read_plane(Certificate& result) {
  constexpr const char* expected = "'plane' and a height, a rational number";
  require_line(expected);
  demand(2, expected);
  result.raising = {rational(fields_[1]), lines_->number()};
  height_ = &result.raising->height;
  result.a.levels = result.format < 3 ? 1 : 2;
  result.b.levels = 2;
  advance();
}

/// What the line at hand, which must announce this part, says of its number.
std::size_t Parser::header(const std::string& word, const char* number, std::size_t fields) {
  const std::string expected = "'" + word + "' and " + number;
  require_line(expected.c_str());
  demand(fields, expected.c_str());
  if (fields_[0] != word) throw wrong(expected);
  counts_.push_back(count(1, expected.c_str()));
  return counts_.back();
}

RationalPoint Parser::point(std::size_t first) const {
  return {rational(fields_[first]), rational(fields_[first + 1]), rational(fields_[first + 2])};
}

void Parser::read_body(Body& body, const std::string& name, int format) {
  body.line = lines_->number();
  if (format == 2 && height_ == nullptr && at("shape_" + name)) {
    body.core = Body::Core::shape;
    for (std::size_t left = header("shape_" + name, "the number of its terms"); left > 0; --left)
      body.terms.push_back(read_term());
    advance();
  } else if (is_of_bodies(format) && at("halfspace_" + name)) {
    read_half_space(body);
  } else {
    read_points(body, name);
  }
  if (is_of_bodies(format) && at("radius_" + name)) {
    constexpr const char* expected = "a radius: one rational number";
    require_line(expected);
    demand(2, expected);
    body.radius = rational(fields_[1]);
    advance();
  }
}

void Parser::read_half_space(Body& body) {
  const bool plane = height_ != nullptr;
  const char* const expected = plane ? "a half-plane: its normal and its offset, three rational numbers"
                                     : "a half-space: its normal and its offset, four rational numbers";
  require_line(expected);
  demand(plane ? 4 : 5, expected);
  body.core = Body::Core::half_space;
  body.normal = plane ? RationalPoint{rational(fields_[1]), rational(fields_[2]), {}} : point(1);
  body.offset = rational(fields_.back());
  advance();
}

void Parser::read_points(Body& body, const std::string& name) {
  const std::size_t count = header(name, "the number of its points"), first = body.points.items.size();
  if (height_ == nullptr) {
    return read_rows(body.points, count, 3, "a point: three rational numbers",
                     [this](auto& points) { points.push_back(point(0)); });
  }
  Rational level;
  if (body.levels > 1) level = {integers_->keep(-height_->num.value()), height_->den};
  read_rows(body.points, count, 2, "a point of the plane: two rational numbers", [&](auto& points) {
    points.push_back({rational(fields_[0]), rational(fields_[1]), level});
  });
  if (body.levels == 1) return;
  auto& [points, lines, line] = body.points;
  for (std::size_t k = first, end = points.size(); k < end; ++k) {
    points.push_back({points[k].x, points[k].y, *height_});
    lines.push_back(lines[k]);
  }
}

/// On the line behind the one at hand; the last of its atoms is at hand afterwards.
Term Parser::read_term() {
  constexpr const char* expected = "an atom: 'point', 'disc' or 'ball', and its vectors, three rational numbers each";
  Term term;
  advance();
  std::size_t left = header("term", "the number of its atoms");
  count_numbers(1);
  for (; left > 0; --left) {
    next(expected);
    const std::size_t vectors = fields_[0] == "point" ? 1 : fields_[0] == "disc" ? 3 : fields_[0] == "ball" ? 4 : 0;
    if (vectors == 0) throw wrong(expected);
    demand(1 + 3 * vectors, expected);
    count_numbers(3 * vectors);
    Atom atom;
    for (std::size_t k = 0; k < vectors; ++k) atom.push_back(point(1 + 3 * k));
    term.push_back(std::move(atom));
  }
  return term;
}

void Parser::read_claim(Certificate& result) {
  const bool shapes = result.a.core == Body::Core::shape || result.b.core == Body::Core::shape;
  const char* expected = "'claim depth Q', 'claim touching', 'claim apart Q' or 'claim signed_bounds LO HI'";
  if (result.format == 1) expected = "'claim depth Q', 'claim bounds LO HI', 'claim touching' or 'claim disjoint'";
  if (shapes) expected = "'claim signed_bounds LO HI'";
  if (result.format > 2 || (result.format == 2 && height_ != nullptr))
    expected = "'claim depth Q', 'claim touching' or 'claim apart Q'";
  if (result.claim == Claim::solid) expected = "'claim solid'";
  if (result.format == 6) expected = "'claim apart', 'claim grazing' or 'claim contact T'";
  require_line(expected);
  result.claim_line = lines_->number();
  if (fields_.size() < 2 || fields_[0] != "claim") throw wrong(expected);
  const auto is = [&](std::string_view word, std::size_t numbers, bool there) {
    return there && fields_[1] == word && fields_.size() == 2 + numbers;
  };
  const bool first = result.format == 1, bounds = result.format == 2 && height_ == nullptr,
             solid = result.claim == Claim::solid, moving = result.format == 6, still = !solid && !moving;
  if (is("solid", 0, solid)) {
    result.claim = Claim::solid;
  } else if (is("depth", 1, !shapes && still)) {
    result.claim = Claim::depth;
  } else if (is("touching", 0, !shapes && still)) {
    result.claim = Claim::touching;
  } else if (is("bounds", 2, first)) {
    result.claim = Claim::bounds;
  } else if (is("disjoint", 0, first)) {
    result.claim = Claim::disjoint;
  } else if (is("apart", 1, !first && !shapes && still) || is("apart", 0, moving)) {
    result.claim = Claim::apart;
  } else if (is("grazing", 0, moving)) {
    result.claim = Claim::grazing;
  } else if (is("contact", 1, moving)) {
    result.claim = Claim::contact;
  } else if (is("signed_bounds", 2, bounds)) {
    result.claim = Claim::signed_bounds;
  } else {
    throw wrong(expected);
  }
  if (fields_.size() > 2) {
    result.low = rational(fields_[2]);
    result.high = fields_.size() > 3 ? rational(fields_[3]) : result.low;
  }
  advance();
}

void Parser::read_directions(Certificate& result) {
  constexpr const char* number = "their number, and 'some' or 'all'";
  const std::size_t lines = header("directions", number, 3);
  if (fields_[2] != "some" && fields_[2] != "all") throw wrong(std::string("'directions' and ") + number);
  result.all = fields_[2] == "all";
  read_vectors(result.directions, lines);
}

void Parser::read_vectors(Part<std::vector<Vector>>& part, std::size_t lines) {
  constexpr const char* expected = "a direction: three integers";
  read_rows(part, lines, 3, expected, [this](auto& vectors) {
    vectors.push_back({integer(fields_[0], expected), integer(fields_[1], expected), integer(fields_[2], expected)});
  });
}

void Parser::read_heights(Body& body, const std::string& name) {
  read_rows(body.heights, header("heights_" + name), 1, "a height: a rational number",
            [this](auto& heights) { heights.push_back(rational(fields_[0])); });
}

void Parser::read_inner(Body& body, const std::string& name) {
  constexpr std::size_t fields = 4;
  read_rows(body.inner, header("inner_" + name), fields * body.terms.size(),
            "an inner point: for each term the index of an atom, and three rational numbers", [this](auto& places) {
              for (std::size_t k = 0; k < fields_.size(); k += fields)
                places.push_back({index_number(fields_[k]), point(k + 1)});
            });
}

void Parser::read_pairs(Part<std::vector<Pair>>& part, const char* word) {
  read_rows(part, header(word), 2, "an index into b and one into a", [this](auto& pairs) {
    pairs.push_back({index_number(fields_[0]), index_number(fields_[1])});
  });
}

void Parser::read_facets(Part<Facets>& part, const char* word) {
  constexpr const char* facet = "a facet: the number of its corners, and that many indices of vertices";
  part.line = lines_->number();
  for (std::size_t left = header(word); left > 0; --left) {
    next(facet);
    if (count(0, facet) != fields_.size() - 1) throw wrong(facet);
    count_numbers(fields_.size());
    for (std::size_t k = 1; k < fields_.size(); ++k) part.items.corners.push_back(index_number(fields_[k]));
    part.items.ends.push_back(part.items.corners.size());
    part.lines.push_back(lines_->number());
  }
  advance();
}

void Parser::read_weights(Part<std::vector<Weight>>& part, const char* word) {
  read_rows(part, header(word), 2, "a weight: an index and a rational number", [this](auto& weights) {
    weights.push_back({index_number(fields_[0]), rational(fields_[1])});
  });
}

void Parser::read_proof(Certificate& result) {
  if (has_half_space(result) || result.claim == Claim::disjoint) return;
  const bool facets = result.claim == Claim::depth || result.claim == Claim::bounds;
  result.proof = facets || (result.claim == Claim::signed_bounds && at("vertices")) ? Proof::facets : Proof::weights;
  if (result.proof == Proof::facets) {
    read_pairs(result.vertices, "vertices");
    read_facets(result.facets);
  } else {
    read_weights(result.weights_a, "weights_a");
    read_weights(result.weights_b, "weights_b");
  }
  result.has_cone = is_of_bodies(result.format) && result.claim == Claim::touching && at("lineality");
  if (!result.has_cone) return;
  read_vectors(result.lineality, header("lineality"));
  read_vectors(result.rays, header("rays"));
  read_pairs(result.differences, "differences");
}

void Parser::read_footer(const Certificate& certificate) {
  constexpr std::size_t of_format_1 = 5;
  if (certificate.format == 1) counts_.resize(of_format_1);  // two more are 0 where nothing follows the directions
  const std::string expected = "'end' and " + std::to_string(counts_.size()) + " counts";
  require_line(expected.c_str());
  demand(1 + counts_.size(), expected.c_str());
  if (fields_[0] != "end") throw wrong(expected);
  for (std::size_t i = 0; i < counts_.size(); ++i)
    if (count(i + 1, expected.c_str()) != counts_[i]) throw wrong("the counts of the parts again");
}

// Unions and solids.

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
    if (height_ != nullptr || at(std::string("pieces_") + name)) read_pieces(*body, name);
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
    InnerPolytope polytope{index_number(fields_[1]),
                           index_number(fields_[2]),
                           lines_->number(),
                           result.vertices.items.size(),
                           result.facets.items.size(),
                           {},
                           {}};
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

// Format 4.

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

// Motions.

void Parser::read_motions(Certificate& result) {
  for (const auto& [name, body] : {std::pair{"a", &result.a}, std::pair{"b", &result.b}}) {
    body->line = lines_->number();
    read_points(*body, name);
  }
  MotionParts& parts = result.of_motions;
  read_motion(parts.motions[0], "motion_a");
  read_motion(parts.motions[1], "motion_b");
  read_claim(result);
  parts.line = lines_->number();
  std::size_t left = header("pieces");
  for (advance(); left > 0; --left) read_piece_of_motion(parts);
  if (result.claim != Claim::contact) return;
  read_weights(result.weights_a, "weights_a");
  read_weights(result.weights_b, "weights_b");
}

void Parser::read_motion(MotionParts::Motion& motion, const char* word) {
  const std::string expected = "'" + std::string(word) + "', alone on its line";
  require_line(expected.c_str());
  demand(1, expected.c_str());
  if (fields_[0] != word) throw wrong(expected);
  for (MotionParts::Quaternion& turn : motion.turns) {
    row(4, "a quaternion: four rational numbers");
    turn = {rational(fields_[0]), point(1)};
  }
  for (RationalPoint& place : motion.places) {
    row(3, "a place: three rational numbers");
    place = point(0);
  }
  advance();
}

void Parser::read_piece_of_motion(MotionParts& parts) {
  using Kind = MotionParts::Piece::Kind;
  constexpr const char* expected =
      "a piece: its end; 'a' or 'b' and three integers, 'ab' and six, or 'near' and a rational";
  require_line(expected);
  const std::string_view word = fields_.size() < 2 ? "" : fields_[1];
  const bool edges = word == "ab", near = word == "near";
  if (!edges && !near && word != "a" && word != "b") throw wrong(expected);
  demand(near ? 3 : edges ? 8 : 5, expected);
  count_numbers(fields_.size() - 1);
  MotionParts::Piece piece{near          ? Kind::near
                           : edges       ? Kind::of_edges
                           : word == "a" ? Kind::of_a
                                         : Kind::of_b,
                           lines_->number(),
                           rational(fields_[0]),
                           {},
                           {},
                           {},
                           {}};
  const auto vector = [this](std::size_t k) -> Vector {
    return {integer(fields_[k], expected), integer(fields_[k + 1], expected), integer(fields_[k + 2], expected)};
  };
  if (near) piece.delta = rational(fields_[2]);
  else piece.n = vector(2);
  if (edges) piece.g = vector(5);
  advance();
  if (near) {
    read_weights(piece.weights[0], "weights_a");
    read_weights(piece.weights[1], "weights_b");
  }
  parts.pieces.push_back(std::move(piece));
}

}  // namespace fathom_check
