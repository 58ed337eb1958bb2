// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/report/markup.hpp"

#include <fmt/format.h>

namespace fathom::harness {

std::string shown_id(std::string_view id, std::string_view variant) {
  return variant.empty() ? std::string(id) : fmt::format("{} ~{}", id, variant);
}

}  // namespace fathom::harness
