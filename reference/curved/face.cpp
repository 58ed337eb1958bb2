// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/curved/face.hpp"

#include <algorithm>
#include <utility>

#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/curved/nearest.hpp"

namespace fathom::curved {
namespace {

constexpr unsigned face_fine = 20;  // 2^-20: points inside a face need not be near its boundary
constexpr std::size_t most_face_calls = 60;

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

std::optional<Combination> foot_in_face(kernels::Context& context, const std::vector<Term>& a, const std::vector<Term>& b, const Vector& n,
                                        std::span<const TermHeight> heights) {
  const FaceTerms of_a(a, -n, heights.first(a.size()));
  FaceTerms of_b(b, n, heights.subspan(a.size()));
  mpq_class height;
  for (const TermHeight& h : heights) height += h.height;
  for (Atom& atom : of_b.terms.front().atoms) atom.center = atom.center - (height / mpq_class(dot(n, n))) * n;  // the foot to O
  const Lattice face = lattice(of_a.terms, of_b.terms, face_fine);
  Oracle oracle(context, face, most_face_calls);
  const polytope::Difference first = oracle.ask({1, 0, 0}, face_fine);
  const auto apart = [&](const polytope::SimplexFoot&) { return oracle.lowest()->height < 0; };
  const NearestFoot nearest = find_nearest(oracle, first, apart, [](const polytope::SimplexFoot&) { return face_fine; });
  if (nearest.end != NearestEnd::common) return std::nullopt;
  Combination result;
  for (std::size_t i = 0; i < nearest.corners.size(); ++i) {
    const std::uint32_t id = nearest.corners[i].ids.first;
    result.a.push_back(of_a.in_core(oracle.inner_point(id, true)));
    result.b.push_back(of_b.in_core(oracle.inner_point(id, false)));
    result.weights.push_back(kernels::ratio(nearest.foot.weights[i], nearest.foot.denominator));
  }
  return result;
}

}  // namespace fathom::curved
