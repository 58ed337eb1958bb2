// SPDX-License-Identifier: GPL-3.0-or-later
// planck, Box2D 2 in JavaScript: the manifold of CollidePolygons, CollidePolygonCircle or CollideCircles, as getWorldManifold places it.
//   manifold   its deepest point
// Polygons have a skin of Settings.polygonRadius, which the bodies of a case do not have and which no user sees: it is taken off again.
import { createRequire } from 'node:module';
import { cornersOf, manifold, mode, note, Refused, serve, setting, versionOf } from './engine.mjs';

const P = createRequire(import.meta.url)('planck');
const { CircleShape, Manifold, PolygonShape, Settings, Transform } = P;
const most = setting('max_polygon_vertices', Settings.maxPolygonVertices);
const tellsPositions = mode === 'manifold' && setting('positions', 0) !== 0;
Settings.maxPolygonVertices = most;
note('polygon_radius', `${Settings.polygonRadius}, taken off`);
note('linear_slop', String(Settings.linearSlop));

function shapeOf(body) {
  if (body.margin > 0) return new CircleShape(body.margin);
  const corners = cornersOf(body, most), shape = new PolygonShape(corners.map(([x, y]) => ({ x, y })));
  // Points that are nearer than half of the slop are welded; with fewer than three left it makes a box of its own.
  if (shape.m_vertices.some(({ x, y }) => !corners.some((p) => p[0] === x && p[1] === y))) throw new Refused('corners within linear_slop / 2');
  return shape;
}

// Circles are no polygons: their radius is what the case says.
const skin = ({ shape }) => (shape.getType() === 'polygon' ? shape.m_radius : 0);

function collide(a, b) {
  const found = new Manifold(), kinds = [a, b].map(({ shape }) => shape.getType()).join(' ');
  if (kinds === 'circle polygon') {  // Box2D takes the polygon first
    const swapped = collide(b, a);
    return swapped.overlap ? { ...swapped, direction: swapped.direction.map((x) => -x) } : swapped;
  }
  const call = { 'polygon polygon': P.CollidePolygons, 'polygon circle': P.CollidePolygonCircle, 'circle circle': P.CollideCircles }[kinds];
  call(found, a.shape, a.place, b.shape, b.place);
  const world = found.getWorldManifold(null, a.place, a.shape.m_radius, b.place, b.shape.m_radius);
  if (!world) return { overlap: false };
  const { normal: { x, y }, separations, points } = world, skins = skin(a) + skin(b);
  return manifold(Array.from({ length: world.pointCount }, (_, i) => ({ depth: separations[i] + skins, direction: [x, y],
                                                                        position: [points[i].x, points[i].y] })), tellsPositions);
}

await serve({
  name: 'planck', version: versionOf('planck'), precision: 'binary64', dimension: 2,
  modes: {
    manifold: { call: 'CollidePolygons, Manifold.getWorldManifold', depth: 'negative', moves: 'b', claims: 'separating',
                shapes: ['circle'], manifold: tellsPositions && { most: 2 }, ask: collide },
  },
  make: (body) => ({ shape: shapeOf(body), place: new Transform({ x: body.at[0], y: body.at[1] }, 0), at: body.at }),
  hulls: (a, b) => Object.fromEntries([['a', a], ['b', b]].filter(([, { shape }]) => shape.getType() === 'polygon')
                                          .map(([key, { shape, at }]) => [key, shape.m_vertices.map((v) => [v.x + at[0], v.y + at[1]])])),
});
