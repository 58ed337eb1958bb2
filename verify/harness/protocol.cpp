// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/protocol.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

#include "reference/files/case_json.hpp"
#include "reference/polytope/placed_pair.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::harness {
namespace {

void add_body(text::JsonStream& out, const Body& body, Precision precision, bool with_faces) {
  if (body.pieces && body.pieces->size() == 1) return add_body(out, Body{body.pieces->front()}, precision, with_faces);  // a polytope
  if (body.words && !body.pieces) {
    out.value(files::body_json(*body.words, files::Defaults::written).text());
    return;
  }
  out.object([&] {
    if (body.pieces) {
      out.key("pieces");
      out.array_of(*body.pieces, [&](const std::vector<Point>& piece) { add_body(out, Body{piece}, precision, with_faces); });
      return;
    }
    const std::optional<GivenPoints> rounded = seen(body.points, precision);
    if (!rounded) throw std::invalid_argument("a coordinate overflows the subject's precision");
    out.key("vertices");
    // Read by strtod or by strtof, or by strtod and then rounded, each number is the same.
    out.array_of(rounded->binary64(), [&](const std::array<double, 3>& p) { out.value(fmt::format("[{},{},{}]", p[0], p[1], p[2])); });
    const Faces faces = with_faces ? faces_of(body.points) : Faces();
    if (!faces.empty()) out.key("faces"), out.array_of(faces, [&](const std::vector<std::uint32_t>& face) { out.array_of(face); });
  });
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
  text::JsonStream out;
  out.open('{').key("type").plain("run").key("id").plain(ticket).key("a");
  add_body(out, seen.a, precision, with_faces);
  out.key("b");
  add_body(out, seen.b, precision, with_faces);
  return out.close('}').take();
}

std::string body_message(const Body& body, Precision precision, bool with_faces) {
  text::JsonStream out;
  add_body(out, body, precision, with_faces);
  return out.take();
}

std::string stop_message() { return R"({"type":"stop"})"; }

}  // namespace fathom::harness
