// SPDX-License-Identifier: GPL-3.0-or-later
// What a forger makes of records: everything is right but for what was forged.
#pragma once

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "fathom/numbers.hpp"
#include "tests/golden/some_recipes.hpp"
#include "verify/digest/sha256.hpp"
#include "verify/golden/records/record.hpp"

namespace fathom::golden::testing {

using Json = nlohmann::ordered_json;  // keeps the order of fields, so that a forged line differs in one place only

inline mpq_class read(const Json& text) { return *parse_number(text.get<std::string>(), Decimals::exact).value; }
inline double hex(const Json& text) { return std::stod(text.get<std::string>()); }

/// The line with another certificate, whose sum is right.
inline std::string line_with(const std::string& line, const std::string& certificate) {
  Json forged = Json::parse(line);
  forged["certificate"]["sha256"] = digest::digest_of(certificate).sha256;
  return forged.dump();
}

inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

/// A record of shapes whose signed depth is enclosed.
inline Record enclosed_record() {
  for (const Recipe& recipe : some_recipes(1, Level::P0)) {
    if (recipe.name != "cylinder_capsule") continue;
    for (Record& record : records_of(recipe))
      if (record.line.find("\"bounds\"") != std::string::npos &&
          record.line.find("\"penetrating\"") != std::string::npos)
        return record;
  }
  ADD_FAILURE() << "no pair that is enclosed";
  return {};
}

}  // namespace fathom::golden::testing
