// SPDX-License-Identifier: GPL-3.0-or-later
// When bodies meet first, against what is known: planes by their definition at many times, the
// exact depth at many times, motions whose time of contact is the root of a polynomial; and laws:
// bodies exchanged, motions reversed.

#include "fathom/impact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "fathom/approximate.hpp"
#include "kernels/vector.hpp"
#include "reference/motion/motion.hpp"
#include "tests/support/boxes.hpp"

namespace fathom {
namespace {

using PointList = std::vector<Point>;

const RigidMotion at_rest;

mpq_class cell(unsigned bits = 40) { return mpq_class(mpz_class(1), mpz_class(1) << bits); }

mpq_class height(const Vector& n, const Point& p) { return n.x * p.x + n.y * p.y + n.z * p.z; }

Status status_at(const PointList& a, const RigidMotion& of_a, const PointList& b, const RigidMotion& of_b,
                 const mpq_class& t) {
  return penetration_depth(placed_at(a, of_a, t), placed_at(b, of_b, t)).status();
}

/// The lowest of A above the highest of B, by the definition.
bool separates(const MovingPlane& plane, const PointList& a, const RigidMotion& of_a, const PointList& b,
               const RigidMotion& of_b, const mpq_class& t) {
  const Vector n = direction_at(plane, of_a, of_b, t);
  const PointList placed_a = placed_at(a, of_a, t), placed_b = placed_at(b, of_b, t);
  return std::ranges::all_of(placed_a, [&](const Point& p) {
    return std::ranges::all_of(placed_b, [&](const Point& q) { return height(n, p) > height(n, q); });
  });
}

Point combined(const PointList& points, const std::vector<Weight>& weights) {
  Point sum;
  mpq_class all;
  for (const Weight& w : weights) {
    EXPECT_GT(w.weight, 0);
    all += w.weight;
    const Point& p = points.at(w.index);
    sum = {sum.x + w.weight * p.x, sum.y + w.weight * p.y, sum.z + w.weight * p.z};
  }
  EXPECT_EQ(all, 1) << "convex weights";
  return sum;
}

/// Every law of an answer, by definitions and by the depth at single times.
void expect_laws(const PointList& a, const RigidMotion& of_a, const PointList& b, const RigidMotion& of_b,
                 const Impact& found, unsigned bits = 40) {
  if (found.status != ImpactStatus::at_beginning) {
    ASSERT_FALSE(found.pieces.empty());
    EXPECT_TRUE(found.pieces.front().plane && found.pieces.back().plane) << "planes stand at both ends";
  }
  const auto both_near = [](const ImpactPiece& p, const ImpactPiece& q) { return p.near && q.near; };
  EXPECT_EQ(std::ranges::adjacent_find(found.pieces, both_near), found.pieces.end()) << "and between near misses";
  mpq_class from = 0;
  for (const ImpactPiece& piece : found.pieces) {
    ASSERT_LE(from, piece.until) << "pieces follow one another";
    ASSERT_NE(piece.plane.has_value(), piece.near.has_value());
    for (int k = 0; piece.plane && k <= 6; ++k) {
      const mpq_class t = from + (piece.until - from) * k / 6;
      ASSERT_TRUE(separates(*piece.plane, a, of_a, b, of_b, t)) << "the plane separates the bodies at " << t;
    }
    if (piece.near) {
      const Point p = combined(placed_at(a, of_a, piece.until), piece.near->a),
                  q = combined(placed_at(b, of_b, piece.until), piece.near->b);
      const mpq_class x = p.x - q.x, y = p.y - q.y, z = p.z - q.z;
      EXPECT_LE(x * x + y * y + z * z, piece.near->gap * piece.near->gap) << "they are as near as that";
      EXPECT_EQ(piece.until - from, cell(bits)) << "a near miss takes one cell of the grid";
    }
    from = piece.until;
  }
  EXPECT_EQ(found.status == ImpactStatus::contact, found.contact.has_value());
  EXPECT_EQ(found.status == ImpactStatus::at_beginning, found.beginning.has_value());
  if (found.status == ImpactStatus::apart || found.status == ImpactStatus::grazing) {
    EXPECT_EQ(from, 1) << "to the end";
  }
  if (!found.contact) return;
  const FirstContact& contact = *found.contact;
  EXPECT_EQ(from, contact.t0) << "up to t0";
  EXPECT_EQ(contact.t1 - contact.t0, cell(bits)) << "t0 and t1 follow each other on the grid";
  const mpq_class steps = contact.t1 / cell(bits);
  EXPECT_EQ(steps.get_den(), 1) << "t1 is on the grid";
  EXPECT_EQ(status_at(a, of_a, b, of_b, contact.t0), Status::disjoint);
  EXPECT_NE(status_at(a, of_a, b, of_b, contact.t1), Status::disjoint) << "they meet at t1, says the depth";
  EXPECT_EQ(combined(placed_at(a, of_a, contact.t1), contact.a), contact.point);
  EXPECT_EQ(combined(placed_at(b, of_b, contact.t1), contact.b), contact.point) << "one point of both";
  EXPECT_EQ(placed_at(std::vector{contact.in_a}, of_a, contact.t1).front(), contact.point);
  EXPECT_EQ(placed_at(std::vector{contact.in_b}, of_b, contact.t1).front(), contact.point);
}

Impact contact_of_all(const PointList& a, const RigidMotion& of_a, const PointList& b, const RigidMotion& of_b) {
  Impact found = first_contact(a, of_a, b, of_b);
  expect_laws(a, of_a, b, of_b, found);
  return found;
}

/// The time of contact is a root of `value`, which is positive before it.
template <class Value>
void expect_root(const Impact& found, Value value) {
  ASSERT_TRUE(found.contact) << name(found.status);
  EXPECT_GT(value(found.contact->t0), 0) << "before the contact";
  EXPECT_LE(value(found.contact->t1), 0) << "after it";
}

struct RandomMotions {
  std::mt19937_64 random{2026};

  mpq_class number(int low, int high, int denominator) {
    mpq_class q(static_cast<int>(random() % static_cast<unsigned>((high - low) * denominator + 1)) + low * denominator,
                denominator);
    q.canonicalize();
    return q;
  }
  Point point(int size) { return {number(-size, size, 8), number(-size, size, 8), number(-size, size, 8)}; }
  PointList body(std::size_t points) {
    PointList result;
    while (result.size() < points) result.push_back(point(1));
    return result;
  }
  Quaternion quaternion() {
    Quaternion q;
    do q = {number(-4, 4, 1), number(-4, 4, 1), number(-4, 4, 1), number(-4, 4, 1)};
    while (q == Quaternion{0, 0, 0, 0});
    return q;
  }
  RigidMotion motion() {
    RigidMotion result{quaternion(), quaternion(), point(4), {}};
    result.p1 = {-result.p0.x / 2, -result.p0.y / 2, number(-1, 1, 8) - result.p0.z / 2};
    return shorter_way(result);
  }
};

bool turns_through_nothing(const RigidMotion& motion) {
  try {
    (void)first_contact(PointList{{0, 0, 0}}, motion, PointList{{100, 0, 0}}, at_rest);
    return false;
  } catch (const std::invalid_argument&) {
    return true;
  }
}

TEST(Impact, RandomMotionsOfBodiesOfAnyRank) {
  RandomMotions make;
  int contacts = 0, apart = 0;
  for (int i = 0; i < 120; ++i) {
    const PointList a = make.body(1 + i % 7), b = make.body(1 + i / 7 % 8);
    const RigidMotion of_a = make.motion(), of_b = i % 3 == 0 ? make.motion() : at_rest;
    SCOPED_TRACE("motion " + std::to_string(i));
    const Impact found = first_contact(a, of_a, b, of_b);
    expect_laws(a, of_a, b, of_b, found);
    contacts += found.contact.has_value();
    apart += found.status == ImpactStatus::apart;
    const mpq_class until = found.contact ? found.contact->t0 : mpq_class(1);
    for (int k = 0; found.status != ImpactStatus::at_beginning && k <= 16; ++k)
      EXPECT_EQ(status_at(a, of_a, b, of_b, until * k / 16), Status::disjoint) << "by the depth, at part " << k;

    const Impact exchanged = first_contact(b, of_b, a, of_a);
    EXPECT_EQ(exchanged.status, found.status) << "law: the bodies exchanged";
    if (found.contact) {
      ASSERT_TRUE(exchanged.contact);
      EXPECT_EQ(exchanged.contact->t1, found.contact->t1);
    }
    if (found.status == ImpactStatus::apart) {
      const Impact coarse = first_contact(a, of_a, b, of_b, {.bits = 1, .delta = mpq_class(1, 1'000'000'000)});
      EXPECT_EQ(coarse.status, ImpactStatus::apart) << "cells of the grid are crossed in short steps";
      expect_laws(a, of_a, b, of_b, coarse, 1);
      const auto reversed = [](const RigidMotion& m) { return RigidMotion{m.q1, m.q0, m.p1, m.p0}; };
      EXPECT_EQ(first_contact(a, reversed(of_a), b, reversed(of_b)).status, ImpactStatus::apart)
          << "law: motions reversed";
    }
  }
  EXPECT_GT(contacts, 30);
  EXPECT_GT(apart, 15);
}

TEST(Impact, OnCoarseGridsPlanesStandAtBothEnds) {
  // The cubes meet in the first cell, at 3/8.
  const PointList cube = testing::box({0, 0, 0}, {1, 1, 1});
  const RigidMotion along{{1, 0, 0, 0}, {1, 0, 0, 0}, {4, 0, 0}, {-4, 0, 0}};
  const Impact early = first_contact(cube, along, cube, at_rest, {.bits = 1});
  expect_laws(cube, along, cube, at_rest, early, 1);
  ASSERT_TRUE(early.contact);
  EXPECT_EQ(early.contact->t0, 0);
  EXPECT_EQ(early.pieces.size(), 1U);

  // A point turns about a cube by half a turn, and is never nearer to it than 2 - sqrt(2): it is
  // apart, and not near, though no plane holds for half of the time.
  const PointList point{{2, 0, 0}}, around = testing::box({-1, -1, -1}, {1, 1, 1});
  const RigidMotion turn{{1, 0, 0, 0}, {0, 0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
  const Impact past = first_contact(point, turn, around, at_rest, {.bits = 1});
  expect_laws(point, turn, around, at_rest, past, 1);
  EXPECT_EQ(past.status, ImpactStatus::apart);
}

TEST(Impact, AMotionOfBothIsThatOfOneSeenFromTheOther) {
  // B moves as A does: seen from B, A is at rest.
  RandomMotions make;
  const PointList a = testing::box({2, 0, 0}, {3, 1, 1}), b = testing::box({0, 0, 0}, {1, 1, 1});
  for (int i = 0; i < 10; ++i) {
    const RigidMotion motion = make.motion();
    const Impact found = contact_of_all(a, motion, b, motion);
    EXPECT_EQ(found.status, ImpactStatus::apart);
    EXPECT_EQ(found.pieces.size(), 1U) << "one plane turns with both";
  }
}

TEST(Impact, AnEdgeFallsOnAFace) {
  // A cube turns about x by twice the angle whose tangent is t/2, and falls from 4 to 0.
  const PointList cube = testing::box({-1, -1, -1}, {1, 1, 1});
  const RigidMotion fall{{1, 0, 0, 0}, {1, mpq_class(1, 2), 0, 0}, {0, 0, 4}, {0, 0, 0}};
  const Impact found = contact_of_all(cube, fall, cube, at_rest);
  // Lowest: 4 - 4t - (cos + sin), with cos = (4 - t^2)/(4 + t^2), sin = 4t/(4 + t^2); it meets 1.
  expect_root(found, [](const mpq_class& t) { return mpq_class((3 - 4 * t) * (4 + t * t) - (4 - t * t) - 4 * t); });
  EXPECT_EQ(found.contact->normal, (Vector{0, 0, 1}));
  EXPECT_EQ(found.contact->contact.a.size(), 2U) << "an edge of A";
  EXPECT_EQ(found.contact->contact.b.size(), 4U) << "a face of B";
}

TEST(Impact, ASpinningRodMeetsAPost) {
  // Its upper side turns about z by an angle of tangent 2t / (1 - t^2), and meets the diagonal at
  // t = sqrt(2) - 1.
  const PointList rod = testing::box({0, -1, -1}, {3, 0, 1}), post{{1, 1, -2}, {1, 1, 2}, {0, 3, 0}};
  const RigidMotion spin{{1, 0, 0, 0}, {1, 0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
  const auto before = [](const mpq_class& t) { return mpq_class(2 - (t + 1) * (t + 1)); };
  expect_root(contact_of_all(rod, spin, post, at_rest), before);
  expect_root(contact_of_all(post, at_rest, rod, spin), before);
}

TEST(Impact, BodiesWithoutInteriorsPassThroughEachOther) {
  // They meet at sqrt(2) - 1 alone, which is no time of the grid.
  const PointList rod{{0, 0, 0}, {2, 0, 0}}, post{{1, 1, -1}, {1, 1, 1}};
  const RigidMotion spin{{1, 0, 0, 0}, {1, 0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
  EXPECT_EQ(contact_of_all(rod, spin, post, at_rest).status, ImpactStatus::grazing);
  EXPECT_EQ(contact_of_all(post, at_rest, rod, spin).status, ImpactStatus::grazing);
}

TEST(Impact, ACubeTurnsAboutItsCorner) {
  const PointList cube = testing::box({0, 0, 0}, {1, 1, 1});
  const PointList needle{{mpq_class(-1, 2), mpq_class(1, 2), mpq_class(1, 2)}};
  const RigidMotion turn{{1, 0, 0, 0}, {1, 0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
  const Impact found = contact_of_all(cube, turn, needle, at_rest);
  expect_root(found, [](const mpq_class& t) { return mpq_class(2 - (t + 1) * (t + 1)); });
  EXPECT_EQ(found.contact->contact.a.size(), 4U) << "the face that turns towards the point";
}

TEST(Impact, StraightPathsHaveRationalTimes) {
  const PointList cube = testing::box({0, 0, 0}, {1, 1, 1});
  const RigidMotion straight{{1, 0, 0, 0}, {3, 0, 0, 0}, {4, 0, mpq_class(1, 3)}, {-2, 0, mpq_class(1, 3)}};
  const Impact found = contact_of_all(cube, straight, cube, at_rest);
  expect_root(found, [](const mpq_class& t) { return mpq_class(1 - 2 * t); });
  EXPECT_EQ(found.contact->t1, mpq_class(1, 2)) << "a contact on the grid is at t1";
  EXPECT_EQ(found.contact->normal, (Vector{1, 0, 0}));
  const RigidMotion past{{1, 0, 0, 0}, {1, 0, 0, 0}, {4, 2, 0}, {-2, 2, 0}};
  EXPECT_EQ(contact_of_all(cube, past, cube, at_rest).status, ImpactStatus::apart);
  const RigidMotion sliding{{1, 0, 0, 0}, {1, 0, 0, 0}, {4, 1, 0}, {-4, 1, 0}};
  expect_root(contact_of_all(cube, sliding, cube, at_rest), [](const mpq_class& t) { return mpq_class(3 - 8 * t); });
}

TEST(Impact, AStraightPathIsARayBackwards) {
  // A stands in B, and would leave it after factor (1, 2, 3): it comes from there.
  RandomMotions make;
  int compared = 0;
  for (int i = 0; i < 40; ++i) {
    const PointList a = make.body(7), b = make.body(7);
    const DirectionalDepth ray = directional_depth(a, b, {1, 2, 3});
    if (ray.status() != Status::penetrating) continue;
    const mpq_class out = ray.factor(), start = out + 1;
    const RigidMotion in{{1, 0, 0, 0}, {1, 0, 0, 0}, {start, 2 * start, 3 * start}, {0, 0, 0}};
    const Impact found = contact_of_all(a, in, b, at_rest);
    expect_root(found, [&](const mpq_class& t) { return mpq_class((1 - t) * start - out); });
    ++compared;
  }
  EXPECT_GT(compared, 10);
}

TEST(Impact, TheEndOfARodGrazesAWall) {
  // It is highest at t = 1/3, where tan of half the angle is 1, and touches the wall there alone.
  const PointList rod{{0, 0, 0}, {1, 0, 0}}, wall = testing::box({-3, 1, -1}, {3, 2, 1});
  const RigidMotion spin{{1, 0, 0, 0}, {0, 0, 0, 2}, {0, 0, 0}, {0, 0, 0}};
  const Impact found = contact_of_all(rod, spin, wall, at_rest);
  EXPECT_EQ(found.status, ImpactStatus::grazing);
  std::size_t misses = 0;
  for (std::size_t i = 0; i < found.pieces.size(); ++i) {
    if (!found.pieces[i].near) continue;
    ++misses;
    EXPECT_LT(found.pieces[i - 1].until, mpq_class(1, 3));
    EXPECT_GT(found.pieces[i].until, mpq_class(1, 3));
  }
  EXPECT_EQ(misses, 1U);
  // On the grid the same touch is a contact.
  const RigidMotion even{{1, 0, 0, 0}, {0, 0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
  const Impact touch = contact_of_all(rod, even, wall, at_rest);
  ASSERT_TRUE(touch.contact);
  EXPECT_EQ(touch.contact->t1, mpq_class(1, 2));
  // A hair further away it is none.
  const PointList behind = testing::box({-3, mpq_class(1000001, 1000000), -1}, {3, 2, 1});
  EXPECT_EQ(contact_of_all(rod, spin, behind, at_rest).status, ImpactStatus::apart);
}

TEST(Impact, BodiesThatMeetAtTheBeginning) {
  const PointList cube = testing::box({0, 0, 0}, {1, 1, 1});
  const RigidMotion away{{1, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0}, {3, 0, 0}};
  const Impact touching = contact_of_all(cube, away, cube, at_rest);
  ASSERT_TRUE(touching.beginning);
  EXPECT_EQ(touching.beginning->status(), Status::touching);
  const RigidMotion out{{1, 0, 0, 0}, {1, 0, 0, 0}, {mpq_class(1, 2), 0, 0}, {3, 0, 0}};
  const Impact deep = contact_of_all(cube, out, cube, at_rest);
  ASSERT_TRUE(deep.beginning);
  EXPECT_EQ(deep.beginning->squared(), mpq_class(1, 4));
}

TEST(Impact, BitsTellHowNear) {
  const PointList cube = testing::box({-1, -1, -1}, {1, 1, 1});
  const RigidMotion fall{{1, 0, 0, 0}, {1, mpq_class(1, 2), 0, 0}, {0, 0, 4}, {0, 0, 0}};
  mpq_class before;
  for (const unsigned bits : {1U, 5U, 40U, 200U, 1000U}) {
    ImpactOptions options;
    options.bits = bits;
    const Impact found = first_contact(cube, fall, cube, at_rest, options);
    expect_laws(cube, fall, cube, at_rest, found, bits);
    ASSERT_TRUE(found.contact);
    EXPECT_GE(found.contact->t0, before) << "intervals lie in one another";
    before = found.contact->t0;
  }
}

TEST(Impact, RefusesWhatIsNoMotion) {
  const Quaternion one{1, 0, 0, 0}, none{0, 0, 0, 0};
  EXPECT_TRUE(turns_through_nothing({one, none, {}, {}}));
  EXPECT_TRUE(turns_through_nothing({none, one, {}, {}}));
  EXPECT_TRUE(turns_through_nothing({one, {-2, 0, 0, 0}, {}, {}})) << "opposite quaternions: 0 at t = 1/3";
  EXPECT_FALSE(turns_through_nothing({one, {0, 0, 0, 1}, {}, {}})) << "half a turn";
  EXPECT_FALSE(turns_through_nothing(shorter_way({one, {-2, 0, 0, 0}, {}, {}}))) << "one rotation";
  EXPECT_THROW((void)first_contact({}, at_rest, PointList{{0, 0, 0}}, at_rest), std::invalid_argument);
  ImpactOptions options;
  options.bits = 0;
  EXPECT_THROW((void)first_contact(PointList{{1, 0, 0}}, at_rest, PointList{{0, 0, 0}}, at_rest, options),
               std::invalid_argument);
  options.bits = 8;
  options.delta = 0;
  EXPECT_THROW((void)first_contact(PointList{{1, 0, 0}}, at_rest, PointList{{0, 0, 0}}, at_rest, options),
               std::invalid_argument);
  EXPECT_THROW((void)first_contact(PointList{{mpq_class(2, 4), 0, 0}}, at_rest, PointList{{0, 0, 0}}, at_rest),
               std::invalid_argument);
}

TEST(MovingPair, EdgesThatBecomeParallelSeparateNothing) {
  // Two rods, one above the other: at t = 1/2 they are parallel, and their cross product is 0.
  const PointList a{{-1, 0, 1}, {1, 0, 1}}, b{{0, -1, 0}, {0, 1, 0}};
  const RigidMotion turn{{1, 0, 0, 0}, {0, 0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
  const motion::MovingPair pair(a, turn, b, at_rest);
  const MovingPlane edges{MovingPlane::Kind::of_edges, {1, 0, 0}, {0, 1, 0}};
  EXPECT_TRUE(pair.holding(edges, 0, mpq_class(1, 4)).holds);
  EXPECT_FALSE(pair.holding(edges, mpq_class(1, 2), mpq_class(1, 2)).holds) << "the direction is 0 there";
  EXPECT_FALSE(pair.holding(edges, 0, 1).holds);
  EXPECT_TRUE(pair.holding({MovingPlane::Kind::of_b, {0, 0, 1}, {}}, mpq_class(1, 4), mpq_class(3, 4)).holds);
}

TEST(MovingPair, APartOfAnIntervalHoldsIfTheWholeDoes) {
  RandomMotions make;
  int held = 0;
  for (int i = 0; i < 40; ++i) {
    const PointList a = make.body(5), b = make.body(5);
    const RigidMotion of_a = make.motion(), of_b = make.motion();
    const Impact found = first_contact(a, of_a, b, of_b);
    const motion::MovingPair pair(a, of_a, b, of_b);
    mpq_class from = 0;
    for (const ImpactPiece& piece : found.pieces) {
      if (!piece.plane) continue;
      const mpq_class third = (piece.until - from) / 3;
      EXPECT_TRUE(pair.holding(*piece.plane, from + third, from + 2 * third).holds);
      MovingPlane turned = *piece.plane;
      turned.first = -turned.first;
      EXPECT_FALSE(pair.holding(turned, from, from).holds) << "not with the bodies on the other sides";
      from = piece.until;
      ++held;
    }
  }
  EXPECT_GT(held, 40);
}

}  // namespace
}  // namespace fathom
