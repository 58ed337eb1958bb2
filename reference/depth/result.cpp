// SPDX-License-Identifier: GPL-3.0-or-later
// Accessors of Depth for every status.
#include "fathom/depth.hpp"

namespace fathom {

const mpq_class& Depth::squared() const {
  static const mpq_class zero;
  return penetration() ? penetration()->squared : zero;
}

const std::vector<Optimum>& Depth::optima() const {
  static const std::vector<Optimum> none;
  return penetration() ? penetration()->optima : none;
}

std::size_t Depth::optima_count() const { return penetration() ? penetration()->optima.size() + penetration()->unlisted : 0; }

const Vector& Depth::direction() const {
  if (touch()) return touch()->direction;
  return distance() ? distance()->direction : optima().front().direction;
}

const Point& Depth::translation() const {
  static const Point zero;
  return penetration() ? optima().front().translation : zero;
}

const Contact* Depth::contact() const { return penetration() ? &optima().front().contact : nullptr; }

std::optional<Witness> Depth::witness() const {
  if (touch()) return Witness{touch()->point, touch()->point};
  return penetration() ? std::optional(penetration()->witness) : std::nullopt;
}

mpq_class signed_square(const Depth& depth) { return depth.distance() ? mpq_class(-depth.distance()->squared) : depth.squared(); }

}  // namespace fathom
