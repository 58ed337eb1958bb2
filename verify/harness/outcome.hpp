// SPDX-License-Identifier: GPL-3.0-or-later
// The outcome of one case with one subject. [docs/certify.md]
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/files.hpp"
#include "fathom/judge.hpp"
#include "verify/judge/manifold.hpp"

namespace fathom::harness {

/// Stands in the place of a shape's name for a margin around any shape.
inline constexpr const char* margin_word = "margin";
/// The words for the shapes of the plane, beside the margin of polygons.
inline constexpr std::string_view circle_word = "circle", capsule_word = "capsule";
/// Stands in the place of a shape's name for bodies sent as vertices.
inline constexpr const char* vertices_word = "vertices";
/// Stands in the place of a shape's name for unions sent as lists of pieces.
inline constexpr const char* pieces_word = "pieces";

/// The declarations of a subject in its hello.
struct SubjectInfo {
  std::string name, version;  ///< "libccd-epa", "2.1"
  unsigned dimension = 3;     ///< of the bodies that it takes: 2 or 3
  std::string library;        ///< that a snippet calls: "libccd", "fcl", "bullet", "ode"; may be empty
  NumberFormat format;        ///< of points and of answers, in the unit of the cases
  Conventions conventions;
  /// The shapes that it takes by name, "margin", and "pieces" for unions. It gets other bodies as
  /// vertices, other unions by pairs of pieces, and the rest not at all.
  std::set<std::string> shapes = {};
  bool wants_faces = false;  ///< whether each case comes with the facets of the hulls, as polygons of point indices
  bool wants_twist = false;  ///< whether cases with a motion come with it
  /// Fields that its replies must have: "depth", "direction", "witness" and "contacts" for each
  /// reply that claims an overlap; "distance" for each other reply; "derivative" for each reply to
  /// a case with a motion.
  std::set<std::string> promises;
  /// Radii by which it rounds bodies, in its unit: its bodies are the given ones and all points
  /// within that radius. By "vertices", a shape's name, or "" for all.
  std::map<std::string, mpq_class> rounding = {};
  std::map<std::string, std::string> settings;  ///< tolerances, iteration limits, margins: for reports only
};

/// The judgement of the same answer about the hulls that the subject reports, and the distance of
/// these from the given bodies.
struct AboutHulls {
  Judgement query;  ///< of the answer, by the reported hulls
  /// The largest distance of a given vertex from the reported hull; and of a reported vertex from
  /// the given body.
  mpq_class lost_squared, grown_squared;
};

/// The answer about unions that is taken from the replies about their pieces: the deepest or
/// nearest one.
struct AboutPieces {
  std::size_t pairs = 0;                     ///< number of pairs of pieces put to the subject
  std::array<std::uint32_t, 2> answer_of{};  ///< a piece of A and one of B: the pair whose answer it is
  Judgement query;                           ///< of the answer, as one about this pair
};

struct Outcome {
  std::string id;            ///< of the case
  std::string variant;       ///< empty; or the symmetry that was applied to the case: "swap", "translate", "permute",
                             ///< "scale", "repeat"
  std::string digest;        ///< of the points as they were put: 16 hexadecimal digits
  unsigned dimension = 3;    ///< of the bodies
  bool solid = false;        ///< whether both bodies have a volume, or in the plane an area
  bool metre_sized = false;  ///< whether the longest side of each body's box is from 1/100 to 100
  bool dwarfed = false;      ///< whether `radii` exceeds their size
  Verdict verdict = Verdict::garbage;
  std::string detail;  ///< what the harness observed: "killed by signal 11", "no answer within 10 s", a stray line, a
                       ///< misspelt field
  std::optional<Reply> reply;  ///< set if a reply could be read: in the subject's unit; see in_unit
  long fit = 0;                ///< the subject got all lengths times 2^fit
  /// The sum of the radii by which the subject rounds the two bodies itself, in the unit of the
  /// case; 0 if not judged.
  mpq_class radii = 0;
  std::optional<Judgement> judgement;  ///< if the reply was judged
  std::optional<AboutHulls> hulls;     ///< if the reply reports its hulls
  std::optional<AboutPieces> pieces;   ///< if the case is one of unions, and the subject was asked about pairs
  std::vector<judging::ContactFault> contact_faults;  ///< if a reply about polytopes was judged
  double seconds = 0;                                 ///< wall time until the answer, or until all answers
  std::optional<double> microseconds;                 ///< the time without the protocol, as the subject measured it
};

/// A failure that no case caused: after a good answer the process ended, wrote a line or stopped
/// reading, and a fresh process did not fail on the next case; or it did not exit with 0 after
/// "stop".
struct Unattributed {
  std::optional<std::string> after;  ///< the id of the last case that the process had answered, if any
  std::string detail;                ///< "killed by signal 11 (Segmentation fault)"
};

/// Returns the family in an id: the part before "::", or before "-n<size>-s<seed>"; empty if the id
/// has neither.
std::string family_of(const std::string& id);

/// Puts one case to the subject and judges its answer. Does not throw because of anything that a
/// subject does.
using Examine = std::function<Outcome(const Case&)>;
/// Does the same with all lengths times 2^exponent.
using ExamineInUnit = std::function<Outcome(const Case&, long exponent)>;

}  // namespace fathom::harness
