// SPDX-License-Identifier: GPL-3.0-or-later
// Where planes meet, in binary64 with a bound on the error: for searches that ask of most such points no more than which side of other
// planes they lie on.                                                    [proofs/kernels.md, "Points where planes meet, without integers"]
#pragma once

#include <optional>

#include "kernels/filters/meeting_points.hpp"
#include "kernels/vector.hpp"

namespace fathom::kernels {

/// The image of a point: each coordinate errs by at most `error`. If that is no finite number, nothing is known.
struct PointImage {
  Vec3<double> at{};
  double error = 0;
};

/// The point of a plane that is nearest to O.
PointImage foot_image(const PlaneImage& g);

/// The line in which two planes meet, which must outlive it, by their images alone.
class MeetingLine {
 public:
  MeetingLine(const PlaneImage& g, const PlaneImage& h);

  /// True only if the planes are not parallel.
  [[nodiscard]] bool surely_exists() const;
  /// Its point nearest to O.
  [[nodiscard]] PointImage foot() const;
  /// The sign of <g x h, e> for the normals; nullopt if unsure.
  [[nodiscard]] std::optional<Sign> leads_beyond(const PlaneImage& e) const;
  /// The point where all three meet.
  [[nodiscard]] PointImage meeting(const PlaneImage& e) const;

 private:
  const PlaneImage &g_, &h_;
  Vec3<double> direction_;
};

/// The sign of <normal, p> - height; nullopt if unsure.
std::optional<Sign> sure_side(const PlaneImage& plane, const PointImage& p);
/// The sign of |p|^2 - squared; nullopt if unsure.
std::optional<Sign> sure_order(const PointImage& p, double squared);

}  // namespace fathom::kernels
