// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a recipe.
// Output  one to three records: the base case as it is, and as programs see it that round its
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
/// the certificate is not accepted or proves anything else than the record says, and Interrupted.
std::vector<Record> records_of(const Recipe& recipe, Monitor* monitor = nullptr, Workspace* workspace = nullptr);

/// Returns the record of the base case in one form.
Record record_of(const Recipe& recipe, FormedCase made, Monitor* monitor = nullptr, Workspace* workspace = nullptr);

// ---- reading ----

// Reads the parts of a record's line that cannot be computed from others. Nothing is checked yet.

/// Why a text is not a record, as one sentence.
struct NotARecord : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct ReadRecord {
  Recipe recipe;
  Form form = Form::given;
  std::string id;
  std::optional<HullPair> hulls;   ///< of polytopes; what other bodies are their source says
  std::optional<Witness> witness;  ///< of polytopes, or of their distance
  std::string certificate_sha256;
};

/// Throws NotARecord.
ReadRecord read_record(std::string_view line);

/// Returns low and high of the signed depth that a record of shapes says: they are equal if it is
/// exact. Throws NotARecord.
std::pair<Surd, Surd> signed_depth_in(std::string_view line);

/// Returns the numbers of the pieces that a record of unions says are nearest, of A and of B.
/// Throws NotARecord.
std::pair<std::uint32_t, std::uint32_t> nearest_pieces_in(std::string_view line);

/// Returns the id in a record's line where the writer puts it, or an empty text: nothing else is
/// looked at.
std::string_view id_in(std::string_view line);

/// Returns where the two lines first differ, as one sentence: "expected.depth.f64.rn: expected ..,
/// found ..".
std::string first_difference(std::string_view expected, std::string_view found);

}  // namespace fathom::golden
