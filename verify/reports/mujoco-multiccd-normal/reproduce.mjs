// SPDX-License-Identifier: CC0-1.0
// npm install @mujoco/mujoco@3.14.0; node reproduce.mjs
import loadMujoco from '@mujoco/mujoco';

const mujoco = await loadMujoco();
const a = [[0, 0, 1], [-3, 2, 0], [0, 0, 0], [1, 0, 0]];
const b = [[-1, 0, 0], [-3, 4, 1], [0, 0, 1], [-2, 0, 0]];

const dot = (p, q) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
/** By how much A and B overlap along a unit normal that points from A to B: only so far apart a plane across it can pass between them. */
const overlapAlong = (n) => Math.max(...a.map((p) => dot(p, n))) - Math.min(...b.map((p) => dot(p, n)));

function contacts(flag) {
  const body = (mesh) => `<body><freejoint/><geom type="mesh" mesh="${mesh}"/></body>`;
  const model = mujoco.MjModel.from_xml_string(
    `<mujoco><option><flag ${flag}/></option>` +
    `<asset><mesh name="a" vertex="${a.flat().join(' ')}"/><mesh name="b" vertex="${b.flat().join(' ')}"/></asset>` +
    `<worldbody>${body('a')}${body('b')}</worldbody></mujoco>`);
  const data = new mujoco.MjData(model);
  mujoco.mj_forward(model, data);
  return [...Array(data.ncon).keys()].map((i) => {
    const contact = data.contact.get(i), sign = contact.geom1 === 0 ? 1 : -1;
    return { dist: contact.dist, normal: Array.from(contact.frame).slice(0, 3).map((x) => sign * x) };
  });
}

console.log(`MuJoCo ${mujoco.mj_versionString()}: two tetrahedra; right is ${Math.sqrt(4 / 125).toFixed(6)} deep, across two edges`);
for (const [name, flag] of [['multiccd, as by default', ''], ['multiccd disabled', 'multiccd="disable"']])
  for (const { dist, normal } of contacts(flag))
    console.log(`${name}: ${(-dist).toFixed(6)} deep along (${normal.map((x) => x.toFixed(4)).join(' ')}), ` +
                `along which they overlap by ${overlapAlong(normal).toFixed(6)}`);
