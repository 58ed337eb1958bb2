// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "fathom/judge.hpp"

namespace fathom::harness {

/// Returns the first field that a report would show differently, with both values, as "judgement.error: 0.5 and 0.25"; nullopt if all are
/// equal.
std::optional<std::string> difference(const Judgement& x, const Judgement& y);

}  // namespace fathom::harness
