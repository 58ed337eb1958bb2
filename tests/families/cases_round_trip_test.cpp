// SPDX-License-Identifier: GPL-3.0-or-later
// What `fathom cases` prints, read back, is the generated case to the last digit: every family, and
// the catalogues.
#include <gtest/gtest.h>
#include <stdio.h>

#include <memory>
#include <string>

#include "fathom/files.hpp"
#include "verify/families/catalogue.hpp"
#include "verify/families/families.hpp"

namespace {

using namespace fathom;
using namespace fathom::families;

std::vector<Case> printed(const std::string& options) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(("'" FATHOM_EXECUTABLE "' cases " + options).c_str(), "r"),
                                                   pclose);
  std::vector<Case> result;
  std::string line;
  for (int c = fgetc(pipe.get()); c != EOF; c = fgetc(pipe.get())) {
    if (c != '\n') {
      line += static_cast<char>(c);
      continue;
    }
    const CaseItem item = parse_case(line, options);
    EXPECT_TRUE(item.ok()) << line;
    if (item.ok()) result.push_back(item.value());
    line.clear();
  }
  EXPECT_EQ(line, "");
  return result;
}

void expect_same(const Case& read, const Case& made) {
  EXPECT_EQ(read.id, made.id);
  EXPECT_TRUE(read.a.points == made.a.points && read.b.points == made.b.points) << made.id;
  EXPECT_TRUE(read.a.shape == made.a.shape && read.b.shape == made.b.shape) << made.id;
  for (const Body Case::*body : {&Case::a, &Case::b}) {
    ASSERT_EQ((read.*body).pieces != nullptr, (made.*body).pieces != nullptr) << made.id;
    EXPECT_TRUE(!(made.*body).pieces || *(read.*body).pieces == *(made.*body).pieces) << made.id;
  }
}

TEST(CasesRoundTrip, EveryFamily) {
  for (const Family& family : fathom::families::families()) {
    const std::vector<Case> read = printed("--family " + std::string(family.name) + " --count 3 --seed 11");
    ASSERT_EQ(read.size(), 3U) << family.name;
    for (std::uint64_t i = 0; i < 3; ++i) expect_same(read[i], family.make(11 + i, family.usual_size));
  }
}

TEST(CasesRoundTrip, EveryFamilyOfShapes) {
  for (const Family& family : fathom::families::families(Kind::shapes)) {
    const std::vector<Case> read = printed("--family " + std::string(family.name) + " --count 20 --seed 11");
    ASSERT_EQ(read.size(), 20U) << family.name;
    for (std::uint64_t i = 0; i < 20; ++i) expect_same(read[i], family.make(11 + i, family.usual_size));
  }
}

TEST(CasesRoundTrip, TheCatalogueOfShapes) {
  const std::vector<Case> read = printed("--catalogue --shapes");
  ASSERT_EQ(read.size(), shape_catalogue().size());
  for (std::size_t i = 0; i < read.size(); ++i) expect_same(read[i], shape_catalogue()[i].shapes.read());
}

TEST(CasesRoundTrip, EveryFamilyOfUnions) {
  for (const Family& family : fathom::families::families(Kind::unions)) {
    const std::vector<Case> read = printed("--family " + std::string(family.name) + " --count 5 --seed 11");
    ASSERT_EQ(read.size(), 5U) << family.name;
    for (std::uint64_t i = 0; i < 5; ++i) expect_same(read[i], family.make(11 + i, family.usual_size));
  }
}

TEST(CasesRoundTrip, TheCatalogueOfUnions) {
  const std::vector<Case> read = printed("--catalogue --unions");
  ASSERT_EQ(read.size(), union_catalogue().size());
  for (std::size_t i = 0; i < read.size(); ++i) expect_same(read[i], union_catalogue()[i].pair);
}

TEST(CasesRoundTrip, TheCatalogue) {
  const std::vector<Case> read = printed("--catalogue");
  ASSERT_EQ(read.size(), catalogue().size());
  for (std::size_t i = 0; i < read.size(); ++i) expect_same(read[i], catalogue()[i].pair);
}

}  // namespace
