// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of CGAL in, exact points and numbers of CGAL out. Header-only: who includes it links
// CGAL::CGAL besides fathom::fathom. A body is a range of Point_3, a Surface_mesh or a
// Polyhedron_3, over any kernel with rational coordinates: double (taken exactly), GMP's, CGAL's
// and Boost's exact numbers, lazy ones (their exact value), Cartesian or homogeneous. It stands for
// the convex hull of its vertices.
#pragma once

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/MP_Float.h>
#include <CGAL/Quotient.h>

#include <concepts>
#include <cstddef>
#include <iterator>
#include <ranges>
#include <span>
#include <sstream>
#include <type_traits>
#include <vector>

#include "fathom/depth.hpp"
#include "fathom/numbers.hpp"

namespace fathom {

template <class T>
concept CgalPoint = requires {
  typename T::R::Point_3;
}
&&std::derived_from<T, typename T::R::Point_3>;

/// A range of Point_3.
template <class T>
concept CgalPointRange =
    std::ranges::input_range<const T> && CgalPoint<std::remove_cvref_t<std::ranges::range_reference_t<const T>>>;

/// CGAL::Surface_mesh, or what has its vertices() and point(v).
template <class T>
concept CgalSurfaceMesh = requires(const T& mesh) {
  { mesh.point(*mesh.vertices().begin()) } -> std::convertible_to<typename T::Point>;
  requires CgalPoint<typename T::Point>;
};

/// CGAL::Polyhedron_3, or what has its points_begin() and points_end().
template <class T>
concept CgalPolyhedron = requires(const T& mesh) {
  requires CgalPoint<std::remove_cvref_t<decltype(*mesh.points_begin())>>;
  mesh.points_end();
};

template <class T>
concept CgalBody = CgalPointRange<T> || CgalSurfaceMesh<T> || CgalPolyhedron<T>;

/// Points of fathom in one piece: std::vector<Point>, std::span<const Point>, std::array<Point, n>.
template <class T>
concept PointSpan = std::convertible_to<const T&, std::span<const Point>>;

// ---- in ----

/// Returns the value of a kernel's number. Throws std::invalid_argument if a floating-point number
/// is not finite.
template <class Number>
mpq_class exact_value(const Number& x) {
  if constexpr (std::is_floating_point_v<Number>) {
    static_assert(sizeof(Number) <= sizeof(double), "long double is not supported");
    return exact_value(static_cast<double>(x));
  } else if constexpr (std::same_as<Number, mpq_class> || std::same_as<Number, mpz_class>) {
    return mpq_class(x);
  } else if constexpr (requires { x.exact(); }) {  // Lazy_exact_nt
    return exact_value(x.exact());
  } else if constexpr (requires { mpq_class(x.mpq()); }) {  // Gmpq
    return mpq_class(x.mpq());
  } else if constexpr (requires { mpz_class(x.mpz()); }) {  // Gmpz
    return mpq_class(mpz_class(x.mpz()));
  } else if constexpr (std::same_as<Number, CGAL::MP_Float>) {
    mpq_class sum;
    for (std::size_t i = x.v.size(); i-- > 0;) sum = sum * 65536 + x.v[i];
    const auto shift = static_cast<long>(x.exp) * 16;
    return shift < 0 ? mpq_class(sum >> static_cast<unsigned long>(-shift))
                     : mpq_class(sum << static_cast<unsigned long>(shift));
  } else if constexpr (CGAL::Fraction_traits<Number>::Is_fraction::value) {  // Quotient, and the rationals of Boost
    typename CGAL::Fraction_traits<Number>::Numerator_type numerator;
    typename CGAL::Fraction_traits<Number>::Denominator_type denominator;
    typename CGAL::Fraction_traits<Number>::Decompose()(x, numerator, denominator);
    return mpq_class(exact_value(numerator) / exact_value(denominator));
  } else {
    static_assert(std::integral<Number> ||
                      std::derived_from<typename CGAL::Algebraic_structure_traits<Number>::Algebraic_category,
                                        CGAL::Euclidean_ring_tag>,
                  "the kernel's numbers are no rationals that fathom can read exactly");
    static_assert(
        !std::derived_from<typename CGAL::Algebraic_structure_traits<Number>::Algebraic_category, CGAL::Field_tag>,
        "the kernel's numbers are no rationals that fathom can read exactly");
    std::ostringstream digits;  // of an integer
    digits << x;
    return mpq_class(digits.str());
  }
}

/// Returns the same point. Throws as exact_value does.
template <CgalPoint P>
Point exact_point(const P& p) {
  return {exact_value(p.x()), exact_value(p.y()), exact_value(p.z())};
}

/// Returns the points of a range in their order, or of a mesh's vertices in the order of its
/// iteration: the indices in results count these. Throws as exact_value does.
template <CgalBody T>
std::vector<Point> exact_points(const T& body) {
  std::vector<Point> points;
  if constexpr (CgalSurfaceMesh<T>) {
    for (const auto v : body.vertices()) points.push_back(exact_point(body.point(v)));
  } else if constexpr (CgalPolyhedron<T>) {
    for (auto p = body.points_begin(); p != body.points_end(); ++p) points.push_back(exact_point(*p));
  } else {
    for (const auto& p : body) points.push_back(exact_point(p));
  }
  return points;
}

/// Returns the same points.
template <PointSpan T>
std::span<const Point> exact_points(const T& points) {
  return points;
}

/// The penetration depth of any two bodies, of which one or both are CGAL's: the answer for their
/// exact_points. Throws std::invalid_argument if a floating-point coordinate is not finite, and as
/// fathom/depth.hpp says. To other functions of fathom pass exact_points(body).
template <class A, class B>
requires((CgalBody<A> && (CgalBody<B> || PointSpan<B>)) || (PointSpan<A> && CgalBody<B>)) Depth
    penetration_depth(const A& a, const B& b, const Options& options = {}) {
  const auto points_a = exact_points(a);
  const auto points_b = exact_points(b);
  return penetration_depth(std::span<const Point>(points_a), std::span<const Point>(points_b), options);
}

// ---- out ----

/// Returns the same number.
inline CGAL::Exact_rational to_exact_rational(const mpq_class& x) { return CGAL::Exact_rational(x.get_mpq_t()); }

/// Returns the same number in a kernel's exact number type, which can be made from
/// CGAL::Exact_rational or GMP's rationals. To round to double, see fathom/numbers.hpp.
template <class Number>
requires(CGAL::Algebraic_structure_traits<Number>::Is_exact::value) Number to_number(const mpq_class& x) {
  if constexpr (std::constructible_from<Number, mpq_srcptr>) {
    return Number(x.get_mpq_t());
  } else {
    return Number(to_exact_rational(x));
  }
}

/// Returns the same point in a kernel with exact rational coordinates.
template <class Kernel>
typename Kernel::Point_3 to_point_3(const Point& p) {
  using FT = typename Kernel::FT;
  return {to_number<FT>(p.x), to_number<FT>(p.y), to_number<FT>(p.z)};
}

/// Returns a translation as a vector.
template <class Kernel>
typename Kernel::Vector_3 to_vector_3(const Point& translation) {
  using FT = typename Kernel::FT;
  return {to_number<FT>(translation.x), to_number<FT>(translation.y), to_number<FT>(translation.z)};
}

/// Returns a direction or normal as a vector.
template <class Kernel>
typename Kernel::Vector_3 to_vector_3(const Vector& v) {
  return to_vector_3<Kernel>(Point{v.x, v.y, v.z});
}

}  // namespace fathom
