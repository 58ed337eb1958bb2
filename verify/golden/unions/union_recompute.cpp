// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/unions/union_recompute.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <tuple>
#include <utility>

#include "fathom/shape.hpp"
#include "verify/golden/records/accepted.hpp"
#include "verify/golden/unions/union_facts.hpp"

namespace fathom::golden {
namespace {

/// A rotation that takes no axis to an axis, and then a translation.
const Pose& other_frame() {
  static const Pose pose = rigid_pose({7, 2, -3, 5}, {mpq_class(1, 3), -2, mpq_class(3, 7)});
  return pose;
}

Body moved(const Body& body) {
  const auto row = [](const std::array<mpq_class, 4>& m, const Point& p) { return mpq_class(m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3]); };
  const Pose& frame = other_frame();
  Pieces pieces = *body.pieces;
  for (std::vector<Point>& piece : pieces)
    for (Point& p : piece) p = {row(frame[0], p), row(frame[1], p), row(frame[2], p)};
  return {.points = {}, .pieces = std::make_shared<const Pieces>(std::move(pieces))};
}

/// A translation of B in the other frame, as one of A in this one. The inverse of a rotation is its transpose.
Point translation_of_a(const Point& t) {
  const Pose& m = other_frame();
  const auto column = [&](std::size_t i) { return mpq_class(-(m[0][i] * t.x + m[1][i] * t.y + m[2][i] * t.z)); };
  return {column(0), column(1), column(2)};
}

bool before(const Point& p, const Point& q) { return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z); }

/// The pieces that the line says are nearest, and how they are apart by the method.
UnionGap stated_gap(Method method, std::string_view line, const Case& unions, Monitor* monitor) {
  UnionGap gap;
  try {
    const nlohmann::json pieces = nlohmann::json::parse(line).at("expected").at("distance").at("pieces");
    gap.a = pieces.at(0).get<std::uint32_t>();
    gap.b = pieces.at(1).get<std::uint32_t>();
  } catch (const nlohmann::json::exception& error) {
    throw NotARecord(std::string("expected a record, found a fault: ") + error.what());
  }
  const Pieces &a = *unions.a.pieces, &b = *unions.b.pieces;
  if (gap.a >= a.size() || gap.b >= b.size()) throw NotProved("expected.distance.pieces: there are no such pieces");
  Options options;
  options.method = method;
  options.monitor = monitor;
  const Depth answer = penetration_depth(a[gap.a], b[gap.b], options);
  if (!answer.distance()) throw NotProved("expected.distance.pieces: these pieces are not disjoint");
  gap.squared = answer.distance()->squared;
  gap.translation = answer.distance()->translation;
  return gap;
}

}  // namespace

std::string union_line_by(Method method, std::string_view line, const Claimed& claimed, Monitor* monitor) {
  const std::vector<FormedUnions> all = union_cases_of(claimed.recipe);
  const auto made = std::ranges::find(all, claimed.form, &FormedUnions::form);
  if (made == all.end()) throw NotProved("source: it has no such form");
  UnionStatement truth = truth_of(answer_about({made->unions.id, moved(made->unions.b), moved(made->unions.a)}, monitor));
  for (Point& t : truth.optima) t = translation_of_a(t);
  std::ranges::sort(truth.optima, before);
  if (truth.gap) {
    const UnionGap gap = stated_gap(method, line, made->unions, monitor);
    if (gap.squared != truth.gap->squared) throw NotProved("expected.distance.pieces: these pieces are not the nearest");
    truth.gap = gap;
  }
  return line_of(UnionFacts{claimed.recipe, *made, std::move(truth), claimed.certificate_sha256});
}

}  // namespace fathom::golden
