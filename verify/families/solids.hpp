// SPDX-License-Identifier: GPL-3.0-or-later
// Named solids with rational vertices, centred at O, of size about 1.
#pragma once

namespace fathom::families {

Body box(const mpq_class& half_x, const mpq_class& half_y, const mpq_class& half_z);
Body tetrahedron();  ///< regular: four corners of the cube [-1,1]^3
Body cube();         ///< [-1,1]^3
Body octahedron();   ///< +-e_i
/// Twelve pentagons, exactly planar (a pyritohedron), with 55/89 for the reciprocal of the golden ratio.
Body dodecahedron();
/// Twenty triangles, with 89/55 for the golden ratio.
Body icosahedron();
/// The five above, in this order, by index modulo 5.
Body platonic(unsigned index);

/// On the near-regular n-gon of radius 1 (see circle.hpp), along z from -half_height to half_height; turned by `phase` / 4 of a step.
Body prism(unsigned n, const mpq_class& half_height, unsigned phase = 0);
/// The same with the upper polygon turned by half a step: a band of 2n triangles.
Body antiprism(unsigned n, const mpq_class& half_height);

}  // namespace fathom::families
