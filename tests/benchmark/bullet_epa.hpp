// SPDX-License-Identifier: GPL-3.0-or-later
// Bullet's EPA on one pair of hulls, as an engine calls it: binary32, margin 0. Only if Bullet was
// found.
#pragma once

#include <memory>

#include "fathom/files.hpp"

namespace fathom::benchmarks {

class BulletPair {
 public:
  explicit BulletPair(const Case& input);
  ~BulletPair();
  BulletPair(BulletPair&&) noexcept;

  /// The depth as Bullet finds it, or a negative number if it finds none.
  double depth() const;

 private:
  struct Hulls;
  std::unique_ptr<Hulls> hulls_;
};

}  // namespace fathom::benchmarks
