// SPDX-License-Identifier: GPL-3.0-or-later
// The face of P in one direction, where both sides of the bounds may meet: does it hold the foot of
// O? It is a sum of terms again, and flat.                       [proofs/shapes_curved.md, lemma 4]
#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/curved/assembly.hpp"
#include "reference/curved/oracle.hpp"

namespace fathom::curved {
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
