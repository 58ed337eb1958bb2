// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/protocol.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>

#include "fathom/numbers.hpp"
#include "reference/polytope/placed_pair.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::harness {
namespace {

/// Read by strtod or by strtof, or by strtod and then rounded, it is the same number.
std::string number(const mpq_class& value, Precision precision) {
  if (precision == Precision::binary32) return fmt::format("{}", static_cast<double>(round_binary32(value, Rounding::rn)));
  return fmt::format("{}", round_binary64(value, Rounding::rn));
}

void add_body(std::string& text, const Body& body, Precision precision, bool with_faces) {
  text += "{\"vertices\":";
  const char* before = "[";
  for (const Point& p : body.points) {
    text += fmt::format("{}[{},{},{}]", before, number(p.x, precision), number(p.y, precision), number(p.z, precision));
    before = ",";
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

std::string stop_message() { return R"({"type":"stop"})"; }

}  // namespace fathom::harness
