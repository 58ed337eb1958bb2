// SPDX-License-Identifier: GPL-3.0-or-later
// The facts of a page, from the JSON of an answer: values as text, then facts of convex bodies,
// then those of unions. Numbers are copied unchanged.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fathom/numbers.hpp"
#include "reference/rounded/coordinates.hpp"
#include "view/page/page.hpp"
#include "view/picture/markup.hpp"

namespace fathom::page {
namespace {

using picture::FactList, picture::folded, picture::Table;

constexpr std::size_t longest = 4000;  // characters of one number; the page's data hold all of them
constexpr std::size_t most_optima = 20, most_union_optima = 50;

/// Returns the value of a field; null if the object has no such field, or is no object.
const Data& at(const Data& object, std::string_view key) {
  static const Data none;
  const Data* const found = object.find(key);
  return found ? *found : none;
}

/// Returns the items, converted by `write`: "(1, 2, 3)".
template <class Write>
std::string bracketed(const std::vector<Data>& items, Write write) {
  std::string result;
  for (const Data& item : items) result += (result.empty() ? "" : ", ") + write(item);
  return "(" + result + ")";
}

std::string plain(const Data& value) {
  if (value.is_null()) return "-";
  if (value.is_string()) return value.string();
  if (value.kind() == Data::Kind::real) return fmt::format("{}", value.number());  // 1, not 1.0, as in texts of answers
  return value.is_array() ? bracketed(value.items(), plain) : value.written(Data::Form::given).text();
}

std::string shown_text(const std::string& text) {
  if (text.size() <= longest) return picture::markup(text);
  return picture::markup(fmt::format("{}... ({} characters)", text.substr(0, longest), text.size()));
}

/// Returns points of a body, as "1, 5, 7".
std::string point_list(const Data& ids) {
  if (ids.items().empty()) return "-";
  std::string result;
  for (const Data& id : ids.items()) {
    if (result.size() > 200) return result + ", ...";
    result += (result.empty() ? "" : ", ") + shown(id);
  }
  return result;
}

bool is_word(const Data& value, std::string_view word) { return value.is_string() && value.string() == word; }
bool is(const Data& depth, std::string_view status) { return is_word(at(depth, "status"), status); }

std::string decimal(double value, const std::string& beyond) {
  return std::isfinite(value) ? fmt::format("{}", value + 0.0) : beyond;
}

mpq_class rational(const Data& value) { return mpq_class(value.string()); }

/// Returns an exact point with each coordinate rounded once: of three rationals; or, of round
/// bodies, of a point of the core and a distance along a normal. Keeps the exact text of numbers
/// beyond binary64.
std::string decimals(const Data& place) {
  if (place.is_array())
    return shown_text(bracketed(place.items(), [](const Data& coordinate) {
      return decimal(round_binary64(rational(coordinate)), coordinate.string());
    }));
  const Data &core = at(place, "core"), &normal = at(place, "normal");
  const auto integer = [&](std::size_t i) { return mpz_class(normal.at(i).string()); };
  const auto [x, y, z] =
      rounded::nearest_binary64(RoundedPoint{{rational(core.at(0)), rational(core.at(1)), rational(core.at(2))},
                                             {integer(0), integer(1), integer(2)},
                                             rational(at(place, "distance"))});
  return fmt::format("({}, {}, {})", decimal(x, "-"), decimal(y, "-"), decimal(z, "-"));
}

// ---- of convex bodies ----

/// Returns the object with the length that the answer is about.
const Data& length_of(const Data& depth) { return at(depth, is(depth, "disjoint") ? "distance" : "depth"); }

/// Returns a length as a decimal, or words for a length beyond binary64; empty if only bounds are
/// known.
std::string decimal_length(const Data& length) {
  if (at(length, "value").is_number()) return shown(at(length, "value"));
  if (const Data& rounded = at(at(length, "rounded"), "f64"); rounded.is_object())
    return is_word(at(rounded, "rn"), "inf") ? "more than the largest binary64"
                                             : "less than the least positive binary64";
  return "";
}

/// Returns the length as a decimal, or its bounds.
std::string length_text(const Data& depth) {
  if (const std::string text = decimal_length(length_of(depth)); !text.empty()) return text;
  const Data& bounds = at(depth, "signed_depth");
  const bool apart = is(depth, "disjoint");
  const auto bound = [&](std::string_view key) {
    const Data& value = at(bounds, key);
    if (!value.is_number()) return std::string("infinity");
    return apart ? shown(Data(Data::Kind::real, -value.number())) : shown(value);
  };
  return apart ? fmt::format("{} to {}", bound("high"), bound("low"))
               : fmt::format("{} to {}", bound("low"), bound("high"));
}

/// Returns its exact value and roundings, folded.
std::string exact_length(const Data& length) {
  std::string text;
  if (const Data& squared = at(length, "squared"); !squared.is_null()) text += "squared  " + shown(squared) + "\n";
  if (const Data& exact = at(length, "exact"); !exact.is_null())
    text += "exactly  " + picture::markup(exact.written(Data::Form::given).text()) + "\n";
  if (const Data& rounded = at(at(length, "rounded"), "f64"); rounded.is_object())
    text += fmt::format("binary64 {} to nearest\n         {} down\n         {} up\n", shown(at(rounded, "rn")),
                        shown(at(rounded, "rd")), shown(at(rounded, "ru")));
  return text.empty() ? "" : folded("exact", text);
}

/// Returns an exact place; for shapes it is an object in the JSON.
std::string exact_place(const Data& value) {
  if (value.is_null()) return "";
  return folded("exact", value.is_array() ? shown(value) : picture::markup(value.written(Data::Form::given).text()));
}

std::string contact_text(const Data& contact) {
  if (contact.is_null()) return "";
  return fmt::format("{}: <span class=\"key-a\">A</span> at {}, <span class=\"key-b\">B</span> at {}",
                     shown(at(contact, "kind")), point_list(at(contact, "a")), point_list(at(contact, "b")));
}

std::string size_text(const Data& lengths) {
  if (!lengths.is_array() || lengths.items().empty()) return "not finite";
  std::string result;
  for (const Data& length : lengths.items()) result += (result.empty() ? "" : " x ") + shown(length);
  return result;
}

void add_about(FactList& rows, const Data& depth) {
  const Data& sizes = at(depth, "sizes");
  if (sizes.is_object()) {
    rows.add("size_a", "size of A", size_text(at(sizes, "a")));
    rows.add("size_b", "size of B", size_text(at(sizes, "b")));
  }
  if (const Data& flat = at(depth, "flat"); flat.is_array() && !flat.items().empty())
    rows.add("flat", "no interior", flat.items().size() == 2 ? "A and B" : is_word(flat.at(0), "a") ? "A" : "B");
  rows.add("method", "method", shown(at(depth, "method")));
}

std::uint64_t optima_count(const Data& depth) {
  const Data& count = at(depth, "optima_count");
  return count.is_natural() ? count.natural() : at(depth, "optima").items().size();
}

/// Returns the generators of the cone, if there are several: the optima are then a continuum. Empty
/// if there is no cone, or it is one ray.
std::string continuum(const Data& depth) {
  const Data& cone = at(depth, "optimal_cone");
  if (!cone.is_object()) return "";
  const Data &rays = at(cone, "rays"), &lineality = at(cone, "lineality");
  if (is_word(lineality, "all")) return "every direction";
  if (is_word(lineality, "none") && rays.items().size() == 1) return "";
  std::string result;
  const auto add = [&](const std::string& part) {
    result += (result.empty() ? "all directions between " : ", ") + part;
  };
  if (is_word(lineality, "plane") && rays.items().empty())
    return "every direction orthogonal to " + shown(at(cone, "axis"));
  if (is_word(lineality, "plane")) add("those orthogonal to " + shown(at(cone, "axis")));
  if (is_word(lineality, "line")) add("both along " + shown(at(cone, "axis")));
  for (const Data& ray : rays.items()) add(shown(ray));
  return result;
}

/// Returns the number of shortest ways out, if the answer has it, as an answer by bounds does not.
std::string count_of_ways(const Data& depth) {
  if (is_word(at(depth, "method"), "enclosure")) return "";
  if (const std::string all = continuum(depth); !all.empty()) return all;
  return std::to_string(optima_count(depth));
}

std::string optima_table(const Data& depth) {
  const std::vector<Data>& optima = at(depth, "optima").items();
  if (optima.size() < 2) return "";
  Table table("Shortest ways out", {"#", "'contact", "'A's points", "'B's points", "'direction"});
  for (std::size_t i = 0; i < std::min<std::size_t>(optima.size(), most_optima); ++i) {
    const Data& contact = at(optima[i], "contact");
    table.add({std::to_string(i + 1), shown(at(contact, "kind")), point_list(at(contact, "a")),
               point_list(at(contact, "b")), shown(at(optima[i], "direction"))},
              fmt::format("data-optimum=\"{}\"", i));
  }
  const std::uint64_t count = optima_count(depth);
  const std::string more =
      count > most_optima ? fmt::format("<p class=\"soft\">{} more are not listed here.</p>\n", count - most_optima)
                          : "";
  return table.text() + more;
}

// ---- where they touch ----

constexpr std::size_t most_patches = 50, most_patch_corners = 40;

/// Returns "a polygon of 4 corners, area 0.25".
std::string patch_text(const Data& patch) {
  const std::size_t corners = at(patch, "corners").items().size();
  if (corners == 1) return "a point";
  const std::string size = decimal_length(at(patch, "size"));
  return corners == 2 ? "a segment of length " + size : fmt::format("a polygon of {} corners, area {}", corners, size);
}

/// Returns the heading of a patch: "Where they touch then" for bodies that overlap, because it is
/// about A after the way out.
std::string where_text(const Data& depth, const Data& patch) {
  std::string bodies = "they";
  if (const Data& pieces = at(patch, "pieces"); pieces.is_array())
    bodies = fmt::format("piece {} of A and piece {} of B", pieces.at(0).text(), pieces.at(1).text());
  return fmt::format("Where {} {}", bodies,
                     is(depth, "disjoint")      ? "are nearest"
                     : is(depth, "penetrating") ? "touch then"
                                                : "touch");
}

/// Returns a table of the corners, and of the points that span the faces on which they lie.
std::string patch_table(const std::string& where, const Data& patch) {
  Table table(fmt::format("{}: {}", where, patch_text(patch)), {"#", "'on A", "'A's points", "'on B", "'B's points"});
  const std::vector<Data>& corners = at(patch, "corners").items();
  for (std::size_t k = 0; k < std::min(corners.size(), most_patch_corners); ++k)
    table.add({std::to_string(k + 1), decimals(at(corners[k], "a")), point_list(at(corners[k], "on_a")),
               decimals(at(corners[k], "b")), point_list(at(corners[k], "on_b"))});
  const std::string more = corners.size() > most_patch_corners
                               ? fmt::format("<p class=\"soft\">{} more corners are not listed here.</p>\n",
                                             corners.size() - most_patch_corners)
                               : "";
  return table.text() + more + (corners.size() > 1 ? exact_length(at(patch, "size")) : "");
}

/// Adds the gradient and derivatives, which follow from the patches; or the reason why there are
/// none.
void add_first_order(FactList& rows, const Data& depth) {
  const Data& manifold = at(depth, "manifold");
  if (const Data& reason = at(manifold, "left_out"); !reason.is_null())
    rows.add("patch", is(depth, "disjoint") ? "where they are nearest" : "where they touch",
             "not told: " + shown(reason));
  if (const Data& smooth = at(manifold, "smooth"); smooth.is_boolean()) {
    std::string kinks;
    for (const Data& kink : at(manifold, "kinks").items()) kinks += (kinks.empty() ? "no: " : ", ") + shown(kink);
    rows.add("smooth", "smooth by pose", smooth.boolean() ? "yes" : kinks);
  }
  if (const Data& gradient = at(manifold, "gradient_f64"); gradient.is_object())
    rows.add("gradient", "gradient",
             fmt::format("{} by v, {} by w", shown(at(gradient, "v")), shown(at(gradient, "w"))),
             exact_place(at(manifold, "gradient")));
  if (const Data& derivative = at(depth, "derivative"); derivative.is_object())
    rows.add("derivative", "along the twist",
             at(derivative, "left_out").is_null() ? shown(at(derivative, "value"))
                                                  : "not told: " + shown(at(derivative, "left_out")));
}

/// Returns the tables of patches: those of other optima than the first are shown when the optimum
/// is chosen.
std::string patch_tables(const Data& depth) {
  std::string tables;
  const std::vector<Data>& patches = at(at(depth, "manifold"), "patches").items();
  for (std::size_t i = 0; i < std::min(patches.size(), most_patches); ++i) {
    const Data& optimum = at(patches[i], "optimum");
    const std::uint64_t way = optimum.is_natural() ? optimum.natural() : i;
    tables += fmt::format("<div data-patch=\"{}\"{}>{}</div>\n", way, way == 0 ? "" : " hidden",
                          patch_table(where_text(depth, patches[i]), patches[i]));
  }
  if (patches.size() > most_patches)
    tables += fmt::format(
        "<p class=\"soft\">The first {} such places are listed here; {} more, of further ways or pieces, are "
        "not.</p>\n",
        most_patches, patches.size() - most_patches);
  return tables;
}

// ---- of unions ----

const Data& distance_of(const Data& depth) { return at(at(depth, "apart"), "distance"); }
const std::vector<Data>& optima_of(const Data& depth) { return at(depth, "optima").items(); }

/// Returns "piece 1 of A, piece 2 of B".
std::string pieces_text(const Data& pieces) {
  return fmt::format("piece {} of <span class=\"key-a\">A</span>, piece {} of <span class=\"key-b\">B</span>",
                     pieces.at(0).text(), pieces.at(1).text());
}

std::string clearance_text(const Data& optimum) {
  const Data& clearance = at(optimum, "clearance");
  return clearance.is_boolean() && clearance.boolean() ? "yes" : "none: an exact fit";
}

void add_overlap(FactList& rows, const Data& depth) {
  const Data& first = optima_of(depth).at(0);
  rows.add("depth", "depth", decimal_length(at(depth, "depth")), exact_length(at(depth, "depth")));
  rows.add("translation", "A moves out by", decimals(at(first, "translation")), exact_place(at(first, "translation")));
  rows.add("clearance", "clearance", clearance_text(first));
  rows.add("optima", "optima", std::to_string(optima_of(depth).size()));
  const Data& deepest = at(depth, "deepest_pair");
  rows.add("deepest_pair", "deepest pair", decimal_length(at(deepest, "depth")), exact_length(at(deepest, "depth")));
  rows.add("deepest_pieces", "which is", pieces_text(at(deepest, "pieces")));
  rows.add("hulls", "hulls", decimal_length(at(depth, "hulls")), exact_length(at(depth, "hulls")));
}

void add_distance(FactList& rows, const Data& depth) {
  const Data& apart = at(depth, "apart");
  rows.add("distance", "distance", decimal_length(distance_of(depth)), exact_length(distance_of(depth)));
  rows.add("between", "between", pieces_text(at(apart, "pieces")));
  rows.add("translation", "A touches if moved by", decimals(at(apart, "translation")),
           exact_place(at(apart, "translation")));
  for (const char* body : {"a", "b"}) {
    const Data& place = at(at(apart, "witness"), body);
    rows.add(fmt::format("witness_{}", body), *body == 'a' ? "point of A" : "point of B", decimals(place),
             exact_place(place));
  }
}

}  // namespace

std::string shown(const Data& value) { return shown_text(plain(value)); }

std::string answer_sentence(const Data& depth) {
  if (is(depth, "penetrating")) return "A overlaps B by " + length_text(depth);
  if (is(depth, "touching")) return "A and B touch";
  if (is(depth, "disjoint")) return fmt::format("A and B are apart by {}", length_text(depth));
  return "The bounds leave open whether A and B overlap: signed depth " + length_text(depth);
}

bool is_of_plane(const Data& depth) {
  const Data& dimension = at(depth, "dimension");
  return dimension.is_natural() && dimension.natural() == 2;
}

std::string subtitle(const Data& depth) {
  std::string result = shown(at(depth, "id"));
  if (const Data& contact = at(depth, "contact"); contact.is_object())
    result += " &middot; contact " + shown(at(contact, "kind"));
  if (!is(depth, "penetrating") || count_of_ways(depth).empty()) return result;
  if (!continuum(depth).empty()) return result + " &middot; a continuum of shortest ways out";
  const std::uint64_t count = optima_count(depth);
  return result + " &middot; " +
         (count == 1 ? "one shortest way out" : counted(count, "shortest way out", "shortest ways out"));
}

std::string facts(const Data& depth) {
  const bool apart = is(depth, "disjoint"), overlap = is(depth, "penetrating");
  const Data& told = apart ? at(depth, "distance") : depth;
  FactList rows;
  rows.add("status", "status", shown(at(depth, "status")));
  if (is(depth, "touching")) rows.add("depth", "depth", length_text(depth));
  else if (overlap || apart)
    rows.add(apart ? "distance" : "depth", apart ? "distance" : "depth", length_text(depth),
             exact_length(length_of(depth)));
  else rows.add("signed_depth", "signed depth", length_text(depth));
  if (const Data& unit = at(told, "unit_f64"); !unit.is_null())
    rows.add("unit", overlap ? "unit normal n" : "unit direction n", shown(unit), exact_place(at(told, "direction")));
  if (const Data& way = at(told, "translation_f64"); !way.is_null() && (overlap || apart))
    rows.add("translation", overlap ? "A moves out by" : "A touches if moved by", shown(way),
             exact_place(at(told, "translation")));
  if (const std::string contact = contact_text(at(depth, "contact")); !contact.empty())
    rows.add("contact", "contact", contact);
  if (const Data& witness = at(told, "witness_f64"); witness.is_object()) {
    const Data& exact = at(told, "witness");
    rows.add("witness_a", "point of A", shown(at(witness, "a")), exact_place(at(exact, "a")));
    rows.add("witness_b", "point of B", shown(at(witness, "b")), exact_place(at(exact, "b")));
  }
  if (const std::string count = count_of_ways(depth); overlap && !count.empty()) rows.add("optima", "optima", count);
  add_about(rows, depth);
  add_first_order(rows, depth);
  return rows.list() + patch_tables(depth) + optima_table(depth);
}

// ---- unions ----

std::string union_sentence(const Data& depth) {
  if (is(depth, "penetrating")) return "A overlaps B by " + decimal_length(at(depth, "depth"));
  if (is(depth, "touching")) return "A and B touch";
  return "A and B are apart by " + decimal_length(distance_of(depth));
}

std::string union_subtitle(const Data& depth) {
  std::string result =
      shown(at(depth, "id")) + " &middot; unions of convex " + (is_of_plane(depth) ? "polygons" : "pieces");
  if (is(depth, "penetrating"))
    result += " &middot; " + counted(optima_of(depth).size(), "shortest way out", "shortest ways out");
  return result;
}

std::string union_facts(const Data& depth, const stages::UnionStages& stages) {
  FactList rows;
  rows.add("status", "status", shown(at(depth, "status")));
  if (is(depth, "penetrating")) add_overlap(rows, depth);
  else if (is(depth, "disjoint")) add_distance(rows, depth);
  else rows.add("depth", "depth", decimal_length(at(depth, "depth")));
  rows.add("pieces", "pieces", fmt::format("{} of A, {} of B", stages.a.size(), stages.b.size()));
  add_first_order(rows, depth);
  return rows.list() + patch_tables(depth);
}

std::string union_optima(const Data& depth) {
  const std::vector<Data>& optima = optima_of(depth);
  if (!is(depth, "penetrating") || optima.size() < 2) return "";
  Table table("Shortest ways out", {"#", "'A moves by", "'clearance", "pairs that touch"});
  for (std::size_t i = 0; i < std::min<std::size_t>(optima.size(), most_union_optima); ++i)
    table.add({std::to_string(i + 1), decimals(at(optima[i], "translation")), clearance_text(optima[i]),
               std::to_string(at(optima[i], "contacts").items().size())},
              fmt::format("data-optimum=\"{}\"", i));
  const std::string more =
      optima.size() > most_union_optima
          ? fmt::format("<p class=\"soft\">{} more are not listed here.</p>\n", optima.size() - most_union_optima)
          : "";
  return table.text() + more;
}

}  // namespace fathom::page
