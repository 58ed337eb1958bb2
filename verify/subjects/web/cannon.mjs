// SPDX-License-Identifier: GPL-3.0-or-later
// cannon-es: ConvexPolyhedron.findSeparatingAxis, a separating axis test over all faces and pairs of edges, then
//   sat       testSepAxis along the axis that it found
//   contact   the deepest point of clipAgainstHull, measured along the axis as ContactEquation of Narrowphase.convexConvex does
import { createRequire } from 'node:module';
import { mode, Refused, serve, setting, versionOf } from './engine.mjs';

const C = createRequire(import.meta.url)('cannon-es');  // the package's main file is its CommonJS build
if (setting('warnings', 'off') === 'off') console.warn = console.error = () => {};
const tellsPositions = mode === 'contact' && setting('positions', 0) !== 0;
const still = new C.Quaternion();

function polyhedron({ points, faces }) {
  if (!faces.length) throw new Refused('ConvexPolyhedron needs faces');
  const index = new Map(), vertices = [];
  const corner = (i) => {
    if (!index.has(i)) {
      index.set(i, vertices.length);
      vertices.push(new C.Vec3(...points[i]));
    }
    return index.get(i);
  };
  return new C.ConvexPolyhedron({ faces: faces.map((face) => face.map(corner)), vertices });
}

function axisOf(a, b) {
  const axis = new C.Vec3();
  return a.hull.findSeparatingAxis(b.hull, a.at, a.turn, b.at, b.turn, axis) ? axis : null;
}

function sat(a, b) {
  const axis = axisOf(a, b);
  const depth = axis && a.hull.testSepAxis(axis, b.hull, a.at, a.turn, b.at, b.turn);
  return axis && depth !== false ? { overlap: true, depth, direction: axis.toArray() } : { overlap: false };
}

function contact(a, b) {
  const axis = axisOf(a, b), points = [];
  if (!axis) return { overlap: false };
  a.hull.clipAgainstHull(a.at, a.turn, b.hull, b.at, b.turn, axis, -100, 100, points);
  const contacts = points.map((p) => ({ position: p.point.vsub(p.normal.scale(p.depth)).toArray(), depth: p.depth * p.normal.dot(axis) }))
    .filter(({ depth }) => depth >= 0);
  if (contacts.length === 0) return { overlap: false };
  return { overlap: true, depth: Math.max(...contacts.map(({ depth }) => depth)), direction: axis.toArray(),
           ...(tellsPositions ? { contacts } : {}) };
}

const conventions = { depth: 'positive', moves: 'a', shapes: ['box'] };

await serve({
  name: 'cannon', version: versionOf('cannon-es'), precision: 'binary64',
  modes: {
    sat: { ...conventions, call: 'ConvexPolyhedron.findSeparatingAxis, testSepAxis', ask: sat },
    contact: { ...conventions, claims: 'separating', call: 'ConvexPolyhedron.findSeparatingAxis, clipAgainstHull', ask: contact,
               manifold: tellsPositions && {} },
  },
  make(body) {
    const hull = body.shape ? new C.Box(new C.Vec3(...body.half)).convexPolyhedronRepresentation : polyhedron(body);
    const [w, x, y, z] = body.turn;
    return { hull, at: new C.Vec3(...body.at), turn: body.shape ? new C.Quaternion(x, y, z, w) : still };
  },
});
