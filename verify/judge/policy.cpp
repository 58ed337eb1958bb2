// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "fathom/numbers.hpp"
#include "verify/judge/words.hpp"

namespace fathom::judging {
namespace {

constexpr std::string_view within = "within=";

}  // namespace

std::string policy_text(const Policy& policy) {
  switch (policy.kind) {
    case Policy::Kind::minimum: return "minimum";
    case Policy::Kind::separating: return "separating";
    case Policy::Kind::within: return fmt::format("{}{}%", within, exact_text(mpq_class(100 * policy.most)));
    default: return "declared";
  }
}

std::optional<Policy> policy_of(std::string_view text) {
  for (const Policy::Kind kind : policy_kinds)
    if (text == policy_text({kind})) return Policy{kind};
  if (!text.starts_with(within) || !text.ends_with('%')) return std::nullopt;
  const std::optional<mpq_class> percent = parse_number(text.substr(within.size(), text.size() - within.size() - 1), Decimals::exact).value;
  if (!percent || sgn(*percent) < 0) return std::nullopt;
  return Policy{Policy::Kind::within, *percent / 100};
}

}  // namespace fathom::judging
