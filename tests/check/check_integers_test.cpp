// SPDX-License-Identifier: GPL-3.0-or-later
// The checker's kept integers: their values, and that neither reading nor checking allocates for
// each of them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <string>

#include "verify/check/check.hpp"
#include "verify/check/integers.hpp"
#include "verify/check/text.hpp"

namespace fathom_check {
namespace {

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
