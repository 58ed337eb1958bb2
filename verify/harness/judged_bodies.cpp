// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "reference/files/shape_names.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/judge/scene.hpp"

namespace fathom::harness {
namespace {

Body grown(const Body& body, const mpq_class& radius) {
  if (radius == 0) return body;
  Body result;
  result.shape = with_margin(files::shape_of(body), radius);
  return result;
}

Body used(const Body& body, const std::optional<std::vector<Triple>>& hull, long exponent) {
  return hull ? Body{scaled(GivenPoints(*hull), -exponent)} : body;
}

mpq_class squared_way(const Body& from, const Body& to) {
  const auto coordinates = [](const Point& p) { return std::tie(p.x, p.y, p.z); };
  const auto less = [&](const Point& p, const Point& q) { return coordinates(p) < coordinates(q); };
  const std::set<Point, decltype(less)> there(to.points.begin(), to.points.end(), less);
  mpq_class result = 0;
  for (const Point& p : from.points)
    if (!there.contains(p)) result = std::max(result, judging::squared_distance(p, to.points.exact()));
  return result;
}

}  // namespace

mpq_class rounding_radius(const Body& body, const SubjectInfo& info) {
  const std::string word = body.words ? std::string(files::named_shape(body.words->shape).shape->name) : vertices_word;
  for (const std::string& name : {word, std::string()})
    if (const auto found = info.rounding.find(name); found != info.rounding.end()) return found->second;
  return 0;
}

std::pair<mpq_class, mpq_class> rounding_radii(const Case& seen, const SubjectInfo& info, long exponent) {
  return {scaled(rounding_radius(seen.a, info), -exponent), scaled(rounding_radius(seen.b, info), -exponent)};
}

bool rounds_pieces(const SubjectInfo& info) { return rounding_radius(Body{}, info) != 0; }

Case judged_bodies(const Case& seen, const SubjectInfo& info, long exponent) {
  if (info.rounding.empty() || seen.a.pieces) return seen;
  const auto [of_a, of_b] = rounding_radii(seen, info, exponent);
  return {seen.id, grown(seen.a, of_a), grown(seen.b, of_b)};
}

void demand_sent_as_vertices(const Case& seen, const SubjectAnswer& answer) {
  const auto demand = [](const Body& body, bool told, const char* name) {
    if (told && body.words) throw ProtocolError(fmt::format("expected no \"hull.{}\": the body was sent as a shape", name));
    if (told && body.pieces) throw ProtocolError(fmt::format("expected no \"hull.{}\": the body was sent in pieces", name));
  };
  demand(seen.a, answer.hull_a.has_value(), "a");
  demand(seen.b, answer.hull_b.has_value(), "b");
}

Case used_hulls(const Case& seen, const SubjectAnswer& answer, long exponent) {
  return {seen.id, used(seen.a, answer.hull_a, exponent), used(seen.b, answer.hull_b, exponent)};
}

mpq_class squared_way(const Case& from, const Case& to, const SubjectAnswer& answer) {
  mpq_class result = 0;
  if (answer.hull_a) result = squared_way(from.a, to.a);
  if (answer.hull_b) result = std::max(result, squared_way(from.b, to.b));
  return result;
}

}  // namespace fathom::harness
