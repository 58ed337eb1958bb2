// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers are looked at as bits: where the caller has small ones flushed to zero, they would
// compare equal to 0.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "fathom/body.hpp"
#include "fathom/numbers.hpp"

namespace fathom {
namespace {

using Bits = std::array<std::uint64_t, 3>;

}  // namespace

struct GivenPoints::Given {
  std::vector<std::array<double, 3>> points;  // or else
  std::size_t count = 0;
  std::function<std::vector<Point>()> make;
  mutable std::once_flag asked;
  mutable std::vector<Point> exact;  // once asked for
};

GivenPoints::GivenPoints(std::vector<std::array<double, 3>> points) {
  constexpr std::uint64_t infinity = std::uint64_t{0x7ff} << 53;  // without its sign
  for (std::array<double, 3>& p : points) {
    for (double& c : p) {
      const std::uint64_t size = std::bit_cast<std::uint64_t>(c) << 1;
      if (size >= infinity) throw std::invalid_argument("a coordinate is not a finite number");
      if (size == 0) c = 0;
    }
  }
  if (points.empty()) return;
  auto given = std::make_shared<Given>();
  given->points = std::move(points);
  given_ = std::move(given);
}

GivenPoints::GivenPoints(std::size_t count, std::function<std::vector<Point>()> make) {
  auto given = std::make_shared<Given>();
  given->count = count;
  given->make = std::move(make);
  given_ = std::move(given);
}

std::size_t GivenPoints::size() const {
  return given_ ? std::max(given_->points.size(), given_->count) : exact_.size();
}

std::span<const std::array<double, 3>> GivenPoints::binary64() const {
  return given_ ? std::span<const std::array<double, 3>>(given_->points) : std::span<const std::array<double, 3>>();
}

const std::vector<Point>& GivenPoints::exact() const {
  if (!given_) return exact_;
  std::call_once(given_->asked, [given = given_.get()] {
    if (given->make) {
      given->exact = given->make();
      return;
    }
    std::vector<Point> points;
    points.reserve(given->points.size());
    for (const auto& [x, y, z] : given->points) points.push_back({exact_value(x), exact_value(y), exact_value(z)});
    given->exact = std::move(points);
  });
  return given_->exact;
}

std::vector<Point>& GivenPoints::edit() {
  if (given_) {
    exact_ = exact();
    given_.reset();
  }
  return exact_;
}

bool operator==(const GivenPoints& p, const GivenPoints& q) {
  const auto same = [](const auto& x, const auto& y) { return std::bit_cast<Bits>(x) == std::bit_cast<Bits>(y); };
  if (p.in_binary64() && q.in_binary64()) return std::ranges::equal(p.binary64(), q.binary64(), same);
  return p.exact() == q.exact();
}

}  // namespace fathom
