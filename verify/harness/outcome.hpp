// SPDX-License-Identifier: GPL-3.0-or-later
// What became of one case in the hands of one subject.                            [docs/certify.md]
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fathom/files.hpp"
#include "fathom/judge.hpp"
#include "verify/judge/manifold.hpp"

namespace fathom::harness {

/// In the place of a shape's name: a margin around any of them.
inline constexpr const char* margin_word = "margin";
/// In the place of a shape's name: bodies that are sent as vertices.
inline constexpr const char* vertices_word = "vertices";
/// In the place of a shape's name: unions, as lists of pieces.
inline constexpr const char* pieces_word = "pieces";

/// What a subject says of itself in its hello.
struct SubjectInfo {
  std::string name, version;  ///< "libccd-epa", "2.1"
  std::string library;        ///< whose calls a snippet makes: "libccd", "fcl", "bullet", "ode"; may be empty
  NumberFormat format;        ///< of points and of answers, in the unit of the cases
  Conventions conventions;
  /// The names that it takes bodies by, "margin", and "pieces" for unions; others it gets as
  /// vertices, by pairs of pieces, or not at all.
  std::set<std::string> shapes = {};
  bool wants_faces = false;  ///< each case comes with the facets of the hulls, as polygons of point indices
  bool wants_twist = false;  ///< cases that have one come with how the bodies begin to move
  /// Fields that each reply that claims an overlap holds: "depth", "direction", "witness",
  /// "contacts"; "distance", each other reply; and "derivative", each to a case with a twist.
  std::set<std::string> promises;
  /// Its own bodies are the asked ones and all points so near: lengths in its unit, by "vertices",
  /// a shape's name, or "" for all.
  std::map<std::string, mpq_class> rounding = {};
  std::map<std::string, std::string> settings;  ///< tolerances, iteration limits, margins: shown in reports only
};

/// The same answer about the hulls that the subject says it used, and how far these are from the
/// asked bodies.
struct AboutHulls {
  Judgement query;  ///< of the answer, by the used hulls
  /// the largest distance of an asked vertex from the used hull; of a used one from the asked body
  mpq_class lost_squared, grown_squared;
};

/// An answer about unions that is the deepest, or nearest, of those about their pieces.
struct AboutPieces {
  std::size_t pairs = 0;                     ///< how many pairs of pieces the subject was asked about
  std::array<std::uint32_t, 2> answer_of{};  ///< a piece of A and one of B: the pair whose answer it is
  Judgement query;                           ///< of the answer, as one about these two
};

struct Outcome {
  std::string id;            ///< of the case
  std::string variant;       ///< empty; or the symmetry that the case was put through: "swap", "translate", "permute",
                             ///< "scale", "repeat"
  std::string digest;        ///< of the points as the subject saw them: 16 hexadecimal digits
  bool solid = false;        ///< whether both bodies have a volume
  bool metre_sized = false;  ///< whether the longest side of each body's box is from 1/100 to 100
  bool dwarfed = false;      ///< whether `radii` is larger than they are
  Verdict verdict = Verdict::garbage;
  std::string detail;  ///< what the harness saw: "killed by signal 11", "no answer within 10 s", the stray line, a
                       ///< misspelt field
  std::optional<Reply> reply;  ///< if one was understood: in the subject's unit; see in_unit
  long fit = 0;                ///< the subject saw all lengths times 2^fit
  /// by which the subject rounds the two bodies itself, in sum, in the unit of the case; 0 if not
  /// judged
  mpq_class radii = 0;
  std::optional<Judgement> judgement;  ///< if the reply was judged
  std::optional<AboutHulls> hulls;     ///< if the reply told its hulls
  std::optional<AboutPieces> pieces;   ///< if the case is one of unions, and the subject was asked about pairs
  std::vector<judging::ContactFault> contact_faults;  ///< of a judged reply about polytopes
  double seconds = 0;                                 ///< wall time until the answer, or all answers
  std::optional<double> microseconds;                 ///< the same without the protocol, as the subject measured it
};

/// A failure that no case caused: after a good answer the process ended, wrote something or stopped
/// reading, and a fresh process had no such trouble with the next case; or it did not exit with 0
/// after it was told to stop.
struct Unattributed {
  std::optional<std::string> after;  ///< the id of the last case that the process had answered; nullopt if none
  std::string detail;                ///< "killed by signal 11 (Segmentation fault)"
};

/// The family that an id names: the part before "::", or before "-n<size>-s<seed>"; empty if it has
/// neither.
std::string family_of(const std::string& id);

/// Puts one case to the subject and judges what comes back. Never throws for anything that a
/// subject does.
using Examine = std::function<Outcome(const Case&)>;
/// The same, with all lengths times 2^exponent.
using ExamineInUnit = std::function<Outcome(const Case&, long exponent)>;

}  // namespace fathom::harness
