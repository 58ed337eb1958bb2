// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "cli/io/certificate_file.hpp"
#include "cli/io/output.hpp"
#include "verify/check/unreadable.hpp"

namespace fathom::cli {

void require_readable(const std::string& id, std::string_view certificate, const fathom_check::Limits& limits) try {
  fathom_check::require_readable(certificate, limits);
} catch (const fathom_check::Unreadable& refusal) {
  throw OutputError(fmt::format(
      "{}: {}. Narrower numbers make it shorter, as --exact-decimals does for short decimals, and so do fewer points or pieces; "
      "without a certificate the depth is printed",
      id, refusal.what()));
}

}  // namespace fathom::cli
