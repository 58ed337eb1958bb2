// SPDX-License-Identifier: GPL-3.0-or-later
// Unions of convex pieces for C: bodies, and what answers about them alone tell.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "c/boundary.hpp"
#include "fathom/numbers.hpp"
#include "reference/files/piece_files.hpp"

namespace fathom::c {
namespace {

fathom_body union_of(Pieces pieces) {
  Body body;
  body.pieces = std::make_shared<const Pieces>(std::move(pieces));
  return handle(std::move(body));
}

const std::vector<Point>& piece_from(const fathom_body* piece, const std::string& name) {
  require(piece, name.c_str());
  require_convex(*piece->body, name);
  if (piece->body->shape)
    throw std::invalid_argument(name + ": expected a polytope, found another shape: pieces are neither round nor curved");
  return piece->body->points.exact();
}

}  // namespace
}  // namespace fathom::c

using namespace fathom::c;

int fathom_body_from_pieces(fathom_body* const* pieces, size_t count, fathom_body** body) {
  return make_handle(body, [&] {
    require_count(count, "pieces");
    require(pieces, "pieces");
    fathom::Pieces points;
    for (std::size_t i = 0; i < count; ++i) points.push_back(piece_from(pieces[i], "piece " + std::to_string(i)));
    return union_of(std::move(points));
  });
}

int fathom_body_from_piece_files(const char* path, int decimals, fathom_body** body) {
  return make_handle(body, [&] {
    require(path, "path");
    return handle(fathom::files::read_union(path, decimals_from(decimals)));
  });
}

int fathom_answer_clearance(const fathom_answer* answer, size_t index, int* clearance) {
  return guarded([&] {
    require(answer, "answer");
    require(clearance, "clearance");
    require_way_out(*answer, index);
    const auto* const unions = std::get_if<fathom::UnionDepth>(&answer->found);
    *clearance = !unions || unions->optima[index].clearance ? 1 : 0;
  });
}

int fathom_answer_deepest_pair(const fathom_answer* answer, double* depth, size_t pieces[2]) {
  return guarded([&] {
    require(answer, "answer");
    const fathom::UnionBounds& bounds = bounds_of(*answer);
    if (depth) *depth = fathom::root_binary64(bounds.deepest_pair);
    if (!pieces) return;
    pieces[0] = bounds.a;
    pieces[1] = bounds.b;
  });
}

int fathom_answer_hulls(const fathom_answer* answer, double* depth) {
  return guarded([&] {
    require(answer, "answer");
    require(depth, "depth");
    *depth = fathom::root_binary64(bounds_of(*answer).hulls);
  });
}
