// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two arcs cross, decided on the sphere from the two arcs alone: the yardstick for everything that finds crossings faster.
#pragma once

#include <vector>

#include "kernels/predicates/perturbed_kernel.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"

namespace fathom::gaussian {

/// The signs s for which s (e.circle x f.circle) is a strict crossing: a transversal one, in the interior of both arcs. At most one sign,
/// except for two full circles. With n_i the ends of e, (n1 x n2) x f.circle = n2 <n1,f.circle> - n1 <n2,f.circle> tells which of the two
/// antipodal points of the great circles e meets.
std::vector<kernels::Sign> strict_crossings(const kernels::UnperturbedKernel& kernel, const GaussianDiagram& of_e, const Arc& e,
                                            const GaussianDiagram& of_f, const Arc& f);

/// The same for the perturbed arcs, where every crossing is strict.
std::vector<kernels::Sign> perturbed_crossings(const kernels::PerturbedKernel& kernel, const GaussianDiagram& of_e, const Arc& e,
                                               const GaussianDiagram& of_f, const Arc& f);

/// Whether the closed arc contains u, a direction on its great circle.
bool contains(const GaussianDiagram& diagram, const Arc& arc, const Vector& u);

/// Whether the closed arcs have a point in common. True for arcs of one great circle only if an end of one lies on the other.
bool touch(const GaussianDiagram& of_e, const Arc& e, const GaussianDiagram& of_f, const Arc& f);

}  // namespace fathom::gaussian
