// SPDX-License-Identifier: GPL-3.0-or-later
// Parsers for the values of options, and sentences on wrong values. Numbers are exact: decimals as
// typed, integers as plain digits. And suggestions for misspelt words, and quotation for shells.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fathom/depth.hpp"
#include "fathom/numbers.hpp"
#include "fathom/patch.hpp"
#include "fathom/point.hpp"

namespace fathom::cli {

/// The engines of the closest lines, in the order of ClosestLines.
inline constexpr std::array<std::string_view, 3> engine_names{"cutting", "sampled", "naive"};

// Parsers: each returns nullopt for a text that is not of its form.

std::optional<std::uint64_t> typed_integer(std::string_view text, std::uint64_t low = 0,
                                           std::uint64_t high = UINT64_MAX);
std::optional<mpq_class> typed_number(std::string_view text);
/// Parses as many numbers as the dimension says, with commas between them; in the plane z is 0.
std::optional<Point> typed_point(std::string_view text, unsigned dimension = 3);
/// Parses the same, not all zero.
std::optional<Point> typed_vector(std::string_view text, unsigned dimension = 3);
/// Parses six numbers with commas between them, not all zero: v, and w; with the dimension 2 three:
/// two of v, and the angular speed.
std::optional<Twist> typed_twist(std::string_view text, unsigned dimension);
/// Parses such numbers, or v alone.
std::optional<Twist> typed_motion(std::string_view text, unsigned dimension);
/// Parses "10..10000", or "10,20,50", which must ascend. A range yields its ends, and 1, 2 and 5
/// times the powers of ten between them.
std::optional<std::vector<unsigned>> typed_sizes(std::string_view text);
/// Parses a number of threads.
std::optional<unsigned> typed_threads(std::string_view text);
/// Parses "i/n" with 1 <= i <= n.
std::optional<std::pair<std::size_t, std::size_t>> typed_part(std::string_view text);
/// Returns the methods of these words, which must be valid: each once, in the order of the words.
/// For commands that compute answers in two ways.
std::vector<Method> typed_methods(std::span<const std::string> words);
/// Returns the engine of this name.
std::optional<ClosestLines> typed_engine(std::string_view name);
/// Splits "a,b" into "a" and "b".
std::vector<std::string> words_of(std::string_view list);

/// Returns whether the name is that of a mesh, or of cases. Files of cases may have other names
/// too.
bool is_mesh_name(const std::string& path);
bool is_cases_name(const std::string& path);

// Checks of values: each returns a sentence, or "".

std::string unless(bool good, std::string_view expected, const std::string& text);
template <std::uint64_t low, std::uint64_t high>
std::string wrong_integer(const std::string& text);
std::string wrong_integer(const std::string& text, std::uint64_t low, std::uint64_t high);
std::string wrong_twist(const std::string& text);
std::string wrong_count(const std::string& text);
std::string wrong_optima(const std::string& text);
std::string wrong_threads(const std::string& text);
std::string wrong_digits(const std::string& text);
std::string wrong_bits(const std::string& text);
std::string wrong_delta(const std::string& text);
std::string wrong_point(const std::string& text);
std::string wrong_vector(const std::string& text);
std::string wrong_motion(const std::string& text);
std::string wrong_joints(const std::string& text);
std::string wrong_sizes(const std::string& text);
std::string wrong_time(const std::string& text);
std::string wrong_tolerance(const std::string& text);
std::string wrong_fit(const std::string& text);
std::string wrong_policy(const std::string& text);
std::string wrong_second_method(const std::string& text);

template <std::uint64_t low, std::uint64_t high>
std::string wrong_integer(const std::string& text) {
  return wrong_integer(text, low, high);
}

// Suggestions for misspelt words.

/// Returns "; did you mean 'word'?" for the one of `words` that begins with `typed`, if it is
/// unique, or else for the one with the smallest edit distance, if that is small; or "".
std::string did_you_mean(const std::string& typed, std::span<const std::string> words);

// Quotation for /bin/sh.

/// Returns the word in single quotes, with those inside escaped.
std::string quoted(const std::string& word);

/// Returns the words with spaces between them, quoted where needed.
std::string shell_line(std::span<const std::string> words);

}  // namespace fathom::cli
