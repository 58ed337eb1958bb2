// SPDX-License-Identifier: GPL-3.0-or-later
// Box2D 3, in WebAssembly.
//   world   the deepest point of b2Body_GetContactData after one step of a new world: what b2CollidePolygons and the calls for
//           other shapes give. Polygons have radius 0 unless a margin is asked for.
import Box2D from 'box2d3-wasm';
import { cornersOf, manifold, mode, note, quiet, Refused, serve, setting, versionOf } from './engine.mjs';

const b2 = await Box2D(quiet);
const most = 8;  // B2_MAX_POLYGON_VERTICES
const tellsPositions = mode === 'world' && setting('positions', 0) !== 0;
const step = setting('step', 1 / 60);
note('max_polygon_vertices', String(most));
note('linear_slop', '0.005');
note('speculative_distance', '0.02');
const vector = ([x, y]) => new b2.b2Vec2(x, y);

function polygonOf(corners, radius) {
  const hull = b2.b2ComputeHull(corners.map(vector));
  if (hull.count === 0) throw new Refused('b2ComputeHull gave no hull');
  return b2.b2MakePolygon(hull, radius);
}

// Adds the shape to the body; returns the polygon that was made, or null.
function attach(bodyId, { points, faces, margin }) {
  const definition = b2.b2DefaultShapeDef();
  if (margin > 0 && points.length === 1) {
    const circle = Object.assign(new b2.b2Circle(), { center: vector(points[0]), radius: margin });
    b2.b2CreateCircleShape(bodyId, definition, circle);
    return null;
  }
  if (margin > 0 && points.length === 2) {
    const capsule = Object.assign(new b2.b2Capsule(), { center1: vector(points[0]), center2: vector(points[1]), radius: margin });
    b2.b2CreateCapsuleShape(bodyId, definition, capsule);
    return null;
  }
  const polygon = polygonOf(cornersOf({ points, faces }, most), margin);
  b2.b2CreatePolygonShape(bodyId, definition, polygon);
  return margin > 0 ? null : polygon;
}

let world = null;  // each pair has a new one
function newWorld() {
  const definition = b2.b2DefaultWorldDef();
  definition.gravity = vector([0, 0]);
  return b2.b2CreateWorld(definition);
}

function collide(a, b) {
  b2.b2World_Step(world, step, 1);
  const contacts = [];
  for (const { manifold: found, shapeIdA } of b2.b2Body_GetContactData(a.id, 16)) {
    const flip = b2.b2Shape_GetBody(shapeIdA).index1 !== a.id.index1;
    const { x, y } = found.normal, direction = flip ? [-x, -y] : [x, y];
    for (let i = 0; i < found.pointCount; ++i) {
      const { separation, point } = found.GetPoint(i);
      contacts.push({ depth: separation, direction, position: [point.x, point.y] });
    }
  }
  return manifold(contacts, tellsPositions);
}

await serve({
  name: 'box2d', version: versionOf('box2d3-wasm'), precision: 'binary32', dimension: 2,
  modes: {
    world: { call: 'b2World_Step, b2Body_GetContactData', depth: 'negative', moves: 'b', claims: 'separating',
             shapes: ['circle', 'capsule', 'margin'], manifold: tellsPositions && { most: 2 }, ask: collide },
  },
  make(body) {
    world ??= newWorld();
    const definition = b2.b2DefaultBodyDef();
    definition.type = b2.b2BodyType.b2_dynamicBody;
    definition.position = vector(body.at);
    const id = b2.b2CreateBody(world, definition);
    return { id, at: body.at, polygon: attach(id, body) };
  },
  free() {
    if (world) b2.b2DestroyWorld(world);
    world = null;
  },
  hulls: (a, b) => Object.fromEntries([['a', a], ['b', b]].filter(([, { polygon }]) => polygon).map(([key, { polygon, at }]) => [
    key, Array.from({ length: polygon.count }, (_, i) => polygon.GetVertex(i)).map(({ x, y }) => [x + at[0], y + at[1]])])),
});
