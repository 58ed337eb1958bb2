// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a recipe.
// Output  one to three records: the base case as it is, and as programs get it that round its
//         numbers to binary64 or to binary32. Each is one line of JSON with the truth about exactly
//         the bodies in it, and the certificate that proves it.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fathom/depth.hpp"
#include "fathom/monitor.hpp"
#include "fathom/numbers.hpp"
#include "reference/text/json_value.hpp"
#include "verify/golden/records/recipe.hpp"

namespace fathom::golden {

struct Record {
  std::string id;
  std::string line;         ///< golden.schema.json, also a case of schema fathom/case/1; without a line feed
  std::string certificate;  ///< verify/check/FORMAT.md, with its last line feed; accepted by the checker
  std::string csv_row;      ///< with its line feed; empty unless of polytopes in binary64
  bool in_binary64 = false, in_binary32 = false;  ///< whether every number is one of that format
};

/// Returns the records of a recipe, one for each of cases_of(recipe). Throws std::logic_error if
/// the certificate is not accepted or contradicts the record, and Interrupted.
std::vector<Record> records_of(const Recipe& recipe, Monitor* monitor = nullptr, Workspace* workspace = nullptr);

/// Returns the record of the base case in one form.
Record record_of(const Recipe& recipe, FormedCase made, Monitor* monitor = nullptr, Workspace* workspace = nullptr);

// ---- reading ----

// Reads the parts of a record's line that cannot be computed from others, without checking them.

/// Why a text is not a record, as one sentence.
struct NotARecord : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct ReadRecord {
  Recipe recipe;
  Form form = Form::given;
  std::string id;
  std::optional<HullPair> hulls;   ///< of polytopes; other bodies come from their source
  std::optional<Witness> witness;  ///< of polytopes, or of their distance
  std::string certificate_sha256;
};

/// Returns the exact number of a field, one of a string too. Throws NotARecord.
mpq_class number_in(const text::JsonValue& value);

/// Throws NotARecord.
ReadRecord read_record(std::string_view line);

/// Returns the bounds of the signed depth in a record of shapes: they are equal if it is exact.
/// Throws NotARecord.
std::pair<Surd, Surd> signed_depth_in(std::string_view line);

/// Returns the numbers of the nearest pieces in a record of unions, of A and of B. Throws
/// NotARecord.
std::pair<std::uint32_t, std::uint32_t> nearest_pieces_in(std::string_view line);

/// Returns the id at the place where the writer of records puts it, or an empty text. Does not look
/// at the rest of the line.
std::string_view id_in(std::string_view line);

/// Returns a sentence on the first difference of the two lines: "expected.depth.f64.rn: expected
/// .., found ..".
std::string first_difference(std::string_view expected, std::string_view found);

}  // namespace fathom::golden
