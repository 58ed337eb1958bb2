// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates of the test data, and what becomes of them when one place is edited.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "verify/check/check.hpp"

namespace fathom_check {

inline std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline std::string data(const std::string& name) {
  return read(std::filesystem::path(FATHOM_TEST_DATA) / "certificates" / name);
}

/// `text` with the only, or the first, `from` replaced. The test fails if there is none.
inline std::string edited(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

}  // namespace fathom_check
