// SPDX-License-Identifier: GPL-3.0-or-later
// The search for the bounds: directions that people like, then the nearest point of P, then, for
// cores that penetrate, a polytope inside P that grows.                   [proofs/shapes_curved.md]
#include "reference/curved/curved_bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "fathom/depth.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/predicates/direction.hpp"
#include "kernels/vector.hpp"
#include "reference/curved/assembly.hpp"
#include "reference/curved/oracle.hpp"
#include "reference/expanding/surface.hpp"

namespace fathom::curved {
namespace {

// ---- a polytope inside P expands towards the supports of its nearest facets (lemma 2) ----

/// Of a normal that is asked for without being shortened.
constexpr long most_exact_bits = 128;
/// After so many calls the search looks for the first time at how fast it gets on.
constexpr std::size_t first_checkpoint = 128;
/// After so many scans of all facets in vain the next one has to wait for more calls.
constexpr std::size_t most_scans_in_a_row = 128;
/// Of keys; so squares of what is in reach, at most 2, stay below infinity.
constexpr long most_scale = 400;
/// Squared distances that differ by less are not told apart.
constexpr long least_key_exponent = -1000;
constexpr double least_key = 0x1p-999;

/// What binary64 says of bounds, of which it decides nothing: in the lattice's coordinates times
/// 2^-exponent.
class Estimates {
 public:
  Estimates(const Lattice& lattice, const Goal& goal);

  [[nodiscard]] double ceiling(const Ceiling& ceiling) const { return distance(ceiling.height, ceiling.direction); }
  /// height / |normal|.
  [[nodiscard]] double distance(const mpz_class& height, const Vector& normal) const;
  /// Of the foot of O, whose square is numerator / denominator.
  [[nodiscard]] double root(const mpz_class& numerator, const mpz_class& denominator) const;
  /// False if the goal is out of sight. `gap` is at most high - low, which do not say it once they
  /// agree in all their bits.
  [[nodiscard]] bool perhaps_met(double low, double high, double gap) const;
  /// How far bounds of one sign may be apart.
  [[nodiscard]] double allowed() const { return share_ * extent_; }
  /// How fine a point has to be while the bounds differ by this.
  [[nodiscard]] unsigned precision(double gap) const;

 private:
  long exponent_;
  unsigned fine_;
  double extent_, rho_, share_;
};

class Growth {
 public:
  /// `common`: O is known to be in P.
  Growth(Oracle& oracle, const Goal& goal, const Estimates& estimates, bool common)
      : oracle_(oracle), goal_(goal), estimates_(estimates), common_(common) {}

  /// The points must not lie in one plane.
  void start(const std::array<polytope::Difference, 4>& points);
  /// Expands until the goal is met, h(n) = 0 for some n, nothing is above any facet, no call is
  /// left, or the calls that are left will not do.
  void run();

  /// The squared distance of the nearest facet plane of Q, in the shapes' unit; nullopt if O is not
  /// in the interior of Q. Exact.
  [[nodiscard]] std::optional<mpq_class> squared();
  /// Q; its vertices name points of the oracle twice.
  InnerPolytope polytope() { return expanding::inner_polytope(surface_, merge_); }
  /// How often the goal took a scan of all facets.
  [[nodiscard]] std::size_t scans() const { return scans_; }

 private:
  using Corner = expanding::SurfaceVertex<mpz_class>;
  using TriangleId = expanding::TriangleId;

  // By the squared distance, negative above O, less that of the reference: so near distances differ
  // by many bits.
  struct Waiting {
    double key;
    bool exact;  ///< it comes from the exact plane
    TriangleId triangle;
    bool operator<(const Waiting& other) const { return key > other.key; }
  };
  struct Reference {
    mpz_class square, length;  ///< height |height| and <n,n> of some ceiling
    long scale = 0;            ///< of keys: they are times 4^scale, so that a small reference has a square too
    double rounded = 0;        ///< their quotient, times 4^scale
    double far = 0;            ///< a distance that is far above it
  };

  [[nodiscard]] Corner corner(polytope::Difference d) const;
  void wait_for(TriangleId t, bool exact);
  std::optional<Waiting> nearest();
  void refer_to(const Ceiling& ceiling);
  [[nodiscard]] double key(const mpz_class& height, const Vector& normal) const;
  [[nodiscard]] double distance(double key) const;
  [[nodiscard]] double least_gap(const Waiting& first, double low, double high) const;
  bool met();
  bool hopeless(double gap);
  void expand(TriangleId t, double gap);
  void ask_exactly(TriangleId t);

  Oracle& oracle_;
  const Goal& goal_;
  const Estimates& estimates_;
  bool common_;
  expanding::Surface<mpz_class> surface_;
  expanding::MergeMemory merge_;
  std::vector<Waiting> waiting_;  // a heap
  Reference reference_;
  std::size_t scans_ = 0, next_scan_ = 0;
  std::size_t checkpoint_ = first_checkpoint;  // a power of two
  double last_gap_ = 0, last_factor_ = 0;      // at the one before, if any; and by how much it had shrunk there
};

Estimates::Estimates(const Lattice& lattice, const Goal& goal)
    : exponent_(lattice.exponent), fine_(lattice.fine), share_(goal.share().get_d()) {
  const auto scaled = [&](const mpq_class& length) {
    return kernels::times_power_of_two(length / lattice.fine_unit, -exponent_).get_d();
  };
  extent_ = scaled(goal.extent());
  rho_ = scaled(goal.rho());
}

double Estimates::root(const mpz_class& numerator, const mpz_class& denominator) const {
  return kernels::root_from_above(numerator, denominator, exponent_);
}

double Estimates::distance(const mpz_class& height, const Vector& normal) const {
  const double magnitude = root(mpz_class(height * height), dot(normal, normal));
  return sgn(height) < 0 ? -magnitude : magnitude;
}

bool Estimates::perhaps_met(double low, double high, double gap) const {
  const double size = std::max({extent_, std::fabs(low + rho_), std::fabs(high + rho_)});
  return gap <= 2 * share_ * size;
}

unsigned Estimates::precision(double gap) const {
  if (!(gap > 0x1p-44)) return fine_;
  return static_cast<unsigned>(
      std::min(std::max(6L - std::ilogb(gap), 8L), static_cast<long>(fine_)));  // few bits may be asked for
}

Growth::Corner Growth::corner(polytope::Difference d) const {
  return {d, oracle_[d], kernels::image(oracle_[d], oracle_.exponent())};
}

void Growth::start(const std::array<polytope::Difference, 4>& points) {
  refer_to(*oracle_.lowest());
  surface_.start({corner(points[0]), corner(points[1]), corner(points[2]), corner(points[3])});
  for (const TriangleId t : surface_.triangles().ids()) wait_for(t, false);
}

double Growth::key(const mpz_class& height, const Vector& normal) const {
  const mpz_class length = dot(normal, normal);
  const mpz_class difference = height * abs(height) * reference_.length - reference_.square * length,
                  scale = length * reference_.length;
  long i = 0, j = 0;
  const double quotient = mpz_get_d_2exp(&i, difference.get_mpz_t()) / mpz_get_d_2exp(&j, scale.get_mpz_t());
  const long exponent = i - j - 2 * (oracle_.exponent() - reference_.scale);
  return std::ldexp(quotient, static_cast<int>(std::max(exponent, least_key_exponent)));
}

double Growth::distance(double key) const {
  const double square = key + reference_.rounded, root = std::sqrt(std::fabs(square));
  return std::ldexp(square < 0 ? -root : root, -static_cast<int>(reference_.scale));
}

// All keys change, but not their order.
void Growth::refer_to(const Ceiling& ceiling) {
  const double root = estimates_.ceiling(ceiling);
  const long scale = root > 0 ? std::clamp(-static_cast<long>(std::ilogb(root)), 0L, most_scale) : 0;
  const double scaled = std::ldexp(root, static_cast<int>(scale));
  reference_ = {ceiling.height * abs(ceiling.height), dot(ceiling.direction, ceiling.direction), scale,
                scaled * std::fabs(scaled), std::sqrt(std::max(0x1p-8 + root * std::fabs(root), 0.0))};
  std::vector<Waiting> waiting = std::move(waiting_);
  waiting_.clear();
  for (const Waiting& w : waiting)
    if (surface_.triangles()[w.triangle].alive) wait_for(w.triangle, w.exact);
}

// Binary64 decides nothing but the order. Planes that are not far, and those that come first, are
// asked for exactly.
void Growth::wait_for(TriangleId t, bool exact) {
  const kernels::RoundedPlane& rounded = surface_.triangles()[t].rounded;
  if (!exact && rounded.trustworthy() && rounded.estimated_distance() > reference_.far) {
    const double scaled = std::ldexp(rounded.estimated_distance(), static_cast<int>(reference_.scale));
    waiting_.push_back({scaled * scaled - reference_.rounded, false, t});
  } else {
    const expanding::ExactPlane<mpz_class>& plane = surface_.plane(t);
    waiting_.push_back({key(plane.height, plane.normal), true, t});
  }
  std::push_heap(waiting_.begin(), waiting_.end());
}

std::optional<Growth::Waiting> Growth::nearest() {
  while (!waiting_.empty()) {
    std::pop_heap(waiting_.begin(), waiting_.end());
    const Waiting first = waiting_.back();
    waiting_.pop_back();
    if (!surface_.triangles()[first.triangle].alive) continue;
    if (first.exact) return first;
    wait_for(first.triangle, true);
  }
  return std::nullopt;
}

// A triangle that nothing is above lies as near to the boundary of P as points can: it is passed
// over.
void Growth::run() {
  while (const std::optional<Waiting> first = nearest()) {
    const Ceiling& lowest = *oracle_.lowest();
    const double high = estimates_.ceiling(lowest), low = distance(first->key);
    if (sgn(lowest.height) == 0 ||
        (oracle_.calls() >= next_scan_ && estimates_.perhaps_met(low, high, least_gap(*first, low, high)) && met())) {
      ask_exactly(first->triangle);
      return;
    }
    if (oracle_.spent() || (oracle_.calls() >= checkpoint_ && hopeless(high - low))) return;
    expand(first->triangle, high - low);
    const double improved = key(oracle_.lowest()->height, oracle_.lowest()->direction);
    if (improved < 0x1p24 * (first->key - improved)) refer_to(*oracle_.lowest());
  }
}

// Nearly high - low, and surely not more: keys differ where the bounds agree in all their bits. So
// the planes of all facets, which met() compares exactly, are not looked at after every call.
double Growth::least_gap(const Waiting& first, double low, double high) const {
  if (!(low > 0)) return high * (1 - 0x1p-10);  // low may be off by 2^-14 high
  const double above = key(oracle_.lowest()->height, oracle_.lowest()->direction),
               rounding = 0x1p-50 * (std::fabs(above) + std::fabs(first.key)) + least_key;
  return std::ldexp((above - first.key - rounding) / std::ldexp(high + low, static_cast<int>(reference_.scale)),
                    -static_cast<int>(reference_.scale)) *
         (1 - 0x1p-40);
}

// It takes a scan of all facets. Where binary64 is wrong about the gap, as where O is nearer to the
// boundary than 2^-500 of the extent, the scans are spread over the calls after a while.
bool Growth::met() {
  if (++scans_ > most_scans_in_a_row) next_scan_ = oracle_.calls() + oracle_.calls() / 8;
  std::optional<mpq_class> low = squared();
  if (!low && common_) low = 0;
  if (!low) return false;
  const Ceiling& ceiling = *oracle_.lowest();
  const mpq_class& unit = oracle_.lattice().fine_unit;
  const mpq_class high =
      kernels::ratio(ceiling.height * ceiling.height, dot(ceiling.direction, ceiling.direction)) * unit * unit;
  return goal_.met(goal_.from_below(*low), goal_.from_above(high));
}

// Whether the gap is expected to stay too wide until all calls are spent. Never while the sign of
// the bounds is open. Where optima form a continuum it shrinks by one factor whenever the calls
// double; if it did so at the last two checkpoints, it is expected to do so again. Else it is
// expected to shrink by that factor with every as many calls as there were between them, though it
// will do so ever faster.
bool Growth::hopeless(double gap) {
  const std::size_t between = checkpoint_ / 2;
  checkpoint_ *= 2;
  const double factor = last_gap_ / gap, last_factor = std::exchange(last_factor_, factor);
  last_gap_ = gap;
  if (last_factor == 0) return false;
  const bool by_doubling = factor < 1.2 * last_factor;
  double expected = gap;
  if (factor > 1.1)
    for (std::size_t calls = oracle_.calls(); calls < oracle_.budget() && expected > estimates_.allowed();
         calls += by_doubling ? calls : between)
      expected /= factor;
  if (expected <= estimates_.allowed()) return false;
  const std::optional<mpq_class> low = squared();
  return low && goal_.from_below(*low) > 0;
}

void Growth::expand(TriangleId t, double gap) {
  const Vector n = oracle_.shortened(surface_.plane(t).normal);
  for (const unsigned precision : {estimates_.precision(gap), oracle_.lattice().fine}) {
    if (oracle_.spent()) return;
    const Corner above = corner(oracle_.ask(n, precision));
    if (surface_.side(t, above) <= 0) continue;
    for (const TriangleId fresh : surface_.insert(above, t)) wait_for(fresh, false);
    return;
  }
}

// The facet of a core has a short normal, in which the bounds may meet.
void Growth::ask_exactly(TriangleId t) {
  const Vector n = primitive(surface_.plane(t).normal);
  if (!oracle_.spent() && kernels::binary_exponent(n) <= most_exact_bits) oracle_.ask(n, oracle_.lattice().fine);
}

std::optional<mpq_class> Growth::squared() {
  const expanding::ExactPlane<mpz_class>* nearest = nullptr;
  double from_above = 0;
  mpz_class square, length;
  for (const TriangleId t : surface_.triangles().ids()) {
    if (!surface_.triangles()[t].alive) continue;
    if (nearest != nullptr && surface_.triangles()[t].rounded.surely_beyond(from_above)) continue;
    const expanding::ExactPlane<mpz_class>& plane = surface_.plane(t);
    if (plane.height <= 0) return std::nullopt;
    if (nearest != nullptr && compare({plane.normal, plane.height}, {nearest->normal, nearest->height}) >= 0) continue;
    nearest = &plane;
    from_above = estimates_.root(mpz_class(plane.height * plane.height), dot(plane.normal, plane.normal));
  }
  const mpq_class& unit = oracle_.lattice().fine_unit;
  return kernels::ratio(nearest->height * nearest->height, dot(nearest->normal, nearest->normal)) * unit * unit;
}

// ---- a half-space and a curved core: one support is the answer, from both sides ----

// The least multiple > 0 of a vector of rationals that is integral and primitive.
mpq_class factor_of(const Point& m) {
  const mpz_class denominator = lcm(lcm(m.x.get_den(), m.y.get_den()), m.z.get_den());
  const mpz_class factor =
      gcd(gcd(mpz_class(m.x * denominator), mpz_class(m.y * denominator)), mpz_class(m.z * denominator));
  mpq_class result(denominator, factor);
  result.canonicalize();
  return result;
}

// The point of a term that reaches its height exactly.
AtomPoint reaching(const Term& term, const Vector& n, const mpq_class& height) {
  TightAtom tight = std::move(tight_atoms(term, n, height).front());
  return {tight.atom, std::move(tight.local)};
}

/// `plane` is the core of A or B; `radius` is that of its shape. `other` is no half-space.
CurvedBounds half_space_bounds(kernels::Context& context, const HalfSpace& plane, const Shape& other, bool plane_is_a,
                               const mpq_class& radius, unsigned bits) {
  const auto& terms = std::get<std::vector<Term>>(other.core);
  const Lattice points = plane_is_a ? lattice({}, terms, bits + 6) : lattice(terms, {}, bits + 6);
  const Goal goal(bits, bits, points.extent * points.unit + 2 * (radius + other.radius), radius + other.radius);
  const mpq_class factor = factor_of(plane.normal);
  const Point& m = plane.normal;
  const Vector outward{mpz_class(m.x * factor), mpz_class(m.y * factor), mpz_class(m.z * factor)};
  CurvedBounds result;
  Vector& n = result.bracket.direction;
  n = plane_is_a ? Vector(-outward) : outward;
  const Vector s = -outward;  // in which the other core is to be seen

  Oracle oracle(context, points, 1);
  oracle.ask(n, points.fine);
  result.support_calls = 1;
  const std::vector<TermHeight> heights = oracle.heights(n);
  InnerPoint inner = oracle.inner_point(0, !plane_is_a);
  for (std::size_t t = 0; t < terms.size(); ++t)
    if (heights[t].exact) inner[t] = reaching(terms[t], s, heights[t].height);

  std::vector<mpq_class> rounded = short_heights(heights, n, goal);
  const mpq_class offset = plane.offset * factor;
  mpq_class low = offset;
  for (std::size_t t = 0; t < terms.size(); ++t) low += dot(s, place(terms[t].atoms[inner[t].atom], inner[t].local));
  const mpq_class lower = signed_square(low, n),
                  upper = signed_square(std::accumulate(rounded.begin(), rounded.end(), offset), n);
  result.low = lower == upper ? goal.exact_or_below(lower) : goal.from_below(lower);
  result.high = lower == upper ? goal.exact_or_above(upper) : goal.from_above(upper);
  (plane_is_a ? result.bracket.heights_b : result.bracket.heights_a) = std::move(rounded);
  (plane_is_a ? result.bracket.inner_b : result.bracket.inner_a) = std::vector<InnerPoint>{std::move(inner)};
  return result;
}

// ---- two curved cores ----

constexpr std::size_t directions_tried = 4;
constexpr unsigned further_bits[] = {80, 160};  // of the extent, where the status is open

// The points' coordinates are multiples of so small a part of the axes that it does not show in the
// bounds.
unsigned fine_for(unsigned bits) { return bits + 6; }

class Search {
 public:
  Search(kernels::Context& context, const Shape& a, const Shape& b, unsigned bits, unsigned status_bits,
         std::size_t budget)
      : a_(std::get<std::vector<Term>>(a.core)),
        b_(std::get<std::vector<Term>>(b.core)),
        lattice_(lattice(a_, b_, fine_for(status_bits))),
        goal_(bits, status_bits, lattice_.extent * lattice_.unit + 2 * (a.radius + b.radius), a.radius + b.radius),
        oracle_(context, lattice_, budget),
        assembly_(context, a_, b_, oracle_, goal_) {}

  CurvedBounds run() {
    ask(likely_directions(lattice_, directions_tried));
    // Cores that a plane separates, or touches, are often nearest where the plane says.
    if (!meets()) {
      search();
      if (assembly_.lower() <= 0 && !assembly_.closed()) guess();
    }
    CurvedBounds result = assembly_.take();
    result.facet_scans = scans_;
    return result;
  }

 private:
  bool meets() { return oracle_.lowest()->height <= 0 && assembly_.meets_in_face(); }
  void guess() {
    const Ceiling before = *oracle_.lowest();
    ask(short_directions(lattice_, before.direction));
    if (compare(*oracle_.lowest(), before) < 0 && meets()) return;
    if (Goal::decided(goal_.from_below(assembly_.lower()), goal_.from_above(assembly_.upper()))) return;
    ask(fan_directions(lattice_, before.direction));
    if (compare(*oracle_.lowest(), before) < 0) meets();
  }
  // At least one direction is asked for.
  void ask(const std::vector<Vector>& directions) {
    for (const Vector& n : directions)
      if (oracle_.calls() == 0 || !oracle_.spent()) oracle_.ask(n, lattice_.fine);
  }
  void search() {
    const Estimates estimates(lattice_, goal_);
    const auto distance = [&](const polytope::SimplexFoot<mpz_class>& z) {
      return estimates.root(dot(z.point, z.point), mpz_class(z.denominator * z.denominator));
    };
    const auto gap = [&](const polytope::SimplexFoot<mpz_class>& z) {
      return estimates.ceiling(*oracle_.lowest()) + distance(z);
    };
    const auto enough = [&](const polytope::SimplexFoot<mpz_class>& z) {
      const double low = -distance(z), high = estimates.ceiling(*oracle_.lowest());
      return estimates.perhaps_met(low, high, high - low - 0x1p-46) && assembly_.met(assembly_.square_of(z));
    };
    const auto precision = [&](const polytope::SimplexFoot<mpz_class>& z) { return estimates.precision(gap(z)); };
    const NearestFoot nearest = find_nearest(oracle_, {0, 0}, enough, precision);
    if (nearest.end == NearestEnd::near || nearest.end == NearestEnd::open) {
      ask_exactly(-nearest.foot.point);
      if (!meets()) assembly_.set_lower(nearest);
      return;
    }
    if (nearest.end == NearestEnd::common) assembly_.set_lower(nearest);
    grow(nearest, estimates);
    if (nearest.end == NearestEnd::common && oracle_.lowest()->height == 0) assembly_.meets_in_face();
  }

  void grow(const NearestFoot& nearest, const Estimates& estimates) {
    Growth growth(oracle_, goal_, estimates, nearest.end == NearestEnd::common);
    if (nearest.end == NearestEnd::inside) {
      const auto& c = nearest.corners;
      growth.start({c[0].ids, c[1].ids, c[2].ids, c[3].ids});
    } else {
      const auto first = expanding::starting_tetrahedron(oracle_);
      if (!first) return;
      growth.start(*first);
    }
    growth.run();
    scans_ = growth.scans();
    if (const auto squared = growth.squared()) assembly_.set_lower(*squared, growth.polytope());
  }

  // The normal of a face of the cores may be short.
  void ask_exactly(const Vector& direction) {
    const Vector n = primitive(direction);
    if (kernels::binary_exponent(n) <= most_exact_bits && !oracle_.spent()) oracle_.ask(n, lattice_.fine);
  }

  const std::vector<Term>&a_, &b_;
  Lattice lattice_;
  Goal goal_;
  Oracle oracle_;
  Assembly assembly_;
  std::size_t scans_ = 0;
};

bool open(const CurvedBounds& bounds) { return bounds.low < bounds.high && !Goal::decided(bounds.low, bounds.high); }

}  // namespace

CurvedBounds signed_bounds(kernels::Context& context, const Shape& a, const Shape& b, unsigned bits,
                           std::size_t support_calls, bool coaxial) {
  const kernels::DefaultFloatEnvironment environment;
  std::optional<Profile> profile;
  if (const auto* of_a = std::get_if<std::vector<Term>>(&a.core), *of_b = std::get_if<std::vector<Term>>(&b.core);
      coaxial && of_a && of_b)
    profile = common_profile(*of_a, *of_b);
  const auto search = [&](unsigned status_bits, std::size_t budget) {
    if (const auto* plane = std::get_if<HalfSpace>(&a.core))
      return half_space_bounds(context, *plane, b, true, a.radius, status_bits);
    if (const auto* plane = std::get_if<HalfSpace>(&b.core))
      return half_space_bounds(context, *plane, a, false, b.radius, status_bits);
    if (profile)
      if (auto around = coaxial_bounds(context, *profile, a, b, bits, status_bits, budget)) return std::move(*around);
    return Search(context, a, b, bits, status_bits, budget).run();
  };
  CurvedBounds result = search(bits, support_calls);
  std::size_t calls = result.support_calls;
  for (const unsigned finer : further_bits) {
    if (!open(result) || calls >= support_calls) break;
    if (finer <= bits) continue;
    CurvedBounds next = search(finer, support_calls - calls);
    calls += next.support_calls;
    if (!open(next) || next.high - next.low < result.high - result.low) result = std::move(next);
  }
  result.support_calls = calls;
  if (result.low == result.high) result.exact = Surd{result.low, 0};
  return result;
}

}  // namespace fathom::curved
