// SPDX-License-Identifier: GPL-3.0-or-later
// The size of the pictures that tests look at.
#pragma once

#include "view/picture/view.hpp"

namespace fathom::picture {

inline constexpr PixelSize size{400, 300};

}  // namespace fathom::picture
