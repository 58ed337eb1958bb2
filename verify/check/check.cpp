// SPDX-License-Identifier: Apache-2.0
#include "check.hpp"

#include "budget.hpp"
#include "limits.hpp"
#include "reader.hpp"
#include "text.hpp"

namespace fathom_check {
namespace {

Verdict verify_only(std::string_view text) {
  Lines lines(text, longest_line);
  Reader reader(lines);
  const std::optional<Verdict> verdict = reader.next();
  if (!verdict || verdict->outcome == Outcome::malformed) return verdict.value_or(Verdict());
  const std::size_t line = lines.number();
  if (reader.next()) throw malformed(line + 1, "expected the end after one certificate, found more");
  return *verdict;
}

}  // namespace

Verdict verify(std::string_view text) noexcept {
  try {
    return caught([text] { return verify_only(text); }, 0);
  } catch (...) {
    return {};  // refused, without a reason: not even the memory for one
  }
}

std::string verdict_line(const Verdict& v, std::string_view name) {
  const std::string label = v.id.empty() ? escaped(name) : v.id;
  if (!v.accepted()) {
    const char* const word = v.outcome == Outcome::refused ? "s REFUSED " : "s MALFORMED ";
    return word + label + ":" + std::to_string(v.line) + ": " + v.reason;
  }
  const char* const what = v.format == 2 || v.format == 4 ? " signed_depth"
                           : v.distance_squared.empty()   ? " depth_squared"
                                                          : " distance_squared";
  std::string line = "s VERIFIED " + v.status;
  const std::string triangles = v.triangles.empty() ? "" : " triangles=" + v.triangles;
  const bool solid = v.status == "solid";
  if (solid) {
    line += triangles;
  } else if (v.at_least.empty()) {
    line += what + ("=" + v.depth_squared + v.distance_squared + v.signed_depth);
  } else {
    line += what + ("_in=[" + v.at_least + "," + v.at_most + "]");
  }
  if (v.optima > 0) line += " optima=" + std::to_string(v.optima);
  if (!v.cone.empty()) line += " cone=" + v.cone;
  if (!v.pieces.empty()) line += " pieces=" + v.pieces;
  if (!solid) line += triangles;
  if (!v.patches.empty()) line += " patches=" + v.patches;
  if (v.rates > 0) line += " rates=" + std::to_string(v.rates);
  return line + " " + label;
}

}  // namespace fathom_check
