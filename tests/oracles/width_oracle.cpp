// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracles/width_oracle.hpp"

#include <CGAL/Gmpz.h>
#include <CGAL/Homogeneous.h>
#include <CGAL/Width_3.h>
#include <CGAL/Width_default_traits_3.h>

#include <algorithm>

namespace fathom::oracles {

namespace {

using Kernel = CGAL::Homogeneous<CGAL::Gmpz>;
using Width = CGAL::Width_3<CGAL::Width_default_traits_3<Kernel>>;

CGAL::Gmpz gmpz(const mpz_class& value) { return CGAL::Gmpz(value.get_mpz_t()); }
mpz_class mpz(const CGAL::Gmpz& value) { return mpz_class(value.mpz()); }

}  // namespace

OracleAnswer width_oracle(std::span<const Point> body) {
  const IntegerBodies scaled = integer_bodies(body, {});
  std::vector<Kernel::Point_3> points;
  for (const Vector& p : scaled.a) points.emplace_back(gmpz(p.x), gmpz(p.y), gmpz(p.z), CGAL::Gmpz(1));
  Width width(points.begin(), points.end());
  CGAL::Gmpz numerator, denominator;
  width.get_squared_width(numerator, denominator);
  OracleAnswer answer{Status::penetrating,
                      mpq_class(mpz(numerator), mpz_class(mpz(denominator) * scaled.denominator * scaled.denominator)),
                      {}};
  answer.squared.canonicalize();
  std::vector<Kernel::Vector_3> directions;
  width.get_all_build_directions(directions);
  for (const Kernel::Vector_3& d : directions) {
    const Vector u = primitive({mpz(d.hx()), mpz(d.hy()), mpz(d.hz())});  // hw > 0 or < 0: both signs are optimal
    answer.directions.push_back(u);
    answer.directions.push_back(-u);
  }
  std::ranges::sort(answer.directions, lexicographically_less);
  answer.directions.erase(std::unique(answer.directions.begin(), answer.directions.end()), answer.directions.end());
  return answer;
}

}  // namespace fathom::oracles
