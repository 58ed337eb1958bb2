// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/approximate/body_pair.hpp"

#include "fathom/approximate.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/vector.hpp"
#include "reference/depth/contact.hpp"
#include "reference/polytope/position.hpp"

namespace fathom {

BodyPair::BodyPair(kernels::Context& context, std::span<const Point> a, std::span<const Point> b)
    : placed_(polytope::place(a, b)), facts_(depth::facts_of(placed_)) {
  const polytope::PositionOfOrigin origin = polytope::position_of_origin(placed_.a, placed_.b);
  if (origin.position == polytope::Position::inside)
    solid_ = std::make_unique<const Solid>(depth::hulls_of(context, placed_, facts_));
  else separation_ = Separation{*origin.normal, origin.position == polytope::Position::boundary};
}

Point BodyPair::translation(const mpq_class& factor, const Vector& u) const {
  return mpq_class(factor / placed_.denominator) * u;
}

BodyPair::Meeting BodyPair::meeting(const Vector& n, const Point& t) const {
  const depth::FacingFaces faces = depth::facing_faces(placed_, n);
  const mpz_class d = lcm(lcm(t.x.get_den(), t.y.get_den()), t.z.get_den());
  const mpq_class s = placed_.denominator * d;
  const Vector v{mpq_class(s * t.x).get_num(), mpq_class(s * t.y).get_num(), mpq_class(s * t.z).get_num()};
  return {{depth::kind_of(faces.a.ids.size(), faces.b.ids.size()), faces.a.ids, faces.b.ids},
          depth::meeting_points(placed_, faces, v, d)};
}

Hierarchies::Hierarchies(std::span<const Point> a, std::span<const Point> b, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  kernels::Context context(monitor);
  pair_ = std::make_unique<const BodyPair>(context, a, b);
}

Hierarchies::Hierarchies(Hierarchies&&) noexcept = default;
Hierarchies& Hierarchies::operator=(Hierarchies&&) noexcept = default;
Hierarchies::~Hierarchies() = default;

}  // namespace fathom
