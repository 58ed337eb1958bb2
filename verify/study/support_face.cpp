// SPDX-License-Identifier: GPL-3.0-or-later
// An atom c + M y reaches <n,c> + |M^T n|: as a whole if M^T n = 0, else in the one point c + M s/|s|, s = M^T n.
#include <algorithm>
#include <optional>

#include "fathom/numbers.hpp"
#include "kernels/number/irrational.hpp"
#include "verify/study/solid.hpp"

namespace fathom::studies {
namespace {

/// The part of an atom that is farthest in a direction.
struct Farthest {
  const Atom* atom;
  Surd height;
  std::vector<mpq_class> slopes;  ///< s

  Farthest(const Atom& of, const RationalVector& n) : atom(&of), height{dot(n, rational(of.center)), 0} {
    for (const Point& axis : of.axes) {
      slopes.push_back(dot(n, rational(axis)));
      height.root += slopes.back() * slopes.back();
    }
  }
  [[nodiscard]] bool whole() const { return height.root == 0; }

  /// Its one point, or the centre of the whole.
  [[nodiscard]] RootVector place() const {
    RootVector result{rational(atom->center), {}, height.root};
    for (std::size_t k = 0; k < slopes.size() && !whole(); ++k)
      result.irrational = result.irrational + scaled(slopes[k] / height.root, rational(atom->axes[k]));
    return result;
  }
};

// Points that reach one height have one root, or rational ones: c1 + sqrt(q1) = c2 + sqrt(q2) in rationals c and q, of which one root is
// irrational, has q1 = q2.
RootVector between(const RootVector& p, const RootVector& q) {
  if (p.square == q.square) return {q.rational - p.rational, q.irrational - p.irrational, p.square};
  const auto plain = [](const RootVector& v) {
    return v.square == 0 ? v.rational : v.rational + scaled(*kernels::rational_root(v.square), v.irrational);
  };
  return {plain(q) - plain(p), {}, 0};
}

void add_spanning(SupportFace& face, const RootVector& v) {
  const RootVector one_x{{1, 0, 0}, {}, 0}, one_y{{0, 1, 0}, {}, 0};
  if (parallel(v, one_x) && parallel(v, one_y)) return;  // 0
  if (face.spanning.size() < 2 && std::none_of(face.spanning.begin(), face.spanning.end(), [&](const auto& u) { return parallel(u, v); }))
    face.spanning.push_back(v);
}

Corner corner_of(const Term& term, const std::vector<Farthest>& tight) {
  Corner sharpest = Corner::smooth;
  for (const Farthest& part : tight) {
    if (part.whole()) {
      const bool pointed = std::all_of(term.atoms.begin(), term.atoms.end(), [](const Atom& atom) { return atom.axes.empty(); });
      return pointed ? Corner::vertex : Corner::apex;
    }
    if (part.atom->axes.size() == 2) sharpest = Corner::rim;
  }
  return sharpest;
}

void add_term(SupportFace& face, const Term& term, const RationalVector& n) {
  std::vector<Farthest> tight;
  for (const Atom& atom : term.atoms) {
    Farthest part(atom, n);
    const int order = tight.empty() ? 1 : compare(part.height, tight.front().height);
    if (order < 0) continue;
    if (order > 0) tight.clear();
    tight.push_back(std::move(part));
  }
  face.height.add(tight.front().height.rational);
  face.height.add(1, tight.front().height.root);
  const RootVector first = tight.front().place();
  for (const Farthest& part : tight) {
    add_spanning(face, between(first, part.place()));
    if (part.whole())
      for (const Point& axis : part.atom->axes) add_spanning(face, {rational(axis), {}, 0});
    face.of_points = face.of_points && part.atom->axes.empty();
  }
  face.corner = std::max(face.corner, corner_of(term, tight));
}

}  // namespace

SupportFace support_face(std::span<const Term> terms, const Vector& direction) {
  SupportFace face;
  for (const Term& term : terms) add_term(face, term, rational(direction));
  return face;
}

}  // namespace fathom::studies
