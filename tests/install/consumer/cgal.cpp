// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies over many kernels of CGAL, straight into fathom. Prints what differs from the expected
// answer; 0 if nothing does.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>
#include <CGAL/Homogeneous.h>
#include <CGAL/MP_Float.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Quotient.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost_mp.h>
#include <CGAL/gmpxx.h>

#include <algorithm>
#include <array>
#include <fathom/cgal.hpp>
#include <iostream>
#include <limits>
#include <list>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

int failures = 0;

void expect(bool holds, std::string_view law) {
  if (holds) return;
  ++failures;
  std::cout << law << "\n";
}

/// The corners of a tetrahedron: O and (size, 0, 0), (0, size, 0), (0, 0, size).
template <class K>
std::vector<typename K::Point_3> tetrahedron(const typename K::FT& size) {
  const typename K::FT zero(0);
  return {{zero, zero, zero}, {size, zero, zero}, {zero, size, zero}, {zero, zero, size}};
}

const std::vector<fathom::Point> cube = [] {
  std::vector<fathom::Point> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({mpq_class(i & 1), mpq_class(i >> 1 & 1), mpq_class(i >> 2)});
  return corners;
}();

/// The cube against the tetrahedron of size s = 1/2 + 1: across the diagonal plane they are s /
/// sqrt(3) deep, along an axis 1.
template <class K>
void expect_right(const typename K::FT& size, std::string_view kernel) {
  const auto points = tetrahedron<K>(size);
  expect(fathom::exact_points(points)[1] == fathom::Point{mpq_class(3, 2), 0, 0}, kernel);
  const fathom::Depth depth = fathom::penetration_depth(points, cube);
  expect(depth.squared() == mpq_class(3, 4), kernel);
  expect(depth.optima() == fathom::penetration_depth(fathom::exact_points(points), cube).optima(), kernel);
}

template <class K>
void expect_same_number(const mpq_class& q, std::string_view kernel) {
  using FT = typename K::FT;
  expect(fathom::exact_value(fathom::to_number<FT>(q)) == q, kernel);
  const fathom::Point p{q, 0, mpq_class(-q)};
  expect(fathom::exact_point(fathom::to_point_3<K>(p)) == p, kernel);
}

void kernels() {
  expect_right<Epick>(1.5, "Epick");
  expect_right<Epeck>(Epeck::FT(3) / 2, "Epeck");
  expect_right<CGAL::Simple_cartesian<double>>(1.5, "double");
  expect_right<CGAL::Simple_cartesian<float>>(1.5F, "float");
  expect_right<CGAL::Simple_cartesian<mpq_class>>(mpq_class(3, 2), "mpq_class");
  expect_right<CGAL::Simple_cartesian<CGAL::Gmpq>>(CGAL::Gmpq(3, 2), "Gmpq");
  expect_right<CGAL::Simple_cartesian<boost::multiprecision::mpq_rational>>(boost::multiprecision::mpq_rational(3, 2),
                                                                            "mpq_rational");
  expect_right<CGAL::Simple_cartesian<CGAL::MP_Float>>(CGAL::MP_Float(1.5), "MP_Float");
  expect_right<CGAL::Simple_cartesian<CGAL::Quotient<CGAL::MP_Float>>>(CGAL::Quotient<CGAL::MP_Float>(3, 2),
                                                                       "Quotient<MP_Float>");
  expect_right<CGAL::Homogeneous<CGAL::Gmpz>>(CGAL::Quotient<CGAL::Gmpz>(3, 2), "Homogeneous<Gmpz>");
  const mpq_class third(1, 3);
  expect_same_number<Epeck>(third, "to Epeck");
  expect_same_number<CGAL::Simple_cartesian<CGAL::Gmpq>>(third, "to Gmpq");
  expect_same_number<CGAL::Simple_cartesian<mpq_class>>(third, "to mpq_class");
  expect_same_number<CGAL::Simple_cartesian<boost::multiprecision::mpq_rational>>(third, "to mpq_rational");
  expect(fathom::exact_value(CGAL::MP_Float(-0x1.8p-200)) == mpq_class("-0x3") / (mpq_class(1) << 201),
         "a small MP_Float");
  expect(fathom::exact_value(CGAL::MP_Float(0x1.8p200)) == (mpq_class(3) << 199), "a large MP_Float");
  expect(fathom::exact_value(Epeck::FT(1) / 3 * 3) == 1, "the exact value of a lazy number");
  expect(fathom::exact_value(0.1) == mpq_class("3602879701896397/36028797018963968"), "the exact value of a double");
}

/// Bodies of every kind, each the same tetrahedron.
struct Kinds {
  std::vector<fathom::Point> points;
  std::vector<Epick::Point_3> range;
  std::list<Epeck::Point_3> list;
  std::array<CGAL::Simple_cartesian<mpq_class>::Point_3, 4> array;
  CGAL::Surface_mesh<Epick::Point_3> mesh;
  CGAL::Polyhedron_3<Epeck> polyhedron;

  explicit Kinds(double size) : range(tetrahedron<Epick>(size)) {
    const auto removed = mesh.add_vertex(Epick::Point_3(100, 100, 100));
    for (const Epick::Point_3& p : range) mesh.add_vertex(p);
    mesh.remove_vertex(removed);  // what is removed does not count
    const auto exact = tetrahedron<Epeck>(size);
    list.assign(exact.begin(), exact.end());
    polyhedron.make_tetrahedron(exact[0], exact[1], exact[2], exact[3]);
    std::ranges::copy(tetrahedron<CGAL::Simple_cartesian<mpq_class>>(mpq_class(size)), array.begin());
    points = fathom::exact_points(mesh);
  }

  template <class F>
  void for_each(F f) const {
    f(points, "points");
    f(std::span<const fathom::Point>(points), "a span of points");
    f(range, "a range");
    f(list, "a list");
    f(array, "an array");
    f(mesh, "a mesh");
    f(polyhedron, "a polyhedron");
  }
};

void pairs() {
  const Kinds one(1.5), other(1);
  const mpq_class squared = fathom::penetration_depth(one.points, other.points).squared();
  expect(squared > 0, "the tetrahedra penetrate");
  one.for_each([&](const auto& a, const std::string& kind_of_a) {
    other.for_each([&](const auto& b, const std::string& kind_of_b) {
      const fathom::Depth depth = fathom::penetration_depth(a, b);
      const fathom::Depth expected =
          fathom::penetration_depth(fathom::exact_points(a), fathom::exact_points(b));  // with the same indices
      expect(depth.squared() == squared && depth.optima() == expected.optima(), kind_of_a + " and " + kind_of_b);
    });
  });
  fathom::Options naive;
  naive.method = fathom::Method::naive;
  expect(fathom::penetration_depth(one.mesh, other.polyhedron, naive).method == fathom::Method::naive,
         "options are passed on");
}

void not_finite() {
  const Kinds good(1);
  for (const double x : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    Kinds bad(1);
    const Epick::Point_3 p(x, 0, 0);
    bad.range[1] = p;
    bad.mesh.add_vertex(p);
    const auto throws = [](const auto& a, const auto& b) {
      try {
        (void)fathom::penetration_depth(a, b);
      } catch (const std::invalid_argument&) {
        return true;
      }
      return false;
    };
    good.for_each([&](const auto& b, const std::string& kind) {
      expect(throws(bad.range, b) && throws(b, bad.range), "a range that is not finite throws with " + kind);
      expect(throws(bad.mesh, b) && throws(b, bad.mesh), "a mesh that is not finite throws with " + kind);
    });
  }
}

static_assert(!fathom::CgalBody<std::vector<fathom::Point>> && !fathom::CgalBody<std::vector<Epick::Vector_3>> &&
              !fathom::CgalBody<int>);

}  // namespace

int main() {
  kernels();
  pairs();
  not_finite();
  if (failures == 0) std::cout << "every kernel agrees\n";
  return failures;
}
