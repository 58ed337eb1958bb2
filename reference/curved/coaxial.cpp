// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of revolution about one axis: a polygon grows in the half-plane of profiles.
#include <algorithm>
#include <array>
#include <iterator>
#include <list>
#include <map>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "kernels/number/irrational.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/curved/assembly.hpp"
#include "reference/curved/curved_bounds.hpp"
#include "reference/curved/oracle.hpp"

namespace fathom::curved {

namespace {

/// Where the profile is round about O the outline would take as many points as the budget has: it
/// ends here.
constexpr std::size_t most_outline_calls = 1000;
/// Directions of the half-plane of more bits are shortened.
constexpr long most_direction_bits = 128;
constexpr unsigned spare_bits = 12;  // more than the goal's

// Of an atom in this direction, in multiples of |d|.
Surd height_of(const ProfileAtom& atom, const ProfileDirection& u) {
  return {u.a * atom.zeta, atom.along * u.a * u.a + atom.across * u.b * u.b};
}

// A vector orthogonal to d. Axes of atoms are tried first: where d and radii are rational, so is
// the length of one of them.
Vector across_of(const Vector& d, const std::vector<Term>& a, const std::vector<Term>& b) {
  const Point axis = rational(d);
  const mpq_class length = dot(axis, axis);
  std::optional<Vector> any;
  for (const std::vector<Term>* core : {&a, &b}) {
    for (const Term& term : *core) {
      for (const Atom& atom : term.atoms) {
        for (const Point& m : atom.axes) {
          const Vector x = primitive_along(length * m - dot(m, axis) * axis);
          if (is_zero(x)) continue;
          if (kernels::rational_root(length * mpq_class(dot(x, x)))) return x;
          if (!any) any = x;
        }
      }
    }
  }
  for (const Vector& e : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) {
    const Vector x = primitive(cross(d, e));
    if (is_zero(x)) continue;
    if (kernels::rational_root(length * mpq_class(dot(x, x)))) return x;
    if (!any) any = x;
  }
  return *any;
}

// ---- the polygon ----

/// A point of P in the half-plane, and the places of the terms' atoms that it is the sum of.
struct Spot {
  mpq_class z, r;
  std::vector<ProfilePlace> places;
};

// Twice the area of the triangle of O, p and q, positive if q is before p, seen from O.
mpq_class turn(const Spot& p, const Spot& q) { return q.z * p.r - p.z * q.r; }

class ProfileSearch {
 public:
  ProfileSearch(kernels::Context& context, const Profile& profile, const Shape& a, const Shape& b, unsigned bits,
                unsigned status_bits, std::size_t budget)
      : profile_(profile),
        square_(dot(profile.axis, profile.axis)),
        a_(std::get<std::vector<Term>>(a.core)),
        b_(std::get<std::vector<Term>>(b.core)),
        lattice_(lattice(a_, b_, status_bits + spare_bits)),
        goal_(bits, status_bits, lattice_.extent * lattice_.unit + 2 * (a.radius + b.radius), a.radius + b.radius),
        oracle_(context, lattice_, budget),
        assembly_(context, a_, b_, oracle_, goal_),
        bits_(status_bits + spare_bits) {
    const mpq_class ratio = square_ / mpq_class(dot(profile.across, profile.across));
    const auto exact = kernels::rational_root(ratio);
    stretch_ = exact ? *exact : kernels::enclosed({0, ratio}, bits_).low;
    finest_ = static_cast<long>(bits_) + kernels::binary_order(square_) / 2 + 2 -
              (lattice_.extent == 0 ? 0 : kernels::binary_order(lattice_.extent * lattice_.unit));
  }

  std::optional<CurvedBounds> run(const std::optional<ArcDepth>& arcs) {
    if (!start()) return std::nullopt;
    if (arcs) ask(arcs->direction);
    grow();
    assembly_.set_lower(square_ * edges_.begin()->first, revolution());
    std::optional<Surd> exact;
    if (assembly_.closed()) exact = Surd{goal_.rho(), assembly_.lower()};
    else if (arcs) exact = Surd{arcs->depth.rational + goal_.rho(), arcs->depth.root};
    CurvedBounds result = assembly_.take();
    result.exact = std::move(exact);
    return result;
  }

 private:
  using Outline = std::list<Spot>;

  bool start();
  void grow();
  bool split(Outline::iterator edge);
  void ask(const ProfileDirection& u);
  [[nodiscard]] ProfileDirection shortened(ProfileDirection u) const;
  [[nodiscard]] std::array<Spot, 2> ends(const ProfileDirection& u) const;
  [[nodiscard]] ProfilePlace place(const ProfileAtom& atom, const ProfileDirection& u, bool last) const;
  [[nodiscard]] mpq_class below(const mpq_class& x) const;
  [[nodiscard]] mpq_class root_below(const mpq_class& square) const;
  void wait_for(Outline::iterator edge);
  [[nodiscard]] Revolution revolution() const;

  const Profile& profile_;
  const mpq_class square_;  // of |d|
  const std::vector<Term>&a_, &b_;
  Lattice lattice_;
  Goal goal_;
  Oracle oracle_;
  Assembly assembly_;
  unsigned bits_;
  mpq_class stretch_;                                  // |d| / |across|, or a number near to it
  long finest_;                                        // places are multiples of 2^-finest
  Outline outline_;                                    // from the axis behind O to the axis before it
  std::multimap<mpq_class, Outline::iterator> edges_;  // by the square of their distance, in that of |d|
};

// The direction is a rational vector of space, of which the oracle knows the height.
void ProfileSearch::ask(const ProfileDirection& u) {
  if (oracle_.calls() > 0 && oracle_.spent()) return;
  const Vector n = primitive_along(u.a * rational(profile_.axis) + (u.b * stretch_) * rational(profile_.across));
  oracle_.ask(kernels::bit_length(n) <= 3 * most_direction_bits ? n : oracle_.shortened(n), 0);
}

ProfileDirection ProfileSearch::shortened(ProfileDirection u) const {
  const mpz_class unit = lcm(u.a.get_den(), u.b.get_den());
  mpz_class a(u.a * unit), b(u.b * unit);
  const mpz_class factor = gcd(a, b);
  a /= factor, b /= factor;
  const long bits = std::max(kernels::bit_length(a), kernels::bit_length(b)),
             most = std::max(most_direction_bits, static_cast<long>(bits_));
  if (bits > most) {
    a >>= static_cast<mp_bitcnt_t>(bits - most);
    b >>= static_cast<mp_bitcnt_t>(bits - most);
  }
  return {a, b};
}

// Towards 0, which leads into the atom.
mpq_class ProfileSearch::below(const mpq_class& x) const {
  const mpq_class scaled = kernels::times_power_of_two(x, finest_);
  return kernels::times_power_of_two(mpq_class(mpz_class(scaled.get_num() / scaled.get_den())), -finest_);
}

mpq_class ProfileSearch::root_below(const mpq_class& square) const {
  const auto exact = kernels::rational_root(square);
  return exact ? *exact : below(kernels::enclosed({0, square}, bits_ + spare_bits).low);
}

// The point of the atom that is farthest; where it is farthest as a whole, one of its ends: that
// which an outline meets first or last.
ProfilePlace ProfileSearch::place(const ProfileAtom& atom, const ProfileDirection& u, bool last) const {
  const mpq_class square = height_of(atom, u).root;
  if (square == 0) {
    const bool far = last == (u.a < 0);
    mpq_class z = root_below(atom.along);
    return {0, last ? z : mpq_class(-z), far ? root_below(atom.across) : mpq_class(0)};
  }
  if (const auto root = kernels::rational_root(square)) return {0, atom.along * u.a / *root, atom.across * u.b / *root};
  const mpq_class above = kernels::enclosed({0, square}, bits_ + spare_bits).high;
  return {0, below(atom.along * u.a / above), below(atom.across * u.b / above)};
}

// The face of P in this direction, as far as places are known exactly: its two ends.
std::array<Spot, 2> ProfileSearch::ends(const ProfileDirection& u) const {
  std::array<Spot, 2> result;
  for (std::size_t t = 0; t < profile_.terms.size(); ++t) {
    const std::vector<ProfileAtom>& atoms = profile_.terms[t];
    std::optional<Surd> highest;
    std::array<ProfilePlace, 2> found;
    std::array<mpq_class, 2> along;  // the edge
    for (std::uint32_t i = 0; i < atoms.size(); ++i) {
      const Surd height = height_of(atoms[i], u);
      const int higher = highest ? compare(height, *highest) : 1;
      if (higher < 0) continue;
      highest = height;
      for (const bool last : {false, true}) {
        ProfilePlace p = place(atoms[i], u, last);
        p.atom = i;
        const mpq_class where = u.b * (atoms[i].zeta + p.z) - u.a * p.r;
        mpq_class& best = along.at(last ? 1 : 0);
        if (higher == 0 && (last ? where <= best : where >= best)) continue;
        best = where;
        found.at(last ? 1 : 0) = std::move(p);
      }
    }
    for (std::size_t k = 0; k < 2; ++k) {
      ProfilePlace& p = found.at(k);
      result.at(k).z += atoms[p.atom].zeta + p.z;
      result.at(k).r += p.r;
      if (t < profile_.terms_of_a) p.z = -p.z;
      result.at(k).places.push_back(std::move(p));
    }
  }
  return result;
}

void ProfileSearch::wait_for(Outline::iterator edge) {
  const Spot &p = *edge, &q = *std::next(edge);
  const mpq_class c = turn(p, q), dz = q.z - p.z, dr = q.r - p.r;
  edges_.emplace(c * c / (dz * dz + dr * dr), edge);
}

// The half-turn from behind O to before it. False if O is not seen to be inside.
bool ProfileSearch::start() {
  for (const ProfileDirection& u : {ProfileDirection{-1, 0}, ProfileDirection{0, 1}, ProfileDirection{1, 0}}) {
    ask(u);
    if (oracle_.height() <= 0) return false;
    for (Spot& p : ends(u)) {
      if (!outline_.empty() && p.z == outline_.back().z && p.r == outline_.back().r) continue;
      if (!outline_.empty() && turn(outline_.back(), p) <= 0) return false;
      outline_.push_back(std::move(p));
    }
  }
  for (auto edge = outline_.begin(); std::next(edge) != outline_.end(); ++edge) wait_for(edge);
  return outline_.size() > 2 && outline_.front().z < 0 && outline_.back().z > 0;
}

// The nearest edge comes first; where no point of P is above it, it cannot be farther.
void ProfileSearch::grow() {
  while (!assembly_.met(square_ * edges_.begin()->first)) {
    if (oracle_.spent() || oracle_.calls() >= most_outline_calls || !split(edges_.begin()->second)) return;
  }
}

bool ProfileSearch::split(Outline::iterator edge) {
  const Outline::iterator next = std::next(edge);
  const mpq_class a = edge->r - next->r, b = next->z - edge->z, c = turn(*edge, *next);
  if (b < 0) return false;
  const ProfileDirection u = shortened({a, b});
  ask(u);
  std::vector<Spot> above;
  for (Spot& p : ends(u)) {
    const Spot& before = above.empty() ? *edge : above.back();
    if (a * p.z + b * p.r > c && turn(before, p) > 0 && turn(p, *next) > 0) above.push_back(std::move(p));
  }
  if (above.empty()) return false;
  edges_.erase(edges_.begin());
  for (Spot& p : above) outline_.insert(next, std::move(p));
  for (; edge != next; ++edge) wait_for(edge);
  return true;
}

Revolution ProfileSearch::revolution() const {
  Revolution result;
  result.axis = profile_.axis;
  const auto named = [](std::vector<ProfilePoint>& points, ProfilePoint point) {
    const auto same = [](const ProfilePlace& p, const ProfilePlace& q) {
      return p.atom == q.atom && p.z == q.z && p.r == q.r;
    };
    if (points.empty() || !std::ranges::equal(points.back(), point, same)) points.push_back(std::move(point));
    return static_cast<std::uint32_t>(points.size() - 1);
  };
  for (const Spot& p : outline_) {
    const auto middle = p.places.begin() + static_cast<std::ptrdiff_t>(profile_.terms_of_a);
    const std::uint32_t i = named(result.points_a, {p.places.begin(), middle}),
                        j = named(result.points_b, {middle, p.places.end()});
    result.outline.emplace_back(i, j);
  }
  return result;
}

}  // namespace

std::optional<Profile> common_profile(const std::vector<Term>& a, const std::vector<Term>& b) {
  const auto of_a = shapes::axis_of(a), of_b = shapes::axis_of(b);
  if (!of_a || !of_b) return std::nullopt;
  const Point apart = of_b->point - of_a->point;
  Profile profile;
  if (of_a->direction) profile.axis = *of_a->direction;
  else if (of_b->direction) profile.axis = *of_b->direction;
  else profile.axis = apart == Point{} ? Vector{0, 0, 1} : primitive_along(apart);
  const Point d = rational(profile.axis);
  if (of_b->direction && !is_zero(cross(*of_b->direction, profile.axis))) return std::nullopt;
  if (cross(apart, d) != Point{}) return std::nullopt;
  profile.terms_of_a = a.size();
  profile.across = across_of(profile.axis, a, b);
  const auto along = [&](const Point& p) { return mpq_class(dot(p, d) / dot(d, d)); };
  for (const std::vector<Term>* core : {&a, &b}) {
    for (const Term& term : *core) {
      const mpq_class start = profile.terms.empty() ? along(apart) : mpq_class(0);
      std::vector<ProfileAtom>& atoms = profile.terms.emplace_back();
      for (const Atom& atom : term.atoms) {
        const mpq_class zeta = along(atom.center - term.atoms.front().center);
        atoms.push_back({*shapes::profile_about(atom, profile.axis),
                         core == &a ? mpq_class(start - zeta) : mpq_class(start + zeta)});
      }
    }
  }
  return profile;
}

std::optional<CurvedBounds> coaxial_bounds(kernels::Context& context, const Profile& profile, const Shape& a,
                                           const Shape& b, unsigned bits, unsigned status_bits,
                                           std::size_t support_calls) {
  return ProfileSearch(context, profile, a, b, bits, status_bits, support_calls).run(depth_of_arcs(profile));
}

// The depth where the profile of P is made of segments and arcs: its least is in one of finitely
// many directions.                                 [proofs/shapes_curved.md, "Around one axis"]

namespace {

/// More atoms, of all terms together, have too many pairs.
constexpr std::size_t most_tied_atoms = 40;
constexpr unsigned direction_bits = 128;

/// x + y sqrt(D), for one D.
struct RootTerm {
  mpq_class x, y;
};
RootTerm operator+(const RootTerm& p, const RootTerm& q) { return {p.x + q.x, p.y + q.y}; }
Surd surd(const RootTerm& p, const mpq_class& square) { return {p.x, p.y * abs(p.y) * square}; }

/// What an atom adds to the height of the unit vector (a, b): center a + rim b + radius.
struct Arc {
  mpq_class center, rim, radius;
  [[nodiscard]] RootTerm height(const RootTerm& a, const RootTerm& b) const {
    return {center * a.x + rim * b.x + radius, center * a.y + rim * b.y};
  }
};

class ArcSearch {
 public:
  explicit ArcSearch(std::vector<std::vector<Arc>> terms) : terms_(std::move(terms)) {}

  ArcDepth run() {
    try_direction({1, 0}, {0, 0}, 0);
    try_direction({-1, 0}, {0, 0}, 0);
    for (const std::vector<Arc>& term : terms_)
      for (std::size_t i = 0; i < term.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) try_tie(term[i], term[j]);
    return std::move(*best_);
  }

 private:
  // The unit vectors with p a + q b + s = 0: a line meets the circle.
  void try_tie(const Arc& one, const Arc& other) {
    const mpq_class p = one.center - other.center, q = one.rim - other.rim, s = one.radius - other.radius;
    const mpq_class norm = p * p + q * q, square = norm - s * s;
    if (norm == 0 || square < 0) return;
    for (const int side : {1, -1})
      try_direction({-s * p / norm, -side * q / norm}, {-s * q / norm, side * p / norm}, square);
  }

  void try_direction(const RootTerm& a, const RootTerm& b, const mpq_class& square) {
    if (sign(surd(b, square)) < 0) return;
    RootTerm sum;
    for (const std::vector<Arc>& term : terms_) {
      RootTerm highest = term.front().height(a, b);
      for (const Arc& arc : term) {
        const RootTerm height = arc.height(a, b);
        if (sign(surd({height.x - highest.x, height.y - highest.y}, square)) > 0) highest = height;
      }
      sum = sum + highest;
    }
    const Surd depth = surd(sum, square);
    if (best_ && compare(depth, best_->depth) >= 0) return;
    const auto near = [&](const RootTerm& p) { return kernels::enclosed(surd(p, square), direction_bits).low; };
    best_ = {depth, {near(a), std::max(near(b), mpq_class(0))}};
  }

  std::vector<std::vector<Arc>> terms_;
  std::optional<ArcDepth> best_;
};

}  // namespace

std::optional<ArcDepth> depth_of_arcs(const Profile& profile) {
  const std::optional<mpq_class> length = kernels::rational_root(mpq_class(dot(profile.axis, profile.axis)));
  if (!length) return std::nullopt;
  std::vector<std::vector<Arc>> terms;
  std::size_t atoms = 0;
  for (const std::vector<ProfileAtom>& term : profile.terms) {
    atoms += term.size();
    if (atoms > most_tied_atoms) return std::nullopt;
    terms.emplace_back();
    for (const ProfileAtom& atom : term) {
      const std::optional<mpq_class> root = kernels::rational_root(atom.across);
      if (!root || (atom.along != 0 && atom.along != atom.across)) return std::nullopt;
      const mpq_class radius = *root * *length;
      const bool round = atom.along != 0;
      terms.back().push_back({atom.zeta * *length, round ? mpq_class(0) : radius, round ? radius : mpq_class(0)});
    }
  }
  return ArcSearch(std::move(terms)).run();
}

}  // namespace fathom::curved
