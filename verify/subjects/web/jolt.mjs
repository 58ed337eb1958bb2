// SPDX-License-Identifier: GPL-3.0-or-later
// Jolt Physics: TransformedShape.CollideShape, which NarrowPhaseQuery and the simulation call for one pair.
//   radius0   convex radius 0, so that the hull is the one that was asked for
//   radius    convex radius 0.05, which the C++ library has by default: hulls are shrunk and rounded by it where they can be
//   world     convex radius 0; the manifold that a contact listener is told in one step of a world of two bodies
import Jolt from 'jolt-physics/wasm-compat';
import { manifold, mode, quiet, Refused, serve, setting, turnFrom, versionOf } from './engine.mjs';

const J = await Jolt(quiet);
const radius = setting('max_convex_radius', mode === 'radius' ? 0.05 : 0);
const hullTolerance = setting('hull_tolerance', 1e-3);
const maxErrorOfRadius = setting('max_error_convex_radius', 0.05);
const query = new J.CollideShapeSettings();
if (mode !== 'world') {
  query.mPenetrationTolerance = setting('penetration_tolerance', 1e-4);
  query.mCollisionTolerance = setting('collision_tolerance', 1e-4);
  query.mMaxSeparationDistance = setting('max_separation_distance', 0);
}
const tellsPositions = mode === 'world' && setting('positions', 0) !== 0;

const stage = stageOf();
const plain = (v) => [v.GetX(), v.GetY(), v.GetZ()];
const one = new J.Vec3(1, 1, 1), zero = new J.RVec3(0, 0, 0), filter = new J.ShapeFilter();

// A world. Shapes enter the collision dispatch only when one is made.
function stageOf() {
  const layers = new J.JoltSettings();
  const pairs = new J.ObjectLayerPairFilterTable(1), phases = new J.BroadPhaseLayerInterfaceTable(1, 1);
  pairs.EnableCollision(0, 0);
  phases.MapObjectToBroadPhaseLayer(0, new J.BroadPhaseLayer(0));
  layers.mObjectLayerPairFilter = pairs;
  layers.mBroadPhaseLayerInterface = phases;
  layers.mObjectVsBroadPhaseLayerFilter = new J.ObjectVsBroadPhaseLayerFilterTable(phases, 1, pairs, 1);
  return new J.JoltInterface(layers);
}

function hull(points) {
  const settings = new J.ConvexHullShapeSettings(), p = new J.Vec3();
  settings.mMaxConvexRadius = radius;
  settings.mMaxErrorConvexRadius = maxErrorOfRadius;
  settings.mHullTolerance = hullTolerance;
  for (const v of points) {
    p.Set(...v);
    settings.mPoints.push_back(p);
  }
  J.destroy(p);
  return settings;
}

function primitive({ shape, radius: r, half_length: h, half, radius_low: low, radius_high: high }) {
  switch (shape) {
    case 'sphere': return new J.SphereShapeSettings(r);
    case 'box': return new J.BoxShapeSettings(new J.Vec3(...half), Math.min(radius, ...half));
    case 'capsule': return new J.CapsuleShapeSettings(h, r);
    case 'cylinder': return new J.CylinderShapeSettings(h, r, Math.min(radius, h, r));
    case 'frustum': return new J.TaperedCylinderShapeSettings(h, high, low, Math.min(radius, high, low));
    case 'cone': return new J.TaperedCylinderShapeSettings(h, 0, r, 0);
    case 'tapered_capsule': return new J.TaperedCapsuleShapeSettings(h, high, low);
    default: throw new TypeError(shape);
  }
}

// Jolt's hull by its triangles, where it is the hull that the query uses: with a convex radius it is shrunk, and rounded.
function verticesOf({ shape, at, isHull }) {
  if (!isHull || radius > 0) return undefined;
  const faces = new J.ShapeGetTriangles(shape, J.AABox.prototype.sBiggest(), shape.GetCenterOfMass(), J.Quat.prototype.sIdentity(), one);
  const numbers = new Float32Array(J.HEAPF32.buffer, faces.GetVerticesData(), faces.GetVerticesSize() / 4);
  const vertices = new Map();
  for (let i = 0; i < numbers.length; i += 3) {
    const vertex = Array.from(numbers.subarray(i, i + 3), (x, k) => x + at[k]);
    vertices.set(vertex.join(), vertex);
  }
  J.destroy(faces);
  return [...vertices.values()];
}

const ask = (a, b) => {
  b.collector.Reset();
  b.placed.CollideShape(a.shape, one, a.placed.GetCenterOfMassTransform(), query, zero, b.collector, filter);
  if (!b.collector.HadHit()) return { overlap: false };
  const hit = b.collector.mHit;
  return { overlap: hit.mPenetrationDepth >= 0, depth: hit.mPenetrationDepth, direction: plain(hit.mPenetrationAxis),
           witness: { a: plain(hit.mContactPointOn1), b: plain(hit.mContactPointOn2) } };
};

// A point of a manifold is told as one on each body: they are as far apart as the solver takes them to overlap there.
function inWorld(a, b) {
  const bodies = stage.GetPhysicsSystem().GetBodyInterface(), listener = new J.ContactListenerJS(), found = [];
  const entered = [a, b].map(({ shape, at, turn }) => {
    const position = new J.RVec3(...at), q = new J.Quat(...turn);
    const about = new J.BodyCreationSettings(shape, position, q, J.EMotionType_Dynamic, 0);
    about.mOverrideMassProperties = J.EOverrideMassProperties_MassAndInertiaProvided;
    about.mMassPropertiesOverride.mMass = 1;
    about.mGravityFactor = 0;
    const body = bodies.CreateBody(about);
    for (const done of [position, q, about]) J.destroy(done);
    bodies.AddBody(body.GetID(), J.EActivation_Activate);
    return body;
  });
  listener.OnContactValidate = () => J.ValidateResult_AcceptAllContactsForThisBodyPair;
  listener.OnContactAdded = (first, _, told) => {
    const points = J.wrapPointer(told, J.ContactManifold), turned = first !== J.getPointer(entered[0]);
    const normal = plain(points.mWorldSpaceNormal), direction = normal.map((x) => (turned ? -x : x));
    for (let i = 0; i < points.mRelativeContactPointsOn1.size(); ++i) {
      const p = plain(points.GetWorldSpaceContactPointOn1(i)), q = plain(points.GetWorldSpaceContactPointOn2(i));
      const depth = p.reduce((sum, x, k) => sum + (x - q[k]) * normal[k], 0);
      found.push({ depth: -depth, direction, position: p.map((x, k) => (x + q[k]) / 2) });
    }
  };
  listener.OnContactPersisted = listener.OnContactRemoved = () => {};
  stage.GetPhysicsSystem().SetContactListener(listener);
  stage.Step(1 / 60, 1);
  for (const body of entered.reverse()) {  // A is the first of the next pair too, in the same place
    bodies.RemoveBody(body.GetID());
    bodies.DestroyBody(body.GetID());
  }
  J.destroy(listener);
  return manifold(found, tellsPositions);
}

const shapes = ['sphere', 'box', 'capsule', 'cylinder', 'frustum', 'cone', 'tapered_capsule'];
const conventions = { call: 'TransformedShape.CollideShape', depth: 'positive', moves: 'b', unit: false, shapes, ask };

await serve({
  name: 'jolt', version: versionOf('jolt-physics'), precision: 'binary32',
  modes: {
    radius0: conventions, radius: conventions,
    world: { call: 'PhysicsSystem.Update, ContactListener', depth: 'negative', moves: 'b', unit: false, claims: 'separating',
             shapes, manifold: tellsPositions && { most: 4 }, ask: inWorld },
  },
  make(body) {
    const settings = body.shape ? primitive(body) : hull(body.points);
    const result = settings.Create();
    const error = result.HasError() ? result.GetError().c_str() : null;
    const shape = error === null ? result.Get() : null;
    shape?.AddRef();
    J.destroy(settings);
    if (error !== null) throw new Refused(`ShapeSettings.Create: ${error}`);
    const [w, x, y, z] = body.shape ? turnFrom(body, 'y') : body.turn;
    const placed = new J.TransformedShape(), position = new J.RVec3(...body.at), turn = new J.Quat(x, y, z, w);
    placed.mShape = shape;
    placed.SetWorldTransform(position, turn, one);
    J.destroy(position);
    J.destroy(turn);
    return { shape, placed, at: body.at, turn: [x, y, z, w], isHull: !body.shape, collector: new J.CollideShapeClosestHitCollisionCollector() };
  },
  hulls: (a, b) => ({ a: verticesOf(a), b: verticesOf(b) }),
  free({ shape, placed, collector }) {
    J.destroy(placed);
    J.destroy(collector);
    shape.Release();
  },
});
