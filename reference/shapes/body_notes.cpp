// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/shapes/body_notes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "fathom/numbers.hpp"
#include "reference/files/piece_files.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/text/json.hpp"

namespace fathom::shapes {
namespace {

/// By how many percent the hull is larger, rounded down to two digits.
std::string excess_text(const mpq_class& ratio) {
  const mpq_class percent = 100 * (ratio - 1);
  return enclose_root(mpq_class(percent * percent), 2).low;
}

/// What could be said of the mesh is said.
bool is_told(const polytope::MeshConvexity& found, bool open_too) { return found.dents || (open_too && found.open); }

using Lengths = std::array<double, 3>;

constexpr double remarkable = 100;  // times as large

// A difference of two numbers in binary64 is rounded once, as is wanted.
Lengths extent_of(std::span<const std::array<double, 3>> points) {
  std::array<double, 3> low = points.front(), high = low;
  for (const std::array<double, 3>& p : points)
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  return {high[0] - low[0], high[1] - low[1], high[2] - low[2]};
}

const mpq_class& component(const Point& p, std::size_t i) { return i == 0 ? p.x : i == 1 ? p.y : p.z; }

Lengths extent_of(const std::vector<Point>& points) {
  Lengths result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto less = [i](const Point& p, const Point& q) { return component(p, i) < component(q, i); };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
    result[i] = round_binary64(mpq_class(component(*high, i) - component(*low, i)));
  }
  return result;
}

/// How far the atom reaches from its centre along an axis: at least so much as it does.
mpq_class reach(const Atom& atom, std::size_t i) {
  mpq_class squared;
  for (const Point& axis : atom.axes) squared += component(axis, i) * component(axis, i);
  const double root = root_binary64(squared, Rounding::ru);
  return std::isfinite(root) ? exact_value(root) : mpq_class(squared + 1);
}

Lengths extent_of(const Shape& shape, const std::vector<Term>& terms) {
  const auto is_round = [](const Term& term) {
    return std::ranges::any_of(term.atoms, [](const Atom& atom) { return !atom.axes.empty(); });
  };
  const Rounding mode = std::ranges::any_of(terms, is_round) ? Rounding::ru : Rounding::rn;
  Lengths result{};
  for (std::size_t i = 0; i < 3; ++i) {
    mpq_class length = 2 * shape.radius;
    for (const Term& term : terms) {
      std::vector<mpq_class> ends;
      for (const Atom& atom : term.atoms)
        for (const int side : {-1, 1}) ends.emplace_back(component(atom.center, i) + side * reach(atom, i));
      const auto [low, high] = std::minmax_element(ends.begin(), ends.end());
      length += *high - *low;
    }
    result[i] = round_binary64(length, mode);
  }
  return result;
}

/// A length, or what it is more than if it is beyond the numbers.
std::string number_text(double length) {
  return std::isfinite(length) ? fmt::format("{:.4g}", length)
                               : fmt::format("over {:.4g}", std::numeric_limits<double>::max());
}

std::string text_of(const std::optional<Lengths>& lengths, bool plane) {
  if (!lengths) return plane ? "a half-plane" : "a half-space";
  if (plane) return fmt::format("{} x {}", number_text((*lengths)[0]), number_text((*lengths)[1]));
  return fmt::format("{} x {} x {}", number_text((*lengths)[0]), number_text((*lengths)[1]),
                     number_text((*lengths)[2]));
}

}  // namespace

std::optional<Lengths> extent(const Body& body) {
  if (body.pieces) return extent_of(polytope::joined(*body.pieces));
  if (!body.shape)
    return body.points.in_binary64() ? extent_of(body.points.binary64()) : extent_of(body.points.exact());
  const auto* const terms = std::get_if<std::vector<Term>>(&body.shape->core);
  return terms ? std::optional(extent_of(*body.shape, *terms)) : std::nullopt;
}

BodySizes sizes_of(const Body& a, const Body& b) { return {extent(a), extent(b), false, a.dimension == 2}; }

BodySizes sizes_of(const Body& a) { return {extent(a), std::nullopt, true, a.dimension == 2}; }

std::string sizes_text(const BodySizes& sizes) {
  return "A " + text_of(sizes.a, sizes.plane) + (sizes.one_body ? "" : ", B " + text_of(sizes.b, sizes.plane));
}

std::optional<std::string> sizes_note(const BodySizes& sizes) {
  if (!sizes.a || !sizes.b) return std::nullopt;
  const double of_a = std::ranges::max(*sizes.a), of_b = std::ranges::max(*sizes.b);
  const bool a_is_large = of_a > of_b;
  const double large = std::max(of_a, of_b),
               ratio = std::min(large, std::numeric_limits<double>::max()) / std::min(of_a, of_b);
  if (of_a == 0 || of_b == 0 || !(ratio > remarkable)) return std::nullopt;
  const std::string times =
      std::isfinite(large) || std::isinf(ratio) ? number_text(ratio) : "over " + number_text(ratio);
  return fmt::format("{} is {} times as large as {} (sizes: {}): are both in the same unit?", a_is_large ? 'A' : 'B',
                     times, a_is_large ? 'B' : 'A', sizes_text(sizes));
}

std::optional<polytope::MeshConvexity> hull_fact(const Body& body) {
  if (!body.faces || body.shape || body.pieces) return std::nullopt;
  polytope::MeshConvexity found = polytope::mesh_convexity(body.points, *body.faces);
  return found.tried ? std::optional(std::move(found)) : std::nullopt;
}

std::optional<DentedPieces> dented_pieces(const Body& body) {
  if (!body.pieces) {
    std::optional<polytope::MeshConvexity> fact = hull_fact(body);
    if (!fact) return std::nullopt;
    return is_told(*fact, true) ? DentedPieces{{.found = *std::move(fact)}} : DentedPieces{};
  }
  if (!body.faces) return std::nullopt;
  const MeshFaces& all = *body.faces;
  const std::size_t count = all.ends.empty() ? all.corners.size() / 3 : all.ends.size();
  DentedPieces found;
  std::size_t face = 0, begin = 0, before = 0;  // `before`: points of the pieces before
  for (std::size_t i = 0; i < body.pieces->size(); ++i) {
    const std::vector<Point>& points = (*body.pieces)[i];
    MeshFaces faces;
    const auto is_its = [&] {
      return (!all.ends.empty() && all.ends[face] == begin) || all.corners[begin] < before + points.size();
    };
    for (; face < count && is_its(); ++face) {
      const std::size_t end = all.ends.empty() ? begin + 3 : all.ends[face];
      for (; begin < end; ++begin) faces.corners.push_back(static_cast<std::uint32_t>(all.corners[begin] - before));
      faces.ends.push_back(static_cast<std::uint32_t>(faces.corners.size()));
    }
    before += points.size();
    if (faces.ends.empty()) continue;
    polytope::MeshConvexity compared = polytope::mesh_convexity(points, faces);
    if (is_told(compared, true)) found.push_back({i, files::piece_name(body, i), std::move(compared)});
  }
  return found;
}

std::string dents_of(std::string_view body, const polytope::MeshConvexity& found) {
  if (!is_told(found, true)) return "";
  if (!found.dents) return fmt::format("{} is open", body);
  std::string text = fmt::format("{} is {}not convex", body, found.open ? "open and " : "");
  const polytope::Dents& dents = *found.dents;
  if (dents.volume_ratio) text += fmt::format(", its hull is {} % larger", excess_text(*dents.volume_ratio));
  if (dents.deepest && dents.deepest->squared_depth > 0)
    text += fmt::format(", its deepest point {:.3g} inside the hull", root_binary64(dents.deepest->squared_depth));
  return text;
}

std::string dents_text(std::string_view body, const DentedPieces& pieces) {
  constexpr std::size_t most = 8;
  std::vector<std::string> texts;
  for (const DentedPiece& piece : pieces) {
    if (texts.size() == most) {
      texts.push_back(fmt::format("{} more of its pieces likewise", pieces.size() - most));
      break;
    }
    const std::string name = piece.name.empty() ? "" : fmt::format(" ({})", text::Json(piece.name).text());
    texts.push_back(dents_of(fmt::format("piece {} of {}{}", piece.piece, body, name), piece.found));
  }
  return fmt::format("{}", fmt::join(texts, "; "));
}

std::string dents_text(const HullFacts& facts, bool open_too) {
  std::vector<std::string> texts;
  const auto add = [&](const char* body, const auto& fact, const std::optional<DentedPieces>& pieces) {
    if (fact && is_told(*fact, open_too)) texts.push_back(dents_of(body, *fact));
    if (!pieces) return;
    DentedPieces told = *pieces;
    std::erase_if(told, [&](const DentedPiece& piece) { return !is_told(piece.found, open_too); });
    if (!told.empty()) texts.push_back(dents_text(body, told));
  };
  add("A", facts.a, facts.pieces_a);
  add("B", facts.b, facts.pieces_b);
  return fmt::format("{}", fmt::join(texts, "; "));
}

std::string about_hulls(const HullFacts& facts, bool width) {
  const std::string dents = dents_text(facts);
  if (dents.empty()) return "";
  if (width) return "about the convex hull, which is as wide: " + dents;
  const auto is_solid = [](const polytope::MeshConvexity& mesh) { return mesh.dents && mesh.dents->volume_ratio; };
  const auto one = [&](const auto& mesh) { return mesh && is_solid(*mesh); };
  const auto any = [&](const std::optional<DentedPieces>& pieces) {
    return pieces && std::ranges::any_of(*pieces, is_solid, &DentedPiece::found);
  };
  return "about the convex hulls: " + dents +
         (one(facts.a) || one(facts.b)                 ? " (depth --solid asks about the mesh itself)"
          : any(facts.pieces_a) || any(facts.pieces_b) ? " (depth --solid asks about whole meshes)"
                                                       : "");
}

}  // namespace fathom::shapes
