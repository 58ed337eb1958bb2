// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of answers as text: numbers, points and directions, exact if that is short, else a few
// digits after a "~", or the nearest binary64; and rows and lines of them.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/args/arguments.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/depth.hpp"
#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "fathom/signed_depth.hpp"
#include "kernels/vector.hpp"
#include "reference/output/answer_json.hpp"
#include "reference/output/json_values.hpp"
#include "reference/rounded/coordinates.hpp"
#include "view/picture/scene.hpp"

namespace fathom::cli {

/// Returns the square root as a decimal: the shortest one that reads back as its nearest binary64;
/// 17 digits beyond that range.
std::string root_text(const mpq_class& squared);
/// Returns a value >= 0 as root_text does.
std::string surd_text(const Surd& value);

inline Surd negated(const Surd& value) { return {-value.rational, -value.root}; }

/// Returns "(1/2, 0, -3)", or "~(0.333333333, ...)".
std::string point_text(const Point& p);

/// Returns "(-1, 0, 0)", or if the integers are long the unit vector of that direction:
/// "~(0.577350269, ...)".
std::string direction_text(const Vector& n);

// Points, translations and directions, rounded to the nearest binary64 or exact.

using rounded::CoordinatePair;
using rounded::Coordinates;
using rounded::coordinates;
using rounded::nearest_binary64;
using rounded::rational_point;
using rounded::unit;

/// Returns "(-0.25, 0, 1)": the shortest decimals that read back as the nearest binary64 numbers;
/// 17 digits beyond that range.
std::string decimals(const Coordinates& values, unsigned dimension = 3);

/// Returns a point or translation: its decimals; or, if `exact`, fractions, with a part along a
/// direction apart: "(1/2, 0, 0) and 1/3 along (1, 1, 1)".
// `dimension`: 2 in the plane, where the third coordinate, which is 0, is left out.
std::string place_text(const Point& p, bool exact, unsigned dimension = 3);
std::string place_text(const AlongNormal& vector, bool exact, unsigned dimension = 3);
std::string place_text(const RoundedPoint& point, bool exact, unsigned dimension = 3);

/// Returns a direction: the unit vector's decimals; or, if `exact`, the integers in lowest terms.
std::string way_text(const Vector& n, bool exact, unsigned dimension = 3);

// The rows of answers.

/// The form of an answer, by the options of its command.
struct AnswerForm : output::Shown {
  AnswerForm() = default;
  explicit AnswerForm(const Given& given);

  bool exact = false;      ///< text: exact numbers instead of decimals
  bool by_default = true;  ///< the user did not choose the method
  unsigned dimension = 3;  ///< 2 of answers about bodies of the plane
  GivenTwists twists;      ///< the derivative along them

  /// Whether a manifold is needed.
  [[nodiscard]] bool manifold() const { return patch || twists; }
  /// The same for this answer.
  [[nodiscard]] AnswerForm about(const Answer& answer) const {
    AnswerForm form = *this;
    form.dimension = answer.dimension();
    return form;
  }
};

/// Points, translations and directions in the form of an answer.
std::string place_text(const auto& place, const AnswerForm& form) {
  return place_text(place, form.exact, form.dimension);
}
inline std::string way_text(const Vector& n, const AnswerForm& form) { return way_text(n, form.exact, form.dimension); }

/// Returns an angular velocity; in the plane one number.
std::string spin_text(const SurdPoint& w, const AnswerForm& form);

/// A label and its text.
using Row = std::pair<std::string, std::string>;

/// Returns the quantity that the command computes: "depth" or "width".
std::string quantity(const AnswerForm& form);

/// Returns the heading, if there is one, and the rows with their texts in one column; without the
/// last newline. On a terminal the rows are broken at its width.
std::string aligned(const std::string& heading, const std::vector<Row>& rows);

/// Returns the line for a case of a stream, "id: first; second", broken on a terminal as above.
std::string case_line(const std::string& id, const std::vector<std::string>& parts);

/// Returns the id, or as a JSON string if it holds control characters.
std::string safe_id(const std::string& id);

/// Returns the indices of the points that span a face, "0 1 2"; the first few of a large face.
std::string indices_text(const std::vector<std::uint32_t>& indices);

/// Returns "edge-edge: points 1 2 of A, 3 4 of B"; for the width of one body both are of A.
std::string contact_text(const Contact& contact, bool same_body = false);

/// Adds two points, in two rows if one would be too long; one point if they are equal.
void add_points(std::vector<Row>& rows, const std::string& label, const std::string& a, const std::string& b,
                bool same_body = false);
void add_witness(std::vector<Row>& rows, const Witness& witness, const AnswerForm& form);

/// Returns the bodies without interior: "A and B", or ""; for one body "A", or "".
std::string flat_text(const BodyFacts& facts, bool same_body = false);

/// Returns a row that explains why a flat A may have a positive depth.
Row flat_note();

/// Adds a row "solid" for each body that is the solid of a mesh, with properties that users may not
/// expect.
void add_solids(std::vector<Row>& rows, const output::AboutBodies& bodies);

/// Returns "[low, high]".
std::string enclosure_text(const Enclosure& enclosure);
/// Returns the enclosure of the root, to that many digits.
inline std::string enclosure_text(const mpq_class& squared, unsigned digits) {
  return enclosure_text(enclose_root(squared, digits));
}

// The exact answer to a case, for bodies of any kinds, in the requested form.
//                                                                            [docs/command_line.md]

using output::AboutBodies;
using output::AnsweredCase;
using text::Json;

/// Returns several lines, without the last newline.
std::string answer_block(const AnsweredCase& answered, const AnswerForm& form);

/// Returns one line, which begins with the id, without its newline.
std::string answer_line(const AnsweredCase& answered, const AnswerForm& form);

/// Returns the scene of two bodies and their answer, which must be complete; with their patches, if
/// requested.
picture::PairScene answer_scene(const Case& bodies, const AnsweredCase& answered, const AnswerForm& form);

/// Returns an SVG file of the case and its answer, which must be complete, with the answer's
/// numbers as text below.
std::string answer_picture(const Case& bodies, const AnsweredCase& answered, const AnswerForm& form);

}  // namespace fathom::cli
