// SPDX-License-Identifier: CC0-1.0
// npm install cannon-es@0.20.0; node reproduce.mjs
import { createRequire } from 'node:module';

const { Body, ConvexPolyhedron, Box, Quaternion, Vec3, World } = createRequire(import.meta.url)('cannon-es');
const still = new Quaternion(), ground = new Vec3(0, 0, 0);
// A square pyramid, 2 m high, about its centre of mass; its faces are counter-clockwise from outside.
const pyramid = new ConvexPolyhedron({
  vertices: [[-1, -1, -0.5], [1, -1, -0.5], [1, 1, -0.5], [-1, 1, -0.5], [0, 0, 1.5]].map((p) => new Vec3(...p)),
  faces: [[3, 2, 1, 0], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
});
const slab = new Box(new Vec3(2, 2, 0.125));  // from z = -0.125 to 0.125

console.log('cannon-es 0.20.0: a pyramid of 2 m whose base has sunk through a slab of 0.25 m');
for (const base of [0, -0.375, -0.625, -0.875]) {
  const at = new Vec3(0, 0, base + 0.5), axis = new Vec3();
  pyramid.findSeparatingAxis(slab.convexPolyhedronRepresentation, at, still, ground, still, axis);
  const depth = pyramid.testSepAxis(axis, slab.convexPolyhedronRepresentation, at, still, ground, still);
  const up = 0.125 - base, down = base + 2 + 0.125;
  console.log(`base at ${base}: depth ${depth.toFixed(3)}, move the pyramid ${axis.z > 0 ? 'up' : 'down'}; ` +
              `right: up by ${up.toFixed(3)}, down it is ${down.toFixed(3)}`);
}

/** Where the pyramid is after a second in a world without gravity. */
function settled(base) {
  const world = new World();
  world.addBody(new Body({ mass: 0, shape: slab }));
  const body = new Body({ mass: 1, shape: pyramid, position: new Vec3(0, 0, base + 0.5) });
  world.addBody(body);
  for (let i = 0; i < 60; ++i) world.fixedStep();
  return body.position.z - 0.5;
}
for (const base of [-0.375, -0.625]) console.log(`a second in a world, base from ${base}: it went ${settled(base) > base ? 'up' : 'down'}`);
