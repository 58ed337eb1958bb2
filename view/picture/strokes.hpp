// SPDX-License-Identifier: GPL-3.0-or-later
// The elements that every picture is painted with. Styles are classes of style.hpp; places are pixels.
#pragma once

#include <gmpxx.h>

#include <string>
#include <utility>
#include <vector>

#include "view/picture/view.hpp"

namespace fathom::picture {

/// A path; empty if there is nothing to draw.
std::string path_element(const std::string& style, const std::string& d);

/// A circle; empty if its place is not finite. `more`: further attributes, with a space before them.
std::string circle_element(const std::string& style, const Dot& at, double radius, const std::string& more = "");

/// The corners of a box around dots, of which there is at least one.
std::pair<Dot, Dot> box_around(const std::vector<Dot>& dots);

/// The union of convex areas: toned, or filled with the pattern `hatch`; a dot for what would be too small to be seen.
std::string area_element(const std::vector<std::vector<Dot>>& areas, const std::string& style, const std::string& hatch);

/// A face, given by the points that span it: a dot, a line, or the outline of a facet. `more` as for circles.
std::string feature_element(const std::vector<Point>& points, const Window& window, const std::string& style, double radius,
                            const std::string& more = "");

/// An arrow; a dot if it is too short to see.
std::string arrow_elements(const Dot& from, const Dot& to, const std::string& style);

/// Bars that stand for round lengths: one, or two if the axes are scaled apart.
std::string scale_bars(const Window& window);

/// Words in the corner below on the right; empty if there are none.
std::string note_element(const std::string& text, const PixelSize& size);

/// The pattern that B is filled with.
std::string hatch_element(const std::string& id);

/// The ground of a picture.
std::string ground_element(const PixelSize& size);

/// The tags around a picture's content that say what it shows to those who do not see it. `name` begins the ids; texts are markup.
std::string svg_opening(const std::string& more, const PixelSize& size, const std::string& style);
std::string svg_told(const std::string& name, const std::string& title, const std::string& description);

}  // namespace fathom::picture
