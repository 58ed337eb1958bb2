// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the parts of a record's line that cannot be computed from others. Nothing is checked yet.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "verify/golden/records/record_facts.hpp"

namespace fathom::golden {

/// Why a text is not a record, as one sentence.
struct NotARecord : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Claimed {
  Recipe recipe;
  Form form = Form::given;
  Case points;                     ///< of shapes and unions the id alone: what else they are their source says
  std::optional<Witness> witness;  ///< of polytopes, or of their distance
  std::string certificate_sha256;
};

/// Throws NotARecord.
Claimed read_record(std::string_view line);

/// Returns the id in a record's line where the writer puts it, or an empty text: nothing else is looked at.
std::string_view id_in(std::string_view line);

/// Returns where the two lines first differ, as one sentence: "expected.depth.f64.rn: expected .., found ..".
std::string first_difference(std::string_view expected, std::string_view found);

}  // namespace fathom::golden
