// SPDX-License-Identifier: GPL-3.0-or-later
// The number behind --threads and --jobs.
#pragma once

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <string>
#include <system_error>

#include "kernels/messages.hpp"

namespace fathom::cli {

inline constexpr unsigned most_threads = 1024;

/// Returns nullopt unless the text is a number of threads.
inline std::optional<unsigned> threads_of(const std::string& text) {
  unsigned threads = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), threads);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && threads >= 1 && threads <= most_threads ? std::optional(threads) : std::nullopt;
}

/// Says what was expected instead of the text.
inline std::string expected_threads(const std::string& text) {
  return fmt::format("expected an integer from 1 to {}, found {}", most_threads, kernels::shown(text));
}

/// The same, or "" for a number of threads: the check of an option.
inline std::string check_threads(const std::string& text) { return threads_of(text) ? "" : expected_threads(text); }

}  // namespace fathom::cli
