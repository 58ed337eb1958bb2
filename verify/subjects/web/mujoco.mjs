// SPDX-License-Identifier: GPL-3.0-or-later
// MuJoCo: two free bodies of one geom each, compiled as a model; meshes from their vertices alone.
//   native     the deepest contact that mj_collision finds, by its own GJK and EPA with several contacts, as by default
//   single     the same with one contact: multiccd disabled
//   libccd     the same with nativeccd disabled: libccd's MPR
//   distance   mj_geomDistance, which gives points and no direction
// version=3.9.0 takes another version of MuJoCo, one of those of history/package.json.
import { existsSync, readFileSync } from 'node:fs';
import { manifold, mode, note, quiet, refuse, Refused, serve, setting, signed, turnFrom } from './engine.mjs';

const M = await (await engineOf(setting('version', ''))).default(quiet);
const tolerance = setting('ccd_tolerance', 1e-6);
const iterations = setting('ccd_iterations', 35);
const farthest = mode === 'distance' ? setting('distmax', 1e9) : 0;
const tellsPositions = mode !== 'distance' && setting('positions', 0) !== 0;
const limits = tellsPositions && { most: setting('most', 50) };  // mjMAXCONPAIR; of meshes it keeps four
note('multiccd', mode === 'single' ? 'disable' : 'default');
note('nativeccd', mode === 'libccd' ? 'disable' : 'enable');
const flags = `nativeccd="${mode === 'libccd' ? 'disable' : 'enable'}"${mode === 'single' ? ' multiccd="disable"' : ''}`;
const ends = M.DoubleBuffer.FromArray([0, 0, 0, 0, 0, 0]);

function engineOf(version) {
  if (!version) return import('@mujoco/mujoco');
  const folder = new URL(`./history/node_modules/mujoco-${version}/`, import.meta.url);
  if (!/^[\d.]+$/.test(version) || !existsSync(folder)) refuse(`version ${JSON.stringify(version)} is not in history/node_modules`);
  const { main, exports } = JSON.parse(readFileSync(new URL('package.json', folder)));
  return import(new URL(exports?.['.'].import ?? main, folder));
}

// 3.3.8 reads files alone.
function modelOfText(xml) {
  if (M.MjModel.from_xml_string) return M.MjModel.from_xml_string(xml);
  M.FS.writeFile('/pair.xml', xml);
  return M.MjModel.loadFromXML('/pair.xml');
}

function geometry(body, name) {
  const { shape, radius: r, half_length: h, half, radii } = body;
  const size = { sphere: [r], box: half, capsule: [r, h], cylinder: [r, h], ellipsoid: radii }[shape];
  if (shape === null) return `type="mesh" mesh="${name}"`;
  return `type="${shape}" size="${size.join(' ')}" quat="${turnFrom(body, 'z').join(' ')}"`;
}

const meshOf = (body, name, inertia) =>
  body.shape ? '' : `<mesh name="${name}" vertex="${body.points.flat().join(' ')}"${inertia ? ` inertia="${inertia}"` : ''}/>`;
const bodyOf = (body, name) => `<body pos="${body.at.join(' ')}"><freejoint/><inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>` +
  `<geom ${geometry(body, name)}/></body>`;

function compile(a, b, inertia) {
  const model = modelOfText(
    `<mujoco><option ccd_tolerance="${tolerance}" ccd_iterations="${iterations}"><flag ${flags}/></option>` +
    `<asset>${meshOf(a, 'a', inertia)}${meshOf(b, 'b', inertia)}</asset>` +
    `<worldbody>${bodyOf(a, 'a')}${bodyOf(b, 'b')}</worldbody></mujoco>`);
  if (!model) throw new Error('no model');
  const data = new M.MjData(model);
  M.mj_kinematics(model, data);
  M.mj_comPos(model, data);
  return { model, data };
}

const reason = (why) => (typeof why === 'number' && M.getExceptionMessage ? M.getExceptionMessage(why).join(' ') : String(why?.message ?? why));

// A body without volume is compiled as a shell, as MuJoCo's own message advises.
function modelOf(a, b) {
  try {
    return compile(a, b);
  } catch (first) {
    try {
      return compile(a, b, 'shell');
    } catch (second) {
      throw new Refused(`${reason(first)}; as a shell: ${reason(second)}`.replace(/\s+/g, ' ').slice(0, 200));
    }
  }
}

// The corners of the mesh's hull, moved and turned as the geom is: MuJoCo gives a mesh the frame of its inertia.
function verticesOf({ model, data }, geom) {
  const mesh = model.geom_dataid[geom];
  if (mesh < 0) return undefined;
  const first = model.mesh_vertadr[mesh], graph = model.mesh_graphadr[mesh];
  const corners = graph < 0 ? Array.from({ length: model.mesh_vertnum[mesh] }, (_, i) => i)
                            : Array.from({ length: model.mesh_graph[graph] }, (_, i) => model.mesh_graph[graph + 2 + model.mesh_graph[graph] + i]);
  const at = data.geom_xpos.slice(3 * geom, 3 * geom + 3), turn = data.geom_xmat.slice(9 * geom, 9 * geom + 9);
  return corners.map((corner) => {
    const v = model.mesh_vert.slice(3 * (first + corner), 3 * (first + corner) + 3);
    return [0, 1, 2].map((i) => at[i] + turn[3 * i] * v[0] + turn[3 * i + 1] * v[1] + turn[3 * i + 2] * v[2]);
  });
}

function contacts({ model, data }) {
  M.mj_collision(model, data);
  const found = [], list = data.contact;
  for (let i = 0; i < data.ncon; ++i) {
    const contact = list.get(i), sign = contact.geom1 === 0 ? 1 : -1;
    found.push({ depth: contact.dist, direction: Array.from(contact.frame).slice(0, 3).map((x) => sign * x),
                 position: Array.from(contact.pos) });
    contact.delete?.();
  }
  list.delete?.();
  return manifold(found, tellsPositions);
}

function distance({ model, data }) {
  const separation = M.mj_geomDistance(model, data, 0, 1, farthest, ends);
  const [p, q] = [0, 3].map((k) => Array.from(ends.GetView().subarray(k, k + 3)));
  return { ...signed(separation), witness: { a: p, b: q } };
}

const conventions = { depth: 'negative', moves: 'b', shapes: ['sphere', 'box', 'capsule', 'cylinder', 'ellipsoid'] };
// The model holds both bodies: it is made with the second one, and asked with it.
let first = null;

await serve({
  name: 'mujoco', version: M.mj_versionString(), precision: { points: 'binary32', answers: 'binary64' },
  modes: {
    native: { ...conventions, claims: 'separating', call: 'mj_collision', manifold: limits, ask: (a, b) => contacts(b) },
    single: { ...conventions, call: 'mj_collision', manifold: limits, ask: (a, b) => contacts(b) },
    libccd: { ...conventions, call: 'mj_collision', manifold: limits, ask: (a, b) => contacts(b) },
    distance: { ...conventions, call: 'mj_geomDistance', ask: (a, b) => distance(b) },
  },
  make(body) {
    if (!first) return (first = body);
    const a = first;
    first = null;
    return modelOf(a, body);
  },
  hulls: (_, made) => ({ a: verticesOf(made, 0), b: verticesOf(made, 1) }),
  free(made) {
    first = null;
    made.data?.delete();
    made.model?.delete();
  },
});
