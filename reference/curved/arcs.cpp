// SPDX-License-Identifier: GPL-3.0-or-later
// The depth where the profile of P is made of segments and arcs: its least is in one of finitely
// many directions.                                 [proofs/shapes_curved.md, "Around one axis"]
#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "kernels/number/irrational.hpp"
#include "kernels/vector.hpp"
#include "reference/curved/coaxial.hpp"

namespace fathom::curved {
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
