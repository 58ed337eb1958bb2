// SPDX-License-Identifier: GPL-3.0-or-later
// What a forger makes of records: everything is right but for what was forged.
#pragma once

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "fathom/numbers.hpp"
#include "verify/check/check.hpp"
#include "verify/digest/sha256.hpp"
#include "verify/golden/records/prove.hpp"
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

/// The certificate of another record is refused, with its own name and with this record's.
inline void expect_refused_of(const Record& record, const Record& other) {
  const std::string& proof = other.certificate;
  EXPECT_NE(faults_of(line_with(record.line, proof), proof).value_or("").find("that of another record"), std::string::npos);
  const std::string renamed = replaced(proof, "id " + other.id, "id " + record.id);
  ASSERT_TRUE(fathom_check::verify(renamed).accepted()) << "it is true of other bodies";
  EXPECT_EQ(faults_of(line_with(record.line, renamed), renamed), "the certificate is about other bodies");
}

/// A form that the record's source has not is refused.
inline void expect_form_refused(const Record& record) {
  Json line = Json::parse(record.line);
  line["source"]["form"] = "binary32";
  line["id"] = record.id + ".b32";
  const std::string proof = replaced(record.certificate, "id " + record.id, "id " + record.id + ".b32");
  EXPECT_EQ(faults_of(line_with(line.dump(), proof), proof), "source: it has no such form");
}

/// A size of four billion is refused, of a record of the family's first seed.
inline void expect_size_refused(const Record& record, const std::string& family) {
  Json line = Json::parse(record.line);
  line["source"]["size"] = 4'000'000'000;
  line["id"] = family + "-n4000000000-s1";
  EXPECT_EQ(faults_of(line.dump(), record.certificate), "source.size: it is larger than that of any record");
}

}  // namespace fathom::golden::testing
