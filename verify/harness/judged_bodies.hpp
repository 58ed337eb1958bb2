// SPDX-License-Identifier: GPL-3.0-or-later
// The bodies that an answer is judged on, where they are not the ones that were asked: rounded, or as the subject's hulls are.
//                                                                                         [verify/PROTOCOL.md; verify/judge/VERDICTS.md]
#pragma once

#include <utility>

#include "verify/harness/outcome.hpp"
#include "verify/harness/protocol.hpp"

namespace fathom::harness {

/// Returns the bodies, each grown by the ball of the radius that the subject declares for it, whose lengths are 2^exponent times those of
/// the case. What has a radius is a shape without words. Unions are as they are: see rounds_pieces.
Case judged_bodies(const Case& seen, const SubjectInfo& info, long exponent);

/// Returns the radius by which the subject rounds such a body, in the subject's unit.
mpq_class rounding_radius(const Body& body, const SubjectInfo& info);

/// Returns the radii by which the subject rounds A and B, in the unit of the case, whose lengths it sees times 2^exponent.
std::pair<mpq_class, mpq_class> rounding_radii(const Case& seen, const SubjectInfo& info, long exponent);

/// Whether the subject rounds pieces by a radius; then there is no truth about what it sees.
bool rounds_pieces(const SubjectInfo& info);

/// Throws ProtocolError if the answer tells the hull of a body that was not sent as vertices: as a shape, or in pieces.
void demand_sent_as_vertices(const Case& seen, const SubjectAnswer& answer);

/// Returns the case with the hulls that the answer tells in the place of the bodies, in the unit of the case.
Case used_hulls(const Case& seen, const SubjectAnswer& answer, long exponent);

/// Returns the square of the largest distance of a vertex of `from` from the body of the same letter in `to`, over the bodies whose hulls
/// the answer tells.
mpq_class squared_way(const Case& from, const Case& to, const SubjectAnswer& answer);

}  // namespace fathom::harness
