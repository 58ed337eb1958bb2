// SPDX-License-Identifier: GPL-3.0-or-later
// matter-js.
//   sat   Matter.Collision.collides of two bodies, a separating axis test over Axes.fromVertices, which keeps one normal for each slope to
//         three decimals
import { createRequire } from 'node:module';
import { angleOf, cornersOf, serve, versionOf } from './engine.mjs';

const { Bodies, Body, Collision, Vertices } = createRequire(import.meta.url)('matter-js');

function collide(a, b) {
  const found = Collision.collides(a, b);
  return found ? { overlap: true, depth: found.depth, direction: [found.normal.x, found.normal.y] } : { overlap: false };
}

function bodyOf(body) {
  const [x, y] = body.at;
  if (body.shape) return Bodies.rectangle(x, y, 2 * body.half[0], 2 * body.half[1], { angle: angleOf(body.turn) });
  const vertices = Vertices.clockwiseSort(cornersOf(body).map(([u, v]) => ({ x: u, y: v })));
  const centre = Vertices.centre(vertices);  // Body.create moves this point of the vertices to the position
  return Body.create({ vertices, position: { x: x + centre.x, y: y + centre.y } });
}

await serve({
  name: 'matter', version: versionOf('matter-js'), precision: 'binary64', dimension: 2,
  modes: { sat: { call: 'Collision.collides', depth: 'positive', moves: 'a', shapes: ['box'], ask: collide } },
  make: (body) => Object.assign(bodyOf(body), { asked: body.shape }),
  hulls: (a, b) => Object.fromEntries([['a', a], ['b', b]].filter(([, { asked }]) => !asked)
                                          .map(([key, { vertices }]) => [key, vertices.map(({ x, y }) => [x, y])])),
});
