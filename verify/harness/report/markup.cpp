// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "verify/harness/report/text.hpp"

namespace fathom::harness {

std::string shown_id(std::string_view id, std::string_view variant) {
  return variant.empty() ? std::string(id) : fmt::format("{} ~{}", id, variant);
}

}  // namespace fathom::harness
