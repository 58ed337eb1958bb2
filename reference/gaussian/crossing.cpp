// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/gaussian/gaussian_diagram.hpp"

namespace fathom::gaussian {
namespace {

// How the arc's interior crosses the circle. A full circle does both.
struct Senses {
  bool leaves = false;  // the circle's positive side
  bool enters = false;
};

template <class Kernel>
Senses crossing_senses(const Kernel& kernel, const GaussianDiagram& diagram, const Arc& arc, const kernels::Direction& circle) {
  if (diagram.rank == 1) return {true, true};
  const kernels::Sign from = kernel.side_of_arc(diagram.nodes[arc.from], circle);
  const kernels::Sign to = kernel.side_of_arc(diagram.nodes[arc.to], circle);
  if (from * to != kernels::Sign::negative) return {};
  return {from == kernels::Sign::positive, to == kernels::Sign::positive};
}

template <class Kernel>
std::vector<kernels::Sign> crossings(const Kernel& kernel, const GaussianDiagram& of_e, const Arc& e, const GaussianDiagram& of_f,
                                     const Arc& f) {
  const Senses of_arc_e = crossing_senses(kernel, of_e, e, f.circle);
  if (!of_arc_e.leaves && !of_arc_e.enters) return {};
  const Senses of_arc_f = crossing_senses(kernel, of_f, f, e.circle);
  std::vector<kernels::Sign> signs;
  if (of_arc_e.enters && of_arc_f.leaves) signs.push_back(kernels::Sign::negative);
  if (of_arc_e.leaves && of_arc_f.enters) signs.push_back(kernels::Sign::positive);
  return signs;
}

}  // namespace

std::vector<kernels::Sign> strict_crossings(const kernels::UnperturbedKernel& kernel, const GaussianDiagram& of_e, const Arc& e,
                                            const GaussianDiagram& of_f, const Arc& f) {
  // Two full circles may coincide; other arcs of one circle have a zero at an end.
  if (of_e.rank == 1 && of_f.rank == 1 && is_zero(cross(e.circle.exact(), f.circle.exact()))) return {};
  return crossings(kernel, of_e, e, of_f, f);
}

std::vector<kernels::Sign> perturbed_crossings(const kernels::PerturbedKernel& kernel, const GaussianDiagram& of_e, const Arc& e,
                                               const GaussianDiagram& of_f, const Arc& f) {
  return crossings(kernel, of_e, e, of_f, f);
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

}  // namespace fathom::gaussian
