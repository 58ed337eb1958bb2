// SPDX-License-Identifier: GPL-3.0-or-later
// Names of values that only records have.
#pragma once

#include <string_view>

#include "fathom/depth.hpp"
#include "verify/golden/records/recipe.hpp"

namespace fathom::golden {

constexpr std::string_view name_of(Form form) {
  switch (form) {
    case Form::given: return "given";
    case Form::binary64: return "binary64";
    case Form::binary32: break;
  }
  return "binary32";
}

}  // namespace fathom::golden
