// SPDX-License-Identifier: GPL-3.0-or-later
// The fields of one case, read from JSON: where a value may stand, what belongs there, and what was
// read. Poses are not applied yet.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/files.hpp"
#include "fathom/impact.hpp"
#include "reference/files/pose.hpp"
#include "reference/text/json_value.hpp"

namespace fathom::files {

struct ShapeName;

enum class CasePlace {
  whole,
  schema,
  id,
  rounding,
  dimension,
  twist,  ///< read_motion reads it
  body,
  body_rounding,
  vertices,
  vertex,
  coordinate,
  pose,
  pose_row,
  pose_entry,
  faces,  ///< read_faces reads them
  shape,  ///< a shape's name, or what only some shapes have: of a body that read_shapes reads, or refuses
  other   ///< no field of ours: skipped
};

/// Returns the place of `key` in the object of a case, or of a body.
CasePlace field_of_case(std::string_view key);
CasePlace field_of_body(std::string_view key);

/// Returns whether some body has a field called `key` that tells what it is: a number field, or
/// "shape", "axis", "vertices", "faces", "terms", "pieces", "solid".
bool is_field_of_shapes(std::string_view key);

/// Returns whether this shape has that field. Each has a name and a margin; none has pieces, or a
/// solid.
bool has_field(const ShapeName& shape, std::string_view key);

/// Returns whether an unknown field of a case, or of a body, has a name near that of a known one.
/// Quick: most names differ in length.
bool looks_misspelt(std::string_view key, bool of_body);

/// A sentence on the unknown fields of a pose, of all whose keys are given; or "".
std::string misspelt_in_pose(std::span<const std::string> keys);

/// Returns a note on the case, and on each body, with such fields, if the field that may be meant
/// is missing.
std::vector<CaseNote> misspelt_fields(const text::JsonValue& document, bool plane);

/// One of the two bodies as it is written.
struct BodyFields {
  GivenPoints vertices;
  std::optional<Pose> pose;
  bool rounded = false;    ///< "pose_rounding": "binary64"
  bool has_faces = false;  ///< read_faces reads them
  bool is_shape = false;   ///< it has a shape's name, a margin, or a pose that is no 3 x 4 matrix: read_shapes reads it
};

/// The fields of a case, or the first error in it.
struct CaseFields {
  std::optional<std::string> id;  ///< also of a bad case, if it could be read
  BodyFields a, b;
  bool rounded = false;        ///< of both bodies
  bool moves = false;          ///< it has a twist: read_motion reads it
  bool plane = false;          ///< its dimension is 2: read_shapes reads both bodies
  bool misspelt = false;       ///< perhaps: see looks_misspelt
  std::string fault;           ///< empty if the case is good; else what was expected where, and what was found
  std::size_t fault_line = 0;  ///< the number of lines of `text` before a syntax error
};

/// Reads the JSON text of one case. `read` is what read_json finds in it. White space alone may
/// follow the object, and at most 64 objects and arrays may be nested, in skipped fields too.
CaseFields read_case_fields(std::string_view text, const text::JsonRead& read);

/// Returns what read_case_fields, its naive twin, returns for the text, in a fraction of the time;
/// or nullopt, and read_case_fields has to read it. It does so for every text with a fault, and for
/// a few good ones. Call it while rounding is to nearest.
std::optional<CaseFields> quick_case_fields(std::string_view text);

// ---- body_fields.cpp: bodies that are more than vertices and a matrix (shapes, margins,
// quaternions, pieces), and faces ----

/// Those bodies of a case that were asked for, or the first fault.
struct ShapesOfCase {
  std::optional<Body> a, b;
  std::string fault;  ///< "a.radius: expected a number, found null"; empty if all is good
  std::vector<CaseNote> notes;
};

/// Reads body a, or b, or both, of the object of a case. `rounded`: the case says that points are
/// rounded once to the nearest binary64, which bodies with discs, balls, terms or planes refuse.
/// `dimension`: 2 of bodies of the plane.
ShapesOfCase read_shapes(const text::JsonValue& document, bool a, bool b, bool rounded, unsigned dimension = 3);

/// Reads faces, arrays of indices of points, into `body`, whose points were read. `path` names the
/// field. Returns a sentence on what went wrong, or "".
std::string read_faces(const text::JsonValue& faces, const std::string& path, Body& body);

/// The motions of both bodies of a case: fields of it that only one question reads.
struct MotionsOfCase {
  RigidMotion a, b;
};

/// The motion from one pose to another the shorter way; at rest in one of them if the other is not
/// given, or where the points stand. A pose must not be a matrix, which tells no quaternion.
/// Returns a sentence in `fault` if it is.
RigidMotion motion_between(const std::optional<GivenPose>& from, const std::optional<GivenPose>& to,
                           std::string& fault);

/// Reads the object "motion" of a case, whose text read_case could read. Returns a sentence in
/// `fault` on what went wrong: there may be none.
MotionsOfCase read_motions(std::string_view text, std::string& fault);

/// Reads the object "twist" of a case. Returns a sentence on what went wrong, or "".
std::string read_motion(const text::JsonValue& twist, Motion& motion);

}  // namespace fathom::files
