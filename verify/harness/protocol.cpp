// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/protocol.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

#include "reference/files/body_json.hpp"
#include "reference/polytope/placed_pair.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::harness {
namespace {

/// Read by strtod or by strtof, or by strtod and then rounded, it is the same number.
void add_point(std::string& text, const std::array<double, 3>& p) {
  fmt::format_to(std::back_inserter(text), "[{},{},{}]", p[0], p[1], p[2]);
}

void add_body(std::string& text, const Body& body, Precision precision, bool with_faces) {
  if (body.pieces) {  // a single one is a polytope
    if (body.pieces->size() > 1) text += "{\"pieces\":[";
    const char* before = "";
    for (const std::vector<Point>& piece : *body.pieces) {
      text += std::exchange(before, ",");
      add_body(text, Body{piece}, precision, with_faces);
    }
    if (body.pieces->size() > 1) text += "]}";
    return;
  }
  if (body.words) {
    text += files::body_json(*body.words, files::Defaults::written);
    return;
  }
  text += "{\"vertices\":";
  const char* before = "[";
  const std::optional<GivenPoints> rounded = seen(body.points, precision);
  if (!rounded) throw std::invalid_argument("a coordinate overflows the subject's precision");
  for (const std::array<double, 3>& p : rounded->binary64()) {
    text += std::exchange(before, ",");
    add_point(text, p);
  }
  text += ']';
  const Faces faces = with_faces ? faces_of(body.points) : Faces();
  if (!faces.empty()) text += fmt::format(",\"faces\":[{}]", fmt::join(faces, ","));
  text += '}';
}

}  // namespace

Faces faces_of(const std::vector<Point>& points) {
  const polytope::Polytope hull = polytope::convex_hull(polytope::place(points, points).a.points());
  Faces faces;
  if (hull.rank < 3) return faces;
  for (const polytope::Facet& facet : hull.facets) {
    std::vector<std::uint32_t>& face = faces.emplace_back();
    for (std::uint32_t i = facet.begin; i < facet.end; ++i) face.push_back(hull.input_ids[hull.corners[i]]);
  }
  return faces;
}

std::string hello_message() { return fmt::format(R"({{"type":"hello","protocol":"{}"}})", protocol_name); }

std::string run_message(const std::string& ticket, const Case& seen, Precision precision, bool with_faces) {
  std::string text = fmt::format(R"({{"type":"run","id":"{}","a":)", ticket);
  add_body(text, seen.a, precision, with_faces);
  text += ",\"b\":";
  add_body(text, seen.b, precision, with_faces);
  return text + '}';
}

std::string body_message(const Body& body, Precision precision, bool with_faces) {
  std::string text;
  add_body(text, body, precision, with_faces);
  return text;
}

std::string stop_message() { return R"({"type":"stop"})"; }

}  // namespace fathom::harness
