// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <utility>

#include "kernels/number/rational.hpp"
#include "reference/approximate/directions.hpp"
#include "reference/approximate/shallow.hpp"

namespace fathom::approximate {
namespace {

constexpr std::size_t directions_between_reports = 64;

const std::array<Vector, 6> six_axes{Vector{1, 0, 0},  Vector{-1, 0, 0}, Vector{0, 1, 0},
                                     Vector{0, -1, 0}, Vector{0, 0, 1},  Vector{0, 0, -1}};

mpq_class square(const mpq_class& q) { return q * q; }

std::vector<Vector> directions(kernels::Context& context, const mpq_class& delta) {
  const DirectionGrid grid(context, delta);
  std::vector<Vector> result;
  result.reserve(grid.size());
  for (std::uint64_t cell = 0; cell < grid.size(); ++cell) result.push_back(grid.centre(cell));
  return result;
}

/// Whether the angle between u and v is smaller than that between u and w; both are less than right ones.
bool closer(const Vector& u, const Vector& v, const Vector& w) {
  const mpz_class along_v = dot(u, v), along_w = dot(u, w);
  return along_v * along_v * dot(w, w) > along_w * along_w * dot(v, v);
}

// What the rays from one start have found so far.
class Search {
 public:
  Search(const RayShooter& shooter, const Vector& start) : shooter_(shooter), start_(start) {}

  /// False if O is not inside P.
  bool look(const Vector& u, const mpq_class& delta) {
    if (known_.size() >= six_axes.size() && too_long(u, delta)) {
      ++result_.skipped;
      return true;
    }
    RayHit hit = shooter_.shoot(u, start_);
    ++result_.rays;
    result_.steps += hit.steps;
    result_.inside = hit.interior;
    if (!hit.interior) return false;
    const mpz_class height = hit.height - dot(hit.normal, start_);
    const mpq_class plane_squared = kernels::ratio(height * height, dot(hit.normal, hit.normal));
    if (known_.empty() || plane_squared < result_.nearest_squared) result_.nearest_squared = plane_squared;
    mpq_class length_squared = square(hit.factor) * dot(u, u);
    known_.push_back({u, std::move(hit.normal), std::move(hit.factor), std::move(length_squared)});
    gauge_.add(known_.back());
    return true;
  }

  NearRays result(const mpq_class& delta) {
    if (!result_.inside) return std::move(result_);
    const mpq_class limit_squared = square(1 + delta) * result_.nearest_squared;
    std::ranges::copy_if(known_, std::back_inserter(result_.in_reach),
                         [&](const NearRay& ray) { return ray.length_squared <= limit_squared; });
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool too_long(const Vector& u, const mpq_class& delta) const {
    return gauge_.below(u, square(1 + delta) * result_.nearest_squared / dot(u, u));
  }

  const RayShooter& shooter_;
  const Vector& start_;
  NearRays result_;
  std::vector<NearRay> known_;
  GaugeBound gauge_;
};

}  // namespace

void GaugeBound::add(const NearRay& ray) {
  std::vector<Known>& list = axes_.size() < six_axes.size() ? axes_ : others_;
  list.push_back({ray.direction, 1 / ray.factor});
}

bool GaugeBound::below(const Vector& u, const mpq_class& bound_squared) const {
  if (square(along_axes({u.x, u.y, u.z})) * bound_squared < 1) return true;
  const Known* nearest = nullptr;
  for (const Known& known : others_) {
    if (dot(u, known.direction) > 0 && (!nearest || closer(u, known.direction, nearest->direction))) nearest = &known;
  }
  return nearest && square(along(u, *nearest)) * bound_squared < 1;
}

mpq_class GaugeBound::along_axes(const std::array<mpq_class, 3>& r) const {
  mpq_class sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += abs(r[i]) * axes_[2 * i + (r[i] < 0 ? 1 : 0)].gauge;
  return sum;
}

// With u = s k + r, s >= 0, the gauge of u is at most s gauge(k) plus that of r along the axes. As a function of s this is convex and
// linear in pieces: it is least at s = 0, or where a component of r vanishes.
mpq_class GaugeBound::along(const Vector& u, const Known& known) const {
  const std::array<mpz_class, 3> to{u.x, u.y, u.z}, k{known.direction.x, known.direction.y, known.direction.z};
  mpq_class least = along_axes({to[0], to[1], to[2]});
  for (std::size_t i = 0; i < 3; ++i) {
    if (sgn(to[i]) * sgn(k[i]) <= 0) continue;
    const mpq_class s = kernels::ratio(to[i], k[i]);
    const mpq_class sum = s * known.gauge + along_axes({to[0] - s * k[0], to[1] - s * k[1], to[2] - s * k[2]});
    if (sum < least) least = sum;
  }
  return least;
}

RayGrids::RayGrids(kernels::Context& context, const mpq_class& delta) {
  std::vector<Vector> finest = directions(context, delta);
  grids_.push_back({std::max(delta, mpq_class(1)), {six_axes.begin(), six_axes.end()}});
  for (mpq_class coarse = mpq_class(1, 4); coarse > delta; coarse /= 4) {
    std::vector<Vector> grid = directions(context, coarse);
    if (grid.size() < finest.size()) grids_.push_back({coarse, std::move(grid)});
  }
  if (finest.size() > six_axes.size()) grids_.push_back({delta, std::move(finest)});
}

NearRays RayGrids::shoot(kernels::Context& context, const RayShooter& shooter, const Vector& start) const {
  Search search(shooter, start);
  std::size_t done = 0, all = 0;
  for (const Grid& grid : grids_) all += grid.directions.size();
  for (const Grid& grid : grids_) {
    for (const Vector& u : grid.directions) {
      if (done++ % directions_between_reports == 0)
        context.report("rays near the origin", static_cast<double>(done - 1) / static_cast<double>(all));
      if (!search.look(u, grid.delta)) return search.result(grid.delta);
    }
  }
  return search.result(grids_.back().delta);
}

}  // namespace fathom::approximate
