// SPDX-License-Identifier: Apache-2.0
// The certificate checker as a library: needs the C++ standard library and GMP. What acceptance
// proves is written in FORMAT.md.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fathom_check {

/// How bad: the exit code of a run is the largest that occurred.
enum class Outcome { verified = 0, refused = 1, malformed = 2 };

/// The judgement on one certificate. It starts from "no".
struct Verdict {
  Outcome outcome = Outcome::refused;  ///< what the checker decided
  std::string id;                      ///< as written in the certificate, percent-escaped; empty if it has none

  // If verified:
  /// "penetrating", "touching", "disjoint"; "undecided" where signed bounds leave it open; "solid";
  /// of bodies in motion "apart", "grazing", "contact"
  std::string status;
  /// of the certificate: 1 sets depth_squared, 2 and 4 signed_depth, unless it claims bounds; 3 one
  /// of the squares; 5 one of two bodies, none of one solid; 6 none
  int format = 1;
  std::string depth_squared;      ///< exact, in lowest terms: "1/4"
  std::string distance_squared;   ///< exact, of unions that are apart
  std::string signed_depth;       ///< exact: "sqrt(2)+1/2", "-sqrt(3)+0"; the numbers in lowest terms
  std::string at_least, at_most;  ///< bounds: of depth^2 in format 1, of the signed depth in format 2
  /// number of nearest facets, if the certificate claims to list them all, or of shortest ways out
  /// of unions
  std::size_t optima = 0;
  /// of touching cores: "1+2" for a lineality of one dimension and two rays; empty if it is not
  /// claimed
  std::string cone;

  std::string pieces;     ///< of unions and of two solids: "2x5", of a and of b; of one solid: "5"
  std::string triangles;  ///< of the mesh of a solid: "12"; of two bodies "12x24", a union has "-"
  std::string patches;    ///< "4+1": how many corners the contact patch of each direction has; empty if none is claimed
  bool plane = false;     ///< whether all this is of bodies of the plane
  std::size_t rates = 0;  ///< number of derivatives of the signed depth that are claimed
  std::string until;      ///< of bodies in motion: the time up to which they are apart; empty if this is not shown of 0
  std::string meeting;    ///< the time at which they are in contact; empty if they do not meet
  std::string near;  ///< "(1/4,1/2):1/8+..": the times between which nothing is shown, and their distance at the later

  // If not:
  std::size_t line = 0;  ///< where, from 1
  std::string reason;    ///< a phrase for people
  /// Whether the certificate is a proof.
  [[nodiscard]] bool accepted() const noexcept { return outcome == Outcome::verified; }
};

/// Checks the one certificate that `text` holds. More than one, or anything else beside comments,
/// is malformed. Exact; does not throw; memory and time are bounded on any input (FORMAT.md,
/// section 8).
[[nodiscard]] Verdict verify(std::string_view text) noexcept;

/// The line that a checker prints, without a line feed: "s VERIFIED penetrating depth_squared=1/4
/// cube". `name` stands for a missing id.
[[nodiscard]] std::string verdict_line(const Verdict& verdict, std::string_view name);

}  // namespace fathom_check
