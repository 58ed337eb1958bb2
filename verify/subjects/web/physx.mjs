// SPDX-License-Identifier: GPL-3.0-or-later
// PhysX 5; PxGeometryQuery::computePenetration is not in the binding.
//   gjk     PxGjkQuery.proximityInfo: GJK and EPA
//   sweep   PxGeometryQuery.sweep of A against B over a short way with PxHitFlag eMTD: an overlap at the start is answered with its
//           minimum translation
//   scene   the deepest contact point that one simulation step reports (PCM, as in every scene): a manifold
import PhysX from 'physx-js-webidl';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { manifold, mode, note, quiet, Refused, serve, setting, signed, turnFrom } from './engine.mjs';

const require = createRequire(import.meta.url), pathOf = (name) => require.resolve(`physx-js-webidl/${name}`);
const P = await start();
const top = P.PxTopLevelFunctions.prototype, number = top.PHYSICS_VERSION;
const version = `${JSON.parse(readFileSync(pathOf('package.json'))).version} (PhysX ${number >> 24}.${(number >> 16) & 255}.${(number >> 8) & 255})`;
const foundation = top.CreateFoundation(number, new P.PxDefaultAllocator(), new P.PxDefaultErrorCallback());
const scale = new P.PxTolerancesScale();
const length = setting('tolerance_length', 1);
scale.length = length;
const physics = top.CreatePhysics(number, foundation, scale);
const cooking = new P.PxCookingParams(scale);
cooking.planeTolerance = setting('plane_tolerance', 0.0007);
note('hulls', 'at most 129 vertices; flat bodies become boxes');
const flags = new P.PxConvexFlags(P.PxConvexFlagEnum.eCOMPUTE_CONVEX);
const plain = (v) => [v.x, v.y, v.z];
const conventions = { depth: 'negative', moves: 'a', shapes: ['sphere', 'box', 'capsule', 'cylinder', 'cone', 'ellipsoid', 'margin'] };

// The package is made for web pages and refuses node: it must not see `process` while it starts.
async function start() {
  const node = globalThis.process, wasmBinary = readFileSync(pathOf('physx-js-webidl.wasm'));
  globalThis.process = undefined;
  globalThis.window = {};
  try {
    return await PhysX({ ...quiet, wasmBinary });
  } finally {
    globalThis.process = node;
    delete globalThis.window;
  }
}

function poseOf(body) {
  const [w, x, y, z] = body.shape ? turnFrom(body, 'x') : body.turn;
  const pose = new P.PxTransform(P.PxIDENTITYEnum.PxIdentity);
  [pose.p.x, pose.p.y, pose.p.z] = body.at;
  [pose.q.x, pose.q.y, pose.q.z, pose.q.w] = [x, y, z, w];
  return pose;
}

function meshOf(points) {
  const list = new P.PxArray_PxVec3(points.length), p = new P.PxVec3();
  points.forEach((v, i) => {
    [p.x, p.y, p.z] = v;
    list.set(i, p);
  });
  const about = new P.PxConvexMeshDesc();
  about.flags = flags;
  about.points.stride = 12;
  about.points.count = points.length;
  about.points.data = list.begin();
  const mesh = top.CreateConvexMesh(cooking, about);
  for (const done of [list, p, about]) P.destroy(done);
  if (!mesh || !P.getPointer(mesh)) throw new Refused('PxCreateConvexMesh gave no mesh');
  return mesh;
}

function verticesOf(mesh, at) {
  const first = mesh.getVertices(), vec3At = (i) => P.NativeArrayHelpers.prototype.getVec3At(first, i);
  return Array.from({ length: mesh.getNbVertices() }, (_, i) => plain(vec3At(i)).map((x, k) => x + at[k]));
}

// Sphere, box and capsule are PhysX's own geometries; the others, and those with a margin, are its convex cores.
function geometryOf({ shape, radius: r, half_length: h, half, radii, margin }) {
  const F = P.PxConvexCoreGeometryFactory.prototype;
  switch (shape) {
    case 'sphere': return new P.PxSphereGeometry(r + margin);
    case 'capsule': return new P.PxCapsuleGeometry(r + margin, h);
    case 'box':
      return margin > 0 ? F.createFromBox(new P.PxConvexCoreBox(...half.map((x) => 2 * x)), margin) : new P.PxBoxGeometry(...half);
    case 'cylinder': return F.createFromCylinder(new P.PxConvexCoreCylinder(2 * h, r), margin);
    case 'cone': return F.createFromCone(new P.PxConvexCoreCone(2 * h, r), margin);
    case 'ellipsoid': return F.createFromEllipsoid(new P.PxConvexCoreEllipsoid(...radii), margin);
    default: throw new TypeError(shape);
  }
}

function gjk() {
  const near = new P.PxGjkQueryProximityInfoResult(), farthest = setting('contact_distance', 1e9);
  const ask = (a, b) => {
    if (!P.PxGjkQuery.prototype.proximityInfo(a.support, b.support, a.pose, b.pose, farthest, length, near)) return { overlap: false };
    return { ...signed(near.separation), direction: plain(near.separatingAxis),
             witness: { a: plain(near.pointA), b: plain(near.pointB) } };
  };
  return { ...conventions, call: 'PxGjkQuery.proximityInfo', ask };
}

function sweep() {
  const along = new P.PxVec3(1, 0, 0), hit = new P.PxSweepHit(), F = P.PxHitFlagEnum;
  const wanted = new P.PxHitFlags(F.eMTD | F.eNORMAL | F.ePOSITION);
  const reach = setting('sweep_distance', 0.01);
  const ask = (a, b) => {
    if (!P.PxGeometryQuery.prototype.sweep(along, reach, a.geometry, a.pose, b.geometry, b.pose, hit, wanted)) return { overlap: false };
    return { overlap: hit.distance <= 0, depth: hit.distance, direction: plain(hit.normal) };
  };
  return { ...conventions, call: 'PxGeometryQuery.sweep', shapes: ['sphere', 'box', 'capsule'], ask };
}

function scene() {
  const about = new P.PxSceneDesc(scale), shader = new P.PassThroughFilterShaderImpl(), events = new P.PxSimulationEventCallbackImpl();
  const most = 256, points = new P.Vector_PxContactPairPoint(most), F = P.PxPairFlagEnum;
  const tellsPositions = setting('positions', 0) !== 0;
  let found = [], shapeOfA;
  about.set_gravity(new P.PxVec3(0, 0, 0));
  about.set_cpuDispatcher(top.DefaultCpuDispatcherCreate(0));
  const wanted = F.eSOLVE_CONTACT | F.eDETECT_DISCRETE_CONTACT | F.eNOTIFY_TOUCH_FOUND | F.eNOTIFY_CONTACT_POINTS;
  shader.filterShader = () => {
    shader.outputPairFlags = wanted;
    return 0;
  };
  for (const name of ['onConstraintBreak', 'onWake', 'onSleep', 'onTrigger']) events[name] = () => {};
  events.onContact = (header, pairs, count) => {
    for (let k = 0; k < count; ++k) {
      const pair = P.NativeArrayHelpers.prototype.getContactPairAt(P.wrapPointer(pairs, P.PxContactPair), k);
      const sign = P.getPointer(pair.get_shapes(0)) === shapeOfA ? 1 : -1;
      for (let i = 0, n = pair.extractContacts(points.data(), most); i < n; ++i)
        found.push({ depth: points.at(i).separation, direction: plain(points.at(i).normal).map((x) => sign * x),
                     position: plain(points.at(i).position) });
    }
  };
  top.setupPassThroughFilterShader(about, shader);
  about.simulationEventCallback = events;
  const stage = physics.createScene(about), material = physics.createMaterial(0.5, 0.5, 0);
  const shapeFlags = new P.PxShapeFlags(P.PxShapeFlagEnum.eSIMULATION_SHAPE), filter = new P.PxFilterData(1, 1, 0, 0);
  const enter = (body) => {
    const actor = physics.createRigidDynamic(body.pose), shape = physics.createShape(body.geometry, material, true, shapeFlags);
    shape.setSimulationFilterData(filter);
    actor.attachShape(shape);
    stage.addActor(actor);
    return { actor, shape };
  };
  const ask = (a, b) => {
    found = [];
    const entered = [a, b].map(enter);
    shapeOfA = P.getPointer(entered[0].shape);
    stage.simulate(1 / 60);
    stage.fetchResults(true);
    for (const { actor, shape } of entered) {
      stage.removeActor(actor);
      actor.detachShape(shape);
      shape.release();
      actor.release();
    }
    return manifold(found, tellsPositions);
  };
  return { ...conventions, claims: 'separating', call: 'PxScene.simulate, PxContactPair.extractContacts', ask,
           manifold: tellsPositions && { most: 4 } };
}

const modes = { gjk, sweep, scene };
await serve({
  name: 'physx', version, precision: 'binary32',
  modes: Object.fromEntries(Object.entries(modes).map(([name, begin]) => [name, name === mode ? begin() : {}])),
  make(body) {
    const pose = poseOf(body);
    if (body.shape) {
      const geometry = geometryOf(body);
      return { pose, geometry, support: mode === 'gjk' ? new P.ConvexGeomSupport(geometry) : null, mesh: null };
    }
    const mesh = meshOf(body.points);
    return { pose, mesh, at: body.at, geometry: new P.PxConvexMeshGeometry(mesh), support: new P.ConvexMeshSupport(mesh) };
  },
  hulls: (...pair) => {
    const [a, b] = pair.map(({ mesh, at }) => (mesh ? verticesOf(mesh, at) : undefined));
    return { a, b };
  },
  free({ support, geometry, pose, mesh }) {
    if (support) P.destroy(support);
    P.destroy(geometry);
    P.destroy(pose);
    mesh?.release();
  },
});
