// SPDX-License-Identifier: GPL-3.0-or-later
// Rapier, whose collisions are parry's.
//   contact   Collider.contactCollider, parry's query::contact: GJK and EPA
//   world     the deepest point of World.contactPair after one step of a new world: the manifold that the solver sees
import RAPIER from '@dimforge/rapier3d-compat';
import { manifold, mode, quiet, Refused, serve, setting, signed, turned, turnFrom, Unsupported } from './engine.mjs';

console.warn = quiet.printErr;
await RAPIER.init();
const prediction = mode === 'contact' ? setting('prediction', 1e9) : 0;  // how far bodies that are apart are looked at
const tellsPositions = mode === 'world' && setting('positions', 0) !== 0;
const plain = (v) => [v.x, v.y, v.z];
const newWorld = () => new RAPIER.World({ x: 0, y: 0, z: 0 });
let world = newWorld();

function describe(body) {
  const { shape, radius: r, half_length: h, half, margin } = body, D = RAPIER.ColliderDesc;
  if (margin > 0 && !['box', 'cylinder', 'cone'].includes(shape)) throw new Unsupported(`${shape ?? 'hull'} with margin`);
  switch (shape) {
    case null: {
      const hull = D.convexHull(new Float32Array(body.points.flat()));
      if (!hull) throw new Refused('ColliderDesc.convexHull gave null');
      return hull;
    }
    case 'sphere': return D.ball(r);
    case 'box': return margin > 0 ? D.roundCuboid(...half, margin) : D.cuboid(...half);
    case 'capsule': return D.capsule(h, r);
    case 'cylinder': return margin > 0 ? D.roundCylinder(h, r, margin) : D.cylinder(h, r);
    case 'cone': return margin > 0 ? D.roundCone(h, r, margin) : D.cone(h, r);
    default: throw new TypeError(shape);
  }
}

function contact(a, b) {
  const found = a.collider.contactCollider(b.collider, prediction);
  if (!found) return { overlap: false };
  return { ...signed(found.distance), direction: plain(found.normal1), witness: { a: plain(found.point1), b: plain(found.point2) } };
}

function inWorld(a, b) {
  world.step();
  const contacts = [];
  world.contactPair(a.collider, b.collider, (found, flipped) => {
    const direction = plain(found.normal()).map((x) => (flipped ? -x : x));
    const [one, two] = flipped ? [b, a] : [a, b];
    for (let i = 0; i < found.numContacts(); ++i) {
      const p = inTheWorld(one, found.localContactPoint1(i)), q = inTheWorld(two, found.localContactPoint2(i));
      contacts.push({ depth: found.contactDist(i), direction, position: p.map((x, k) => (x + q[k]) / 2) });
    }
  });
  return manifold(contacts, tellsPositions);
}

// A point of a collider's frame, where its body was before the step.
const inTheWorld = ({ at, turn }, point) => turned(turn, plain(point)).map((x, k) => x + at[k]);

const shapes = ['sphere', 'box', 'capsule', 'cylinder', 'cone', 'margin'];
const conventions = { depth: 'negative', moves: 'b', shapes };

await serve({
  name: 'rapier', version: RAPIER.version(), precision: 'binary32',
  modes: {
    contact: { ...conventions, call: 'Collider.contactCollider', ask: contact },
    world: { ...conventions, claims: 'separating', call: 'World.step, World.contactPair', manifold: tellsPositions && {}, ask: inWorld },
  },
  make(body) {
    const description = describe(body);
    const [w, x, y, z] = body.shape ? turnFrom(body, 'y') : body.turn;
    const kind = mode === 'world' ? RAPIER.RigidBodyDesc.dynamic() : RAPIER.RigidBodyDesc.fixed();
    const rigid = world.createRigidBody(kind.setTranslation(...body.at).setRotation({ w, x, y, z }));
    try {
      return { rigid, collider: world.createCollider(description, rigid), at: body.at, turn: [w, x, y, z] };
    } catch (why) {  // a hull that parry refuses shows here only
      world.removeRigidBody(rigid);
      throw /expected instance/.test(why?.message) ? new Refused('parry makes no hull of these points') : why;
    }
  },
  free({ rigid }) {
    if (mode === 'contact') world.removeRigidBody(rigid);
    else if (world.getRigidBody(rigid.handle)) {  // what a world answers depends on the pairs before: each pair has a new one
      world.free();
      world = newWorld();
    }
  },
});
