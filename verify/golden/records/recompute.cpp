// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/recompute.hpp"

#include <utility>

#include "verify/golden/records/record_facts.hpp"
#include "verify/golden/records/record_line.hpp"
#include "verify/golden/records/record_reader.hpp"
#include "verify/golden/shapes/shape_recompute.hpp"

namespace fathom::golden {
namespace {

/// The line as it is when `method` answers.
std::string line_by(Method method, const Claimed& claimed, Monitor* monitor) {
  Options options;
  options.method = method;
  options.monitor = monitor;
  Depth answer = penetration_depth(claimed.points.a, claimed.points.b, options);
  Facts facts = facts_of_answer(claimed.recipe, claimed.form, claimed.points, std::move(answer), monitor);
  facts.certificate_sha256 = claimed.certificate_sha256;
  return line_of(facts);
}

}  // namespace

std::optional<std::string> disagreement_with(Method method, std::string_view line, Monitor* monitor) {
  const std::string prefix = "by the method " + std::string(name(method)) + ": ";
  try {
    const Claimed claimed = read_record(line);
    const std::optional<std::string> answer =
        of_shapes(claimed.recipe.source) ? shape_line_by(method, line, claimed, monitor) : std::optional(line_by(method, claimed, monitor));
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
