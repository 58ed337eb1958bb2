// SPDX-License-Identifier: CC0-1.0
// npm install @mujoco/mujoco@3.14.0; node reproduce.mjs
import loadMujoco from '@mujoco/mujoco';

const mujoco = await loadMujoco();
const cube = (h) => [-h, h].flatMap((x) => [-h, h].flatMap((y) => [-h, h].map((z) => `${x} ${y} ${z}`))).join(' ');

/** The contacts of a cube of side 1 and one of side 1/2 at `at`: how many, and the deepest. */
function contacts(small, large, at, flag = '') {
  const body = (geom, place) => `<body pos="${place}"><freejoint/><geom ${geom}/></body>`;
  const model = mujoco.MjModel.from_xml_string(
    `<mujoco><option><flag ${flag}/></option>` +
    `<asset><mesh name="small" vertex="${cube(0.25)}"/><mesh name="large" vertex="${cube(0.5)}"/></asset>` +
    `<worldbody>${body(small, at)}${body(large, '0 0 0')}</worldbody></mujoco>`);
  const data = new mujoco.MjData(model);
  mujoco.mj_forward(model, data);
  const depths = [...Array(data.ncon).keys()].map((i) => -data.contact.get(i).dist);
  return depths.length ? `${depths.length}, the deepest ${Math.max(...depths).toFixed(4)}` : 'none';
}

const mesh = (name) => `type="mesh" mesh="${name}"`, box = (h) => `type="box" size="${h} ${h} ${h}"`;
console.log(`MuJoCo ${mujoco.mj_versionString()}: contacts of a cube of side 1/2 in the middle of a cube of side 1; right is 0.75 deep`);
console.log(`mesh, mesh                     ${contacts(mesh('small'), mesh('large'), '0 0 0')}`);
console.log(`mesh, mesh, multiccd disabled  ${contacts(mesh('small'), mesh('large'), '0 0 0', 'multiccd="disable"')}`);
console.log(`mesh, mesh, nativeccd disabled ${contacts(mesh('small'), mesh('large'), '0 0 0', 'nativeccd="disable"')}`);
console.log(`box, mesh                      ${contacts(box(0.25), mesh('large'), '0 0 0')}`);
console.log(`box, box                       ${contacts(box(0.25), box(0.5), '0 0 0')}`);
console.log(`mesh, mesh, 1 mm off the middle: right is 0.749: ${contacts(mesh('small'), mesh('large'), '0.001 0 0')}`);
