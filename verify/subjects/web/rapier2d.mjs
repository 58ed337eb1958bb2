// SPDX-License-Identifier: GPL-3.0-or-later
// Rapier in the plane: the modes of rapier_engine.mjs.
import RAPIER from '@dimforge/rapier2d-compat';
import { angleOf, Refused, Unsupported } from './engine.mjs';
import { hullOf, serveRapier } from './rapier_engine.mjs';

function describe(D, body) {
  const { shape, radius: r, half_length: h, half, margin, faces } = body;
  if (margin > 0 && shape !== 'box') throw new Unsupported(`${shape ?? 'hull'} with margin`);
  switch (shape) {
    case null:
      if (!faces.length) throw new Refused('it has no interior');
      return hullOf(D, body);
    case 'circle': return D.ball(r);
    case 'box': return margin > 0 ? D.roundCuboid(...half, margin) : D.cuboid(...half);
    case 'capsule': return D.capsule(h, r);
    default: throw new TypeError(shape);
  }
}

// Capsules lie along y.
const rotation = ({ shape, axis, turn: [c, s] }) => (shape === 'capsule' && axis === 'x' ? angleOf([s, -c]) : angleOf([c, s]));

await serveRapier(RAPIER, {
  name: 'rapier2d', dimension: 2, shapes: ['circle', 'box', 'capsule', 'margin'], describe, rotation,
  turned: (angle, [x, y]) => [Math.cos(angle) * x - Math.sin(angle) * y, Math.sin(angle) * x + Math.cos(angle) * y],
});
