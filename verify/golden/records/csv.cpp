// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/csv.hpp"

#include <array>
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

}  // namespace

std::string csv_header() {
  return "id,status,format,flags,depth_squared,depth_f64_rn,depth_f64_rd,depth_f64_ru,depth_f32_rn,depth_f32_rd,depth_f32_ru,"
         "direction_x,direction_y,direction_z,translation_x,translation_y,translation_z,optima,contact,distance,"
         "a_count,a_points,b_count,b_points\n";
}

std::string csv_row(const Facts& facts) {
  if (!facts.in_binary64) return "";
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

}  // namespace fathom::golden
