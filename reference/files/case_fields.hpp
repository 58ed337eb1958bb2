// SPDX-License-Identifier: GPL-3.0-or-later
// The fields of one case, read from JSON; poses are not applied yet.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "fathom/body.hpp"
#include "reference/files/pose.hpp"
#include "reference/text/json_value.hpp"

namespace fathom::files {

/// One of the two bodies as it is written.
struct BodyFields {
  GivenPoints vertices;
  std::optional<Pose> pose;
  bool rounded = false;    ///< "pose_rounding": "binary64"
  bool has_faces = false;  ///< body_fields.hpp reads them
  bool is_shape = false;   ///< it has a shape's name, a margin, or a pose that is no 3 x 4 matrix: body_fields.hpp reads it
};

/// The fields of a case, or the first error in it.
struct CaseFields {
  std::optional<std::string> id;  ///< also of a bad case, if it could be read
  BodyFields a, b;
  bool rounded = false;        ///< of both bodies
  bool misspelt = false;       ///< perhaps: see looks_misspelt
  std::string fault;           ///< empty if the case is good; else what was expected where, and what was found
  std::size_t fault_line = 0;  ///< the number of lines of `text` before a syntax error
};

/// Reads the JSON text of one case. `read` is what read_json finds in it. White space alone may follow the object, and at most 64 objects
/// and arrays may be nested, in skipped fields too.
CaseFields read_case_fields(std::string_view text, const text::JsonRead& read);

/// Reads the fields of good cases in a fraction of the time, one case after another, each in the memory of the one before. One for each
/// thread.
class QuickCaseReader {
 public:
  QuickCaseReader();
  QuickCaseReader(QuickCaseReader&&) noexcept;
  QuickCaseReader& operator=(QuickCaseReader&&) noexcept;
  ~QuickCaseReader();

  /// Returns what read_case_fields, its naive twin, returns for the text; or nullopt, and read_case_fields has to read it. It does so for
  /// every text with a fault, and for a few good ones. Call it while rounding is to nearest.
  std::optional<CaseFields> fields(std::string_view text);

 private:
  struct Scratch;
  std::unique_ptr<Scratch> scratch_;
};

}  // namespace fathom::files
