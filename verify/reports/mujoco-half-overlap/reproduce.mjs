// SPDX-License-Identifier: CC0-1.0
// npm install @mujoco/mujoco@3.14.0; node reproduce.mjs
import loadMujoco from '@mujoco/mujoco';

const mujoco = await loadMujoco();
const corners = [-0.5, 0.5].flatMap((x) => [-0.5, 0.5].flatMap((y) => [-0.5, 0.5].map((z) => `${x} ${y} ${z}`))).join(' ');
const mesh = 'type="mesh" mesh="cube"', box = 'type="box" size="0.5 0.5 0.5"';

/** The contacts of two unit cubes, the second moved by `shift`: how many, and the deepest. */
function contacts(first, second, shift, flag = '') {
  const body = (geom, at) => `<body pos="${at}"><freejoint/><geom ${geom}/></body>`;
  const model = mujoco.MjModel.from_xml_string(
    `<mujoco><option><flag ${flag}/></option><asset><mesh name="cube" vertex="${corners}"/></asset>` +
    `<worldbody>${body(first, '0 0 0')}${body(second, shift)}</worldbody></mujoco>`);
  const data = new mujoco.MjData(model);
  mujoco.mj_forward(model, data);
  const depths = [...Array(data.ncon).keys()].map((i) => -data.contact.get(i).dist);
  return depths.length ? `${depths.length}, the deepest ${Math.max(...depths).toFixed(4)}` : 'none';
}

console.log(`MuJoCo ${mujoco.mj_versionString()}: contacts of two unit cubes`);
for (const [shift, right] of [['0.5 0 0', 0.5], ['0.75 0.25 0', 0.25], ['0.9 0.1 0', 0.1]]) {
  console.log(`shift ${shift}: right is ${right} deep`);
  console.log(`  mesh, mesh                     ${contacts(mesh, mesh, shift)}`);
  console.log(`  mesh, mesh, multiccd disabled  ${contacts(mesh, mesh, shift, 'multiccd="disable"')}`);
  console.log(`  mesh, mesh, nativeccd disabled ${contacts(mesh, mesh, shift, 'nativeccd="disable"')}`);
  console.log(`  box, mesh                      ${contacts(box, mesh, shift)}`);
  console.log(`  box, box                       ${contacts(box, box, shift)}`);
}
console.log(`shift 0.51 0 0: mesh, mesh ${contacts(mesh, mesh, '0.51 0 0')}`);
