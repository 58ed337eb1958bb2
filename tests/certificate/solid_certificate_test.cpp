// SPDX-License-Identifier: GPL-3.0-or-later
// The text of a solid's certificate.
#include <gtest/gtest.h>

#include <stdexcept>

#include "fathom/solid.hpp"
#include "verify/check/check.hpp"

namespace fathom {
namespace {

/// A tetrahedron of which a plane makes two; no one uses the first point.
Solid two_tetrahedra() {
  Solid solid;
  solid.points = {{7, 7, 7}, {0, 0, 0}, {0, 0, 2}, {0, 2, 0}, {2, 0, 0}, {mpq_class(1, 2), mpq_class(3, 2), 0}};
  solid.triangles = {{1, 3, 4}, {1, 4, 2}, {1, 2, 3}, {2, 4, 3}};
  solid.pieces = {{{{1, 2, 3}, {1, 5, 2}, {1, 3, 5}, {2, 5, 3}}}, {{{1, 2, 5}, {1, 4, 2}, {1, 5, 4}, {2, 4, 5}}}};
  return solid;
}

TEST(SolidCertificate, SaysWhatTheSolidIs) {
  EXPECT_EQ(certificate_text(two_tetrahedra(), "two tetrahedra"),
            "fathom-certificate 5\nid two%20tetrahedra\nsolid_a 5\n0 0 0\n0 0 2\n0 2 0\n2 0 0\n1/2 3/2 0\n"
            "mesh 4\n0 2 3\n0 3 1\n0 1 2\n1 3 2\npieces 2\n"
            "piece 4\n3 0 1 2\n3 0 4 1\n3 0 2 4\n3 1 4 2\npiece 4\n3 0 1 4\n3 0 3 1\n3 0 4 3\n3 1 3 4\n"
            "claim solid\nend 5 4 2 4 4\n");
}

TEST(SolidCertificate, IsAcceptedIfItIsTrue) {
  Solid solid = two_tetrahedra();
  const auto line = [&solid] {
    return fathom_check::verdict_line(fathom_check::verify(certificate_text(solid)), "name");
  };
  EXPECT_EQ(line(), "s VERIFIED solid triangles=4 pieces=2 name");
  solid.pieces.pop_back();
  EXPECT_TRUE(line().starts_with("s REFUSED name:")) << line();
  solid.pieces.front().facets.front().front() = 6;
  EXPECT_THROW((void)certificate_text(solid), std::out_of_range);
}

}  // namespace
}  // namespace fathom
