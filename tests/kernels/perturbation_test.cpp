// SPDX-License-Identifier: GPL-3.0-or-later
// How operands move; that no sign between different groups vanishes (claims 1 to 6 of
// proofs/perturbation.md); that signs are those of an honest perturbation by small numbers; what is
// refused.
#include "kernels/predicates/perturbation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "tests/support/plain_predicates.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/property.hpp"
#include "tests/support/signs.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;

const Vector up{0, 1, 0};
const Direction vertical(up, Role::vertical);

Vector pole(bool lower) { return {0, 0, lower ? -1 : 1}; }
Direction pole_of(bool lower) { return Direction(pole(lower), Role::pole); }

/// The vectors with components from {-1,0,1}, 0 left out: 26, or, one of each antipodal pair, 13.
std::vector<Vector> small_vectors(bool up_to_sign) {
  std::vector<Vector> result;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const int first = x != 0 ? x : y != 0 ? y : z;
        if (first > 0 || (first < 0 && !up_to_sign)) result.push_back({x, y, z});
      }
    }
  }
  return result;
}

rc::Gen<Vector> tiny_directions() {
  const auto component =
      rc::gen::resize(rc::kNominalSize, rc::gen::map(rc::gen::inRange(-2, 3), [](int i) { return mpz_class(i); }));
  const auto three = [](const mpz_class& x, const mpz_class& y, const mpz_class& z) { return Vector{x, y, z}; };
  return rc::gen::suchThat(rc::gen::apply(three, component, component, component),
                           [](const Vector& v) { return !is_zero(v); });
}

Perturbation any_perturbation() {
  const std::vector<Perturbation> all = perturbations();
  return all[*rc::gen::inRange<std::size_t>(0, all.size())];
}

/// The polynomial without the terms that contain e_(level+1), ..., e_12.
Infinitesimal cut(const Infinitesimal& s, unsigned level) {
  Infinitesimal result;
  for (const auto& [monomial, coefficient] : s.terms()) {
    bool stays = true;
    for (unsigned k = level + 1; k <= infinitesimals; ++k) stays = stays && monomial.exponent(k) == 0;
    if (stays) result += Infinitesimal(monomial, coefficient);
  }
  return result;
}

Vec3<Infinitesimal> scaled(const Infinitesimal& s, const Vec3<Infinitesimal>& v) { return {s * v.x, s * v.y, s * v.z}; }

constexpr Role all_roles[] = {Role::fixed, Role::node_of_a, Role::circle_of_a, Role::vertical, Role::pole};

/// Nothing special for normals and circles; what the frame is otherwise.
Vector generic(Role role) { return role == Role::vertical ? up : role == Role::pole ? pole(false) : Vector{2, 3, 5}; }

TEST(Moved, NormalsAndCirclesOfAFollowOneLinearMap) {
  EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [] {
    const Perturbation p = any_perturbation();
    const unsigned level = *rc::gen::inRange(0U, infinitesimals + 1);
    const Vector n = *tiny_directions(), m = *tiny_directions(), d = *tiny_directions();
    const auto node = [&](const Vector& w) { return p.moved(w, Role::node_of_a, level); };
    const auto circle = [&](const Vector& w) { return p.moved(w, Role::circle_of_a, level); };
    RC_ASSERT(cross(node(n), node(m)) == circle(cross(n, m)));
    const Infinitesimal volume = det(node({1, 0, 0}), node({0, 1, 0}), node({0, 0, 1}));
    RC_ASSERT(dot(node(n), circle(d)) == volume * Infinitesimal(dot(n, d)));
    RC_ASSERT(node(n + m) == node(n) + node(m));
    RC_ASSERT(node(-n) == -node(n));
    RC_ASSERT(cross(circle(n), circle(m)) == scaled(volume, node(cross(n, m))));
  }));
}

TEST(Moved, TheNineEntriesAreIndependentAndTheFrameIsAsDocumented) {
  for (const Perturbation& p : perturbations()) {
    const auto e = [&](unsigned i) { return Infinitesimal(Monomial(p.rank[i]), p.sign[i]); };
    for (unsigned column = 0; column < 3; ++column) {
      Vector unit{column == 0, column == 1, column == 2};
      const Vec3<Infinitesimal> still{unit.x, unit.y, unit.z};
      const Vec3<Infinitesimal> shift = p.moved(unit, Role::node_of_a, infinitesimals) - still;
      EXPECT_EQ(shift, (Vec3<Infinitesimal>{e(column), e(3 + column), e(6 + column)}));
    }
    const Infinitesimal a = e(9), b = e(10), c = e(11);
    EXPECT_EQ(p.moved(up, Role::vertical, infinitesimals), (Vec3<Infinitesimal>{a, 1, b}));
    EXPECT_EQ(p.moved(pole(false), Role::pole, infinitesimals), (Vec3<Infinitesimal>{c, -(a * c) - b, 1}));
    EXPECT_EQ(p.moved(pole(true), Role::pole, infinitesimals), (Vec3<Infinitesimal>{-c, a * c + b, -1}));
  }
}

TEST(Moved, VerticalAndPoleStayNormalAtEveryLevel) {
  for (const Perturbation& p : perturbations()) {
    for (const bool lower : {false, true}) {
      for (unsigned level = 0; level <= infinitesimals; ++level) {
        EXPECT_EQ(dot(p.moved(up, Role::vertical, level), p.moved(pole(lower), Role::pole, level)), Infinitesimal());
      }
    }
  }
}

TEST(Moved, ALevelIsTheWholeWithoutTheRest) {
  for (const Perturbation& p : perturbations()) {
    for (const Role role : all_roles) {
      const Vector w = generic(role);
      const Vec3<Infinitesimal> whole = p.moved(w, role, infinitesimals);
      EXPECT_EQ(p.moved(w, role, 0), (Vec3<Infinitesimal>{w.x, w.y, w.z}));
      EXPECT_FALSE(p.concerns(role, 0) || p.concerns(role, infinitesimals + 1));
      for (unsigned level = 0; level <= infinitesimals; ++level) {
        const Vec3<Infinitesimal> expected{cut(whole.x, level), cut(whole.y, level), cut(whole.z, level)};
        EXPECT_EQ(p.moved(w, role, level), expected) << level;
        if (level == 0) continue;
        EXPECT_EQ(p.concerns(role, level), p.moved(w, role, level) != p.moved(w, role, level - 1)) << level;
      }
    }
  }
}

// Claims 1 and 2, exhaustive.
TEST(NoSignVanishes, OfANodeOnTheEquatorAndOfACircleThroughTheVertical) {
  for (const Perturbation& p : perturbations()) {
    for (const Vector& w : small_vectors(false)) {
      for (const bool lower : {false, true}) {
        for (const Role role : {Role::fixed, Role::node_of_a}) {
          const int sign = perturbed(p).side_of_equator(Direction(w, role), pole_of(lower));
          EXPECT_EQ(sign * sign, 1);
          EXPECT_EQ(perturbed(p).side_of_equator(Direction(-w, role), pole_of(lower)), -sign);
          EXPECT_EQ(perturbed(p).side_of_equator(Direction(w, role), pole_of(!lower)), -sign)
              << "each node lies in one hemisphere";
        }
      }
      for (const Role role : {Role::fixed, Role::circle_of_a}) {
        EXPECT_EQ(perturbed(p).side_of_arc(vertical, Direction(w, role)) *
                      perturbed(p).side_of_arc(vertical, Direction(-w, role)),
                  -1);
      }
    }
  }
}

// Claims 3, 4 and 6, exhaustive.
TEST(NoSignVanishes, OfPairsOfDifferentBodies) {
  for (const Perturbation& p : perturbations()) {
    for (const Vector& s : small_vectors(true)) {
      for (const Vector& t : small_vectors(false)) {
        const Direction node(s, Role::node_of_a), circle(s, Role::circle_of_a), fixed(t);
        EXPECT_EQ(perturbed(p).x_order(node, fixed, vertical) * perturbed(p).x_order(fixed, node, vertical), -1);
        EXPECT_NE(perturbed(p).side_of_arc(node, fixed), 0);
        EXPECT_NE(perturbed(p).side_of_arc(fixed, circle), 0);
        for (const bool lower : {false, true}) {
          EXPECT_EQ(perturbed(p).order_at_infinity(circle, fixed, pole_of(lower)) *
                        perturbed(p).order_at_infinity(fixed, circle, pole_of(lower)),
                    -1);
        }
      }
    }
  }
}

// Claim 5, exhaustive.
TEST(NoSignVanishes, OfTwoCirclesOnTheVerticalThroughANodeOfEither) {
  for (const Perturbation& p : {perturbations()[0], perturbations()[3]}) {
    for (const Vector& d : small_vectors(true)) {
      for (const Vector& g : small_vectors(true)) {
        for (const Vector& n : small_vectors(true)) {
          const Direction circle(d, Role::circle_of_a), fixed(g);
          EXPECT_NE(perturbed(p).order_on_vertical(circle, fixed, Direction(n), vertical), 0);
          EXPECT_NE(perturbed(p).order_on_vertical(fixed, circle, Direction(n, Role::node_of_a), vertical), 0);
        }
      }
    }
  }
}

/// The five predicates on operands of both bodies, in one list.
struct Operands {
  Vector n, m, d, g;  // node and circle of A, of B
  bool lower;
};

template <class Ask>
std::vector<int> ask_all(const Operands& o, const Ask& ask) {
  const Direction n(o.n, Role::node_of_a), m(o.m), d(o.d, Role::circle_of_a), g(o.g), z = pole_of(o.lower);
  return {ask(plain::SideOfEquator{}, n, z),
          ask(plain::SideOfEquator{}, m, z),
          ask(plain::XOrder{}, n, m, vertical),
          ask(plain::SideOfArc{}, n, g),
          ask(plain::SideOfArc{}, m, d),
          ask(plain::SideOfArc{}, vertical, d),
          ask(plain::OrderOnVertical{}, d, g, n, vertical),
          ask(plain::OrderOnVertical{}, d, g, m, vertical),
          ask(plain::OrderAtInfinity{}, d, g, z)};
}

Operands any_operands() {
  return {*tiny_directions(), *tiny_directions(), *tiny_directions(), *tiny_directions(), *rc::gen::arbitrary<bool>()};
}

// Letting in one infinitesimal after another ends with the sign of the whole polynomial, on random
// operands with components up to 2.
TEST(PerturbedKernel, TheFirstLevelThatDecidesIsTheWhole) {
  EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [] {
    const Perturbation p = any_perturbation();
    const Operands o = any_operands();
    const auto whole = ask_all(o, [&](const auto& functor, const auto&... w) {
      return sgn(functor(p.moved(w.exact(), w.role(), infinitesimals)...));
    });
    RC_ASSERT(std::ranges::count(whole, 0) == 0);
    const Direction n(o.n, Role::node_of_a), m(o.m), d(o.d, Role::circle_of_a), g(o.g), z = pole_of(o.lower);
    const std::vector<int> filtered{perturbed(p).side_of_equator(n, z),
                                    perturbed(p).side_of_equator(m, z),
                                    perturbed(p).x_order(n, m, vertical),
                                    perturbed(p).side_of_arc(n, g),
                                    perturbed(p).side_of_arc(m, d),
                                    perturbed(p).side_of_arc(vertical, d),
                                    perturbed(p).order_on_vertical(d, g, n, vertical),
                                    perturbed(p).order_on_vertical(d, g, m, vertical),
                                    perturbed(p).order_at_infinity(d, g, z)};
    RC_ASSERT(filtered == whole);
  }));
}

TEST(PerturbedKernel, RecordsTheMonomialThatDecides) {
  const Perturbation p;
  const auto decided = [&](const Direction& n, const Direction& d) {
    PredicateCounts counts;
    perturbed(p, counts).side_of_arc(n, d);
    const TierCounts& since = counts[static_cast<std::size_t>(Predicate::side_of_arc)];
    return since.decided.size() == 1 ? Monomial::unpacked(since.decided.begin()->first).text() : "none or several";
  };
  EXPECT_EQ(decided(vertical, Direction(Vector{1, 0, 5})), "e1");
  EXPECT_EQ(decided(vertical, Direction(Vector{0, 0, 5})), "e2");
  EXPECT_EQ(decided(Direction(Vector{0, 0, 1}, Role::node_of_a), Direction(Vector{1, 0, 0})), "e6")
      << "the entry in row 1, column 3";
  EXPECT_EQ(decided(vertical, Direction(Vector{0, 1, 0})), "none or several");
}

/// A direction moved by honest numbers t_i in place of the infinitesimals, in the order of `rank`.
Vec3<mpq_class> moved_by_numbers(const std::array<mpq_class, infinitesimals>& t, const Vector& w, Role role) {
  using Row = std::array<mpq_class, 3>;
  const std::array<Row, 3> m{{{1 + t[0], t[1], t[2]}, {t[3], 1 + t[4], t[5]}, {t[6], t[7], 1 + t[8]}}};
  const Row given{w.x, w.y, w.z};
  Row result{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t r = (i + 1) % 3, s = (i + 2) % 3, p = (j + 1) % 3, q = (j + 2) % 3;
      const mpq_class minor = m[r][p] * m[s][q] - m[r][q] * m[s][p];
      result[i] += (role == Role::circle_of_a ? minor : m[i][j]) * given[j];
    }
  }
  switch (role) {
    case Role::fixed: return {w.x, w.y, w.z};
    case Role::vertical: return {t[9], 1, t[10]};
    case Role::pole: return {w.z * t[11], w.z * (-t[9] * t[11] - t[10]), w.z};
    default: return {result[0], result[1], result[2]};
  }
}

// The three largest infinitesimals as numbers: e_k = r^(4^(k-1)), r = 2^-16. No predicate's degree
// in one of them exceeds 3, so different monomials differ by a factor r at least; and on components
// up to 2 the absolute values of all coefficients add up to less than 2^14.
TEST(PerturbedKernel, SignsAreThoseOfAnHonestPerturbation) {
  EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [] {
    const Perturbation p = any_perturbation();
    constexpr unsigned level = 3;
    std::array<mpq_class, infinitesimals> t;
    for (std::size_t i = 0; i < infinitesimals; ++i) {
      if (p.rank[i] <= level) t[i] = mpq_class(p.sign[i], power_of_two(16UL << (2 * (p.rank[i] - 1))));
    }
    const Operands o = any_operands();
    const auto symbolic = ask_all(
        o, [&](const auto& functor, const auto&... w) { return sgn(functor(p.moved(w.exact(), w.role(), level)...)); });
    const auto numeric = ask_all(o, [&](const auto& functor, const auto&... w) {
      return sgn(functor(moved_by_numbers(t, w.exact(), w.role())...));
    });
    RC_ASSERT(symbolic == numeric);
  }));
}

// All 26 small nodes of either body, 13 of each in a hemisphere, 8 and more of them over one
// abscissa on the input: an order.
TEST(XOrder, IsTotalInEachPerturbedHemisphere) {
  for (const Perturbation& p : perturbations()) {
    for (const bool lower : {false, true}) {
      std::vector<Direction> nodes;
      for (const Vector& w : small_vectors(false)) {
        for (const Role role : {Role::fixed, Role::node_of_a}) {
          if (perturbed(p).side_of_equator(Direction(w, role), pole_of(lower)) > 0) nodes.emplace_back(w, role);
        }
      }
      ASSERT_EQ(nodes.size(), 26U);
      // Counted, not sorted: a sort may not be asked to order what is not an order.
      std::vector<std::size_t> right_of(nodes.size());
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (std::size_t j = 0; j < nodes.size(); ++j) {
          if (i == j) continue;
          const int sign = perturbed(p).x_order(nodes[i], nodes[j], vertical);
          EXPECT_EQ(perturbed(p).x_order(nodes[j], nodes[i], vertical), -sign);
          if (sign > 0) ++right_of[i];
        }
      }
      std::ranges::sort(right_of);
      for (std::size_t i = 0; i < right_of.size(); ++i)
        EXPECT_EQ(right_of[i], i) << "a tournament with these scores is transitive";
    }
  }
}

TEST(PerturbedKernel, RefusesWhatNoPerturbationResolves) {
  for (const Perturbation& p : perturbations()) {
    const Vector n{1, 2, 3}, d{3, 0, -1};  // normal to each other
    EXPECT_THROW(perturbed(p).side_of_arc(Direction(n), Direction(d)), std::logic_error);
    EXPECT_THROW(perturbed(p).side_of_arc(Direction(n, Role::node_of_a), Direction(d, Role::circle_of_a)),
                 std::logic_error);
    EXPECT_THROW(perturbed(p).order_at_infinity(Direction(d), Direction(-d), pole_of(false)), std::logic_error);
    EXPECT_THROW(perturbed(p).order_at_infinity(Direction(d, Role::circle_of_a), Direction(d + d, Role::circle_of_a),
                                                pole_of(false)),
                 std::logic_error);
    EXPECT_THROW(perturbed(p).x_order(Direction(n), Direction(n), vertical), std::logic_error);
    EXPECT_THROW(perturbed(p).x_order(Direction(n, Role::node_of_a), Direction(-n, Role::node_of_a), vertical),
                 std::logic_error);
  }
}

}  // namespace
}  // namespace fathom::kernels
