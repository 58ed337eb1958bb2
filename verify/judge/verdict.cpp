// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>

#include "fathom/judge.hpp"

namespace fathom::judging {
namespace {

constexpr std::string_view names[] = {"crash",
                                      "time-out",
                                      "silent",
                                      "garbage",
                                      "failed",
                                      "nan",
                                      "false-separation",
                                      "false-overlap",
                                      "not-a-direction",
                                      "wrong-sign",
                                      "too-deep",
                                      "too-shallow",
                                      "not-separating",
                                      "inconsistent",
                                      "witness-off",
                                      "not-invariant",
                                      "unsupported",
                                      "touching-by-convention",
                                      "pass"};
static_assert(std::size(names) == static_cast<std::size_t>(Verdict::pass) + 1);

}  // namespace

}  // namespace fathom::judging

namespace fathom {

std::string_view name(Verdict verdict) { return judging::names[static_cast<std::size_t>(verdict)]; }

std::optional<Verdict> verdict_named(std::string_view name) {
  const auto found = std::ranges::find(judging::names, name);
  if (found == std::end(judging::names)) return std::nullopt;
  return static_cast<Verdict>(found - std::begin(judging::names));
}

}  // namespace fathom
