// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/atlas/sphere_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "view/atlas/limits.hpp"
#include "view/stages/charts_picture.hpp"

namespace fathom::atlas {
namespace {

using stages::Index;
using stages::Stages;

constexpr double radius = 205, middle_x = panel_width / 2, middle_y = 222;

Place unit(const Place& p) {
  const double size = std::hypot(p[0], p[1], p[2]);
  return {p[0] / size, p[1] / size, p[2] / size};
}

/// An orthographic view from outside.
struct Eye {
  Place towards, right, up;

  /// From beside the direction, so that what it points at is not in the very middle.
  explicit Eye(const Place& n) {
    const Place aside = std::abs(n[2]) < 0.9 ? Place{0, 0, 1} : Place{0, 1, 0};
    const Place across = unit(cross(aside, n)), above = cross(n, across);
    towards = unit(
        {n[0] + 0.35 * across[0] + 0.25 * above[0], n[1] + 0.35 * across[1] + 0.25 * above[1], n[2] + 0.35 * across[2] + 0.25 * above[2]});
    right = unit(cross(aside, towards));
    up = cross(towards, right);
  }

  [[nodiscard]] Pixel pixel(const Place& p) const { return {middle_x + radius * dot(p, right), middle_y - radius * dot(p, up)}; }
  [[nodiscard]] std::string path(const SphereArc& arc, const Place& side) const {
    std::string result;
    for (const SphereArc& part : parts_in(arc, side)) result += path_text(polyline(part, [this](const Place& p) { return pixel(p); }));
    return result;
  }
};

struct Arcs {
  std::string far, near, lit;
};

Arcs arcs_of(const Eye& eye, const stages::StagedBody& body, const std::set<Index>& lit, const char* style, bool all) {
  Arcs result;
  const Place behind{-eye.towards[0], -eye.towards[1], -eye.towards[2]};
  for (Index edge = 0; edge < body.arcs.size(); ++edge) {
    const bool is_lit = lit.contains(edge);
    if (!is_lit && !all) continue;
    const std::optional<SphereArc> arc = arc_of(body, edge);
    if (!arc) continue;
    const std::string front = eye.path(*arc, eye.towards), back = eye.path(*arc, behind);
    if (!is_lit) result.near += front, result.far += back;
    else result.lit += fmt::format("<path class=\"{} lit{}\" d=\"{}{}\"/>\n", style, front.empty() ? " far" : "", front, back);
  }
  return result;
}

std::string element(const std::string& d, const char* style, const char* more) {
  return d.empty() ? "" : fmt::format("<path class=\"{}{}\" d=\"{}\"/>\n", style, more, d);
}

std::string optimum_elements(const Stages& all, const Eye& eye) {
  std::string result;
  for (std::size_t i = std::min(all.contact.optima.size(), most_optima); i-- > 0;) {
    const Place& n = all.contact.optima[i].direction;
    const Pixel p = eye.pixel(n);
    if (dot(n, eye.towards) >= 0)
      result += fmt::format("<circle class=\"optimum\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>\n", p.x, p.y, i == 0 ? 7 : 4.5);
  }
  return result;
}

}  // namespace

SpherePanel sphere_panel(const Stages& all, std::optional<Index> pair) {
  const Eye eye(all.contact.direction == Place{} ? Place{0, 0, 1} : unit(all.contact.direction));
  std::set<Index> lit_a, lit_b;
  if (pair) lit_a = {all.pairs[*pair].a.begin(), all.pairs[*pair].a.end()}, lit_b = {all.pairs[*pair].b.begin(), all.pairs[*pair].b.end()};
  const bool all_arcs = all.a.arcs.size() + all.b.arcs.size() <= most_arcs;
  const Arcs a = arcs_of(eye, all.a, lit_a, "arc of-a", all_arcs), b = arcs_of(eye, all.b, lit_b, "arc of-b", all_arcs);
  std::string content = fmt::format("<circle class=\"ball\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", middle_x, middle_y, radius);
  content += element(a.far, "arc of-a", " far") + element(b.far, "arc of-b", " far") + element(a.near, "arc of-a", "") +
             element(b.near, "arc of-b", "") + a.lit + b.lit + optimum_elements(all, eye);
  std::string caption = fmt::format("Seen from near the optimum: {} arcs of -A, {} of B; those of the far side are faint.",
                                    all.a.arcs.size(), all.b.arcs.size());
  if (!all_arcs) caption += fmt::format(" More than {} arcs: only lit ones are drawn.", most_arcs);
  return {content, caption};
}

}  // namespace fathom::atlas
