// SPDX-License-Identifier: GPL-3.0-or-later
// The words for verdicts.
#include <algorithm>
#include <iterator>

#include "fathom/judge.hpp"

namespace fathom {
namespace {

constexpr std::string_view names[] = {"crash",        "time-out",         "silent",        "garbage",         "failed",
                                      "nan",          "false-separation", "false-overlap", "not-a-direction", "wrong-sign",
                                      "too-deep",     "too-shallow",      "too-far",       "too-near",        "not-separating",
                                      "inconsistent", "witness-off",      "not-invariant", "unsupported",     "touching-by-convention",
                                      "pass"};
static_assert(std::size(names) == static_cast<std::size_t>(Verdict::pass) + 1);

}  // namespace

std::string_view name(Verdict verdict) { return names[static_cast<std::size_t>(verdict)]; }

std::optional<Verdict> verdict_named(std::string_view name) {
  const auto found = std::ranges::find(names, name);
  if (found == std::end(names)) return std::nullopt;
  return static_cast<Verdict>(found - std::begin(names));
}

}  // namespace fathom
