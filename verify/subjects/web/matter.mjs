// SPDX-License-Identifier: GPL-3.0-or-later
// matter-js.
//   sat   Matter.Collision.collides of two bodies, a separating axis test over Axes.fromVertices, which keeps one normal for each slope to
//         three decimals
import { createRequire } from 'node:module';
import { cornersOf, serve, versionOf } from './engine.mjs';

const { Body, Collision, Vertices } = createRequire(import.meta.url)('matter-js');

function collide(a, b) {
  const found = Collision.collides(a, b);
  return found ? { overlap: true, depth: found.depth, direction: [found.normal.x, found.normal.y] } : { overlap: false };
}

function bodyOf(body) {
  const [x, y] = body.at;
  const vertices = Vertices.clockwiseSort(cornersOf(body).map(([u, v]) => ({ x: u, y: v })));
  const centre = Vertices.centre(vertices);  // Body.create moves this point of the vertices to the position
  return Body.create({ vertices, position: { x: x + centre.x, y: y + centre.y } });
}

await serve({
  name: 'matter', version: versionOf('matter-js'), precision: 'binary64', dimension: 2,
  modes: { sat: { call: 'Collision.collides', depth: 'positive', moves: 'a', ask: collide } },
  make: bodyOf,
  hulls: (a, b) => Object.fromEntries([['a', a], ['b', b]].map(([key, { vertices }]) => [key, vertices.map(({ x, y }) => [x, y])])),
});
