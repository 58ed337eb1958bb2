// SPDX-License-Identifier: GPL-3.0-or-later
// Computes records again, by other methods and about the bodies turned and exchanged, without their
// certificates.                                                                 [proofs/golden.md]
#include <algorithm>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "fathom/plane.hpp"
#include "fathom/shape.hpp"
#include "verify/golden/records/facts.hpp"
#include "verify/golden/records/prove.hpp"
#include "verify/golden/records/record.hpp"

namespace fathom::golden {
namespace {

/// Returns a rotation that takes no axis to an axis, and no facet of a box along the axes to a
/// plane with small integer coefficients; then a translation.
const Pose& other_frame() {
  static const Pose pose = rigid_pose({7, 2, -3, 5}, {mpq_class(1, 3), -2, mpq_class(3, 7)});
  return pose;
}

Options options_of(Method method, Monitor* monitor) {
  Options options;
  options.method = method;
  options.monitor = monitor;
  return options;
}

// Each function returns the truth about the bodies according to `method`; nullopt if it compared
// the truth with the line itself.

std::optional<RecordStatement> truth_by(Method method, const HullPair& hulls, std::string_view, Monitor* monitor) {
  return truth_of(hulls, penetration_depth(hulls.a, hulls.b, options_of(method, monitor)), monitor);
}

std::optional<RecordStatement> truth_by(Method method, const families::NamedPair& shapes, std::string_view line,
                                        Monitor* monitor) {
  const Shape a = families::shape_of(shapes.a), b = families::shape_of(shapes.b);
  const Options options = options_of(method, monitor);
  const SignedDepth turned = answer_about(moved(b, other_frame()), moved(a, other_frame()), options);
  const Surd* const exact = turned.exact();
  const Surd low = exact ? *exact : Surd{turned.bounds()->low, 0},
             high = exact ? *exact : Surd{turned.bounds()->high, 0};
  const auto [stated_low, stated_high] = signed_depth_in(line);
  if (compare(stated_low, high) > 0 || compare(low, stated_high) > 0)
    throw NotProved("expected.signed_depth: the bodies, turned and exchanged, have another one");
  if (std::holds_alternative<Bracket>(turned.core)) return std::nullopt;
  return truth_of(answer_about(a, b, options));
}

std::optional<RecordStatement> truth_by(Method method, const families::PlanePair& plane, std::string_view,
                                        Monitor* monitor) {
  static const Pose turn = rigid_pose({7, 0, 0, 2}, {mpq_class(1, 3), -2, 0});
  const auto turned = [](const Body& body) {
    Body result;
    result.shape = moved(*body.shape, turn);
    return in_plane(std::move(result));
  };
  const Options options = options_of(method, monitor);
  const Answer answer = answer_about(plane, options),
               other = answer_about(families::PlanePair{turned(plane.b), turned(plane.a)}, options);
  if (compare(*answer.exact(), *other.exact()) != 0 || answer.ways_out() != other.ways_out())
    throw NotProved("expected.signed_depth: the bodies, turned and exchanged, have another one");
  return truth_of(answer);
}

Pieces moved(Pieces pieces) {
  const Pose& m = other_frame();
  const auto row = [&m](std::size_t i, const Point& p) {
    return mpq_class(m[i][0] * p.x + m[i][1] * p.y + m[i][2] * p.z + m[i][3]);
  };
  for (std::vector<Point>& piece : pieces)
    for (Point& p : piece) p = {row(0, p), row(1, p), row(2, p)};
  return pieces;
}

/// Returns a translation of B in the other frame as one of A in the original frame. The inverse of
/// a rotation is its transpose.
Point translation_of_a(const Point& t) {
  const Pose& m = other_frame();
  const auto column = [&](std::size_t i) { return mpq_class(-(m[0][i] * t.x + m[1][i] * t.y + m[2][i] * t.z)); };
  return {column(0), column(1), column(2)};
}

/// Returns the nearest pieces that the line names, with their distance by `method`.
UnionGap stated_gap(Method method, std::string_view line, const Unions& unions, Monitor* monitor) {
  const auto [a, b] = nearest_pieces_in(line);
  if (a >= unions.a.size() || b >= unions.b.size())
    throw NotProved("expected.distance.pieces: there are no such pieces");
  const Depth answer = penetration_depth(unions.a[a], unions.b[b], options_of(method, monitor));
  if (!answer.distance()) throw NotProved("expected.distance.pieces: these pieces are not disjoint");
  return {answer.distance()->squared, a, b, answer.distance()->translation};
}

std::optional<RecordStatement> truth_by(Method method, const Unions& unions, std::string_view line, Monitor* monitor) {
  UnionStatement truth = truth_of(answer_about(moved(unions.b), moved(unions.a), monitor));
  for (Point& t : truth.optima) t = translation_of_a(t);
  std::ranges::sort(truth.optima,
                    [](const Point& p, const Point& q) { return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z); });
  if (truth.gap) {
    UnionGap gap = stated_gap(method, line, unions, monitor);
    if (gap.squared != truth.gap->squared)
      throw NotProved("expected.distance.pieces: these pieces are not the nearest");
    truth.gap = std::move(gap);
  }
  return truth;
}

/// Returns the record's line according to `method`; nullopt if the line was compared otherwise.
std::optional<std::string> line_by(Method method, std::string_view line, Monitor* monitor) {
  const ReadRecord claimed = read_record(line);
  FormedCase made = claimed.hulls ? FormedCase{claimed.form, claimed.id, *claimed.hulls, claimed.recipe.contacts}
                                  : case_in(cases_of(claimed.recipe), claimed.form);
  std::optional<RecordStatement> truth =
      std::visit([&](const auto& bodies) { return truth_by(method, bodies, line, monitor); }, made.bodies);
  if (!truth) return std::nullopt;
  std::optional<ContactFacts> contacts;
  if (made.contacts) {
    const Options options = options_of(method, monitor);
    ContactStatement found = contacts_of(made.bodies, options);
    insist_on_exchanged(made.bodies, found.contacts, other_frame(), options);
    if (method == Method::naive) insist_on_clipped(made.bodies, found.contacts);
    truth = std::move(found.truth);
    contacts = std::move(found.contacts);
  }
  return line_of(
      facts_of(claimed.recipe, std::move(made), *std::move(truth), claimed.certificate_sha256, std::move(contacts)));
}

}  // namespace

std::optional<std::string> disagreement_with(Method method, std::string_view line, Monitor* monitor) {
  const std::string prefix = "by the method " + std::string(name(method)) + ": ";
  try {
    const std::optional<std::string> expected = line_by(method, line, monitor);
    if (!expected || *expected == line) return std::nullopt;
    return prefix + first_difference(*expected, line);
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& fault) {
    return prefix + fault.what();
  }
}

}  // namespace fathom::golden
