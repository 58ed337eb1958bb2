// SPDX-License-Identifier: CC0-1.0
// npm install @dimforge/rapier3d-compat@0.21.0; node reproduce.mjs
import RAPIER from '@dimforge/rapier3d-compat';

console.warn = () => {};  // about how init is called
await RAPIER.init();
const corners = (h) => new Float32Array([-h, h].flatMap((x) => [-h, h].flatMap((y) => [-h, h].flatMap((z) => [x, y, z]))));
const hull = (h = 0.5) => RAPIER.ColliderDesc.convexHull(corners(h)), cuboid = () => RAPIER.ColliderDesc.cuboid(0.5, 0.5, 0.5);

/** The contact of two cubes, the second moved by `shift`. */
function contact(first, second, shift, prediction = 0) {
  const world = new RAPIER.World({ x: 0, y: 0, z: 0 });
  const a = world.createCollider(first), b = world.createCollider(second.setTranslation(...shift));
  const { distance, normal1: n } = a.contactCollider(b, prediction);
  world.free();
  return `depth ${(-distance).toFixed(4)} along (${[n.x, n.y, n.z].map((x) => (x + 0).toFixed(4)).join(' ')})`;
}

console.log(`Rapier ${RAPIER.version()}: contactCollider of two unit cubes`);
for (const shift of [0.1, 2 / 3, 0.75]) {
  console.log(`shift (${shift.toFixed(4)} 0 0): right is depth ${(1 - shift).toFixed(4)} along (1 0 0)`);
  console.log(`  hulls                   ${contact(hull(), hull(), [shift, 0, 0])}`);
  console.log(`  hulls, prediction 0.1   ${contact(hull(), hull(), [shift, 0, 0], 0.1)}`);
  console.log(`  hull, cuboid            ${contact(hull(), cuboid(), [shift, 0, 0])}`);
  console.log(`  cuboids                 ${contact(cuboid(), cuboid(), [shift, 0, 0])}`);
}
console.log(`shift (0.74 0 0): hulls ${contact(hull(), hull(), [0.74, 0, 0])}`);
console.log(`side 10, shift (1 0 0), right is 9 along (1 0 0): hulls ${contact(hull(5), hull(5), [1, 0, 0])}`);
