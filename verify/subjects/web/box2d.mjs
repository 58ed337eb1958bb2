// SPDX-License-Identifier: GPL-3.0-or-later
// Box2D 3, in WebAssembly.
//   world   the deepest point of b2Body_GetContactData after one step of a new world: what b2CollidePolygons and the calls for
//           other shapes give. Polygons have radius 0 unless a margin is asked for.
import Box2D from 'box2d3-wasm';
import { cornersOf, manifold, mode, note, quiet, Refused, serve, setting, Unsupported, versionOf } from './engine.mjs';

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

const boxCorners = ([x, y]) => [[x, -y], [x, y], [-x, y], [-x, -y]];

// Adds the shape to the body; returns the polygon that was made, or null.
function attach(bodyId, body) {
  const definition = b2.b2DefaultShapeDef(), margin = body.margin ?? 0;
  switch (body.shape) {
    case 'circle': case 'capsule': {
      if (margin > 0) throw new Unsupported(`${body.shape} with margin`);
      const end = body.shape === 'circle' ? 0 : body.half_length, along = body.axis === 'y' ? [0, end] : [end, 0];
      if (body.shape === 'circle') {
        const circle = new b2.b2Circle();
        circle.center = vector([0, 0]), circle.radius = body.radius;
        b2.b2CreateCircleShape(bodyId, definition, circle);
      } else {
        const capsule = new b2.b2Capsule();
        capsule.center1 = vector(along.map((x) => -x)), capsule.center2 = vector(along), capsule.radius = body.radius;
        b2.b2CreateCapsuleShape(bodyId, definition, capsule);
      }
      return null;
    }
    default: {
      const polygon = polygonOf(body.shape ? boxCorners(body.half) : cornersOf(body, most), margin);
      b2.b2CreatePolygonShape(bodyId, definition, polygon);
      return body.shape ? null : polygon;
    }
  }
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
             shapes: ['circle', 'capsule', 'box', 'margin'], manifold: tellsPositions && { most: 2 }, ask: collide },
  },
  make(body) {
    world ??= newWorld();
    const definition = b2.b2DefaultBodyDef();
    definition.type = b2.b2BodyType.b2_dynamicBody;
    definition.position = vector(body.at);
    definition.rotation = Object.assign(new b2.b2Rot(), { c: body.turn[0], s: body.turn[1] });  // b2MakeRot is an approximation
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
