// SPDX-License-Identifier: GPL-3.0-or-later
// Answers do not depend on the floating-point environment of the process. This program is compiled
// and linked with -ffast-math, so that it starts with subnormal numbers flushed to zero; the tests
// add each rounding mode and unmask all exceptions.
#include "kernels/float_environment.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "fathom/approximate.hpp"
#include "fathom/certificate.hpp"
#include "fathom/depth.hpp"
#include "fathom/fathom.h"
#include "fathom/files.hpp"
#include "fathom/impact.hpp"
#include "fathom/judge.hpp"
#include "fathom/numbers.hpp"
#include "fathom/patch.hpp"
#include "fathom/shape.hpp"
#include "fathom/signed_depth.hpp"
#include "reference/approximate/separation.hpp"
#include "reference/approximate/shallow.hpp"
#include "reference/polytope/lattice.hpp"
#include "tests/c/handles.hpp"
#include "verify/families/families.hpp"
#include "verify/families/polytope_pairs.hpp"
#include "verify/families/solids.hpp"
#include "verify/study/study.hpp"

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace fathom {
namespace {

// ---- environments ----

constexpr unsigned flushes_to_zero = 0x8040;  // FTZ and DAZ in MXCSR

/// While it lives: one rounding mode, and on x86 subnormals flushed to zero and every exception a
/// signal.
class HostileEnvironment {
 public:
  explicit HostileEnvironment(int mode) {
    std::fegetenv(&saved_);
    std::fesetround(mode);
#ifdef __SSE2__
    _mm_setcsr((_mm_getcsr() & _MM_ROUND_MASK) | flushes_to_zero);
#endif
  }
  ~HostileEnvironment() { std::fesetenv(&saved_); }

 private:
  std::fenv_t saved_;
};

#ifdef __SSE2__
TEST(FloatEnvironment, ThisProgramStartsWithSubnormalsFlushed) {
  EXPECT_EQ(_mm_getcsr() & flushes_to_zero, flushes_to_zero);
}

TEST(FloatEnvironment, IsTheDefaultInsideAndTheCallersAgainAfterwards) {
  unsigned inside = 0, before = 0, after = 0;
  {
    const HostileEnvironment hostile(FE_UPWARD);
    before = _mm_getcsr();
    {
      const kernels::DefaultFloatEnvironment environment;
      inside = _mm_getcsr();
      volatile double third = 1;
      third = third / 3;  // inexact: a signal in the hostile environment
    }
    after = _mm_getcsr();
  }
  EXPECT_EQ(inside, 0x1f80U);
  EXPECT_EQ(before, after);
}

TEST(FloatEnvironment, ReturnsWhenAnExceptionFliesThrough) {
  const std::vector<Point> empty;
  const HostileEnvironment hostile(FE_DOWNWARD);
  const unsigned before = _mm_getcsr();
  bool thrown = false;
  try {
    penetration_depth(empty, empty);
  } catch (const std::invalid_argument&) {
    thrown = true;
  }
  const unsigned after = _mm_getcsr();
  _mm_setcsr(0x1f80);
  EXPECT_TRUE(thrown);
  EXPECT_EQ(before, after);
}
#endif

// ---- answers as text ----

/// Where two bodies touch, and how their signed depth changes along a motion.
struct ToFirstOrder {
  ContactGeometry geometry;
  std::variant<DirectionalDerivative, LeftOut> derivative;
  std::optional<VertexWeights> weights;

  ToFirstOrder(const std::vector<Point>& a, const std::vector<Point>& b)
      : geometry(contact_geometry({a}, {b}, exact_answer({a}, {b}))),
        derivative(directional_derivative(geometry, {{1, 2, 0}, {0, mpq_class(1, 3), 1}})),
        weights(vertex_weights({a}, {b}, geometry)) {}
};

/// Writes whatever a result is made of.
class Writer {
 public:
  Writer& operator<<(const mpq_class& x) { return put(x.get_str()); }
  Writer& operator<<(const mpz_class& x) { return put(x.get_str()); }
  Writer& operator<<(const Point& p) { return *this << p.x << p.y << p.z; }
  Writer& operator<<(const Vector& v) { return *this << v.x << v.y << v.z; }
  Writer& operator<<(const std::string& text) { return put(text); }
  Writer& operator<<(double x) { return put(hex_text(x)); }
  Writer& operator<<(std::uint64_t n) { return put(std::to_string(n)); }
  Writer& operator<<(std::uint32_t n) { return put(std::to_string(n)); }
  Writer& operator<<(int n) { return put(std::to_string(n)); }
  Writer& operator<<(bool b) { return put(b ? "true" : "false"); }
  Writer& operator<<(const Contact& c) { return *this << static_cast<int>(c.kind) << c.a << c.b; }
  Writer& operator<<(const Witness& w) { return *this << w.a << w.b; }
  Writer& operator<<(const Optimum& o) { return *this << o.direction << o.support << o.translation() << o.contact; }
  Writer& operator<<(const Distance& d) { return *this << d.squared << d.direction << d.translation << d.witness; }
  template <class T>
  Writer& operator<<(const SeparationOr<T>& x) {
    *this << static_cast<int>(x.status()) << x.flat_a << x.flat_b;
    return x.separation() ? *this << x.separation()->normal : *this << *x.penetration();
  }
  Writer& operator<<(const RayExit& x) {
    return *this << x.factor << x.translation << x.normal << x.contact << x.witness;
  }
  Writer& operator<<(const Weight& w) { return *this << w.index << w.weight; }
  Writer& operator<<(const GrowthDistance& x) {
    *this << x.growth << x.center_a << x.center_b << x.flat_a << x.flat_b;
    if (!x.touch) return *this;
    return *this << x.touch->normal << x.touch->contact << x.touch->weights_a << x.touch->weights_b << x.touch->witness;
  }
  Writer& operator<<(const ToFirstOrder& x) {
    for (const Patch& patch : x.geometry.patches) {
      *this << patch.direction << patch.squared() << patch.centroid().a.core;
      for (std::size_t k = 0; k < patch.corners.size(); ++k)
        *this << patch.a(k).core << patch.b(k).core << patch.corners[k].on_a << patch.corners[k].on_b;
    }
    if (const auto* const d = std::get_if<DirectionalDerivative>(&x.derivative))
      *this << static_cast<int>(d->sign()) << d->root() << d->direction;
    if (x.weights) *this << x.weights->a << x.weights->b;
    return *this;
  }
  Writer& operator<<(const MetricPenetration& x) {
    *this << x.depth;
    for (const MetricOptimum& o : x.optima) *this << o.vertex << o.translation << o.direction << o.contact << o.witness;
    return *this;
  }
  Writer& operator<<(const ApproxPenetration& x) {
    return *this << x.squared << x.bound_squared << x.direction << x.translation << x.contact << x.witness;
  }
  Writer& operator<<(const Body& body) { return *this << body.points.exact(); }
  template <class T>
  Writer& operator<<(const std::optional<T>& x) {
    return x ? *this << *x : put("none");
  }
  template <class T>
  Writer& operator<<(const std::vector<T>& all) {
    put("[");
    for (const T& x : all) *this << x;
    return put("]");
  }
  template <class Tag>
  Writer& operator<<(kernels::Id<Tag> id) {
    return *this << id.value;
  }
  Writer& operator<<(const Depth& d) {
    return *this << static_cast<int>(d.status()) << d.squared() << d.optima() << d.direction() << d.translation()
                 << d.witness() << (d.distance() ? std::optional(*d.distance()) : std::nullopt) << d.flat_a << d.flat_b;
  }
  [[nodiscard]] std::string text() const { return text_; }

 private:
  Writer& put(const std::string& text) {
    text_ += text + ' ';
    return *this;
  }
  std::string text_;
};

template <class... T>
std::string text(const T&... parts) {
  Writer writer;
  (writer << ... << parts);
  return writer.text();
}

// ---- what is asked ----

/// Runs `ask` in the hostile environment and writes its result outside of it; mode < 0: in the
/// default environment.
template <class Ask>
std::string told(int mode, const Ask& ask) {
  std::optional<decltype(ask())> result;
  if (mode < 0) {
    result = ask();
  } else {
    const HostileEnvironment hostile(mode);
    result = ask();
  }
  return text(*result);
}

constexpr std::array rounding_modes{FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

template <class Ask>
void expect_the_same(const char* what, const Ask& ask) {
  const kernels::DefaultFloatEnvironment environment;
  const std::string expected = told(-1, ask);
  for (const int mode : rounding_modes) EXPECT_EQ(told(mode, ask), expected) << what << ", rounding mode " << mode;
}

Body stretched(std::uint64_t seed, const mpq_class& by) {
  families::Random random(seed);
  return families::scaled(families::random_sphere_body(random, 8), 1, 1, by);
}

/// Bodies whose extent in z is 2^-600 of that in x and y; and a box of which one coordinate is the
/// least normal number.
std::vector<Case> cases_at_the_edge_of_binary64() {
  const kernels::DefaultFloatEnvironment environment;
  std::vector<Case> cases;
  const mpq_class tiny = mpq_class(1) >> 600;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    cases.push_back({"stretched " + std::to_string(seed), stretched(seed, tiny),
                     families::translated(stretched(seed + 100, tiny), {mpq_class(1, 4), 0, 0})});
  }
  Case boxes{"least normal number", families::box(2, 2, 2),
             families::translated(families::box(2, 2, 2), {mpq_class(1, 2), mpq_class(1, 4), mpq_class(1, 8)})};
  boxes.b.points.edit()[0].x += mpq_class(1) >> 1022;
  cases.push_back(std::move(boxes));
  return cases;
}

std::vector<Case> all_cases() {
  std::vector<Case> cases = cases_at_the_edge_of_binary64();
  for (const families::Family& family : families::families()) cases.push_back(family.make(1, 6));
  for (const families::CatalogueEntry& entry : families::catalogue()) cases.push_back(entry.pair);
  return cases;
}

// ---- every public function ----

TEST(FloatEnvironment, DepthByEveryMethodOverAllFamilies) {
  for (const Case& input : all_cases()) {
    SCOPED_TRACE(input.id);
    for (const Method method : {Method::automatic, Method::exact, Method::naive}) {
      expect_the_same("depth", [&] { return penetration_depth(input.a.points, input.b.points, {.method = method}); });
    }
  }
}

TEST(FloatEnvironment, CertificatesOverAllFamilies) {
  for (const Case& input : all_cases()) {
    SCOPED_TRACE(input.id);
    const Depth depth = penetration_depth(input.a.points, input.b.points);
    expect_the_same("certificate",
                    [&] { return certificate_text(make_certificate(input.a.points, input.b.points, depth)); });
    expect_the_same("its text", [&] { return certificate_text(input.a.points, input.b.points, depth, "id"); });
    if (depth.status() != Status::penetrating) continue;
    expect_the_same("bounds", [&] {
      return certificate_text(
          make_bounds_certificate(input.a.points, input.b.points, depth.squared() / 2, depth.squared() * 2));
    });
    expect_the_same("gap",
                    [&] { return second_nearest_squared(input.a.points, input.b.points, *depth.penetration()); });
  }
}

/// The points, truncated to binary64.
std::vector<std::array<double, 3>> doubles(const Body& body) {
  std::vector<std::array<double, 3>> result;
  for (const Point& p : body.points) result.push_back({p.x.get_d(), p.y.get_d(), p.z.get_d()});
  return result;
}

TEST(FloatEnvironment, PointsInBinary64OverAllFamilies) {
  Workspace workspace;
  Options options;
  options.workspace = &workspace;
  for (const Case& input : all_cases()) {
    SCOPED_TRACE(input.id);
    const auto a = doubles(input.a), b = doubles(input.b);
    expect_the_same("depth", [&] { return penetration_depth(a, b, options); });
    const Depth depth = penetration_depth(a, b);
    expect_the_same("certificate", [&] { return certificate_text(a, b, depth, "id"); });
  }
}

TEST(FloatEnvironment, TheOtherQuestions) {
  for (const Case& input : cases_at_the_edge_of_binary64()) {
    SCOPED_TRACE(input.id);
    const std::vector<Point>&a = input.a.points, &b = input.b.points;
    expect_the_same("shallow", [&] { return shallow_depth(a, b); });
    expect_the_same("width", [&] { return width(a); });
    expect_the_same("approx", [&] { return approx_depth(a, b, mpq_class(1, 10)); });
    expect_the_same("approx width", [&] { return approx_width(a, mpq_class(1, 10)); });
    expect_the_same("ray", [&] { return directional_depth(a, b, {1, 2, 3}); });
    expect_the_same("growth", [&]() -> std::optional<GrowthDistance> {
      try {
        return growth_distance(a, b);
      } catch (const NoGrowth&) {
        return std::nullopt;
      }
    });
    expect_the_same("impact", [&] {
      const RigidMotion moving{{1, 0, 0, 0}, {1, mpq_class(1, 3), 0, 1}, {5, 1, 0}, {-5, 0, 0}}, at_rest;
      return certificate_text(a, moving, b, at_rest, first_contact(a, moving, b, at_rest));
    });
    expect_the_same("contact geometry", [&] { return ToFirstOrder(a, b); });
    expect_the_same("metric", [&] {
      const Body ball = families::translated(families::box(2, 2, 2), {-1, -1, -1});
      return metric_depth(a, b, unit_ball(ball.points));
    });
    expect_the_same("study", [&] { return study(a, b).depth; });
  }
}

TEST(FloatEnvironment, RaysThroughHierarchies) {
  for (const Case& input : cases_at_the_edge_of_binary64()) {
    SCOPED_TRACE(input.id);
    expect_the_same("hierarchies", [&] {
      const polytope::PlacedPair placed = polytope::place(input.a.points, input.b.points);
      const polytope::Polytope hull_a = polytope::convex_hull(placed.a.points()),
                               hull_b = polytope::convex_hull(placed.b.points());
      const polytope::Hierarchy a(hull_a), b(hull_b);
      kernels::Context context;
      const approximate::ShallowPenetration shallow(context, a, b);
      const approximate::RayHit hit = approximate::shoot_ray(a, b, {3, 1, 2});
      return text(hit.factor, hit.normal, shallow.query(context).inside,
                  approximate::approx_separation(context, a, b, mpq_class(1, 4)).normal, a.extreme({5, -7, 1}),
                  a.extreme_face({0, 0, 1}));
    });
  }
}

TEST(FloatEnvironment, Numbers) {
  const mpq_class subnormal = (mpq_class(5, 3) >> 1060) + (mpq_class(1) >> 1074);
  expect_the_same("round_binary64", [&] { return round_binary64(subnormal, Rounding::rn); });
  expect_the_same("round_binary32",
                  [&] { return static_cast<double>(round_binary32(mpq_class(5, 3) >> 120, Rounding::ru)); });
  expect_the_same("root_binary64", [&] { return root_binary64(subnormal * subnormal, Rounding::rd); });
  expect_the_same("exact_value", [&] { return exact_value(0x1.8p-1070); });
  expect_the_same("parse_number", [&] { return *parse_number("4.9e-322", Decimals::binary64).value; });
  expect_the_same("enclose_root", [&] { return enclose_root(mpq_class(2), 40).high; });
  expect_the_same("round_binary64 of a surd", [&] {
    return round_binary64(Surd{subnormal, subnormal * subnormal / 3}, Rounding::ru);
  });
  expect_the_same("round_binary32 of a surd", [&] {
    return static_cast<double>(round_binary32(Surd{1, 2}, Rounding::rd));
  });
  expect_the_same("enclose", [&] { return enclose({1, 2}, 40).low; });
}

TEST(FloatEnvironment, SignedDepths) {
  const std::vector<Point> piece{{0, 0, 0}, {1, exact_value(5e-324), 0}, {0, 1, 0}, {0, 0, exact_value(0.1)}};
  expect_the_same("union_depth", [&] { return union_depth({piece, piece}, {piece}).optima.front().translation; });
  const Pose pose =
      rigid_pose({exact_value(0.1), exact_value(0.3), 2, 1}, {mpq_class(5, 3) >> 1060, 0, exact_value(5e-324)});
  for (const Shape& body :
       {box({1, 1, exact_value(3e-310)}), capsule(exact_value(0.7), 2), moved(box({1, 2, 3}), pose)}) {
    expect_the_same("study", [&] { return study(body, moved(sphere(2), pose))[ShapeCoincidence::concentric].count; });
    expect_the_same("signed_depth", [&] {
      const SignedDepth depth = signed_depth(body, moved(sphere(exact_value(1e-320)), pose));
      return text(depth.low_binary64(), depth.high_binary64(), depth.translations().front().alpha,
                  depth.witness()->a.core);
    });
  }
}

TEST(FloatEnvironment, Files) {
  expect_the_same("mesh", [&] {
    return parse_mesh("OFF\n3 0 0\n1 0 5e-324\n0 1.1 0\n0 0 2.5e-310\n", "a.off", Decimals::binary64);
  });
  const std::string lines = R"({"a":{"vertices":[[1e-320,0,0],[1,2.3,4]]},"b":{"vertices":[[0.1,0,3e-310]]}})";
  expect_the_same("case", [&] { return parse_case(lines, "cases").value().a; });
}

TEST(FloatEnvironment, Judging) {
  const std::vector<Triple> a{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
      b{{0.1, 0.1, 5e-324}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Reply reply;
  reply.overlap = true;
  reply.depth = 0.404;
  reply.direction = Triple{-0.57, -0.57, -0.57};
  expect_the_same("judge", [&] { return judge(a, b, reply).sentence; });
  expect_the_same("judge of unions", [&] {
    return judge(truth_about(Pieces{GivenPoints(a)}, Pieces(2, GivenPoints(b))), reply).sentence;
  });
  expect_the_same("the library for C", [&] {
    using namespace testing;  // handles
    const BodyHandle first = body_of({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}),
                     second = body_of({0.1, 0.1, 5e-324, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    fathom_claim claim;
    fathom_judgement judgement;
    fathom_claim_init(&claim);
    fathom_judgement_init(&judgement);
    const int code = fathom_judge(first.get(), second.get(), &claim, &judgement, nullptr);
    return text(code, exactly(answer_about(first, second), FATHOM_WITNESS_A), judgement.signed_depth,
                judgement.verdict);
  });
}

}  // namespace
}  // namespace fathom
