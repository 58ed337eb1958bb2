// SPDX-License-Identifier: GPL-3.0-or-later
// A subject that misbehaves as the first coordinate of A says, and answers about shapes with what it was told of them.
const { rotationOf, run, Unsupported } = await import(process.env.FATHOM_KIT);
console.log('a greeting of a library');

run((a, b) => {
  if (a.shape && b.shape === a.shape)
    return { overlap: true, hull: { a: a.rotation, b: b.quaternion ? rotationOf(b.quaternion) : b.rotation } };
  if (a.shape) {
    const along = a.rotation.map((row) => row['xyz'.indexOf(a.axis)]);
    return { overlap: true, depth: a.radius + a.margin, direction: along,
             witness: { a: a.translation, b: b.shape ? b.half : b.vertices.at(-1) } };
  }
  if (b.pieces.length > 0)
    return { overlap: true, depth: b.pieces.length, witness: { a: a.vertices[0], b: b.pieces.at(-1).vertices.at(-1) } };
  const what = a.vertices[0][0];
  if (what === 1) return { overlap: true, depth: NaN, direction: { x: Infinity, y: -Infinity, z: -0.5 } };
  if (what === 2) {
    console.log('a stray line');
    process.stdout.write('and one from below\n');
  }
  if (what === 3) throw new Error('no "way" out');
  if (what === 4) throw new Unsupported('too flat');
  if (what === 6) return { overlap: true, depth: 0.25, hull: { a: a.vertices } };
  if (what === 7) return { overlap: true, depth: 0.25, contacts: [{ position: a.vertices[0] }, { position: a.vertices[1], depth: 0.25 }] };
  if (what === 8) return { overlap: false, distance: Infinity };
  if (what === 9) throw new Error('half a pair: \ud800');
  if (what === 10) throw new Error('x'.repeat(17 << 20));
  if (what === 11) throw { toString() { throw new Error('no text'); } };
  if (what === 12) return { overlap: true, depth: 1, direction: [1, 0] };
  if (what === 13) return { overlap: true, microseconds: 12.5 };
  if (what === 14) return { overlap: true, witness: { a: a.vertices[1], b: b.vertices[1] } };
  if (what === 15) return { overlap: true, derivative: a.twist.v[0] + b.twist.w[2] };
  return what === 5 ? { overlap: false } : Promise.resolve({ overlap: true, depth: 1 / 3 + a.faces.length });
}, { name: 'trial', version: '7', precision: { points: 'binary32', answers: 'binary64' }, touching: 'overlap', depth: 'negative', moves: 'b', unit: false, faces: true, twist: true,
     shapes: ['capsule', 'box', 'margin'], promises: ['depth'], settings: { limit: '3' }, rounding: { vertices: 0.1, box: 0.25 },
     manifold: { most: 4, margin: 0.125 },
     claims: 'separating', axis: process.env.FATHOM_KIT_AXIS, dimension: process.env.FATHOM_KIT_PLANE ? 2 : 3 });
