// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs of great circles, the parts of them in a hemisphere, and how they look in a projection.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "view/stages/stages.hpp"

namespace fathom::atlas {

using stages::Place;

double dot(const Place& p, const Place& q);
Place cross(const Place& p, const Place& q);

/// The points cos(t) from + sin(t) side for t in [begin, end]; `from` and `side` are orthogonal unit vectors.
struct SphereArc {
  Place from, side;
  double begin, end;

  [[nodiscard]] Place at(double t) const;
};

/// An arc of a diagram; nullopt if its ends are too near each other to be seen apart.
std::optional<SphereArc> arc_of(const stages::StagedBody& body, stages::Index edge);

/// The parts in the hemisphere around z; all of it if it lies on the equator.
std::vector<SphereArc> parts_in(const SphereArc& arc, const Place& z);

/// A place in pixels.
struct Pixel {
  double x, y;
};

using Projection = std::function<Pixel(const Place&)>;

/// The arc as a line of pixels, which is off by less than half a pixel.
std::vector<Pixel> polyline(const SphereArc& arc, const Projection& project);

/// "M1.0 2.0L3.0 4.0"
std::string path_text(const std::vector<Pixel>& pixels);

}  // namespace fathom::atlas
