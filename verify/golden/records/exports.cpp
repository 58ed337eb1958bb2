// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/exports.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fathom/numbers.hpp"
#include "kernels/number/hex.hpp"
#include "verify/golden/records/names.hpp"

namespace fathom::golden {
namespace {

using Triple = std::array<double, 3>;

std::string hex(double value) {
  std::string text;
  kernels::append_hex(value, text);
  return text;
}

/// A hexadecimal float as C++ writes it.
void append_literal(double value, std::string& text) {
  constexpr std::string_view infinity = "std::numeric_limits<double>::infinity()";
  if (!std::isinf(value)) kernels::append_hex(value, text);
  else (text += value < 0 ? "-" : "") += infinity;
}

/// To nearest.
Triple nearest(const RoundedVector& v) { return {v[0].binary64[0], v[1].binary64[0], v[2].binary64[0]}; }

/// Of the first optimum; zeros for touching bodies, what brings disjoint ones together.
Triple translation(const Facts& facts) {
  return facts.rounded.translations.empty() ? Triple{} : nearest(facts.rounded.translations.front());
}

void append_joined(const Triple& p, char separator, std::string& text) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (i > 0) text += separator;
    kernels::append_hex(p[i], text);
  }
}

void append_literals(const Triple& p, std::string& text) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    text += i == 0 ? "{" : ", ";
    append_literal(p[i], text);
  }
  text += '}';
}

std::string row_of(const Facts& facts) {
  const std::vector<Optimum>& optima = facts.answer.optima();
  std::string row = facts.points.id + ',';
  ((row += name(facts.answer.status())) += ',') += facts.in_binary32 ? "binary32," : "binary64,";
  for (std::size_t i = 0; i < facts.flags.size(); ++i) (row += i == 0 ? "" : " ") += facts.flags[i];
  row += ',' + exact_text(facts.answer.squared());
  for (const auto& format : {facts.rounded.depth.binary64, facts.rounded.depth.binary32})
    for (const double value : format) row += ',' + hex(value);
  row += ',';
  append_joined(nearest(facts.rounded.units.front()), ',', row);
  row += ',';
  append_joined(translation(facts), ',', row);
  row += ',' + std::to_string(optima.size()) + ',';
  if (!optima.empty()) row += name(optima.front().contact.kind);
  row += ',' + hex(facts.rounded.distance.binary64[0]);
  for (const Body* body : {&facts.points.a, &facts.points.b}) {
    row += ',' + std::to_string(body->points.size());
    char before = ',';
    for (const Triple& p : body->points.binary64()) {
      row += std::exchange(before, ' ');
      append_joined(p, ' ', row);
    }
  }
  return row + '\n';
}

std::string entry_of(const Facts& facts) {
  std::string entry = "FATHOM_GOLDEN_CASE(\"" + facts.points.id + "\", \"";
  (entry += name(facts.answer.status())) += "\", ";
  for (const double value : facts.rounded.depth.binary64) {
    append_literal(value, entry);
    entry += ", ";
  }
  append_literals(nearest(facts.rounded.units.front()), entry);
  entry += ", ";
  append_literals(translation(facts), entry);
  entry += ", " + std::to_string(facts.answer.optima().size()) + ", ";
  append_literal(facts.rounded.distance.binary64[0], entry);
  for (const Body* body : {&facts.points.a, &facts.points.b}) {
    const char* before = ", {";
    for (const Triple& p : body->points.binary64()) {
      entry += std::exchange(before, ", ");
      append_literals(p, entry);
    }
    entry += '}';
  }
  return entry + ")\n";
}

}  // namespace

std::string csv_header() {
  return "id,status,format,flags,depth_squared,depth_f64_rn,depth_f64_rd,depth_f64_ru,depth_f32_rn,depth_f32_rd,depth_f32_ru,"
         "direction_x,direction_y,direction_z,translation_x,translation_y,translation_z,optima,contact,distance,"
         "a_count,a_points,b_count,b_points\n";
}

std::string include_head() {
  return R"(// SPDX-License-Identifier: CC0-1.0
// Golden cases of fathom with binary64 points: NOTES.md explains them. Before this file is included, say what becomes of a case:
//   struct Case {
//     const char *id, *status;                      // "penetrating", "touching", "disjoint"
//     double depth, depth_down, depth_up;           // correctly rounded: to nearest, down, up
//     std::array<double, 3> direction, translation; // of the first optimum, to nearest; disjoint: those of the distance
//     int optima;                                   // how many directions tie
//     double distance;                              // of disjoint bodies, to nearest
//     std::vector<std::array<double, 3>> a, b;      // the bodies are the convex hulls
//   };
//   std::vector<Case> cases;
//   void fill() {
//   #define FATHOM_GOLDEN_CASE(...) cases.push_back(Case{__VA_ARGS__});
//   #include "golden-L0-0000.inc"
//   }
// C++17, with <limits> included. The macro is undefined again at the end.
#ifndef FATHOM_GOLDEN_CASE
#error "define FATHOM_GOLDEN_CASE(...) before this file is included"
#endif
)";
}

std::string include_tail() { return "#undef FATHOM_GOLDEN_CASE\n"; }

Exports exports_of(const Facts& facts) {
  if (!facts.in_binary64) return {};
  return {row_of(facts), entry_of(facts)};
}

}  // namespace fathom::golden
