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
         line.back() <= '5';
}

}  // namespace

void Parser::read(Certificate& result) {
  bytes_ = numbers_ = 0;
  counts_.clear();
  integers_ = &result.integers;
  const bool whole = lines_->kind() == Lines::Kind::whole;
  if (!whole || !is_header(lines_->text())) {
    const Fault fault = wrong("'fathom-certificate' and a format: 1 to 5");
    if (at_header()) lines_->advance();  // it is this certificate's own
    throw fault;
  }
  result.format = lines_->text().back() - '0';
  bytes_ += lines_->text().size();
  advance();
  if (at("id")) read_id(result);
  switch (result.format) {
    case 3: read_unions(result); break;
    case 4: read_convex(result), read_patches(result.of_patches); break;
    case 5: read_solids(result); break;
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
  if (format == 2 && at("shape_" + name)) {
    body.core = Body::Core::shape;
    for (std::size_t left = header("shape_" + name, "the number of its terms"); left > 0; --left)
      body.terms.push_back(read_term());
    advance();
  } else if (is_of_bodies(format) && at("halfspace_" + name)) {
    constexpr const char* expected = "a half-space: its normal and its offset, four rational numbers";
    require_line(expected);
    demand(5, expected);
    body.core = Body::Core::half_space;
    body.normal = point(1);
    body.offset = rational(fields_[4]);
    advance();
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

void Parser::read_points(Body& body, const std::string& name) {
  read_rows(body.points, header(name, "the number of its points"), 3, "a point: three rational numbers",
            [this](auto& points) { points.push_back(point(0)); });
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
  if (result.format > 2) expected = "'claim depth Q', 'claim touching' or 'claim apart Q'";
  if (result.claim == Claim::solid) expected = "'claim solid'";
  require_line(expected);
  result.claim_line = lines_->number();
  if (fields_.size() < 2 || fields_[0] != "claim") throw wrong(expected);
  const auto is = [&](std::string_view word, std::size_t numbers, bool there) {
    return there && fields_[1] == word && fields_.size() == 2 + numbers;
  };
  const bool first = result.format == 1, second = result.format == 2, solid = result.claim == Claim::solid;
  if (is("solid", 0, solid)) {
    result.claim = Claim::solid;
  } else if (is("depth", 1, !shapes && !solid)) {
    result.claim = Claim::depth;
  } else if (is("touching", 0, !shapes && !solid)) {
    result.claim = Claim::touching;
  } else if (is("bounds", 2, first)) {
    result.claim = Claim::bounds;
  } else if (is("disjoint", 0, first)) {
    result.claim = Claim::disjoint;
  } else if (is("apart", 1, !first && !shapes && !solid)) {
    result.claim = Claim::apart;
  } else if (is("signed_bounds", 2, second)) {
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

}  // namespace fathom_check
