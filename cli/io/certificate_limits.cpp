// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/io/certificate_limits.hpp"

#include <fmt/format.h>

#include "cli/io/output.hpp"
#include "verify/check/unreadable.hpp"

namespace fathom::cli {

void require_readable(const std::string& id, std::string_view certificate, const fathom_check::Limits& limits) {
  const std::string why = fathom_check::unreadable(certificate, limits);
  if (why.empty()) return;
  throw OutputError(
      fmt::format("{}: no certificate is written, since all checkers would refuse to read it: {}. Narrower numbers make it shorter, as "
                  "--exact-decimals does for short decimals, and so do fewer points or pieces; without a certificate the depth is printed",
                  id, why));
}

}  // namespace fathom::cli
