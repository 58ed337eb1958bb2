// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/convexity.hpp"

#include <fmt/format.h>

#include "cli/output/json_values.hpp"
#include "fathom/numbers.hpp"

namespace fathom::cli {
namespace {

using polytope::Dents;
using polytope::MeshConvexity;

std::optional<MeshConvexity> fact(const Body& body) {
  if (!body.faces || body.shape) return std::nullopt;
  MeshConvexity found = polytope::mesh_convexity(body.points, *body.faces);
  return found.tried ? std::optional(std::move(found)) : std::nullopt;
}

constexpr double shown_as_excess = 0.005;  // "1 + 2e-16 times": three digits would show 1

std::string volume_text(const mpq_class& ratio) {
  const double excess = round_binary64(mpq_class(ratio - 1));
  if (excess < shown_as_excess) return fmt::format("the hull holds 1 + {:.2g} times its volume", excess);
  return fmt::format("the hull holds {:.3g} times its volume", round_binary64(ratio));
}

std::string dents_of(char body, const Dents& dents) {
  std::string text = fmt::format("{} is not convex: {}", body,
                                 dents.volume_ratio ? volume_text(*dents.volume_ratio) : std::string("its faces are not closed"));
  if (!dents.deepest) return text;
  if (dents.deepest->squared_depth == 0) return text + ", all its points are on the hull";
  return text + fmt::format(", its deepest point is {:.3g} inside", root_binary64(dents.deepest->squared_depth));
}

Json object_of(const MeshConvexity& found) {
  if (!found.dents) return {{"convex", Json::boolean(true)}};
  const Dents& dents = *found.dents;
  return {{"convex", Json::boolean(false)},
          {"volume_ratio", dents.volume_ratio ? number(*dents.volume_ratio) : Json()},
          {"deepest", dents.deepest ? Json{{"point", dents.deepest->point}, {"depth", length(dents.deepest->squared_depth, {})}} : Json()}};
}

}  // namespace

HullFacts hull_facts(const Case& input, bool one_body) { return {fact(input.a), one_body ? std::nullopt : fact(input.b)}; }

std::string dents_text(const HullFacts& facts) {
  std::string result;
  if (facts.a && facts.a->dents) result = dents_of('A', *facts.a->dents);
  if (facts.b && facts.b->dents) result += (result.empty() ? "" : "; ") + dents_of('B', *facts.b->dents);
  return result;
}

std::optional<Json> hull_object(const HullFacts& facts) {
  if (!facts.a && !facts.b) return std::nullopt;
  Json result = Json::object();
  if (facts.a) result["a"] = object_of(*facts.a);
  if (facts.b) result["b"] = object_of(*facts.b);
  return result;
}

}  // namespace fathom::cli
