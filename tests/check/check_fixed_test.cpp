// SPDX-License-Identifier: GPL-3.0-or-later
// The checker's integers of a fixed size: GMP's are their twin, in every operation at the ends of
// its range, and in whole verdicts.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/check/edits.hpp"
#include "verify/check/checks.hpp"
#include "verify/check/fixed.hpp"
#include "verify/check/limits.hpp"
#include "verify/check/reader.hpp"

namespace fathom_check {
namespace {

mpz_class power(unsigned long exponent) { return mpz_class(1) << exponent; }

template <class Number>
mpz_class gmp(const Number& n) {
  mpz_class result;
  copy(result, n);
  return result;
}

/// Around the ends of the halves of a number of 127 bits.
std::vector<mpz_class> awkward() {
  std::vector<mpz_class> result{0};
  for (const unsigned long exponent : {0, 1, 31, 62, 63, 64, 65, 126, 127})
    for (const mpz_class& n : {mpz_class(power(exponent) - 1), power(exponent), mpz_class(power(exponent) + 1)})
      if (n < power(127)) result.insert(result.end(), {n, -n});
  return result;
}

TEST(CheckFixed, ComputesLikeGmp) {
  std::vector<Int256> products;
  for (const mpz_class& a : awkward())
    for (const mpz_class& b : awkward()) {
      ASSERT_EQ(gmp(to_int128(a.get_mpz_t())), a);
      products.push_back(Int256::product(to_int128(a.get_mpz_t()), to_int128(b.get_mpz_t())));
      ASSERT_EQ(gmp(products.back()), a * b) << a << " " << b;
      ASSERT_EQ(sgn(products.back()), sgn(a) * sgn(b));
      ASSERT_EQ(gmp(-products.back()), -a * b);
    }
  for (std::size_t i = 0; i < products.size(); i += 7)
    for (const Int256& q : products) {
      const mpz_class m = gmp(products[i]), n = gmp(q);
      ASSERT_EQ(gmp(products[i] + q), m + n);
      ASSERT_EQ(products[i] < q, m < n);
      ASSERT_EQ(products[i] != q, m != n);
    }
}

TEST(CheckFixed, CountsBits) {
  for (const mpz_class& n : awkward()) EXPECT_EQ(bits(n.get_mpz_t()), n == 0 ? 0 : mpz_sizeinbase(n.get_mpz_t(), 2));
  EXPECT_EQ(bits(power(1000).get_mpz_t()), 1001U);
}

/// How many powers of 2 longer a cube is along each axis.
using Stretch = std::array<long, 3>;

mpq_class times_power(const mpq_class& n, long exponent) {
  return exponent < 0 ? mpq_class(n >> static_cast<unsigned long>(-exponent))
                      : mpq_class(n << static_cast<unsigned long>(exponent));
}

/// Corners of a cube, `m` away from O along each axis, as a body.
std::string corners(const std::string& name, const mpz_class& m, const std::vector<int>& numbers,
                    const Stretch& stretch = {}) {
  std::string result = name + " " + std::to_string(numbers.size()) + "\n";
  for (const int number : numbers)
    for (std::size_t axis = 0; axis < 3; ++axis)
      result += times_power((number >> axis & 1) == 0 ? -m : m, stretch[axis]).get_str() + (axis == 2 ? "\n" : " ");
  return result;
}
const std::vector<int> all{0, 1, 2, 3, 4, 5, 6, 7};

/// Both bodies are that cube: the coordinates of the vertices are twice as large. The shortest axes
/// are the optima.
std::string cubes_of(const mpz_class& m, const Stretch& stretch = {}) {
  const long least = *std::min_element(stretch.begin(), stretch.end());
  std::string optima;
  const auto add = [&](std::size_t axis, const char* direction) {
    if (stretch[axis] == least) optima += direction;
  };
  add(0, "-1 0 0\n"), add(1, "0 -1 0\n"), add(2, "0 0 -1\n"), add(2, "0 0 1\n"), add(1, "0 1 0\n"), add(0, "1 0 0\n");
  const std::string count = std::to_string(std::count(optima.begin(), optima.end(), '\n'));
  return "fathom-certificate 1\n" + corners("a", m, all, stretch) + corners("b", m, all, stretch) + "claim depth " +
         times_power(4 * m * m, 2 * least).get_str() + "\ndirections " + count + " all\n" + optima +
         "vertices 8\n0 7\n1 6\n2 5\n3 4\n4 3\n5 2\n"
         "6 1\n7 0\nfacets 6\n4 0 4 6 2\n4 1 3 7 5\n4 0 1 5 4\n4 2 6 7 3\n4 0 2 3 1\n4 4 5 7 6\nend 8 8 " +
         count + " 8 6\n";
}

/// A is a point, B the tetrahedron of every other corner, which has the longest normals:
/// 4 m^2 (1, 1, 1), or of a cube that is stretched by s, 4 m^2 s_x s_y s_z (1/s_x, 1/s_y, 1/s_z).
std::string tetrahedron(const mpz_class& m, const Stretch& stretch = {}) {
  const long longest = *std::max_element(stretch.begin(), stretch.end());
  mpq_class sum = 0;
  std::array<std::string, 3> n;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sum += times_power(1, -2 * stretch[axis]);
    n[axis] = times_power(1, longest - stretch[axis]).get_str();
  }
  const auto& [x, y, z] = n;
  return "fathom-certificate 1\na 1\n0 0 0\n" + corners("b", m, {0, 3, 5, 6}, stretch) + "claim depth " +
         mpq_class(m * m / sum).get_str() + "\ndirections 4 all\n-" + x + " -" + y + " " + z + "\n-" + x + " " + y +
         " -" + z + "\n" + x + " -" + y + " -" + z + "\n" + x + " " + y + " " + z +
         "\nvertices 4\n0 0\n1 0\n2 0\n3 0\n"
         "facets 4\n3 1 3 2\n3 0 2 3\n3 0 3 1\n3 0 1 2\nend 1 4 4 4 4\n";
}

/// A cube and a point that are apart in this direction.
std::string apart(const mpz_class& m, const mpz_class& component) {
  return "fathom-certificate 1\n" + corners("a", m, all) + "b 1\n" + mpz_class(3 * m + 1).get_str() + " " +
         m.get_str() + " " + mpz_class(-m).get_str() + "\nclaim disjoint\ndirections 1 some\n" +
         mpz_class(-component).get_str() + " " + mpz_class(component - 1).get_str() + " " + component.get_str() +
         "\nend 8 1 1 0 0\n";
}

struct Judged {
  std::string line;  ///< what is printed
  bool checked;      ///< whether it was well-formed
};

Judged judged_with(const std::string& text, Arithmetic arithmetic) {
  Lines lines(text, longest_line);
  const std::optional<Reader::Found> found = Reader(lines).read();
  Verdict verdict = found->fault.value_or(Verdict());
  if (!found->fault) verdict = caught([&] { return check_claim(found->certificate, arithmetic), Verdict(); }, 0);
  return {verdict_line(verdict, "text"), !found->fault};
}

/// Whether it is accepted; that both kinds of integers agree on this, and on where and why not.
bool agreed(const std::string& text, std::set<std::string>& lines) {
  const Judged fixed = judged_with(text, Arithmetic::fixed_where_it_fits),
               any = judged_with(text, Arithmetic::of_any_size);
  EXPECT_EQ(fixed.line, any.line) << text;
  if (fixed.checked) lines.insert(fixed.line);
  return verify(text).accepted();
}

/// Texts around every bound of what fits.
std::vector<std::string> at_the_bounds() {
  std::vector<std::string> result;
  for (const unsigned long exponent : {58, 59, 60, 61, 62, 63, 64, 127}) {
    for (const mpz_class& m : {mpz_class(power(exponent) - 1), power(exponent)})
      result.insert(result.end(), {cubes_of(m), tetrahedron(m), apart(m, power(62)), apart(m, power(63) - 1),
                                   apart(m, power(63)), apart(m, power(127) - 1), apart(m, power(127))});
  }
  for (const Stretch& stretch :
       {Stretch{0, 200, 64}, {300, 1, 0}, {-130, -130, -130}, {1000, 1000, 1000}, {7, -990, 7}})
    for (const mpz_class& m : {mpz_class(1), mpz_class(power(53) - 1), mpz_class(power(63) + 1)})
      result.insert(result.end(), {cubes_of(m, stretch), tetrahedron(m, stretch)});
  return result;
}

TEST(CheckFixed, AcceptsAtTheBounds) {
  std::set<std::string> lines;
  std::size_t accepted = 0;
  for (const std::string& text : at_the_bounds()) accepted += agreed(text, lines) ? 1 : 0;
  EXPECT_EQ(accepted, at_the_bounds().size()) << *lines.begin();
}

/// One number of the text becomes another one.
std::string forged(std::string text, std::mt19937& random) {
  std::vector<std::pair<std::size_t, std::size_t>> words;  // from where, how long
  for (std::size_t begin = text.find("\na ") + 1, end = 0; begin < text.size(); begin = end + 1) {
    end = text.find_first_of(" \n", begin);
    if (end > begin && std::string("-0123456789").find(text[begin]) != std::string::npos)
      words.emplace_back(begin, end - begin);
  }
  const auto any = [&random](std::size_t count) { return random() % count; };
  const auto [begin, length] = words[any(words.size())];
  const std::string word = text.substr(begin, length);
  const auto [other, other_length] = words[any(words.size())];
  const std::array<std::string, 6> forgeries{
      "-" + word, word + "1", "0", word.substr(0, length - 1) + "1", word + "/3", text.substr(other, other_length)};
  return text.replace(begin, length, forgeries[any(forgeries.size())]);
}

TEST(CheckFixed, ForgeriesAreRefusedWhereAndWhyGmpRefusesThem) {
  std::vector<std::string> texts = at_the_bounds();
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::path(FATHOM_TEST_DATA) / "certificates"))
    if (entry.path().extension() == ".cert" && entry.path().stem() != "two_in_one_file")
      texts.push_back(read(entry.path()));
  std::mt19937 random(1);
  std::set<std::string> lines;
  for (const std::string& text : texts) {
    agreed(text, lines);
    for (int k = 0; k < 100; ++k) agreed(forged(text, random), lines);
  }
  EXPECT_GT(lines.size(), 200U) << "different lines and reasons";
}

}  // namespace
}  // namespace fathom_check
