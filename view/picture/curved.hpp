// SPDX-License-Identifier: GPL-3.0-or-later
// The outline of a curved body: the hull of its farthest points in many directions of the picture's plane. It lies inside the true one, by
// a fraction of a pixel where the body is no larger than the picture.
#pragma once

#include <vector>

#include "view/picture/drawn.hpp"

namespace fathom::picture {

Bounds2 curved_box(const Curved& body, const View& view);
std::vector<Dot> curved_outline(const Curved& body, const Window& window, const Point& by);

}  // namespace fathom::picture
