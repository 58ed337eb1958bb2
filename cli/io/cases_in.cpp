// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "cli/io/case_input.hpp"

namespace fathom::cli {

std::optional<std::size_t> cases_in(const std::string& path) {
  std::error_code fault;
  if (path == "-" || !std::filesystem::is_regular_file(path, fault)) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  std::array<char, 1 << 16> piece;
  std::size_t cases = 0;
  char before = '\n';
  while (file.read(piece.data(), piece.size()) || file.gcount() > 0) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(file.gcount()); ++i) {
      if (before == '\n' && piece[i] == '{') ++cases;
      before = piece[i];
    }
  }
  return cases > 0 ? std::optional(cases) : std::nullopt;
}

}  // namespace fathom::cli
