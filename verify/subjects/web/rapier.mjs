// SPDX-License-Identifier: GPL-3.0-or-later
// Rapier in space: the modes of rapier_engine.mjs.
import RAPIER from '@dimforge/rapier3d-compat';
import { turned, turnFrom, Unsupported } from './engine.mjs';
import { hullOf, serveRapier } from './rapier_engine.mjs';

function describe(D, body) {
  const { shape, radius: r, half_length: h, half, margin } = body;
  if (margin > 0 && !['box', 'cylinder', 'cone'].includes(shape)) throw new Unsupported(`${shape ?? 'hull'} with margin`);
  switch (shape) {
    case null: return hullOf(D, body);
    case 'sphere': return D.ball(r);
    case 'box': return margin > 0 ? D.roundCuboid(...half, margin) : D.cuboid(...half);
    case 'capsule': return D.capsule(h, r);
    case 'cylinder': return margin > 0 ? D.roundCylinder(h, r, margin) : D.cylinder(h, r);
    case 'cone': return margin > 0 ? D.roundCone(h, r, margin) : D.cone(h, r);
    default: throw new TypeError(shape);
  }
}

function rotation(body) {
  const [w, x, y, z] = body.shape ? turnFrom(body, 'y') : body.turn;
  return { w, x, y, z };
}

await serveRapier(RAPIER, {
  name: 'rapier', dimension: 3, shapes: ['sphere', 'box', 'capsule', 'cylinder', 'cone', 'margin'], describe, rotation,
  turned: ({ w, x, y, z }, v) => turned([w, x, y, z], v),
});
