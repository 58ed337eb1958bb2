// SPDX-License-Identifier: GPL-3.0-or-later
// Rapier, whose collisions are parry's, in space and in the plane.
//   contact   Collider.contactCollider, parry's query::contact: GJK and EPA
//   world     the deepest point of World.contactPair after one step of a new world: the manifold that the solver sees
import { manifold, mode, quiet, Refused, serve, setting, signed } from './engine.mjs';

/**
 * Serves one of the two packages, in whose modes `prefix` goes before the words above.
 *
 * describe(D, body)   the ColliderDesc (D) of a placed body; throws Refused where there is none
 * rotation(body)      the turn of its collider, as the package takes it
 * turned(turn, v)     the vector that this turns v to
 * hulls               as serve takes it
 */
export async function serveRapier(RAPIER, { name, dimension, shapes, describe, rotation, turned, hulls }) {
  console.warn = quiet.printErr;
  await RAPIER.init();
  const prediction = mode === 'contact' ? setting('prediction', 1e9) : 0;  // how far bodies that are apart are looked at
  const tellsPositions = mode === 'world' && setting('positions', 0) !== 0;
  const zero = dimension === 2 ? { x: 0, y: 0 } : { x: 0, y: 0, z: 0 };
  const plain = (v) => (dimension === 2 ? [v.x, v.y] : [v.x, v.y, v.z]);
  const newWorld = () => new RAPIER.World(zero);
  let world = newWorld();

  function contact(a, b) {
    const found = a.collider.contactCollider(b.collider, prediction);
    if (!found) return { overlap: false };
    return { ...signed(found.distance), direction: plain(found.normal1), witness: { a: plain(found.point1), b: plain(found.point2) } };
  }

  // A point of a collider's frame, where its body was before the step.
  const inTheWorld = ({ at, turn }, point) => turned(turn, plain(point)).map((x, k) => x + at[k]);

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

  const conventions = { depth: 'negative', moves: 'b', shapes };
  await serve({
    name, version: RAPIER.version(), precision: 'binary32', dimension,
    modes: {
      contact: { ...conventions, call: 'Collider.contactCollider', ask: contact },
      world: { ...conventions, claims: 'separating', call: 'World.step, World.contactPair', manifold: tellsPositions && {}, ask: inWorld },
    },
    make(body) {
      const description = describe(RAPIER.ColliderDesc, body), turn = rotation(body);
      const kind = mode === 'world' ? RAPIER.RigidBodyDesc.dynamic() : RAPIER.RigidBodyDesc.fixed();
      const rigid = world.createRigidBody(kind.setTranslation(...body.at).setRotation(turn));
      try {
        return { rigid, collider: world.createCollider(description, rigid), at: body.at, turn, body };
      } catch (why) {  // a hull that parry refuses shows here only
        world.removeRigidBody(rigid);
        throw /expected instance/.test(why?.message) ? new Refused('parry makes no hull of these points') : why;
      }
    },
    hulls,
    free({ rigid }) {
      if (mode === 'contact') world.removeRigidBody(rigid);
      else if (world.getRigidBody(rigid.handle)) {  // what a world answers depends on the pairs before: each pair has a new one
        world.free();
        world = newWorld();
      }
    },
  });
}

/** The hull of a placed body's points. */
export function hullOf(D, { points }) {
  const hull = D.convexHull(new Float32Array(points.flat()));
  if (!hull) throw new Refused('ColliderDesc.convexHull gave null');
  return hull;
}
