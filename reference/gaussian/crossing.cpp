// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/gaussian/crossing.hpp"

#include "kernels/predicates/filter.hpp"

namespace fathom {
namespace {

// The sign of the point in which the arc's interior crosses the circle: 1 where the arc leaves the circle's positive side, -1 where it
// enters it, 0 for none, 2 for a full circle, which does both.
template <class Side>
int crossing_sense(const GaussianDiagram& diagram, const Arc& arc, const Direction& circle, Side side) {
  if (diagram.rank == 1) return 2;
  const int from = side(diagram.nodes[arc.from], circle);
  const int to = side(diagram.nodes[arc.to], circle);
  return from * to < 0 ? from : 0;
}

template <class Side>
std::vector<int> crossings(const GaussianDiagram& of_e, const Arc& e, const GaussianDiagram& of_f, const Arc& f, Side side) {
  const int e_sense = crossing_sense(of_e, e, f.circle, side);
  if (e_sense == 0) return {};
  const int f_sense = crossing_sense(of_f, f, e.circle, side);
  if (f_sense == 0) return {};
  std::vector<int> signs;
  for (const int sign : {-1, 1}) {
    if ((e_sense == 2 || e_sense == sign) && (f_sense == 2 || f_sense == -sign)) signs.push_back(sign);
  }
  return signs;
}

}  // namespace

std::vector<int> strict_crossings(const GaussianDiagram& of_e, const Arc& e, const GaussianDiagram& of_f, const Arc& f) {
  // Two full circles may coincide; other arcs of one circle have a zero at an end.
  if (of_e.rank == 1 && of_f.rank == 1 && is_zero(cross(e.circle.exact(), f.circle.exact()))) return {};
  return crossings(of_e, e, of_f, f, side_of_arc);
}

std::vector<int> perturbed_crossings(const Perturbation& perturbation, const GaussianDiagram& of_e, const Arc& e,
                                     const GaussianDiagram& of_f, const Arc& f) {
  return crossings(of_e, e, of_f, f, [&](const Direction& n, const Direction& d) { return perturbed_side_of_arc(perturbation, n, d); });
}

bool contains(const GaussianDiagram& diagram, const Arc& arc, const Vector& u) {
  if (diagram.rank == 1) return true;
  const Vector& from = diagram.nodes[arc.from].exact();
  const Vector& to = diagram.nodes[arc.to].exact();
  // On an arc shorter than pi only its own directions pass both; on a half-circle the second condition repeats the first.
  return det(from, u, arc.circle.exact()) >= 0 && det(u, to, arc.circle.exact()) >= 0;
}

bool touch(const GaussianDiagram& of_e, const Arc& e, const GaussianDiagram& of_f, const Arc& f) {
  const Vector w = cross(e.circle.exact(), f.circle.exact());
  if (!is_zero(w)) return (contains(of_e, e, w) && contains(of_f, f, w)) || (contains(of_e, e, -w) && contains(of_f, f, -w));
  if (of_e.rank == 1 || of_f.rank == 1) return true;
  return contains(of_e, e, of_f.nodes[f.from].exact()) || contains(of_e, e, of_f.nodes[f.to].exact()) ||
         contains(of_f, f, of_e.nodes[e.from].exact()) || contains(of_f, f, of_e.nodes[e.to].exact());
}

}  // namespace fathom
