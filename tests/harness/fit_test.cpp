// SPDX-License-Identifier: GPL-3.0-or-later
// The size that cases are brought to.                                          [verify/PROTOCOL.md]
#include <gtest/gtest.h>

#include "tests/harness/fake_subject.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/seen_case.hpp"

namespace fathom::harness {
namespace {

Case segments(const mpq_class& length) { return {"s", Body{{{0, 0, 0}, {length, 0, 0}}}, Body{{{5, 0, 0}}}}; }

TEST(ExponentToFit, TheExtentIsLessThanTheSizeAndAtLeastHalfOfIt) {
  EXPECT_EQ(exponent_to_fit(segments(32), mpq_class(64)), 0);
  EXPECT_EQ(exponent_to_fit(segments(64), mpq_class(64)), -1) << "less than";
  const mpq_class below = 64 - mpq_class(1, 1'000'000'007);
  EXPECT_EQ(exponent_to_fit(segments(below), mpq_class(64)), 0);
  EXPECT_EQ(exponent_to_fit(segments(32 - mpq_class(1, 1'000'000'007)), mpq_class(64)), 1);
  for (const mpq_class& size : {mpq_class(64), mpq_class(1, 3), mpq_class(100'003, 7)})
    for (const mpq_class& length : {mpq_class(1), mpq_class(1, 3), scaled(mpq_class(5, 7), -1074), scaled(3, 1023)}) {
      const mpq_class there = scaled(length, exponent_to_fit(segments(length), size));
      EXPECT_TRUE(there < size && 2 * there >= size) << there << ' ' << size;
    }
  EXPECT_EQ(exponent_to_fit(segments(3), std::nullopt), 0);
  EXPECT_EQ(exponent_to_fit(segments(0), mpq_class(64)), 0) << "a point on a point";
}

TEST(InUnit, LengthsOfAnswersAreScaledAndDirectionsAreNot) {
  Reply reply;
  reply.depth = 3;
  reply.direction = Triple{0, 2, 0};
  reply.witness_b = Triple{1, -5, 0x1p-1074};
  reply.distance = 7;
  reply.contacts = {{{2, 4, 6}, 5.0}, {{1, 1, 1}, {}}};
  const Reply there = in_unit(reply, -1);
  EXPECT_EQ(there.depth, 1.5);
  EXPECT_EQ(there.direction, reply.direction);
  EXPECT_EQ(there.distance, 3.5);
  EXPECT_EQ(there.contacts, (std::vector<ContactPoint>{{{1, 2, 3}, 2.5}, {{0.5, 0.5, 0.5}, {}}}));
  EXPECT_EQ(*there.witness_b, (Triple{0.5, -2.5, 0})) << "rounded once, ties to even";
}

TEST(JudgedBodies, AreGrownByTheRadiusOfTheirWord) {
  const Case seen{"c", Body{{{0, 0, 0}, {1, 0, 0}}}, files::body_of(files::named("sphere", {{"radius", {2}}}))};
  SubjectInfo info;
  EXPECT_FALSE(judged_bodies(seen, info, 0).a.shape);
  info.rounding = {{"vertices", mpq_class(1, 2)}};
  EXPECT_EQ(judged_bodies(seen, info, 3).a.shape->radius, mpq_class(1, 16)) << "a length of the subject's unit";
  EXPECT_EQ(judged_bodies(seen, info, 3).b.shape->radius, 2);
  info.rounding = {{"", mpq_class(1, 2)}};
  EXPECT_EQ(judged_bodies(seen, info, 0).b.shape->radius, mpq_class(5, 2));
}

}  // namespace
}  // namespace fathom::harness
