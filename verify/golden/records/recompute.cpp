// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/recompute.hpp"

#include <utility>

#include "verify/golden/records/record_facts.hpp"
#include "verify/golden/records/record_line.hpp"
#include "verify/golden/records/record_reader.hpp"
#include "verify/golden/shapes/shape_recompute.hpp"
#include "verify/golden/unions/union_recompute.hpp"

namespace fathom::golden {
namespace {

/// The line as it is when `method` answers.
std::string line_of_points_by(Method method, const Claimed& claimed, Monitor* monitor) {
  Options options;
  options.method = method;
  options.monitor = monitor;
  Depth answer = penetration_depth(claimed.points.a, claimed.points.b, options);
  Facts facts = facts_of_answer(claimed.recipe, claimed.form, claimed.points, std::move(answer), monitor);
  facts.certificate_sha256 = claimed.certificate_sha256;
  return line_of(facts);
}

std::optional<std::string> line_by(Method method, std::string_view line, Monitor* monitor) {
  const Claimed claimed = read_record(line);
  switch (kind_of(claimed.recipe.source)) {
    case Kind::polytopes: break;
    case Kind::shapes: return shape_line_by(method, line, claimed, monitor);
    case Kind::unions: return union_line_by(method, line, claimed, monitor);
  }
  return line_of_points_by(method, claimed, monitor);
}

}  // namespace

std::optional<std::string> disagreement_with(Method method, std::string_view line, Monitor* monitor) {
  const std::string prefix = "by the method " + std::string(name(method)) + ": ";
  try {
    const std::optional<std::string> answer = line_by(method, line, monitor);
    if (!answer || *answer == line) return std::nullopt;
    const std::string& expected = *answer;
    return prefix + first_difference(expected, line);
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& fault) {
    return prefix + fault.what();
  }
}

}  // namespace fathom::golden
