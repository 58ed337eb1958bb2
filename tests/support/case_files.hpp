// SPDX-License-Identifier: GPL-3.0-or-later
// The files in tests/data, and streams of cases read to their end.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fathom/files.hpp"

namespace fathom::testing {

inline const std::string data = FATHOM_TEST_DATA "/";

inline std::vector<CaseItem> all(CaseStream stream) {
  std::vector<CaseItem> items;
  while (std::optional<CaseItem> item = stream.next()) items.push_back(*std::move(item));
  EXPECT_FALSE(stream.next().has_value()) << "the end stays the end";
  return items;
}

}  // namespace fathom::testing
