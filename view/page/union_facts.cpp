// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the page about unions that are made of the answer: union_parts.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fathom/numbers.hpp"
#include "view/page/parts.hpp"

namespace fathom::page {
namespace {

constexpr std::size_t most_rows = 50;

bool is(const Data& depth, std::string_view status) { return at(depth, "status") == status; }
const Data& distance_of(const Data& depth) { return at(at(depth, "apart"), "distance"); }
const Data& optima_of(const Data& depth) { return at(depth, "optima"); }

/// An exact place, each coordinate rounded once; a number that binary64 does not hold as it is.
std::string decimals(const Data& place) {
  Data rounded = Data::array();
  for (const Data& coordinate : place) {
    const double value = round_binary64(mpq_class(coordinate.get<std::string>())) + 0.0;
    rounded.push_back(std::isfinite(value) ? Data(value) : coordinate);
  }
  return shown(rounded);
}

std::string exact_place(const Data& place) { return on_demand("exact", shown(place)); }

/// "piece 1 of A, piece 2 of B".
std::string pieces_text(const Data& pieces) {
  return fmt::format("piece {} of <span class=\"key-a\">A</span>, piece {} of <span class=\"key-b\">B</span>", pieces.at(0).dump(),
                     pieces.at(1).dump());
}

std::string clearance_text(const Data& optimum) { return at(optimum, "clearance") == true ? "yes" : "none: an exact fit"; }

std::string contacts_table(const Data& contacts) {
  Table table("What touches once A has moved", {"piece of A", "piece of B", "'contact", "'A's points", "'B's points"});
  for (std::size_t i = 0; i < std::min<std::size_t>(contacts.size(), most_rows); ++i) {
    const Data &pieces = at(contacts[i], "pieces"), &contact = at(contacts[i], "contact");
    table.add({pieces.at(0).dump(), pieces.at(1).dump(), shown(at(contact, "kind")), points(at(contact, "a")), points(at(contact, "b"))},
              fmt::format("data-contact=\"{}\"", i));
  }
  const std::string more = contacts.size() > most_rows
                               ? fmt::format("<p class=\"soft\">{} pairs more are not listed here.</p>\n", contacts.size() - most_rows)
                               : "";
  return table.text() + more;
}

std::string optima_table(const Data& optima) {
  if (optima.size() < 2) return "";
  Table table("Shortest ways out", {"#", "'A moves by", "'clearance", "pairs that touch"});
  for (std::size_t i = 0; i < std::min<std::size_t>(optima.size(), most_rows); ++i)
    table.add({std::to_string(i + 1), decimals(at(optima[i], "translation")), clearance_text(optima[i]),
               std::to_string(at(optima[i], "contacts").size())},
              fmt::format("data-optimum=\"{}\"", i));
  const std::string more =
      optima.size() > most_rows ? fmt::format("<p class=\"soft\">{} more are not listed here.</p>\n", optima.size() - most_rows) : "";
  return table.text() + more;
}

void add_overlap(Rows& rows, const Data& depth) {
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

void add_distance(Rows& rows, const Data& depth) {
  const Data& apart = at(depth, "apart");
  rows.add("distance", "distance", decimal_length(distance_of(depth)), exact_length(distance_of(depth)));
  rows.add("between", "between", pieces_text(at(apart, "pieces")));
  rows.add("translation", "A touches if moved by", decimals(at(apart, "translation")), exact_place(at(apart, "translation")));
  for (const char* body : {"a", "b"}) {
    const Data& place = at(at(apart, "witness"), body);
    rows.add(fmt::format("witness_{}", body), *body == 'a' ? "point of A" : "point of B", decimals(place), exact_place(place));
  }
}

}  // namespace

std::string union_sentence(const Data& depth) {
  if (is(depth, "penetrating")) return "A overlaps B by " + decimal_length(at(depth, "depth"));
  if (is(depth, "touching")) return "A and B touch";
  return "A and B are apart by " + decimal_length(distance_of(depth));
}

std::string union_subtitle(const Data& depth) {
  std::string result = shown(at(depth, "id")) + " &middot; unions of convex pieces";
  if (is(depth, "penetrating")) result += " &middot; " + counted(optima_of(depth).size(), "shortest way out", "shortest ways out");
  return result;
}

std::string union_facts(const Data& depth, const stages::UnionStages& stages) {
  Rows rows;
  rows.add("status", "status", shown(at(depth, "status")));
  if (is(depth, "penetrating")) add_overlap(rows, depth);
  else if (is(depth, "disjoint")) add_distance(rows, depth);
  else rows.add("depth", "depth", decimal_length(at(depth, "depth")));
  rows.add("pieces", "pieces", fmt::format("{} of A, {} of B", stages.a.size(), stages.b.size()));
  return rows.list();
}

std::string union_contacts(const Data& depth) {
  if (is(depth, "disjoint")) {
    const Data& apart = at(depth, "apart");
    return contacts_table(Data::array({{{"pieces", at(apart, "pieces")}, {"contact", at(apart, "contact")}}}));
  }
  return contacts_table(at(optima_of(depth).at(0), "contacts")) + (is(depth, "penetrating") ? optima_table(optima_of(depth)) : "");
}

}  // namespace fathom::page
