// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts: what a sensible engine answers in doubles is right at all tilts; what is broken on
// purpose is found, with a proof, and what the proofs do not say is refused.
#include "verify/judge/manifold.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fathom/numbers.hpp"
#include "kernels/vector.hpp"
#include "tests/judge/findings.hpp"
#include "tests/judge/pairs.hpp"
#include "verify/families/random.hpp"
#include "verify/judge/scene.hpp"

namespace fathom::judging {
namespace {

using families::Random;
using testing::cubes;
using testing::Findings;
using testing::left;
using testing::overlap;
using testing::OwnedContactJudge;
using Verdict::contact_outside;
using Verdict::contact_too_deep;
using Verdict::contact_too_shallow;
using Verdict::misses_extent;
using Verdict::tips;

Findings words(const std::vector<ContactFault>& faults) {
  Findings result;
  for (const ContactFault& fault : faults) result.push_back(fault.finding);
  return result;
}

using Declared = std::optional<ContactLimits>;

Conventions declaring(const Declared& manifold) {
  Conventions conventions;
  conventions.manifold = manifold;
  return conventions;
}

OwnedContactJudge judge_of(const Truth& truth, const Reply& reply, const Declared& manifold = ContactLimits(),
                           const Tolerance& tolerance = {}) {
  return {truth, reply, declaring(manifold), Precision::binary64, tolerance};
}

/// The findings; each is to be proved.
Findings found(const Truth& truth, const Reply& reply, const Declared& manifold = ContactLimits(),
               const Tolerance& tolerance = {}) {
  const OwnedContactJudge of(truth, reply, declaring(manifold), Precision::binary64, tolerance);
  const ContactJudge& judge = of.judge;
  const std::vector<ContactFault> faults = judge.faults();
  for (const ContactFault& fault : faults) {
    EXPECT_TRUE(judge.proves(fault)) << fault.sentence;
    EXPECT_FALSE(fault.sentence.empty());
  }
  return words(faults);
}

/// Unit cubes that overlap by 0.6 along x; contacts half way between their faces.
Reply on_square(const std::vector<std::array<double, 2>>& places, std::optional<double> depth = 0.6) {
  Reply reply = overlap(0.6, left);
  for (const auto& [y, z] : places) reply.contacts.push_back({{0.7, y, z}, depth});
  return reply;
}

TEST(Manifold, OfTwoCubes) {
  const Reply four = on_square({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  EXPECT_EQ(found(cubes(), four), Findings{});
  const auto with = [&](std::array<double, 2> place, double depth) {
    Reply reply = four;
    reply.contacts.push_back({{0.7, place[0], place[1]}, depth});
    return reply;
  };
  EXPECT_EQ(found(cubes(), with({0.5, 0.5}, 0.6005)), Findings{}) << "within the tolerance";
  EXPECT_EQ(found(cubes(), with({0.5, 0.5}, 0.6007)), Findings{contact_too_deep});
  EXPECT_EQ(found(cubes(), with({0.5, 0.5}, 0.5995)), Findings{});
  EXPECT_EQ(found(cubes(), with({0.5, 0.5}, 0.5993)), Findings{contact_too_shallow});
  EXPECT_EQ(found(cubes(), with({0, 1.0005}, 0.6)), Findings{});
  EXPECT_EQ(found(cubes(), with({0, 1.0007}, 0.6)), Findings{contact_outside});
  EXPECT_EQ(found(cubes(), with({0, 1.0007}, 0.9)), Findings{contact_outside}) << "one finding for each contact";

  EXPECT_EQ(found(cubes(), on_square({{0, 0}, {1, 0}, {1, 1}})), Findings{misses_extent});
  EXPECT_EQ(found(cubes(), on_square({{0, 0}, {1, 0}})), (Findings{misses_extent, tips}));
  EXPECT_EQ(found(cubes(), on_square({{0, 0}, {1, 0}, {1, 1}}), ContactLimits{.most = 3}), Findings{})
      << "three corners miss one";
  EXPECT_EQ(found(cubes(), on_square({{0, 0}, {0.1, 0}, {0.1, 0.2}}), ContactLimits{.most = 3}),
            (Findings{misses_extent, tips}));
  EXPECT_EQ(found(cubes(), overlap(0.6, left)), Findings{}) << "no contacts are promised";
  const Reply one = on_square({{0, 0}});
  EXPECT_EQ(found(cubes(), one, ContactLimits{.most = 1}), Findings{}) << "one contact promises no extent";
  EXPECT_EQ(found(cubes(), one, std::nullopt), Findings{});
  EXPECT_EQ(found(cubes(), on_square({{0, 0}, {1, 0}}), std::nullopt), Findings{})
      << "nor do any that are not declared";
  EXPECT_EQ(found(cubes(), one), (Findings{misses_extent, tips}));
  EXPECT_EQ(found(cubes(), one, ContactLimits{.most = 2}), (Findings{misses_extent, tips}))
      << "two corners miss by half";
  EXPECT_EQ(judge_of(cubes(), on_square({{0, 0}, {1, 0}})).judge.faults()[0].sentence,
            "the contacts miss a corner of the patch by 1");
  EXPECT_EQ(judge_of(cubes(), with({0.5, 0.5}, 0.7)).judge.faults()[0].sentence,
            "contact 4 is too deep: 0.7 is claimed, along the lines near it the bodies overlap by 0.6 at most");
}

// Contacts among all that may be wrong with an answer: a contact that is outside is told by that
// alone, where it lies along the direction by witness-off.
TEST(Manifold, IsJudgedAmongAllFindings) {
  Reply reply = on_square({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const Conventions whole = declaring(ContactLimits());
  const auto judged = [&] { return judge(cubes(), reply, whole); };
  EXPECT_EQ(judged().verdict, Verdict::pass);
  reply.contacts[0].position = {0.7, -0.5, 0};
  EXPECT_EQ(judged().findings, Findings{contact_outside});
  EXPECT_EQ(judged().contact_a_squared, mpq_class(1, 4)) << "how far away it is";
  reply.contacts[1].position = {0.7, 1.5, 0};
  EXPECT_EQ(judged().sentence,
            "contact 0 is outside: no line near it along the direction meets both bodies, and 1 more is so");
  reply.contacts[2].position[0] = 2;
  reply.contacts[3].depth = 0.5;
  EXPECT_EQ(judged().findings, (Findings{Verdict::witness_off, contact_outside, contact_too_shallow}));
  EXPECT_EQ(judged().verdict, Verdict::witness_off);
  reply.direction.reset();
  EXPECT_EQ(judged().findings, Findings{Verdict::witness_off}) << "without a direction only where they lie";
  reply = on_square({{0, 0}, {1, 0}});
  EXPECT_EQ(judged().verdict, misses_extent);
  EXPECT_EQ(judged().findings, (Findings{misses_extent, tips}));
  reply.direction = testing::right;
  EXPECT_EQ(judged().findings, Findings{Verdict::wrong_sign}) << "a sign is told alone";

  Conventions separating = whole;
  separating.claims = Conventions::Claims::separating;
  Reply upwards = overlap(1, testing::up);
  for (const auto& [x, y] : {std::array{0.4, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.4, 1.0}})
    upwards.contacts.push_back({{x, y, 0.5}, 1.0});
  EXPECT_EQ(judge(cubes(), upwards, separating).verdict, Verdict::pass) << "of another way out no extent is asked";
  upwards.contacts[0].depth = 0.5;
  EXPECT_EQ(judge(cubes(), upwards, separating).verdict, contact_too_shallow);

  // Of such a way the separating distance is longer than what the bodies overlap along any line.
  Reply slanted = overlap(1.6 * std::sqrt(0.5), Triple{-std::sqrt(0.5), -std::sqrt(0.5), 0});
  slanted.contacts = {{{0.7, 0.5, 0.5}, {}}};
  EXPECT_TRUE(judge(cubes(), slanted, separating).excess_allowed);
  EXPECT_EQ(judge(cubes(), slanted, separating).findings, Findings{});
  slanted.contacts[0].depth = 0.6 * std::sqrt(2);
  EXPECT_EQ(judge(cubes(), slanted, separating).findings, Findings{}) << "its own depth is that of its line";
  slanted.contacts[0].depth = 1;
  EXPECT_EQ(judge(cubes(), slanted, separating).findings, Findings{contact_too_deep});
}

// Another way out that is longer by a hair is right, and has a patch of its own.
TEST(Manifold, OfNearTiesIsThatOfTheAnsweredDirection) {
  std::vector<Triple> a, b;
  for (const double x : {0.0, 1.0})
    for (const double y : {0.0, 1.0})
      for (const double z : {0.0, 1.0}) (a.push_back({x, y, z}), b.push_back({x + 0.5, y + 0.499999999, z}));
  const Truth truth = truth_about(GivenPoints(a), GivenPoints(b));
  Reply reply = overlap(0.500000001, Triple{0, -1, 0});
  for (const auto& [x, z] : {std::array{0.5, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.5, 1.0}})
    reply.contacts.push_back({{x, 0.75, z}, {}});
  EXPECT_EQ(judge(truth, reply, declaring(ContactLimits())).verdict, Verdict::pass);
  reply.direction = testing::left;
  reply.depth = 0.5;
  EXPECT_EQ(judge(truth, reply, declaring(ContactLimits())).findings, Findings{misses_extent});
}

// Without depths of their own contacts have that of the answer, less a margin that is declared.
TEST(Manifold, ContactsWithoutDepths) {
  const Truth wedge =
      truth_about(std::vector<Point>{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}, {0, 0, -1}, {0, 4, -1}},
                  std::vector<Point>{{0, 0, -8},
                                     {4, 0, -8},
                                     {0, 4, -8},
                                     {4, 4, -8},
                                     {0, 0, mpq_class(-1, 2)},
                                     {4, 0, mpq_class(-1, 2)},
                                     {0, 4, mpq_class(-1, 2)},
                                     {4, 4, mpq_class(-1, 2)}});
  Reply reply = overlap(0.5, testing::up);
  for (const auto& [x, y] : {std::array{0.0, 0.0}, {0.0, 4.0}, {1.0, 4.0}, {1.0, 0.0}})
    reply.contacts.push_back({{x, y, -0.75}, {}});
  EXPECT_EQ(found(wedge, reply), (Findings{contact_too_deep, contact_too_deep})) << "they overlap by 1/4 at x = 1";
  EXPECT_EQ(found(wedge, reply, ContactLimits{.margin = 0.25}), Findings{});
  for (ContactPoint& contact : reply.contacts) contact.depth = contact.position[0] == 0 ? 0.5 : 0.25;
  EXPECT_EQ(found(wedge, reply), Findings{});
  reply.contacts[2].position[0] = reply.contacts[3].position[0] = 3;  // apart by 1/4
  EXPECT_EQ(found(wedge, reply), (Findings{contact_too_deep, contact_too_deep}));
  reply.contacts[2].depth = reply.contacts[3].depth = -0.25;
  EXPECT_EQ(found(wedge, reply), Findings{}) << "a contact may be one to come";
}

// ---- the definitions ----

GivenPoints random_points(Random& random) {
  std::vector<Triple> points;
  for (int i = 0; i < 5; ++i)
    points.push_back({static_cast<double>(random.between(-8, 8)), static_cast<double>(random.between(-8, 8)),
                      static_cast<double>(random.between(-8, 8))});
  return GivenPoints(std::move(points));
}

using LeastAndGreatest = std::optional<std::array<mpq_class, 2>>;

/// What is wrong with one contact of the depth d, from the overlaps near it along a direction of
/// the length 5.
Findings found_naively(const LeastAndGreatest& overlaps, const mpq_class& d, const mpq_class& tol) {
  if (!overlaps) return {contact_outside};
  if (d > 5 * (*overlaps)[1] + tol) return {contact_too_deep};
  if (d < 5 * (*overlaps)[0] - tol) return {contact_too_shallow};
  return {};
}

// Depths are chosen on the borders, a number to either side of them.
TEST(Manifold, OfOneContactIsWhatTheDefinitionsSay) {
  Random random(5);
  const Vector v{3, 0, 4};
  std::map<Verdict, std::size_t> seen;
  std::size_t right = 0;
  for (int k = 0; k < 24; ++k) {
    const Truth truth = truth_about(random_points(random), random_points(random));
    const mpq_class tol = sizes_of(truth.a, truth.b).extent / 8;
    const Tolerance tolerance{0, mpq_class(1, 8), 0};
    const Triple &p = families::any_of(truth.a.binary64(), random), &q = families::any_of(truth.b.binary64(), random);
    const Triple x{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2};
    const LeastAndGreatest overlaps = patch::overlaps_naive(v, truth.a.exact(), truth.b.exact(), exact_point(x), tol);
    std::vector<double> depths{0.5};
    if (overlaps)
      for (const Rounding rounding : {Rounding::rd, Rounding::ru}) {
        depths.push_back(round_binary64(5 * (*overlaps)[1] + tol, rounding));
        depths.push_back(round_binary64(5 * (*overlaps)[0] - tol, rounding));
      }
    for (const double depth : depths) {
      Reply reply = overlap(depth, Triple{3, 0, 4});
      reply.contacts = {{x, depth}};
      Findings words = found(truth, reply, std::nullopt, tolerance);
      EXPECT_EQ(words, found_naively(overlaps, exact_value(depth), tol)) << "pair " << k << ", depth " << depth;
      if (words.empty()) ++right;
      else ++seen[words[0]];
    }
  }
  EXPECT_GT(right, 10U);
  for (const Verdict finding : {contact_outside, contact_too_deep, contact_too_shallow})
    EXPECT_GT(seen[finding], 3U) << name(finding);
}

// ---- an engine in doubles ----

using Corners = std::array<Triple, 8>;  // corner k of a box has the bits of k

Triple minus(const Triple& p, const Triple& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }
double times(const Triple& p, const Triple& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
Triple crossed(const Triple& u, const Triple& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
Triple along(const Triple& p, double s, const Triple& d) { return {p[0] + s * d[0], p[1] + s * d[1], p[2] + s * d[2]}; }

/// The face of a box that is farthest along v, in order.
std::vector<Triple> face(const Corners& box, const Triple& v) {
  constexpr std::array<std::array<std::size_t, 4>, 6> faces{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  const auto height = [&](const auto& f) {
    double sum = 0;
    for (const std::size_t k : f) sum += times(v, box[k]);
    return sum;
  };
  std::vector<Triple> result;
  for (const std::size_t k : *std::ranges::max_element(faces, {}, height)) result.push_back(box[k]);
  return result;
}

/// A lies on B: the face of A below, clipped by the sides of B's face above; the direction is the
/// latter's normal. As engines do it.
Reply clipped(const Corners& a, const Corners& b) {
  const std::vector<Triple> base = face(b, {0, 0, 1});
  std::vector<Triple> polygon = face(a, {0, 0, -1});
  Triple n = crossed(minus(base[1], base[0]), minus(base[2], base[0]));
  const double length = std::sqrt(times(n, n)) * (n[2] < 0 ? -1 : 1);
  n = {n[0] / length, n[1] / length, n[2] / length};
  const Triple middle = along(base[0], 0.5, minus(base[2], base[0]));
  for (std::size_t i = 0; i < 4; ++i) {
    Triple out = crossed(minus(base[(i + 1) % 4], base[i]), n);
    if (times(out, minus(middle, base[i])) > 0) out = {-out[0], -out[1], -out[2]};
    std::vector<Triple> kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Triple &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
      const double dp = times(out, minus(p, base[i])), dq = times(out, minus(q, base[i]));
      if (dp <= 0) kept.push_back(p);
      if (dp * dq < 0) kept.push_back(along(p, dp / (dp - dq), minus(q, p)));
    }
    polygon = kept;
  }
  Reply reply = overlap(0, n);
  for (const Triple& p : polygon) {
    reply.contacts.push_back({p, times(n, minus(base[0], p))});
    reply.depth = std::max(*reply.depth, *reply.contacts.back().depth);
  }
  return reply;
}

/// A box that lies on one, sunk in a little, turned about the vertical, and tilted.
Corners posed(const Triple& half, const Triple& at, double turn, double tilt) {
  Corners result;
  for (std::size_t k = 0; k < 8; ++k) {
    const double x = (k & 1 ? half[0] : -half[0]), y = (k & 2 ? half[1] : -half[1]), z = (k & 4 ? half[2] : -half[2]);
    const double c = std::cos(turn), s = std::sin(turn);
    const Triple turned{c * x - s * y, s * x + c * y, z};
    const double ct = std::cos(tilt), st = std::sin(tilt);
    result[k] = along(at, 1, {ct * turned[0] + st * z, turned[1], ct * z - st * turned[0]});
  }
  return result;
}

GivenPoints body(const Corners& box) { return GivenPoints(std::vector<Triple>(box.begin(), box.end())); }

/// Broken in one way, each is found by this word.
void expect_broken_found(const Truth& truth, const Reply& right, const std::string& where) {
  const auto has = [&](const Reply& reply, Verdict word) {
    const Findings all = found(truth, reply);
    return std::ranges::find(all, word) != all.end();
  };
  for (std::size_t k = 0; k < right.contacts.size(); ++k) {
    Reply reply = right;
    *reply.contacts[k].depth += 0.01;
    EXPECT_TRUE(has(reply, contact_too_deep)) << where;
    reply = right;
    reply.contacts[k].position[0] += 50;
    EXPECT_TRUE(has(reply, contact_outside)) << where;
  }
  Triple mean{};
  for (const ContactPoint& contact : right.contacts)
    mean = along(mean, 1.0 / static_cast<double>(right.contacts.size()), contact.position);
  Reply reply = right;
  reply.contacts.push_back({mean, 0.0});
  EXPECT_TRUE(has(reply, contact_too_shallow)) << where;
}

TEST(Manifold, OfAClippingEngineIsNotBlamedAtAnyTilt) {
  Random random(3);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random.between(0, 1 << 20)) / (1 << 20);
  };
  for (const double tilt : {0.0, 1e-9, 1e-4, 0.01}) {
    for (int k = 0; k < 3; ++k) {
      const Triple half_a{between(0.5, 2), between(0.5, 2), 1}, half_b{between(0.5, 2), between(0.5, 2), 1};
      const Corners a = posed(half_a, {between(-0.5, 0.5), between(-0.5, 0.5), 1.95}, k == 0 ? 0 : between(0, 3), tilt),
                    b = posed(half_b, {0, 0, 0}, 0, 0);
      const Truth truth = truth_about(body(a), body(b));
      ASSERT_EQ(truth.depth.status(), Status::penetrating);
      const Reply reply = clipped(a, b);
      ASSERT_GE(reply.contacts.size(), 3U);
      const std::string where = "tilt " + std::to_string(tilt) + ", scene " + std::to_string(k);
      EXPECT_EQ(found(truth, reply), Findings{}) << where;
      expect_broken_found(truth, reply, where);
      if (tilt > 0) continue;
      Reply less = reply;
      less.contacts.pop_back();
      EXPECT_EQ(found(truth, less)[0], misses_extent) << where;
      less.contacts.resize(1);
      EXPECT_EQ(found(truth, less), (Findings{misses_extent, tips})) << where;
    }
  }
}

/// How far p is from the nearest side of a polygon, seen from above.
double away_from(const Triple& p, const std::vector<ContactPoint>& polygon) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Triple &from = polygon[k].position, edge = minus(polygon[(k + 1) % polygon.size()].position, from);
    const double share = std::clamp(times(edge, minus(p, from)) / times(edge, edge), 0.0, 1.0);
    const Triple apart = minus(p, along(from, share, edge));
    least = std::min(least, std::sqrt(times(apart, apart)));
  }
  return least;
}

/// The four contacts of an answer that leave out least.
Reply best_four(const Reply& reply) {
  std::vector<char> chosen(reply.contacts.size(), 0);
  std::fill(chosen.begin(), chosen.begin() + 4, 1);
  Reply best = reply;
  double least = std::numeric_limits<double>::infinity();
  do {
    std::vector<ContactPoint> kept;
    double missed = 0;
    for (std::size_t k = 0; k < chosen.size(); ++k)
      if (chosen[k] != 0) kept.push_back(reply.contacts[k]);
    for (std::size_t k = 0; k < chosen.size(); ++k)
      if (chosen[k] == 0) missed = std::max(missed, away_from(reply.contacts[k].position, kept));
    if (missed < least) (least = missed, best.contacts = kept);
  } while (std::ranges::prev_permutation(chosen).found);
  return best;
}

TEST(Manifold, TheBestFourOfMoreAreNotBlamedForTheDeepestByAHair) {
  const Tolerance tolerance{.absolute = mpq_class(1, 1000)};
  std::size_t left_out = 0;
  for (int k = 0; k < 12; ++k) {
    const double turn = 0.3 + static_cast<double>(k) / 12;
    for (const double tilt : {1e-9, 1e-4}) {
      const Corners a = posed({1, 1, 1}, {0.1, -0.05, 1.95}, turn, tilt), b = posed({1, 1, 1}, {0, 0, 0}, 0, 0);
      const Reply all = clipped(a, b);
      if (all.contacts.size() < 6) continue;
      const auto deepest = std::ranges::max_element(all.contacts, {}, &ContactPoint::depth);
      const Reply four = best_four(all);
      if (std::ranges::any_of(four.contacts, [&](const ContactPoint& c) { return c.position == deepest->position; }))
        continue;
      ++left_out;
      const Truth truth = truth_about(body(a), body(b));
      EXPECT_EQ(found(truth, four, ContactLimits{.most = 4}, tolerance), Findings{}) << turn << " " << tilt;
      Reply corner = four;
      corner.contacts.resize(2);
      EXPECT_EQ(found(truth, corner, ContactLimits{.most = 4}, tolerance)[0], misses_extent) << turn << " " << tilt;
    }
  }
  EXPECT_GT(left_out, 5U);
}

// ---- the patch with slack ----

/// A unit box on a plate, 1/16 deep at its edge x = 0; its lower face rises by 1/64 to x = 1.
Truth tilted_box() {
  std::vector<Point> a, b;
  for (const int x : {0, 1})
    for (const int y : {0, 1})
      for (const int z : {0, 1}) {
        a.push_back({x, y, z == 1 ? mpq_class(1) : mpq_class(x) / 64});
        b.push_back({4 * x - 2, 4 * y - 2, z == 1 ? mpq_class(1, 16) : mpq_class(-4)});
      }
  return truth_about(std::move(a), std::move(b));
}

Reply on_plate(const std::vector<std::array<double, 2>>& places) {
  Reply reply = overlap(0.0625, testing::up);
  for (const auto& [x, y] : places) reply.contacts.push_back({{x, y, 0.03125}, 0.0625 - x / 64});
  return reply;
}

TEST(Manifold, IsMeasuredAgainstThePatchWithSlack) {
  const Truth tilted = tilted_box();  // a slack of s reaches to x = 64 s
  const auto measured = [&](const Reply& reply, const mpq_class& slack, const Declared& declared = std::nullopt) {
    Tolerance tolerance;
    tolerance.patch_slack = slack;
    return judge(tilted, reply, declaring(declared), Precision::binary64, tolerance);
  };
  const Reply edge = on_plate({{0, 0}, {0, 1}}), half = on_plate({{0, 0}, {0, 1}, {0.5, 0}, {0.5, 1}});
  const mpq_class slack(1, 64);
  EXPECT_FALSE(judge(tilted, edge, declaring(std::nullopt)).extent_missed_squared) << "it is not asked for";
  EXPECT_EQ(measured(edge, 0).extent_missed_squared, mpq_class(0));
  EXPECT_EQ(measured(edge, 0).extent_covered_squared, mpq_class(1)) << "of a segment the length counts";
  EXPECT_EQ(measured(edge, slack / 4).extent_missed_squared, mpq_class(1, 16));
  EXPECT_EQ(measured(edge, slack).extent_missed_squared, mpq_class(1));
  EXPECT_EQ(measured(edge, slack).extent_covered_squared, mpq_class(0));
  EXPECT_EQ(measured(half, slack).extent_missed_squared, mpq_class(1, 4));
  EXPECT_EQ(measured(half, slack).extent_covered_squared, mpq_class(1, 4));
  EXPECT_EQ(measured(on_plate({{0, 0}, {0, 1}, {0.5, 0}}), slack).extent_covered_squared, mpq_class(1, 16));
  EXPECT_EQ(measured(on_plate({{-1, -1}, {3, -1}, {-1, 3}}), slack).extent_covered_squared, mpq_class(1));
  EXPECT_FALSE(measured(overlap(0.0625, testing::up), slack).extent_missed_squared) << "without contacts";
  EXPECT_FALSE(measured(overlap(0.0625, left), slack).extent_missed_squared);
}

// A measure blames nobody who promises nothing; a promise is held to the slack, both ways.
TEST(Manifold, IsHeldToThePatchWithSlack) {
  const Truth tilted = tilted_box();
  const auto with = [&](const Reply& reply, const mpq_class& slack, const Declared& declared = ContactLimits()) {
    Tolerance tolerance;
    tolerance.patch_slack = slack;
    return found(tilted, reply, declared, tolerance);
  };
  const auto places = [](double x) { return on_plate({{0, 0}, {0, 1}, {x, 0}, {x, 1}}); };
  const mpq_class slack(1, 64);
  const double near = 0.0625 / 1000, reached = 1 - 1.0 / 64;
  EXPECT_EQ(found(tilted, on_plate({{0, 0}, {0, 1}})), Findings{}) << "the exact patch is the edge";
  EXPECT_EQ(with(on_plate({{0, 0}, {0, 1}}), 0), Findings{});
  EXPECT_EQ(with(on_plate({{0, 0}, {0, 1}}), slack), Findings{misses_extent}) << "its middle is not missed";
  EXPECT_EQ(with(on_plate({{0, 0}, {0, 1}}), slack, std::nullopt), Findings{});
  EXPECT_EQ(with(places(1), slack), Findings{});
  EXPECT_EQ(with(places(reached - near / 2), slack), Findings{}) << "a position may be off by the slack too";
  EXPECT_EQ(with(places(reached - near * 2), slack), Findings{misses_extent});
  EXPECT_EQ(with(on_plate({{0, 0}, {0, 1}, {1, 0}}), slack), Findings{misses_extent});
  EXPECT_EQ(with(on_plate({{0, 0}, {0, 1}, {1, 0}}), slack, ContactLimits{.most = 3}), Findings{})
      << "three corners miss one";
  EXPECT_EQ(with(on_plate({{0, 0}, {0, 1}, {0.25, 0}}), slack, ContactLimits{.most = 3}), Findings{misses_extent});
  Tolerance tolerance;
  tolerance.patch_slack = slack;
  EXPECT_EQ(judge_of(tilted, on_plate({{0, 0}, {0, 1}}), ContactLimits(), tolerance).judge.faults()[0].sentence,
            "the contacts miss a corner of the patch with a slack of 0.01562 by 1");
}

// ---- forgeries ----

TEST(Manifold, ForgedProofsAreRefused) {
  Reply reply = on_square({{0, 0}, {1, 0}, {2, 0.5}, {0.5, 0.5}, {0.25, 0.25}, {0.75, 0.25}});
  reply.contacts[3].depth = 0.7;
  reply.contacts[4].depth = 0.5;
  const OwnedContactJudge of = judge_of(cubes(), reply);
  const ContactJudge& judge = of.judge;
  std::vector<ContactFault> faults = judge.faults();
  ASSERT_EQ(words(faults), (Findings{contact_outside, contact_too_deep, contact_too_shallow, misses_extent}));
  const auto refused = [&](std::size_t k, auto change) {
    ContactFault fault = faults[k];
    EXPECT_TRUE(judge.proves(fault));
    change(fault);
    return !judge.proves(fault);
  };
  const mpq_class hair(1, 1'000'000'000);
  for (const std::size_t k : {0U, 1U}) {
    EXPECT_TRUE(refused(k, [](ContactFault& fault) { fault.contact = 5; })) << "a good one";
    EXPECT_TRUE(refused(k, [](ContactFault& fault) { fault.contact = 6; }));
    EXPECT_TRUE(refused(k, [](ContactFault& fault) { fault.contact.reset(); }));
    EXPECT_TRUE(refused(k, [](ContactFault& fault) { fault.planes.reset(); }));
    EXPECT_TRUE(refused(k, [&](ContactFault& fault) { fault.planes->u.x += hair; }));
    EXPECT_TRUE(refused(k, [&](ContactFault& fault) { fault.planes->w.x += hair; }));
    EXPECT_TRUE(refused(k, [](ContactFault& fault) { fault.planes->u = fault.planes->w = {}; }));
    EXPECT_TRUE(refused(k, [](ContactFault& fault) {
      fault.finding = fault.finding == contact_outside ? contact_too_deep : contact_outside;
    }));
  }
  EXPECT_TRUE(refused(1, [](ContactFault& fault) { fault.planes->u.y += 1; })) << "a plane that proves less";
  EXPECT_TRUE(refused(2, [](ContactFault& fault) { fault.contact = 5; }));
  EXPECT_TRUE(refused(2, [](ContactFault& fault) { fault.lines.pop_back(); }));
  EXPECT_TRUE(refused(2, [](ContactFault& fault) { fault.lines.clear(); }));
  EXPECT_TRUE(refused(2, [](ContactFault& fault) { fault.lines[0] = fault.lines[1]; }));
  EXPECT_TRUE(refused(2, [](ContactFault& fault) { fault.lines[0].factor *= 2; }));
  EXPECT_TRUE(refused(2, [](ContactFault& fault) { fault.lines[0].a.x += 1, fault.lines[0].factor += 1; }));
  EXPECT_TRUE(refused(2, [](ContactFault& fault) { fault.lines[0].b.x -= 1, fault.lines[0].factor += 1; }));
  EXPECT_TRUE(refused(3, [](ContactFault& fault) { fault.missed.clear(); }));
  EXPECT_TRUE(refused(3, [](ContactFault& fault) { fault.missed[0].away = -fault.missed[0].away; }));
  EXPECT_TRUE(refused(3, [](ContactFault& fault) { fault.missed[0].away = {0, 0, 0}; }));
  EXPECT_TRUE(refused(3, [](ContactFault& fault) { fault.missed[0].away.x += 1; })) << "not across";
  EXPECT_TRUE(refused(3, [](ContactFault& fault) { fault.missed[0].direction = {0, 0, 1}; }));
  EXPECT_TRUE(refused(3, [](ContactFault& fault) { fault.missed[0].point.z += 1; })) << "not of the patch";
  EXPECT_TRUE(refused(3, [](ContactFault& fault) { fault.finding = tips; }));
}

}  // namespace
}  // namespace fathom::judging
