// SPDX-License-Identifier: CC0-1.0
// npm install cannon-es@0.20.0; node reproduce.mjs
import { createRequire } from 'node:module';

const { Body, Box, ConvexPolyhedron, Vec3, World } = createRequire(import.meta.url)('cannon-es');
const slab = new Box(new Vec3(4, 4, 0.5)).convexPolyhedronRepresentation;  // its top is at z = 0
// A cube of 1 m, about its centre, by its six squares and as a mesh has it; all faces are counter-clockwise from outside.
const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => new Vec3((i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2) - 0.5));
const squares = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
const triangles = squares.flatMap(([a, b, c, d]) => [[a, b, c], [a, c, d]]);

console.log('cannon-es 0.20.0: where a cube of 1 m touches a slab that it lies on, 0.01 deep');
for (const [what, faces] of [['six squares', squares], ['twelve triangles', triangles]]) {
  const world = new World(), place = new Vec3(0, 0, 0.49);
  world.addBody(new Body({ mass: 1, position: place, shape: new ConvexPolyhedron({ vertices: corners, faces }) }));
  world.addBody(new Body({ mass: 0, position: new Vec3(0, 0, -0.5), shape: slab }));
  world.fixedStep();
  console.log(`${what}: ${world.contacts.map(({ ri }) => `(${(place.x + ri.x).toFixed(1)}, ${(place.y + ri.y).toFixed(1)})`).join(' ')}`);
}
