// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/picture/sum_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "view/picture/paint.hpp"
#include "view/picture/strokes.hpp"

namespace fathom::picture {
namespace {

constexpr double short_radius = 40;  // pixels: a smaller ball gets a close-up
constexpr double close_radius = 80;  // how large it is there

/// An edge by its ends, the lower first, with the facets at it.
using Sides = std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>>;

Sides sides_of(const Mesh& mesh) {
  Sides result;
  for (std::size_t f = 0; f < mesh.polygons.size(); ++f) {
    const std::vector<std::uint32_t>& polygon = mesh.polygons[f];
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::uint32_t p = polygon[i], q = polygon[(i + 1) % polygon.size()];
      result[std::minmax(p, q)].push_back(f);
    }
  }
  return result;
}

/// Whether the faces at an edge turn by more than a third of a right angle.
bool is_sharp(const Mesh& mesh, const std::vector<std::size_t>& faces) {
  const double cosine = std::sqrt(3) / 2;
  return faces.size() < 2 || dot(mesh.normals[faces[0]], mesh.normals[faces[1]]) < cosine;
}

Bounds2 box_of(const SumScene& scene, const mpq_class& radius) {
  Bounds2 result{{mpq_class(-radius), mpq_class(-radius)}, {radius, radius}};
  for (const Wires& each : scene.sums)
    for (const Point& corner : each.corners) result.add(scene.view.place(corner));
  return result;
}

std::string edges(const std::vector<Wires::Wire>& wires, const Window& window, bool hidden) {
  std::string d;
  for (const Wires::Wire& wire : wires)
    if (wire.hidden == hidden) d += path_data(window.segment(wire.from, wire.to), false);
  return d;
}

std::string painted(const SumScene& scene, const Window& window, bool close) {
  std::vector<std::vector<Dot>> areas;
  std::string hidden, seen, result = ground_element(window.size());
  for (const Wires& each : scene.sums) {
    areas.push_back(window.hull(each.corners));
    hidden += edges(each.wires, window, true);
    seen += each.wires.empty() ? path_data(areas.back(), true) : edges(each.wires, window, false);
  }
  const Dot origin = window.dot({}), end = window.dot(scene.way);
  const double radius = end.x - origin.x, above = radius * mpq_class(window.scale().y / window.scale().x).get_d();
  result += area_element(areas, "sum", "") + path_element("sum hidden", hidden);
  result +=
      fmt::format("<ellipse class=\"ball\" cx=\"{:.1f}\" cy=\"{:.1f}\" rx=\"{:.1f}\" ry=\"{:.1f}\"/>", origin.x, origin.y, radius, above);
  for (const std::vector<Point>& facet : scene.nearest) result += path_element("near", path_data(window.hull(facet), true));
  result += path_element("sum wire", seen) + arrow_elements(origin, end, "true") + circle_element("origin", origin, 3.5);
  result += fmt::format("<text class=\"origin letter\" x=\"{:.1f}\" y=\"{:.1f}\">O</text>", origin.x - 12, origin.y + 18);
  std::string note = close ? "close-up" : "";
  const auto add = [&](bool holds, const char* what) {
    if (holds) note += (note.empty() ? "" : "; ") + std::string(what);
  };
  add(window.apart(), "axes scaled apart");
  add(scene.approximate, "a mesh");
  return result + scale_bars(window) + note_element(note, window.size());
}

}  // namespace

Wires wires_of(const Mesh& mesh, const View& view) {
  Wires result;
  result.corners = mesh.vertices;
  std::vector<bool> faces_us;
  for (const Vec3<double>& normal : mesh.normals) faces_us.push_back(view.sees(normal));
  const Sides sides = sides_of(mesh);
  for (const auto& [ends, faces] : sides) {
    const bool left = faces_us[faces.front()], right = faces_us[faces.back()], hidden = !left && !right;
    if (sides.size() > (hidden ? most_hidden : most_edges) && left == right) continue;
    if (mesh.creases && left == right && !is_sharp(mesh, faces)) continue;
    result.wires.push_back({mesh.vertices[ends.first], mesh.vertices[ends.second], hidden});
  }
  return result;
}

std::size_t edges_count(const Mesh& mesh) { return sides_of(mesh).size(); }

bool is_speck(const SumScene& scene) {
  const mpq_class radius = scene.view.place(scene.way).x;
  const Bounds2 box = box_of(scene, radius);
  return std::max(mpq_class(box.width()), mpq_class(box.height())) > 1'000'000'000 * radius;
}

std::string sum_panels(const SumScene& scene, const std::string& name, const std::string& label, const std::string& description) {
  const mpq_class radius = scene.view.place(scene.way).x;
  const Window whole = Window::around(scene.view, box_of(scene, radius), on_pages);
  std::vector<std::pair<Window, bool>> windows{{whole, false}};
  if (radius * std::min(whole.scale().x, whole.scale().y) < short_radius && !is_speck(scene))
    windows.emplace_back(Window::close(scene.view, {0, 0}, mpq_class(close_radius / radius), on_pages), true);
  std::string result;
  for (const auto& [window, close] : windows)
    result += svg_opening("", on_pages, "pair") +
              svg_told(name + (close ? "c" : "w"), close ? label + ", close to the ball" : label, description) +
              painted(scene, window, close) + "</svg>\n";
  return result;
}

}  // namespace fathom::picture
