// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "fathom/judge.hpp"
#include "fathom/numbers.hpp"
#include "verify/judge/truth.hpp"

namespace fathom {
namespace {

constexpr std::string_view verdict_names[] = {"crash",
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
                                              "too-far",
                                              "too-near",
                                              "not-separating",
                                              "inconsistent",
                                              "witness-off",
                                              "contact-outside",
                                              "contact-too-deep",
                                              "contact-too-shallow",
                                              "misses-extent",
                                              "tips",
                                              "wrong-derivative",
                                              "not-invariant",
                                              "unsupported",
                                              "touching-by-convention",
                                              "pass"};
static_assert(std::size(verdict_names) == static_cast<std::size_t>(Verdict::pass) + 1);

}  // namespace

std::string_view name(Verdict verdict) { return verdict_names[static_cast<std::size_t>(verdict)]; }

std::optional<Verdict> verdict_named(std::string_view name) {
  const auto found = std::ranges::find(verdict_names, name);
  if (found == std::end(verdict_names)) return std::nullopt;
  return static_cast<Verdict>(found - std::begin(verdict_names));
}

std::string_view name(Accuracy accuracy) {
  constexpr std::string_view names[] = {"correctly rounded", "4 ulp", "16 uR", "1e-6", "tolerance"};
  return names[static_cast<std::size_t>(accuracy)];
}

}  // namespace fathom

namespace fathom::judging {
namespace {

constexpr std::string_view within_word = "within=";

}  // namespace

std::string policy_text(const Policy& policy) {
  switch (policy.kind) {
    case Policy::Kind::minimum: return "minimum";
    case Policy::Kind::separating: return "separating";
    case Policy::Kind::within: return fmt::format("{}{}%", within_word, exact_text(mpq_class(100 * policy.most)));
    default: return "declared";
  }
}

std::optional<Policy> policy_of(std::string_view text) {
  for (const Policy::Kind kind : policy_kinds)
    if (text == policy_text({kind})) return Policy{kind};
  if (!text.starts_with(within_word) || !text.ends_with('%')) return std::nullopt;
  const std::optional<mpq_class> percent =
      parse_number(text.substr(within_word.size(), text.size() - within_word.size() - 1), Decimals::exact).value;
  if (!percent || sgn(*percent) < 0) return std::nullopt;
  return Policy{Policy::Kind::within, *percent / 100};
}

}  // namespace fathom::judging
