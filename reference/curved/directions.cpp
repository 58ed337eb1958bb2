// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/curved/directions.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "kernels/filters/double_images.hpp"
#include "reference/expanding/surface.hpp"

namespace fathom::curved {
namespace {

constexpr std::size_t most_hull_points = 200;  // a term of more has no facets tried

Vector scaled(const mpz_class& s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }

// Normals of the facets of a hull; if it is flat, those of its plane. Points are added one by one.
class FacetNormals {
 public:
  FacetNormals(const std::vector<Vector>& points, std::vector<Vector>& normals) : points_(points), normals_(normals) {}

  void run() {
    const Vector& p = points_.front();
    const auto second = first_with([&](const Vector& q) { return !is_zero(Vector(q - p)); });
    if (!second) return;
    const Vector line = points_[*second] - p;
    const auto third = first_with([&](const Vector& q) { return !is_zero(cross(line, Vector(q - p))); });
    if (!third) return;
    const Vector normal = cross(line, Vector(points_[*third] - p));
    const auto fourth = first_with([&](const Vector& q) { return sgn(dot(normal, Vector(q - p))) != 0; });
    if (!fourth) {
      normals_.push_back(normal);
      normals_.push_back(-normal);
      return;
    }
    surface_.start({corner(0), corner(*second), corner(*third), corner(*fourth)});
    for (std::uint32_t i = 1; i < points_.size(); ++i)
      if (i != *second && i != *third && i != *fourth) add(corner(i));
    for (const expanding::TriangleId t : surface_.triangles().ids())
      if (surface_.triangles()[t].alive) normals_.push_back(surface_.plane(t).normal);
  }

 private:
  using Corner = expanding::SurfaceVertex<mpz_class>;

  template <class Test>
  std::optional<std::uint32_t> first_with(Test test) const {
    const auto found = std::find_if(points_.begin(), points_.end(), test);
    if (found == points_.end()) return std::nullopt;
    return static_cast<std::uint32_t>(found - points_.begin());
  }
  [[nodiscard]] Corner corner(std::uint32_t i) const { return {{i, i}, points_[i], kernels::image(points_[i], exponent_)}; }
  void add(const Corner& corner) {
    for (const expanding::TriangleId t : surface_.triangles().ids()) {
      if (!surface_.triangles()[t].alive || surface_.side(t, corner) <= 0) continue;
      surface_.insert(corner, t);
      return;
    }
  }

  const std::vector<Vector>& points_;
  std::vector<Vector>& normals_;
  long exponent_ = kernels::binary_exponent(points_);
  expanding::Surface<mpz_class> surface_;
};

// h(u)/|u| in binary64, for P times some power of two.
class RoughSupport {
 public:
  explicit RoughSupport(const Lattice& lattice)
      : exponent_(lattice.exponent - static_cast<long>(lattice.fine)), offset_(image(lattice.offset)) {
    for (const LatticeTerm& term : lattice.terms) {
      terms_.emplace_back();
      for (const LatticeAtom& atom : term.atoms) {
        terms_.back().push_back({image(atom.center), {}});
        for (const Vector& axis : atom.axes) terms_.back().back().axes.push_back(image(axis));
      }
      for (const Vector& point : term.cloud.points()) terms_.back().push_back({image(point), {}});
    }
  }

  double operator()(const Vector& direction) const {
    const Vec3<double> n = kernels::direction_image(direction);
    double sum = dot(n, offset_);
    for (const std::vector<RoughAtom>& term : terms_) {
      double greatest = -HUGE_VAL;
      for (const RoughAtom& atom : term) {
        double square = 0;
        for (const Vec3<double>& axis : atom.axes) square += dot(n, axis) * dot(n, axis);
        greatest = std::max(greatest, dot(n, atom.center) + std::sqrt(square));
      }
      sum += greatest;
    }
    return sum / std::sqrt(dot(n, n));
  }

 private:
  struct RoughAtom {
    Vec3<double> center;
    std::vector<Vec3<double>> axes;
  };
  [[nodiscard]] Vec3<double> image(const Vector& v) const { return kernels::image(v, exponent_); }

  long exponent_;
  Vec3<double> offset_;
  std::vector<std::vector<RoughAtom>> terms_;
};

class Directions {
 public:
  explicit Directions(const Lattice& lattice) : lattice_(lattice) {}

  std::vector<Vector> run(std::size_t most) {
    for (const Vector& axis : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) add_both(axis);
    for (const LatticeTerm& term : lattice_.terms) add_of(term);
    const Vector center = between_centers();
    add(-center);
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      add_both(lines_[i]);
      add(Vector(scaled(dot(center, lines_[i]), lines_[i]) - scaled(dot(lines_[i], lines_[i]), center)));
      for (std::size_t j = 0; j < i; ++j) add_both(cross(lines_[i], lines_[j]));
    }
    return best(most);
  }

 private:
  void add(const Vector& n) {
    if (!is_zero(n)) found_.push_back(n);
  }
  void add_both(const Vector& n) {
    add(n);
    add(-n);
  }

  void add_of(const LatticeTerm& term) {
    std::vector<Vector> points = term.cloud.points();
    for (const LatticeAtom& atom : term.atoms) {
      if (atom.axes.empty()) points.push_back(atom.center);
      if (atom.repeats) continue;
      for (const Vector& axis : atom.axes) add_both(axis);
      if (atom.axes.size() == 2) lines_.push_back(cross(atom.axes[0], atom.axes[1]));
    }
    if (points.size() == 2) lines_.push_back(points[1] - points[0]);
    if (points.size() >= 3 && points.size() <= most_hull_points) FacetNormals(points, found_).run();
  }

  // A multiple of the vector from A's center to B's: of each term the mean of the atoms' centers.
  [[nodiscard]] Vector between_centers() const {
    mpz_class multiple = 1;
    const auto count = [](const LatticeTerm& term) { return mpz_class(term.atoms.size() + term.cloud.size()); };
    for (const LatticeTerm& term : lattice_.terms) multiple = lcm(multiple, count(term));
    Vector sum = scaled(multiple, lattice_.offset);
    for (const LatticeTerm& term : lattice_.terms) {
      const mpz_class weight = multiple / count(term);
      for (const LatticeAtom& atom : term.atoms) sum = sum + scaled(weight, atom.center);
      for (const Vector& point : term.cloud.points()) sum = sum + scaled(weight, point);
    }
    return sum;
  }

  [[nodiscard]] std::vector<Vector> best(std::size_t most) const {
    const RoughSupport support(lattice_);
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < found_.size(); ++i) order.emplace_back(support(found_[i]), i);
    std::sort(order.begin(), order.end());
    std::vector<Vector> result;
    for (const auto& [height, i] : order) {
      if (result.size() == most) break;
      Vector n = primitive(found_[i]);
      if (std::find(result.begin(), result.end(), n) == result.end()) result.push_back(std::move(n));
    }
    return result;
  }

  const Lattice& lattice_;
  std::vector<Vector> found_, lines_;
};

}  // namespace

std::vector<Vector> likely_directions(const Lattice& lattice, std::size_t most) { return Directions(lattice).run(most); }

}  // namespace fathom::curved
