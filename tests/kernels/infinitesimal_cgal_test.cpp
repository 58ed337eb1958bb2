// SPDX-License-Identifier: GPL-3.0-or-later
// The infinitesimals as CGAL's number type: its traits, and the constructions and predicates of
// that kernel, CGAL's and this project's, against the formulas over Vec3.

#include <gtest/gtest.h>

#include <type_traits>

#include "kernels/predicates/kernels_cgal.hpp"
#include "kernels/predicates/predicates_cgal.hpp"
#include "tests/support/plain_predicates.hpp"
#include "tests/support/property.hpp"
#include "tests/support/signs.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;

using Traits = CGAL::Algebraic_structure_traits<Infinitesimal>;
using Real = CGAL::Real_embeddable_traits<Infinitesimal>;
using CgalVector = InfinitesimalKernel::Vector_3;

static_assert(std::is_same_v<Traits::Algebraic_category, CGAL::Integral_domain_without_division_tag>);
static_assert(Traits::Is_exact::value && !Traits::Is_numerical_sensitive::value && Real::Is_real_embeddable::value);

const Infinitesimal e1(Monomial(1), 1), e2(Monomial(2), 1);

TEST(InfinitesimalTraits, SignsAndComparisons) {
  EXPECT_EQ(CGAL_NTS sign(e1), CGAL::POSITIVE);
  EXPECT_EQ(CGAL_NTS sign(e2 - e1), CGAL::NEGATIVE);
  EXPECT_EQ(CGAL_NTS sign(e1 - e1), CGAL::ZERO);
  EXPECT_EQ(CGAL_NTS compare(e2, e1 * e1), CGAL::SMALLER);
  EXPECT_EQ(CGAL_NTS abs(e2 - e1), e1 - e2);
  EXPECT_EQ(CGAL_NTS square(1 + e1), 1 + 2 * e1 + e1 * e1);
  EXPECT_TRUE(CGAL_NTS is_zero(Infinitesimal()) && CGAL_NTS is_one(Infinitesimal(1)) && !CGAL_NTS is_zero(e2));
  EXPECT_TRUE(CGAL_NTS is_positive(e2) && CGAL_NTS is_negative(e2 - e1));
}

TEST(InfinitesimalTraits, EnclosuresHoldTheLimitAndWhatIsNextToIt) {
  EXPECT_EQ(CGAL::to_double(3 - e1), 3);
  EXPECT_EQ(CGAL::to_double(e1), 0);
  EXPECT_EQ(CGAL::to_interval(Infinitesimal(3)), std::pair(3.0, 3.0));
  const auto [low, high] = CGAL::to_interval(3 - e1);
  EXPECT_TRUE(low < 3 && high > 3);
  const auto [below, above] = CGAL::to_interval(e2);
  EXPECT_TRUE(below < 0 && above > 0);
  const auto [far, farther] = CGAL::to_interval(Infinitesimal(power_of_two(2000)));
  EXPECT_TRUE(far > 1e300 && farther == std::numeric_limits<double>::infinity());
}

struct Operands {
  Vec3<Infinitesimal> n, m, d, g, v, z;
};

Operands moved(const Perturbation& p, const Vector& n, const Vector& m, const Vector& d, const Vector& g) {
  return {p.moved(n, Role::node_of_a, infinitesimals),        p.moved(m, Role::fixed, infinitesimals),
          p.moved(d, Role::circle_of_a, infinitesimals),      p.moved(g, Role::fixed, infinitesimals),
          p.moved({0, 1, 0}, Role::vertical, infinitesimals), p.moved({0, 0, 1}, Role::pole, infinitesimals)};
}

// CGAL's functors of the kernel over the ring, and the predicates over it, give what the formulas
// over Vec3 give, on perturbed operands.
TEST(InfinitesimalKernel, AgreesWithThePlainFormulas) {
  const InfinitesimalKernel kernel;
  const auto orientation = kernel.orientation_3_object();
  const auto product = kernel.compute_scalar_product_3_object();
  const auto cross_product = kernel.construct_cross_product_vector_3_object();
  EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [&](std::uint32_t seed) {
    std::mt19937_64 random(seed);
    const auto any = [&] { return random_direction(random, 2); };
    const Operands o = moved({}, any(), any(), any(), any());
    const auto c = [](const Vec3<Infinitesimal>& w) { return to_cgal<InfinitesimalKernel>(w); };
    const CgalVector n = c(o.n), m = c(o.m), d = c(o.d), g = c(o.g), v = c(o.v), z = c(o.z);
    RC_ASSERT(from_cgal(n) == o.n);
    RC_ASSERT(from_cgal(cross_product(n, m)) == cross(o.n, o.m));
    RC_ASSERT(product(n, z) == plain::SideOfEquator{}(o.n, o.z));
    RC_ASSERT(SideOfEquator<InfinitesimalKernel>::value(n, z) == plain::SideOfEquator{}(o.n, o.z));
    RC_ASSERT(static_cast<int>(orientation(n, m, v)) == sgn(plain::XOrder{}(o.n, o.m, o.v)));
    RC_ASSERT(XOrder<InfinitesimalKernel>::value(n, m, v) == plain::XOrder{}(o.n, o.m, o.v));
    RC_ASSERT(SideOfArc<InfinitesimalKernel>::value(m, d) == plain::SideOfArc{}(o.m, o.d));
    RC_ASSERT(product(cross_product(d, g), cross_product(v, m)) == plain::OrderOnVertical{}(o.d, o.g, o.m, o.v));
    RC_ASSERT(OrderOnVertical<InfinitesimalKernel>::value(d, g, m, v) == plain::OrderOnVertical{}(o.d, o.g, o.m, o.v));
    RC_ASSERT(static_cast<int>(orientation(d, g, z)) == sgn(plain::OrderAtInfinity{}(o.d, o.g, o.z)));
    RC_ASSERT(OrderAtInfinity<InfinitesimalKernel>::value(d, g, z) == plain::OrderAtInfinity{}(o.d, o.g, o.z));
  }));
}

// The third tier through the kernel: what the filter answers where the input is degenerate.
TEST(InfinitesimalKernel, OrientationDecidesWhatTheFilterDecides) {
  const Perturbation p;
  const Direction vertical(Vector{0, 1, 0}, Role::vertical);
  const auto c = [&](const Vector& w, Role role) {
    return to_cgal<InfinitesimalKernel>(p.moved(w, role, infinitesimals));
  };
  for (const Vector& n : {Vector{0, 0, 1}, Vector{1, 2, 3}, Vector{-1, 5, 1}}) {
    const int filtered = perturbed(p).x_order(Direction(n, Role::node_of_a), Direction(n, Role::fixed), vertical);
    EXPECT_NE(filtered, 0);
    EXPECT_EQ(
        static_cast<int>(CGAL::orientation(c(n, Role::node_of_a), c(n, Role::fixed), c({0, 1, 0}, Role::vertical))),
        filtered);
  }
}

}  // namespace
}  // namespace fathom::kernels
