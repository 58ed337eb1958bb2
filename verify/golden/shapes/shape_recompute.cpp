// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/shapes/shape_recompute.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "fathom/numbers.hpp"
#include "verify/golden/records/accepted.hpp"
#include "verify/golden/shapes/shape_facts.hpp"

namespace fathom::golden {
namespace {

using Ends = std::pair<Surd, Surd>;  // low and high

/// A rotation that takes no axis to an axis, and no face of a body that lies along the axes to a plane that is simple.
const Pose& other_frame() {
  static const Pose pose = rigid_pose({7, 2, -3, 5}, {mpq_class(1, 3), -2, mpq_class(3, 7)});
  return pose;
}

Ends ends_of(const SignedDepth& answer) {
  if (const Surd* const exact = answer.exact()) return {*exact, *exact};
  return {{answer.bounds()->low, 0}, {answer.bounds()->high, 0}};
}

Ends ends_in(std::string_view line) {
  const auto number = [](const nlohmann::json& value) {
    ParsedNumber parsed = parse_number(value.get_ref<const std::string&>(), Decimals::exact);
    if (!parsed.value) throw NotARecord(parsed.error);
    return *std::move(parsed.value);
  };
  try {
    const nlohmann::json value = nlohmann::json::parse(line).at("expected").at("signed_depth");
    if (value.contains("bounds")) return {{number(value.at("bounds").at(0)), 0}, {number(value.at("bounds").at(1)), 0}};
    const nlohmann::json& exact = value.at("exact");
    const Surd surd{number(exact.at("plus")), number(exact.at("root")) * exact.at("sign").get<int>()};
    return {surd, surd};
  } catch (const nlohmann::json::exception& error) {
    throw NotARecord(std::string("expected a record, found a fault: ") + error.what());
  }
}

}  // namespace

std::optional<std::string> shape_line_by(Method method, std::string_view line, const Claimed& claimed, Monitor* monitor) {
  const std::vector<FormedShapes> all = shape_cases_of(claimed.recipe);
  const auto made = std::ranges::find(all, claimed.form, &FormedShapes::form);
  if (made == all.end()) throw NotProved("source: it has no such form");
  const Shape a = families::shape_of(made->shapes.pair.a), b = families::shape_of(made->shapes.pair.b);
  Options options;
  options.method = method;
  options.monitor = monitor;
  const SignedDepth turned = answer_about(moved(b, other_frame()), moved(a, other_frame()), options);
  const auto [low, high] = ends_of(turned);
  const auto [stated_low, stated_high] = ends_in(line);
  if (compare(stated_low, high) > 0 || compare(low, stated_high) > 0)
    throw NotProved("expected.signed_depth: the bodies, turned and exchanged, have another one");
  if (std::holds_alternative<Bracket>(turned.core)) return std::nullopt;
  return line_of(ShapeFacts{claimed.recipe, *made, truth_of(answer_about(a, b, options)), claimed.certificate_sha256});
}

}  // namespace fathom::golden
