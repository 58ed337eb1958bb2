// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the parts of a record's line that cannot be computed from others. Nothing is checked yet.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "fathom/depth.hpp"
#include "fathom/numbers.hpp"
#include "verify/golden/records/recipe.hpp"

namespace fathom::golden {

/// Why a text is not a record, as one sentence.
struct NotARecord : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Claimed {
  Recipe recipe;
  Form form = Form::given;
  std::string id;
  std::optional<HullPair> hulls;   ///< of polytopes; what other bodies are their source says
  std::optional<Witness> witness;  ///< of polytopes, or of their distance
  std::string certificate_sha256;
};

/// Throws NotARecord.
Claimed read_record(std::string_view line);

/// Returns low and high of the signed depth that a record of shapes says: they are equal if it is exact. Throws NotARecord.
std::pair<Surd, Surd> signed_depth_in(std::string_view line);

/// Returns the numbers of the pieces that a record of unions says are nearest, of A and of B. Throws NotARecord.
std::pair<std::uint32_t, std::uint32_t> nearest_pieces_in(std::string_view line);

/// Returns the id in a record's line where the writer puts it, or an empty text: nothing else is looked at.
std::string_view id_in(std::string_view line);

/// Returns where the two lines first differ, as one sentence: "expected.depth.f64.rn: expected .., found ..".
std::string first_difference(std::string_view expected, std::string_view found);

}  // namespace fathom::golden
