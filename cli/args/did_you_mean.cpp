// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "cli/args/words.hpp"
#include "kernels/messages.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t shortest = 3, longest = 60;  // characters of a word that is worth a look

}  // namespace

std::string did_you_mean(const std::string& typed, std::span<const std::string> words) {
  if (words.empty() || typed.size() > longest) return "";
  const auto begins = [&typed](const std::string& word) { return typed.size() >= shortest && word.starts_with(typed); };
  const auto slips = [&typed](const std::string& word) { return kernels::slips(typed, word); };
  const std::string& nearest = *std::ranges::min_element(words, {}, slips);
  const bool only = std::ranges::count_if(words, begins) == 1;
  if (!only && !kernels::is_near(typed, nearest)) return "";
  return "; did you mean '" + (only ? *std::ranges::find_if(words, begins) : nearest) + "'?";
}

}  // namespace fathom::cli
