// SPDX-License-Identifier: GPL-3.0-or-later
// Input that wants the checker's memory, its time or its life. Nothing is accepted, and the test
// ends.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "tests/check/edits.hpp"
#include "tests/check/union_texts.hpp"
#include "verify/check/certificate.hpp"
#include "verify/check/check.hpp"
#include "verify/check/json.hpp"
#include "verify/check/limits.hpp"
#include "verify/check/parser.hpp"
#include "verify/check/text.hpp"

namespace fathom_check {
namespace {

const std::string start = "fathom-certificate 1\n";

TEST(CheckHostile, AnnouncedCountsReserveNothing) {
  for (const char* count :
       {"1000000000000", "18446744073709551615", "18446744073709551616", "99999999999999999999999999999999"}) {
    const Verdict verdict = verify(start + "a " + count + "\n0 0 0\n");
    EXPECT_EQ(verdict.outcome, Outcome::malformed);
    EXPECT_EQ(verdict.line, 4U);
    const std::string body = start + "a 1\n0 0 0\nb 1\n0 0 1\nclaim depth 1\ndirections 1 some\n0 0 -1\n";
    EXPECT_EQ(verify(body + "vertices " + count + "\n0 0\n").outcome, Outcome::malformed);
    EXPECT_EQ(verify(body + "vertices 1\n0 0\nfacets " + count + "\n").outcome, Outcome::malformed);
    EXPECT_EQ(verify(body + "vertices 1\n0 0\nfacets 1\n" + count + " 0 0 0\n").outcome, Outcome::malformed);
    EXPECT_EQ(verify(body + "vertices 1\n0 " + count + "\nfacets 1\n3 0 0 0\nend 1 1 1 1 1\n").outcome,
              Outcome::refused);
  }
}

TEST(CheckHostile, AnnouncedCountsOfUnionsReserveNothing) {
  const std::string pieces = "fathom-certificate 3\npieces_a 1\na 1\n0 0 0\npieces_b 1\nb 1\n0 0 0\n",
                    depth = pieces + "claim depth 1\n";
  const std::string optima = depth + "optima 1\noptimum 0 0 0\nseparations 1\n1 0 0\n",
                    polytopes = optima + "polytopes 1\npolytope 0 0\n";
  for (const std::string count :
       {"1000000000000", "18446744073709551615", "18446744073709551616", "99999999999999999999999999999999"}) {
    for (const std::string& text :
         {"fathom-certificate 3\npieces_a " + count + "\na 1\n0 0 0\n",
          "fathom-certificate 3\npieces_a 1\na " + count + "\n0 0 0\n",
          depth + "optima " + count + "\noptimum 0 0 0\nseparations 0\n",
          depth + "optima 1\noptimum 0 0 0\nseparations " + count + "\n1 0 0\n",
          optima + "polytopes " + count + "\npolytope 0 0\nvertices 0\nfacets 0\n",
          polytopes + "vertices " + count + "\n0 0\n", polytopes + "vertices 0\nfacets " + count + "\n",
          polytopes + "vertices 0\nfacets 0\ntree " + count + "\nleaf\n",
          pieces + "claim touching\nseparations " + count + "\n1 0 0\n"}) {
      const Verdict verdict = verify(text);
      EXPECT_EQ(verdict.outcome, Outcome::malformed) << text;
      EXPECT_EQ(verdict.line, static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1) << text;
    }
  }
}

// Each level is a split whose only child is the next one.
TEST(CheckHostile, AnnouncedCountsOfPatchesReserveNothing) {
  const std::string point =
                        "fathom-certificate 4\na 1\n0 0 0\nb 1\n0 0 1\nclaim touching\ndirections 1 some\n0 0 0\n"
                        "weights_a 1\n0 1\nweights_b 1\n0 1\n",
                    patch = point + "patches 1\n", corner = patch + "patch 1 0\n";
  for (const std::string count :
       {"1000000000000", "18446744073709551615", "18446744073709551616", "99999999999999999999999999999999"}) {
    for (const std::string& text :
         {point + "patches " + count + "\npatch 0 0\n", patch + "patch " + count + " 0\n0 0\n",
          patch + "patch 0 " + count + "\na 0 0 0 0\n", corner + count + " 0 1 0\n", corner + "0 " + count + " 0 1\n",
          corner + "0 0\nrates " + count + "\n0 0 0 0 0 0 0 0\n"})
      EXPECT_EQ(verify(text).outcome, Outcome::malformed) << text;
    EXPECT_EQ(verify(corner + "1 " + count + " 1 0\nend 1 1 1 1 1 1 1 0\n").outcome, Outcome::refused);
    EXPECT_EQ(verify(patch + "patch 0 1\na 0 0 0 " + count + "\nend 1 1 1 1 1 1 0 1\n").outcome, Outcome::refused);
  }
}

TEST(CheckHostile, ATreeMayBeAsDeepAsItIsLong) {
  constexpr std::size_t levels = 1'000'000;
  std::vector<std::string> tree(levels, "split 0 0");
  tree.emplace_back("leaf " + std::to_string(levels - 1));
  const std::string text = boxes("1", {cube}, six, tree).text();
  EXPECT_TRUE(verify(text).accepted()) << verify(text).reason;
  const std::string without = boxes("1", {cube}, six, std::vector<std::string>(levels, "split 0 0")).text();
  EXPECT_EQ(verify(without).reason, "behind this node the tree goes on: a child is missing");
}

// A split with very many children, each of them beyond the same facet: the path grows, and shrinks
// again.
TEST(CheckHostile, ASplitMayHaveManyChildren) {
  constexpr std::size_t children = 200'000;
  std::string root = "split 0";
  std::vector<std::string> tree;
  for (std::size_t child = 0; child < children; ++child) {
    root += child % 2 == 0 ? " 0" : " 3";
    tree.push_back(child % 3 == 0 ? "split 0" : "leaf " + std::to_string(child));
  }
  tree.insert(tree.begin(), root);
  EXPECT_TRUE(verify(boxes("1", {cube}, six, tree).text()).accepted());
  tree.back() = "leaf " + std::to_string(children);
  EXPECT_EQ(verify(boxes("1", {cube}, six, tree).text()).reason, "the path has no constraint of this number");
}

// A polytope of very many facets, and as many splits by it that list none of them.
TEST(CheckHostile, ManyFacetsCostASplitNothing) {
  UnionText text = boxes("1", {cube}, six, std::vector<std::string>(100'000, "split 0 0"));
  text.tree.emplace_back("split 0\n");
  constexpr std::size_t facets = 100'000;
  std::string& polytope = text.polytopes.front();
  polytope = edited(polytope, "facets 6\n", "facets " + std::to_string(6 + facets) + "\n");
  for (std::size_t k = 0; k < facets; ++k) polytope += "4 0 4 6 2\n";
  EXPECT_TRUE(verify(text.text()).accepted()) << verify(text.text()).reason;
}

TEST(CheckHostile, NumbersAreLimited) {
  const auto text = [](const std::string& x) {
    return start + "a 1\n" + x + " 0 0\nb 1\n0 0 1\nclaim disjoint\ndirections 1 some\n0 0 -1\nend 1 1 1 0 0\n";
  };
  EXPECT_EQ(verify(text(std::string(longest_number, '7'))).outcome, Outcome::verified) << "long, but within the limit";
  EXPECT_EQ(verify(text(std::string(longest_number + 1, '7'))).outcome, Outcome::malformed);
  EXPECT_EQ(verify(text("1/" + std::string(longest_number + 1, '7'))).outcome, Outcome::malformed);
}

TEST(CheckHostile, LinesAreLimited) {
  EXPECT_EQ(verify(std::string(longest_line + 1, 'x') + "\n").outcome, Outcome::malformed);
  EXPECT_EQ(verify(start + "#" + std::string(longest_line, ' ') + "\n").outcome, Outcome::malformed);
  Lines lines(std::string_view("abc\nabcd\nab\nabc"), 3);
  EXPECT_EQ(lines.advance(), Lines::Kind::whole);
  EXPECT_EQ(lines.text(), "abc");
  EXPECT_EQ(lines.advance(), Lines::Kind::too_long);
  EXPECT_EQ(lines.advance(), Lines::Kind::whole);
  EXPECT_EQ(lines.text(), "ab");
  EXPECT_EQ(lines.advance(), Lines::Kind::cut_off);
  EXPECT_EQ(lines.number(), 4U);
  EXPECT_EQ(lines.advance(), Lines::Kind::none);
}

// A stream is read in blocks; that must not show.
TEST(CheckHostile, BlocksDoNotShow) {
  constexpr std::size_t longest = 70'000;
  std::string text;
  for (std::size_t length :
       {0, 1, 65'535, 65'536, 65'537, 69'999, 70'000, 70'001, 200'000, 3, 0, 131'071, 50'000, 20'000, 7})
    text += std::string(length, static_cast<char>('a' + length % 26)) + "\n";
  for (const std::size_t cut : {std::size_t{0}, std::size_t{1}, std::size_t{3}}) {
    const std::string_view whole = std::string_view(text).substr(0, text.size() - cut);
    std::istringstream stream{std::string(whole)};
    Lines from_stream(stream, longest), from_text(whole, longest);
    do {
      EXPECT_EQ(from_stream.advance(), from_text.advance()) << "line " << from_text.number();
      EXPECT_EQ(from_stream.text(), from_text.text()) << "line " << from_text.number();
      EXPECT_EQ(from_stream.number(), from_text.number());
    } while (from_text.kind() != Lines::Kind::none);
    EXPECT_FALSE(from_stream.broken());
  }
}

// Long denominators without common factors, and many points: over the common denominator they would
// take gigabytes.
TEST(CheckHostile, CommonDenominatorsArePaidFor) {
  constexpr int awkward = 100, points = 200'000;
  std::string text = start + "a " + std::to_string(points) + "\n";
  for (int k = 0; k < awkward; ++k)
    text += "1/" + std::to_string(2 * k + 1) + std::string(400, static_cast<char>('1' + k % 9)) + "1 0 0\n";
  for (int k = awkward; k < points; ++k) text += "0 0 0\n";
  text += "b 1\n0 0 1\nclaim disjoint\ndirections 1 some\n0 0 -1\nend " + std::to_string(points) + " 1 1 0 0\n";
  const Verdict verdict = verify(text);
  EXPECT_EQ(verdict.outcome, Outcome::malformed);
  EXPECT_NE(verdict.reason.find("limit"), std::string::npos) << verdict.reason;
}

TEST(CheckHostile, BudgetsEnd) {
  Budget budget;
  budget.store(most_memory, 1);
  EXPECT_THROW(budget.store(1, 7), Fault);
}

// As many digits as every Int of so many holds, and no more: 2^32 + 1 is not 1 where a long has 32
// bits.
template <class Int>
void expect_digits_fit() {
  const std::string largest = std::to_string(std::numeric_limits<Int>::max());
  const std::string nines(largest.size() - 1, '9');
  EXPECT_EQ(short_integer<Int>("-0"), Int{0});
  EXPECT_EQ(short_integer<Int>(nines), static_cast<Int>(std::stoll(nines)));
  EXPECT_EQ(short_integer<Int>("-" + nines), static_cast<Int>(-std::stoll(nines)));
  for (const std::string& text : {largest, "1" + nines, "4294967297" + nines, "0" + nines}) {
    EXPECT_EQ(short_integer<Int>(text), std::nullopt) << text;
    EXPECT_EQ(short_integer<Int>("-" + text), std::nullopt) << text;
    EXPECT_EQ(to_integer("-" + text), -mpz_class(text, 10)) << text;
  }
}

TEST(CheckHostile, IntegersOfAnyLengthAreThoseOfGmp) {
  std::string digits;
  for (int k = 0; k < 700; ++k) {
    digits += static_cast<char>('0' + (k < 5 || k % 7 == 0 ? 0 : k * k % 10));
    EXPECT_EQ(to_integer(digits), mpz_class(digits, 10)) << digits;
    EXPECT_EQ(to_integer("-" + digits), -mpz_class(digits, 10)) << digits;
    const std::string nines(digits.size(), '9');
    EXPECT_EQ(to_integer(nines), mpz_class(nines, 10)) << nines;
  }
}

TEST(CheckHostile, DigitsAreTheseTen) {
  for (std::size_t length = 1; length < 30; ++length)
    for (std::size_t at = 0; at < length; ++at)
      for (int c = 0; c < 256; ++c) {
        std::string text(length, '9');
        text[at] = static_cast<char>(c);
        EXPECT_EQ(is_natural(text), c >= '0' && c <= '9') << length << " " << at << " " << c;
      }
}

TEST(CheckHostile, ShortIntegersFitTheirType) {
  expect_digits_fit<std::int16_t>();
  expect_digits_fit<std::int32_t>();
  expect_digits_fit<std::int64_t>();
  expect_digits_fit<long>();
}

TEST(CheckHostile, Utf8) {
  for (const char* text : {"", "a", "\xc2\x80", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf", "\xee\x80\x80",
                           "\xf0\x90\x80\x80x", "\xf4\x8f\xbf\xbf"})
    EXPECT_TRUE(is_utf8(text)) << escaped(text);
  for (const char* text : {"\x80", "\xc1\xbf", "\xc2", "\xc2x", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xef\xbf",
                           "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff", "a\xc3"})
    EXPECT_FALSE(is_utf8(text)) << escaped(text);
}

TEST(CheckHostile, JsonNestingIsLimited) {
  const auto nested = [](int depth) {
    return std::string(static_cast<std::size_t>(depth), '[') + std::string(static_cast<std::size_t>(depth), ']');
  };
  const auto parses = [](const std::string& text) {
    Budget budget;
    JsonReader reader(text, 1);
    try {
      reader.next(budget);
      return !reader.more();
    } catch (const Fault&) {
      return false;
    }
  };
  EXPECT_TRUE(parses(nested(JsonReader::deepest)));
  EXPECT_FALSE(parses(nested(JsonReader::deepest + 1)));
  EXPECT_FALSE(parses(nested(1'000'000)));
  EXPECT_FALSE(parses(std::string(1'000'000, '[')));
}

// The checker's kept integers: their values, and that neither reading nor checking allocates for
// each of them.

TEST(CheckIntegers, AreWhatWasKept) {
  Arena arena;
  std::vector<mpz_class> values{0, 1, -1};
  for (unsigned long bits = 1; bits < 300'000; bits = bits * 5 / 2 + 1) {
    values.push_back((mpz_class(1) << bits) - 1);
    values.push_back(-(mpz_class(1) << bits));
  }
  std::vector<Integer> kept;
  for (const mpz_class& value : values) kept.push_back(arena.keep(value));
  for (std::size_t k = 0; k < values.size(); ++k) {
    EXPECT_EQ(kept[k].value(), values[k]);
    EXPECT_EQ(kept[k].sign(), sgn(values[k]));
  }
}

TEST(CheckIntegers, AreWhatWasKeptOfALong) {
  Arena arena;
  constexpr long least = std::numeric_limits<long>::min(), largest = std::numeric_limits<long>::max();
  for (const long value : {0L, 1L, -1L, 12345L, least, largest}) {
    EXPECT_EQ(arena.keep(value).value(), mpz_class(value));
    EXPECT_EQ(arena.keep(value).sign(), value < 0 ? -1 : value > 0);
    EXPECT_TRUE(arena.keep(value) == arena.keep(mpz_class(value)));
  }
  EXPECT_EQ(Integer().value(), 0);
  EXPECT_EQ(Integer::one().value(), 1);
}

TEST(CheckIntegers, OtherTextIsNoShortInteger) {
  for (const char* text : {"", "-", "+1", "--1", "1-", "12x", "x12", "1 ", " 1", "1/2", "1.5", "1e3", "/", ":"})
    EXPECT_EQ(short_integer<long>(text), std::nullopt) << text;
}

std::size_t allocations = 0;  // by GMP

void count_allocations() {
  const auto allocate = [](std::size_t size) {
    ++allocations;
    return std::malloc(size);
  };
  const auto reallocate = [](void* block, std::size_t, std::size_t size) {
    ++allocations;
    return std::realloc(block, size);
  };
  mp_set_memory_functions(allocate, reallocate, [](void* block, std::size_t) { std::free(block); });
}

/// A double pyramid over a polygon of 2n + 1 corners, the points of a parabola with x from -n to n;
/// O lies inside.
std::string double_pyramid(int n) {
  const int corners = 2 * n + 1;
  std::string points, vertices, facets;
  for (int x = -n; x <= n; ++x) {
    points += std::to_string(x) + "/2 " + std::to_string(2 * x * x - n * n) + "/4 0\n";
    const std::string u = std::to_string(x + n), v = std::to_string((x + n + 1) % corners);
    facets += "3 " + u + ' ' + v + ' ' + std::to_string(corners) + '\n';
    facets += "3 " + v + ' ' + u + ' ' + std::to_string(corners + 1) + '\n';
  }
  for (int k = 0; k < corners + 2; ++k) vertices += std::to_string(k) + " 0\n";
  const std::string count = std::to_string(corners + 2), twice = std::to_string(2 * corners);
  return "fathom-certificate 1\na 1\n0 0 0\nb " + count + '\n' + points +
         "0 0 5/3\n0 0 -5/3\nclaim bounds 0 9\ndirections 1 some\n0 0 1\n" + "vertices " + count + '\n' + vertices +
         "facets " + twice + '\n' + facets + "end 1 " + count + " 1 " + count + ' ' + twice + '\n';
}

TEST(CheckIntegers, GmpAllocatesNoMoreForManyThanForFew) {
  count_allocations();
  const auto needed = [](int n) {
    const std::string text = double_pyramid(n);
    allocations = 0;
    const Verdict verdict = verify(text);
    EXPECT_TRUE(verdict.accepted()) << verdict_line(verdict, "pyramid");
    return allocations;
  };
  const std::size_t few = needed(10), many = needed(1000);
  EXPECT_GT(few, 0U);
  EXPECT_LT(few, 100U);
  EXPECT_LE(many, few + 10) << "law: numbers are kept in blocks, and the loops use their memory again";
}

}  // namespace
}  // namespace fathom_check
