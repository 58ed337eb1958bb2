// SPDX-License-Identifier: GPL-3.0-or-later
// Rapier in the plane: the modes of rapier_engine.mjs.
import RAPIER from '@dimforge/rapier2d-compat';
import { Refused } from './engine.mjs';
import { hullOf, serveRapier } from './rapier_engine.mjs';

// The vector from one end of a capsule's core to the other; null of other bodies.
const coreOf = ({ points: [p, q, ...more], margin }) => (margin > 0 && q && !more.length ? [q[0] - p[0], q[1] - p[1]] : null);

function describe(D, body) {
  const { points, faces, margin } = body, core = coreOf(body);
  if (core) return D.capsule(Math.hypot(...core) / 2, margin);
  if (margin > 0 && points.length === 1) return D.ball(margin);
  if (!faces.length) throw new Refused('it has no interior');
  return margin > 0 ? D.roundConvexHull(new Float32Array(points.flat()), margin) : hullOf(D, body);
}

// Capsules lie along y.
function rotation(body) {
  const core = coreOf(body);
  return core ? Math.atan2(-core[0], core[1]) : 0;
}

await serveRapier(RAPIER, {
  name: 'rapier2d', dimension: 2, shapes: ['circle', 'capsule', 'margin'], describe, rotation,
  hulls: (a, b) => Object.fromEntries([['a', a], ['b', b]].filter(([, { body }]) => !(body.margin > 0)).map(([key, { collider, at }]) => {
    const numbers = Array.from(collider.vertices());
    return [key, Array.from({ length: numbers.length / 2 }, (_, i) => [numbers[2 * i] + at[0], numbers[2 * i + 1] + at[1]])];
  })),
  turned: (angle, [x, y]) => [Math.cos(angle) * x - Math.sin(angle) * y, Math.sin(angle) * x + Math.cos(angle) * y],
});
