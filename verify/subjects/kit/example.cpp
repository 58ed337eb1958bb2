// SPDX-License-Identifier: Apache-2.0
// A subject on fathom_subject.hpp: the boxes around two bodies, which are right about boxes along
// the axes.
#include <algorithm>
#include <fathom_subject.hpp>

namespace {

using fathom_subject::Body, fathom_subject::Reply, fathom_subject::Vector;

Reply solve(const Body& a, const Body& b) {
  Reply reply;
  reply.depth = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto less = [axis](const Vector& p, const Vector& q) { return p[axis] < q[axis]; };
    const auto [low_a, high_a] = std::minmax_element(a.vertices.begin(), a.vertices.end(), less);
    const auto [low_b, high_b] = std::minmax_element(b.vertices.begin(), b.vertices.end(), less);
    const double up = (*high_b)[axis] - (*low_a)[axis], down = (*high_a)[axis] - (*low_b)[axis];
    if (std::min(up, down) >= *reply.depth) continue;
    reply.depth = std::min(up, down);
    reply.direction = Vector{};
    (*reply.direction)[axis] = up < down ? 1 : -1;
  }
  reply.overlap = *reply.depth > 0;
  return reply;
}

}  // namespace

int main() { return fathom_subject::run({"boxes-cpp", "1"}, solve); }
