// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates of when two bodies meet first: the motions, and the planes that separate the bodies
// until then.                                                  [verify/check/FORMAT.md, section 17]
#include <string>
#include <string_view>
#include <vector>

#include "fathom/impact.hpp"
#include "kernels/float_environment.hpp"
#include "reference/certificate/certificate.hpp"
#include "reference/motion/motion.hpp"

namespace fathom::certificate {
namespace {

void insist_on_pieces(const motion::MovingPair& pair, const Impact& impact) {
  if (impact.pieces.empty() || !impact.pieces.front().plane || !impact.pieces.back().plane)
    contradiction("the pieces of time do not begin and end with a plane");
  mpq_class from;
  for (const ImpactPiece& piece : impact.pieces) {
    if (!piece.plane && !piece.near) contradiction("a piece of time has neither a plane nor a gap");
    if (piece.plane && !pair.holding(*piece.plane, from, piece.until).holds)
      contradiction("a plane does not separate the bodies as long as it should");
    from = piece.until;
  }
  if (from != (impact.contact ? impact.contact->t0 : mpq_class(1)))
    contradiction("the planes do not separate the bodies until they meet");
}

void write_rigid_motion(Writer& out, std::string_view name, const RigidMotion& motion) {
  out.word(name).end();
  for (const Quaternion* q : {&motion.q0, &motion.q1}) out.word(q->w).word(q->x).word(q->y).word(q->z).end();
  for (const Point* p : {&motion.p0, &motion.p1}) out.words(*p).end();
}

void write_impact_claim(Writer& out, const Impact& impact) {
  out.word("claim").word(name(impact.status));
  if (impact.contact) out.word(impact.contact->t1);
  out.end();
}

/// Both lists of weights, whose sizes are announced.
void write_both_weights(Writer& out, const std::vector<Weight>& a, const std::vector<Weight>& b,
                        std::vector<std::size_t>& counts) {
  write_weights(out, "weights_a", a);
  write_weights(out, "weights_b", b);
  counts.insert(counts.end(), {a.size(), b.size()});
}

void write_piece(Writer& out, const ImpactPiece& piece, std::vector<std::size_t>& counts) {
  out.word(piece.until);
  if (piece.near) {
    out.word("near").word(piece.near->gap).end();
    write_both_weights(out, piece.near->a, piece.near->b, counts);
    return;
  }
  const MovingPlane& plane = *piece.plane;
  switch (plane.kind) {
    case MovingPlane::Kind::of_b: out.word("b"); break;
    case MovingPlane::Kind::of_a: out.word("a"); break;
    case MovingPlane::Kind::of_edges: out.word("ab"); break;
  }
  out.words(plane.first);
  if (plane.kind == MovingPlane::Kind::of_edges) out.words(plane.second);
  out.end();
}

}  // namespace
}  // namespace fathom::certificate

namespace fathom {

std::string certificate_text(std::span<const Point> a, const RigidMotion& of_a, std::span<const Point> b,
                             const RigidMotion& of_b, const Impact& impact, std::string_view id, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  using namespace certificate;
  if (impact.beginning)
    return certificate_text(placed_at(a, of_a, 0), placed_at(b, of_b, 0), *impact.beginning, id, monitor);
  insist_on_pieces(motion::MovingPair(a, of_a, b, of_b), impact);
  Writer out(64 * (a.size() + b.size() + impact.pieces.size()));
  std::vector<std::size_t> counts{a.size(), b.size(), impact.pieces.size()};
  write_header(out, 6, id);
  write_points(out, "a", a);
  write_points(out, "b", b);
  write_rigid_motion(out, "motion_a", of_a);
  write_rigid_motion(out, "motion_b", of_b);
  write_impact_claim(out, impact);
  out.word("pieces").word(impact.pieces.size()).end();
  for (const ImpactPiece& piece : impact.pieces) write_piece(out, piece, counts);
  if (impact.contact) write_both_weights(out, impact.contact->a, impact.contact->b, counts);
  write_end(out, counts);
  return out.take();
}

}  // namespace fathom
