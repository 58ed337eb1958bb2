// SPDX-License-Identifier: GPL-3.0-or-later
// The values behind options: what a text means, and what is wrong with it. Numbers are meant as
// typed: decimals are exact, integers are plain digits. And words: misspelt ones, and quoted ones.
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

// What a text means, or nullopt if it means nothing of the kind.

std::optional<std::uint64_t> typed_integer(std::string_view text, std::uint64_t low = 0,
                                           std::uint64_t high = UINT64_MAX);
std::optional<mpq_class> typed_number(std::string_view text);
/// Three numbers with commas between them.
std::optional<Point> typed_point(std::string_view text);
/// The same, not all zero.
std::optional<Point> typed_vector(std::string_view text);
/// Six numbers with commas between them, not all zero: v, and w.
std::optional<Twist> typed_twist(std::string_view text);
/// Six numbers as those, or three: v alone.
std::optional<Twist> typed_motion(std::string_view text);
/// "10..10000", or "10,20,50": ascending. Of a range both ends, and 1, 2 and 5 times the powers of
/// ten between them.
std::optional<std::vector<unsigned>> typed_sizes(std::string_view text);
/// A number of threads.
std::optional<unsigned> typed_threads(std::string_view text);
/// "i/n" with 1 <= i <= n.
std::optional<std::pair<std::size_t, std::size_t>> typed_part(std::string_view text);
/// The methods behind --method of a command that computes its answers in two ways, which must be
/// good: each once, in the order of the words.
std::vector<Method> typed_methods(std::span<const std::string> words);
/// The engine of this name.
std::optional<ClosestLines> typed_engine(std::string_view name);
/// "a,b" as "a" and "b".
std::vector<std::string> words_of(std::string_view list);

/// Whether the name is that of a mesh, or of cases. Other names may be of cases too.
bool is_mesh_name(const std::string& path);
bool is_cases_name(const std::string& path);

// What is wrong with a value, as a sentence, or "".

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

// What a misspelt word may be meant to be.

/// Returns "; did you mean 'word'?" for the one of `words` that alone begins with `typed`, or else
/// is nearest to it and near; or "".
std::string did_you_mean(const std::string& typed, std::span<const std::string> words);

// Words quoted for /bin/sh.

/// Returns the word in single quotes, with those inside escaped.
std::string quoted(const std::string& word);

/// Returns the words with spaces between them, quoted where needed.
std::string shell_line(std::span<const std::string> words);

}  // namespace fathom::cli
