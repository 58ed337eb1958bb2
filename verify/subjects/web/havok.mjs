// SPDX-License-Identifier: GPL-3.0-or-later
// Havok for the Web: HP_World_ShapeProximityWithCollector, A as the query's shape, B as the only body of the world. Havok rounds hulls by a
// fixed radius of some 8.7 mm, which no call changes.
import HavokPhysics from '@babylonjs/havok';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { nearest, note, quiet, Refused, serve, setting, turned } from './engine.mjs';

const binary = createRequire(import.meta.url).resolve('@babylonjs/havok/lib/esm/HavokPhysics.wasm');
const H = await HavokPhysics({ ...quiet, wasmBinary: readFileSync(binary) });  // it would fetch a file: address, which node cannot
const { version } = JSON.parse(readFileSync(binary.replace(/lib.esm.HavokPhysics.wasm$/, 'package.json')));
const farthest = setting('max_distance', 1e3);
note('hulls', 'rounded by about 8.7e-3');
const upright = [0, 0, 0, 1], nobody = [0n];

function ok(answer, what) {
  const [result, value] = Array.isArray(answer) ? answer : [answer];
  if (result !== H.Result.RESULT_OK && result?.value !== H.Result.RESULT_OK.value) throw new Error(`${what}: ${result?.value ?? result}`);
  return value;
}
const world = ok(H.HP_World_Create(), 'HP_World_Create');
const collector = ok(H.HP_QueryCollector_Create(4), 'HP_QueryCollector_Create');

function hull(points) {
  const memory = H._malloc(points.length * 12);
  new Float32Array(H.HEAPU8.buffer, memory, points.length * 3).set(points.flat());
  const [result, shape] = H.HP_Shape_CreateConvexHull(memory, points.length);
  H._free(memory);
  if (result !== H.Result.RESULT_OK) throw new Refused('HP_Shape_CreateConvexHull failed');
  return shape;
}

// Its ends are given as points, so an axis is no rotation.
function primitive({ shape, axis, radius: r, half_length: h, half }) {
  const end = (sign) => ['x', 'y', 'z'].map((name) => (name === axis ? sign * h : 0));
  switch (shape) {
    case 'sphere': return ok(H.HP_Shape_CreateSphere([0, 0, 0], r), 'HP_Shape_CreateSphere');
    case 'box': return ok(H.HP_Shape_CreateBox([0, 0, 0], upright, half.map((x) => 2 * x)), 'HP_Shape_CreateBox');
    case 'capsule': return ok(H.HP_Shape_CreateCapsule(end(-1), end(1), r), 'HP_Shape_CreateCapsule');
    case 'cylinder': return ok(H.HP_Shape_CreateCylinder(end(-1), end(1), r), 'HP_Shape_CreateCylinder');
    default: throw new TypeError(shape);
  }
}

function ask(a, b) {
  ok(H.HP_World_AddBody(world, b.body, false), 'HP_World_AddBody');
  b.isAdded = true;
  ok(H.HP_World_ShapeProximityWithCollector(world, collector, [a.shape, a.at, a.turn, farthest, false, nobody]),
     'HP_World_ShapeProximityWithCollector');
  const contacts = [];
  for (let i = 0; i < ok(H.HP_QueryCollector_GetNumHits(collector), 'HP_QueryCollector_GetNumHits'); ++i) {
    const [depth, onA, onB] = ok(H.HP_QueryCollector_GetShapeProximityResult(collector, i), 'HP_QueryCollector_GetShapeProximityResult');
    const [x, y, z, w] = a.turn;  // points on A come in its frame
    contacts.push({ depth, direction: onB[4], witness: { a: turned([w, x, y, z], onA[3]).map((c, k) => c + a.at[k]), b: onB[3] } });
  }
  return nearest(contacts);
}

await serve({
  name: 'havok', version, precision: 'binary32',
  modes: { proximity: { call: 'HP_World_ShapeProximityWithCollector', depth: 'negative', moves: 'a',
                        shapes: ['sphere', 'box', 'capsule', 'cylinder'], ask } },
  make(placed) {
    const shape = placed.shape ? primitive(placed) : hull(placed.points);
    const [w, x, y, z] = placed.turn, turn = [x, y, z, w];
    const body = ok(H.HP_Body_Create(), 'HP_Body_Create');
    ok(H.HP_Body_SetShape(body, shape), 'HP_Body_SetShape');
    ok(H.HP_Body_SetMotionType(body, H.MotionType.STATIC), 'HP_Body_SetMotionType');
    ok(H.HP_Body_SetQTransform(body, [placed.at, turn]), 'HP_Body_SetQTransform');
    return { shape, body, at: placed.at, turn, isAdded: false };
  },
  free({ shape, body, isAdded }) {
    if (isAdded) H.HP_World_RemoveBody(world, body);
    H.HP_Body_Release(body);
    H.HP_Shape_Release(shape);
  },
});
