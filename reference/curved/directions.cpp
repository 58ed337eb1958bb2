// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "kernels/number/rational.hpp"
#include "kernels/predicates/direction.hpp"
#include "reference/curved/oracle.hpp"
#include "reference/expanding/surface.hpp"

namespace fathom::curved {
namespace {

constexpr std::size_t most_hull_points = 200;  // a term of more has no facets tried
constexpr std::size_t most_frames = 6;
constexpr long edge_bits = 40;  // an edge is orthogonal if the cosine is less than about 2^-40
constexpr long fan_bits = 24;   // of a direction that need not be exact
constexpr unsigned short_by =
    7;  // a fraction stands out if it is nearer by this many bits than one of its length has to be

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
  [[nodiscard]] Corner corner(std::uint32_t i) const {
    return {{i, i}, points_[i], kernels::image(points_[i], exponent_)};
  }
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
    const std::vector<Vector> points = points_of(term);
    for (const LatticeAtom& atom : term.atoms) {
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

// The convergent of p/q, |p| <= q, before the greatest partial quotient, if that is large. A random
// number has none; one that is near to a fraction has it there. Quotients of convergents whose
// denominator squared is beyond q are not looked at: they are noise.
std::optional<mpq_class> short_fraction(const mpz_class& p, const mpz_class& q) {
  mpz_class number = abs(p), divisor = q, quotient, rest;
  mpz_class above = 1, below = 0, last_above = 0, last_below = 1;  // the convergent, and the one before
  std::optional<mpq_class> best;
  mpz_class largest = mpz_class(1) << short_by;
  for (bool first = true; divisor != 0 && below * below <= q; first = false) {
    mpz_fdiv_qr(quotient.get_mpz_t(), rest.get_mpz_t(), number.get_mpz_t(), divisor.get_mpz_t());
    if (!first && quotient >= largest) {
      largest = quotient;
      best = kernels::ratio(sgn(p) < 0 ? mpz_class(-above) : above, below);
    }
    last_above += quotient * above;
    last_below += quotient * below;
    swap(above, last_above);
    swap(below, last_below);
    swap(number, divisor);
    swap(divisor, rest);
  }
  if (divisor == 0 && below * below <= q) best = kernels::ratio(sgn(p) < 0 ? mpz_class(-above) : above, below);
  return best;
}

// A multiple > 0 of the short vector that n is near to.
std::optional<Vector> short_vector(const Vector& n) {
  const mpz_class longest = std::max({mpz_class(abs(n.x)), mpz_class(abs(n.y)), mpz_class(abs(n.z))});
  const std::optional<mpq_class> x = short_fraction(n.x, longest), y = short_fraction(n.y, longest),
                                 z = short_fraction(n.z, longest);
  if (!x || !y || !z) return std::nullopt;
  const mpz_class multiple = lcm(lcm(x->get_den(), y->get_den()), z->get_den());
  return Vector{mpz_class(*x * multiple), mpz_class(*y * multiple), mpz_class(*z * multiple)};
}

// Three independent vectors: the axes of a ball, or of a disc with its normal, which is as long if
// they are orthogonal and of one length.
std::optional<std::array<Vector, 3>> frame_of(const LatticeAtom& atom) {
  if (atom.axes.empty()) return std::nullopt;
  std::array<Vector, 3> frame{atom.axes[0], atom.axes[1],
                              atom.axes.size() == 3 ? atom.axes[2] : cross(atom.axes[0], atom.axes[1])};
  if (sgn(det(frame[0], frame[1], frame[2])) == 0) return std::nullopt;
  if (atom.axes.size() == 3) return frame;
  mpz_class length, rest;
  mpz_sqrtrem(length.get_mpz_t(), rest.get_mpz_t(), mpz_class(dot(frame[0], frame[0])).get_mpz_t());
  if (rest == 0)
    for (std::size_t k = 0; k < 2; ++k) frame[k] = scaled(length, frame[k]);
  return frame;
}

// The tangent of a disc where n touches it, if that is short in the disc's axes.
std::optional<Vector> short_tangent(const LatticeAtom& disc, const Vector& n) {
  const mpz_class x = dot(disc.axes[0], n), y = dot(disc.axes[1], n);
  const bool swapped = abs(x) < abs(y);
  const mpz_class &longer = swapped ? y : x, &shorter = swapped ? x : y;
  if (longer == 0) return std::nullopt;
  const std::optional<mpq_class> ratio = short_fraction(sgn(longer) < 0 ? mpz_class(-shorter) : shorter, abs(longer));
  if (!ratio) return std::nullopt;
  const Vector &along = disc.axes[swapped ? 1 : 0], &across = disc.axes[swapped ? 0 : 1];
  return Vector(scaled(ratio->get_den(), across) - scaled(ratio->get_num(), along));
}

// Edges of few points, and tangents of discs, to which n is nearly orthogonal.
std::vector<Vector> tangents(const Lattice& lattice, const Vector& n) {
  std::vector<Vector> result;
  for (const LatticeTerm& term : lattice.terms) {
    for (const LatticeAtom& atom : term.atoms) {
      if (atom.axes.size() != 2 || atom.repeats) continue;
      if (auto tangent = short_tangent(atom, n); tangent && !is_zero(*tangent)) result.push_back(std::move(*tangent));
    }
    const std::vector<Vector> points = points_of(term);
    if (points.size() > most_edge_points) continue;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Vector edge = points[i] - points[j];
        if (kernels::bit_length(mpz_class(dot(edge, n))) + edge_bits <
            kernels::bit_length(edge) + kernels::bit_length(n))
          result.push_back(edge);
      }
    }
  }
  return result;
}

}  // namespace

std::vector<Vector> short_directions(const Lattice& lattice, const Vector& n) {
  std::vector<std::array<Vector, 3>> frames{{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}};
  for (const LatticeTerm& term : lattice.terms) {
    for (const LatticeAtom& atom : term.atoms) {
      if (frames.size() == most_frames || atom.repeats) continue;
      if (auto frame = frame_of(atom)) frames.push_back(std::move(*frame));
    }
  }
  std::vector<Vector> result{primitive(n)};
  for (const auto& [u, v, w] : frames) {
    const std::optional<Vector> found = short_vector({dot(u, n), dot(v, n), dot(w, n)});
    if (!found) continue;
    // <u,m>, <v,m>, <w,m> are those of m times the determinant.
    const Vector m = scaled(found->x, cross(v, w)) + scaled(found->y, cross(w, u)) + scaled(found->z, cross(u, v));
    const Vector other = primitive(sgn(det(u, v, w)) < 0 ? Vector(-m) : m);
    if (std::find(result.begin(), result.end(), other) == result.end()) result.push_back(other);
  }
  result.erase(result.begin());
  return result;
}

std::vector<Vector> fan_directions(const Lattice& lattice, const Vector& n) {
  Vector rough = n;
  const long shift = std::max(kernels::bit_length(n) - fan_bits, 0L);
  for (mpz_class* c : {&rough.x, &rough.y, &rough.z}) *c >>= static_cast<mp_bitcnt_t>(shift);
  std::vector<Vector> result;
  for (const Vector& t : tangents(lattice, n)) {
    const Vector m = scaled(dot(t, t), rough) - scaled(dot(rough, t), t);
    if (!is_zero(m)) result.push_back(primitive(m));
  }
  return result;
}

std::vector<Vector> likely_directions(const Lattice& lattice, std::size_t most) {
  return Directions(lattice).run(most);
}

}  // namespace fathom::curved
