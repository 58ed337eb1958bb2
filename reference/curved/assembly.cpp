// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/curved/assembly.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "kernels/number/irrational.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/curved/oracle.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::curved {

namespace {

// floor(sqrt(x) * 2^exponent) / 2^exponent, or the ceiling. x >= 0.
mpq_class root(const mpq_class& x, long exponent, bool up) {
  const mpq_class scaled = kernels::times_power_of_two(x, 2 * exponent);
  const mpz_class whole = up ? rounded_up(scaled) : mpz_class(scaled.get_num() / scaled.get_den());
  mpz_class result, rest;
  mpz_sqrtrem(result.get_mpz_t(), rest.get_mpz_t(), whole.get_mpz_t());
  if (up && rest != 0) ++result;
  return kernels::times_power_of_two(mpq_class(result), -exponent);
}

constexpr unsigned weight_bits = 12;  // more than the goal's

// Numbers a list of points, each once.
class Names {
 public:
  explicit Names(std::vector<InnerPoint>& points) : points_(points) {}

  std::uint32_t operator()(InnerPoint point) {
    const auto [place, fresh] = names_.try_emplace(std::move(point), static_cast<std::uint32_t>(points_.size()));
    if (fresh) points_.push_back(place->first);
    return place->second;
  }

 private:
  struct Before {
    bool operator()(const AtomPoint& p, const AtomPoint& q) const {
      return p.atom != q.atom ? p.atom < q.atom : p.local < q.local;
    }
    bool operator()(const InnerPoint& p, const InnerPoint& q) const {
      return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end(), *this);
    }
  };

  std::vector<InnerPoint>& points_;
  std::map<InnerPoint, std::uint32_t, Before> names_;
};

// Multiples of 2^-bits near the weights, which sum to 1 as they do; of the small ones none is
// larger than the weight.
std::vector<mpz_class> rounded_weights(const polytope::SimplexFoot<mpz_class>& z, unsigned bits) {
  std::vector<mpz_class> result;
  mpz_class rest = mpz_class(1) << bits;
  for (const mpz_class& weight : z.weights) {
    result.emplace_back((weight << bits) / z.denominator);
    rest -= result.back();
  }
  *std::max_element(result.begin(), result.end()) += rest;
  return result;
}

}  // namespace

mpz_class rounded_up(const mpq_class& value) {
  mpz_class result;
  mpz_cdiv_q(result.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
  return result;
}

Goal::Goal(unsigned bits, unsigned status_bits, mpq_class extent, mpq_class rho)
    : status_bits_(status_bits),
      extent_(std::move(extent)),
      rho_(std::move(rho)),
      share_(kernels::times_power_of_two(15, -static_cast<long>(bits) - 4)),
      status_share_(kernels::times_power_of_two(15, -static_cast<long>(status_bits) - 4)) {}

long Goal::finest(const mpq_class& x) const {
  if (extent_ == 0 && x == 0) return 0;
  const long order = extent_ == 0 ? kernels::binary_order(x) / 2 - 1 : kernels::binary_order(extent_);
  return static_cast<long>(status_bits_) + 6 - order;
}

mpq_class Goal::from_below(const mpq_class& x) const {
  return rho_ + (x < 0 ? mpq_class(-root(-x, finest(x), true)) : root(x, finest(x), false));
}

mpq_class Goal::from_above(const mpq_class& x) const {
  return rho_ + (x < 0 ? mpq_class(-root(-x, finest(x), false)) : root(x, finest(x), true));
}

mpq_class Goal::exact_or_below(const mpq_class& x) const {
  const auto exact = kernels::rational_root(x);
  return exact ? mpq_class(rho_ + *exact) : from_below(x);
}

mpq_class Goal::exact_or_above(const mpq_class& x) const {
  const auto exact = kernels::rational_root(x);
  return exact ? mpq_class(rho_ + *exact) : from_above(x);
}

bool Goal::met(const mpq_class& low, const mpq_class& high) const {
  const mpq_class width = high - low;
  if (!decided(low, high)) return width <= status_share_ * extent_;
  return width <= share_ * std::max({extent_, std::min(mpq_class(abs(low)), mpq_class(abs(high)))});
}

// ---- the two sides of the bounds ----

mpq_class signed_square(const mpq_class& height, const Vector& n) {
  return height * abs(height) / mpq_class(dot(n, n));
}

std::vector<mpq_class> short_heights(const std::vector<TermHeight>& heights, const Vector& n, const Goal& goal) {
  const bool exact = std::all_of(heights.begin(), heights.end(), [](const TermHeight& h) { return h.exact; });
  mpq_class sum;
  for (const TermHeight& h : heights) sum += h.height;
  const long spare =
      4 + kernels::binary_order(mpq_class(mpz_class(heights.size()))) - kernels::binary_order(mpq_class(dot(n, n))) / 2;
  const long finest = goal.finest(signed_square(sum, n)) + spare;
  std::vector<mpq_class> result;
  for (const TermHeight& h : heights)
    result.push_back(exact ? h.height
                           : kernels::times_power_of_two(
                                 mpq_class(rounded_up(kernels::times_power_of_two(h.height, finest))), -finest));
  return result;
}

mpq_class Assembly::square_of(const polytope::SimplexFoot<mpz_class>& z) const {
  const mpq_class& unit = oracle_.lattice().fine_unit;
  return -kernels::ratio(dot(z.point, z.point), mpz_class(z.denominator * z.denominator)) * unit * unit;
}

mpq_class Assembly::upper() const {
  const Ceiling& ceiling = *oracle_.lowest();
  return signed_square(ceiling.height * oracle_.lattice().fine_unit, ceiling.direction);
}

bool Assembly::closed() const { return lower_ == upper(); }

bool Assembly::met(const mpq_class& lower) const {
  const mpq_class upper = this->upper();
  return lower == upper || goal_.met(goal_.from_below(lower), goal_.from_above(upper));
}

void Assembly::set_lower(const NearestFoot& nearest) {
  const polytope::SimplexFoot<mpz_class>& z = nearest.foot;
  const mpq_class exact = square_of(z);
  Combination combination;
  const auto take = [&](std::size_t i, mpq_class weight) {
    if (weight == 0) return;
    combination.a.push_back(oracle_.inner_point(nearest.corners[i].ids.first, true));
    combination.b.push_back(oracle_.inner_point(nearest.corners[i].ids.first, false));
    combination.weights.push_back(std::move(weight));
  };
  if (exact == 0 || exact == upper()) {
    for (std::size_t i = 0; i < nearest.corners.size(); ++i) take(i, kernels::ratio(z.weights[i], z.denominator));
    lower_ = exact;
  } else {
    const unsigned bits = oracle_.lattice().fine + weight_bits;
    const std::vector<mpz_class> weights = rounded_weights(z, bits);
    Vector sum;
    for (std::size_t i = 0; i < nearest.corners.size(); ++i) {
      const Vector& p = nearest.corners[i].p;
      sum = {sum.x + weights[i] * p.x, sum.y + weights[i] * p.y, sum.z + weights[i] * p.z};
      take(i, kernels::times_power_of_two(mpq_class(weights[i]), -static_cast<long>(bits)));
    }
    const mpq_class unit = kernels::times_power_of_two(oracle_.lattice().fine_unit, -static_cast<long>(bits));
    lower_ = -mpq_class(dot(sum, sum)) * unit * unit;
  }
  set_weights(combination);
}

void Assembly::set_weights(const Combination& combination) {
  bracket_ = {};
  Names name_a(bracket_.inner_a), name_b(bracket_.inner_b);
  std::vector<polytope::Difference> ids;
  for (std::size_t i = 0; i < combination.weights.size(); ++i)
    ids.emplace_back(name_a(combination.a[i]), name_b(combination.b[i]));
  bracket_.weights_a = polytope::weights_of(ids, combination.weights, &polytope::Difference::first);
  bracket_.weights_b = polytope::weights_of(ids, combination.weights, &polytope::Difference::second);
}

void Assembly::set_lower(const mpq_class& squared, InnerPolytope inner) {
  lower_ = squared;
  bracket_ = {};
  Names name_a(bracket_.inner_a), name_b(bracket_.inner_b);
  for (auto& [a, b] : inner.vertices) {
    const std::uint32_t point = a;
    a = name_a(oracle_.inner_point(point, true));
    b = name_b(oracle_.inner_point(point, false));
  }
  bracket_.polytope = std::move(inner);
}

void Assembly::set_lower(const mpq_class& squared, Revolution around) {
  lower_ = squared;
  bracket_ = {};
  bracket_.around = std::move(around);
}

bool Assembly::meets_in_face() {
  const Vector& n = oracle_.lowest()->direction;
  const std::vector<TermHeight> heights = oracle_.heights(n);
  if (!std::all_of(heights.begin(), heights.end(), [](const TermHeight& h) { return h.exact; })) return false;
  const std::optional<Combination> foot = foot_in_face(context_, a_, b_, n, heights);
  if (!foot) return false;
  lower_ = signed_square(
      std::accumulate(heights.begin(), heights.end(), mpq_class(),
                      [](const mpq_class& sum, const TermHeight& h) { return mpq_class(sum + h.height); }),
      n);
  set_weights(*foot);
  return true;
}

CurvedBounds Assembly::take() {
  bracket_.direction = oracle_.lowest()->direction;
  const std::vector<mpq_class> heights = short_heights(oracle_.heights(bracket_.direction), bracket_.direction, goal_);
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(a_.size());
  bracket_.heights_a.assign(heights.begin(), middle);
  bracket_.heights_b.assign(middle, heights.end());
  const mpq_class upper =
      signed_square(std::accumulate(heights.begin(), heights.end(), mpq_class()), bracket_.direction);
  const bool equal = lower_ == upper;
  return {equal ? goal_.exact_or_below(lower_) : goal_.from_below(lower_),
          equal ? goal_.exact_or_above(upper) : goal_.from_above(upper),
          {},
          std::move(bracket_),
          oracle_.calls()};
}

// The face of P in one direction, where both sides of the bounds may meet: does it hold the foot of
// O? It is a sum of terms again, and flat.                       [proofs/shapes_curved.md, lemma 4]

namespace {

constexpr unsigned face_fine = 20;  // 2^-20: points inside a face need not be near its boundary
constexpr std::size_t most_face_calls = 60;
constexpr std::size_t most_choices = 256;  // of one atom in each term
constexpr std::size_t most_face_directions = 8;

// The faces of one core's terms, as terms, and where their atoms come from.
struct FaceTerms {
  std::vector<Term> terms;
  std::vector<std::vector<TightAtom>> origins;

  FaceTerms(const std::vector<Term>& core, const Vector& n, std::span<const TermHeight> heights) {
    for (std::size_t t = 0; t < core.size(); ++t) {
      origins.push_back(tight_atoms(core[t], n, heights[t].height));
      terms.emplace_back();
      for (const TightAtom& tight : origins.back()) {
        const Atom& atom = core[t].atoms[tight.atom];
        terms.back().atoms.push_back(tight.whole ? atom : Atom{place(atom, tight.local), {}});
      }
    }
  }

  [[nodiscard]] InnerPoint in_core(InnerPoint point) const {
    for (std::size_t t = 0; t < point.size(); ++t) {
      const TightAtom& origin = origins[t][point[t].atom];
      point[t].atom = origin.atom;
      if (!origin.whole) point[t].local = origin.local;
    }
    return point;
  }
};

// The parameters of the disc's point center + d, if it is one.
std::optional<std::vector<mpq_class>> parameters(const Atom& disc, const Point& d) {
  const Point &u = disc.axes[0], &v = disc.axes[1];
  const mpq_class uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), area = uu * vv - uv * uv;
  if (area == 0) return std::nullopt;
  const mpq_class du = dot(d, u), dv = dot(d, v);
  const mpq_class x = (vv * du - uv * dv) / area, y = (uu * dv - uv * du) / area;
  if (x * x + y * y > 1 || d != x * u + y * v) return std::nullopt;
  return std::vector<mpq_class>{x, y};
}

// All choices of one atom in each term, or the first of them.
class Choices {
 public:
  Choices(const std::vector<Term>& a, const std::vector<Term>& b) : terms_of_a_(a.size()) {
    for (const Term& term : a) terms_.push_back(&term);
    for (const Term& term : b) terms_.push_back(&term);
    choice_.resize(terms_.size());
  }

  [[nodiscard]] std::size_t terms() const { return terms_.size(); }
  [[nodiscard]] const Atom& atom(std::size_t t) const { return terms_[t]->atoms[choice_[t]]; }
  [[nodiscard]] bool of_a(std::size_t t) const { return t < terms_of_a_; }
  /// That of the atoms' sum, as a part of P.
  [[nodiscard]] Point center() const {
    Point sum;
    for (std::size_t t = 0; t < terms(); ++t) sum = of_a(t) ? sum - atom(t).center : sum + atom(t).center;
    return sum;
  }
  /// The atoms' centers, but for one disc a point of it.
  [[nodiscard]] Combination with(std::size_t disc, const std::vector<mpq_class>& local) const {
    Combination result{{{}}, {{}}, {1}};
    for (std::size_t t = 0; t < terms(); ++t) {
      AtomPoint point{choice_[t], t == disc ? local : std::vector<mpq_class>(atom(t).axes.size())};
      (of_a(t) ? result.a : result.b).front().push_back(std::move(point));
    }
    return result;
  }

  bool next() {
    for (std::size_t t = 0; ++tried_ < most_choices && t < terms(); ++t) {
      if (++choice_[t] < terms_[t]->atoms.size()) return true;
      choice_[t] = 0;
    }
    return false;
  }

 private:
  std::vector<const Term*> terms_;
  std::size_t terms_of_a_, tried_ = 0;
  std::vector<std::uint32_t> choice_;
};

// O as a point of one disc and centers of other atoms: at the disc's edge, or near to it, no search
// in multiples of 2^-fine finds it.
std::optional<Combination> of_one_disc(Choices choices) {
  do {
    const Point center = choices.center();
    for (std::size_t t = 0; t < choices.terms(); ++t) {
      if (choices.atom(t).axes.size() != 2) continue;
      if (const auto local = parameters(choices.atom(t), choices.of_a(t) ? center : Point(-center)))
        return choices.with(t, *local);
    }
  } while (choices.next());
  return std::nullopt;
}

// The search for O in the face of P in direction n, moved by the foot of O.
class FaceSearch {
 public:
  FaceSearch(kernels::Context& context, const std::vector<Term>& a, const std::vector<Term>& b, const Vector& n)
      : context_(context),
        a_(a),
        b_(b),
        n_(n),
        face_(lattice(a, b, face_fine)),
        oracle_(context, face_, most_face_calls) {}

  /// A combination whose difference is O. `edges`: it is looked for in the edges of the face too.
  std::optional<Combination> run(bool edges) {
    const polytope::Difference first = oracle_.ask({1, 0, 0}, face_fine);
    const auto apart = [&](const polytope::SimplexFoot<mpz_class>&) { return oracle_.lowest()->height < 0; };
    const NearestFoot nearest =
        find_nearest(oracle_, first, apart, [](const polytope::SimplexFoot<mpz_class>&) { return face_fine; });
    if (nearest.end == NearestEnd::near) return std::nullopt;
    if (nearest.end == NearestEnd::common) return combination(nearest);
    if (auto found = of_one_disc(Choices(a_, b_))) return found;
    return edges ? in_edges() : std::nullopt;
  }

 private:
  [[nodiscard]] Combination combination(const NearestFoot& nearest) const {
    Combination result;
    for (std::size_t i = 0; i < nearest.corners.size(); ++i) {
      const std::uint32_t id = nearest.corners[i].ids.first;
      result.a.push_back(oracle_.inner_point(id, true));
      result.b.push_back(oracle_.inner_point(id, false));
      result.weights.push_back(kernels::ratio(nearest.foot.weights[i], nearest.foot.denominator));
    }
    return result;
  }

  /// The directions in which the face may have O at its edge: those that people like; what the
  /// search came near to; across the edges of terms of points; and if all discs are round, from the
  /// center of a choice of them to O.
  [[nodiscard]] std::vector<Vector> directions() const {
    std::vector<Vector> result = likely_directions(face_, most_face_directions);
    for (Vector& m : short_directions(face_, oracle_.lowest()->direction)) result.push_back(std::move(m));
    for (const LatticeTerm& term : face_.terms) {
      const std::vector<Vector> points = points_of(term);
      if (points.size() > most_edge_points) continue;
      for (const Vector& p : points)
        for (const Vector& q : points) result.push_back(cross(n_, Vector(p - q)));
    }
    Choices choices(a_, b_);
    do result.push_back(primitive_along(-choices.center()));
    while (choices.next());
    return result;
  }

  std::optional<Combination> in_edges() {
    for (const Vector& m : directions()) {
      if (is_zero(cross(m, n_))) continue;
      const std::vector<TermHeight> heights = oracle_.heights(m);
      mpq_class sum;
      bool exact = true;
      for (const TermHeight& h : heights) sum += h.height, exact = exact && h.exact;
      if (sum < 0) return std::nullopt;
      if (!exact || sum > 0) continue;
      if (auto found = foot_in_face(context_, a_, b_, m, heights, false)) return found;
    }
    return std::nullopt;
  }

  kernels::Context& context_;
  const std::vector<Term>&a_, &b_;
  const Vector& n_;
  Lattice face_;
  Oracle oracle_;
};

}  // namespace

Point place(const Atom& atom, std::span<const mpq_class> local) {
  Point result = atom.center;
  for (std::size_t k = 0; k < atom.axes.size(); ++k) {
    result.x += local[k] * atom.axes[k].x;
    result.y += local[k] * atom.axes[k].y;
    result.z += local[k] * atom.axes[k].z;
  }
  return result;
}

std::vector<TightAtom> tight_atoms(const Term& term, const Vector& n, const mpq_class& height) {
  std::vector<TightAtom> result;
  for (std::uint32_t i = 0; i < term.atoms.size(); ++i) {
    const Atom& atom = term.atoms[i];
    TightAtom tight{i, true, {}};
    mpq_class square;
    for (const Point& axis : atom.axes) {
      tight.local.push_back(dot(n, axis));
      square += tight.local.back() * tight.local.back();
    }
    const mpq_class root = height - dot(n, atom.center);
    if (root < 0 || root * root != square) continue;
    if (square != 0) {
      tight.whole = false;
      for (mpq_class& y : tight.local) y /= root;
    }
    result.push_back(std::move(tight));
  }
  return result;
}

std::optional<Combination> foot_in_face(kernels::Context& context, const std::vector<Term>& a,
                                        const std::vector<Term>& b, const Vector& n,
                                        std::span<const TermHeight> heights, bool edges) {
  const FaceTerms of_a(a, -n, heights.first(a.size()));
  FaceTerms of_b(b, n, heights.subspan(a.size()));
  mpq_class height;
  for (const TermHeight& h : heights) height += h.height;
  for (Atom& atom : of_b.terms.front().atoms)
    atom.center = atom.center - (height / mpq_class(dot(n, n))) * n;  // the foot to O
  std::optional<Combination> found = FaceSearch(context, of_a.terms, of_b.terms, n).run(edges);
  if (!found) return std::nullopt;
  for (InnerPoint& point : found->a) point = of_a.in_core(std::move(point));
  for (InnerPoint& point : found->b) point = of_b.in_core(std::move(point));
  return found;
}

}  // namespace fathom::curved
