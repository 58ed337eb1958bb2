// SPDX-License-Identifier: CC0-1.0
// npm install jolt-physics@1.1.0; node reproduce.mjs
import loadJolt from 'jolt-physics/wasm-compat';

const Jolt = await loadJolt();
registerShapes();
const corners = [[-4, -3, -2], [4, 1, 3], [-1, 3, -4], [3, 0, -1]];

function registerShapes() {  // a JoltInterface does it
  const settings = new Jolt.JoltSettings();
  const pairs = new Jolt.ObjectLayerPairFilterTable(1), phases = new Jolt.BroadPhaseLayerInterfaceTable(1, 1);
  phases.MapObjectToBroadPhaseLayer(0, new Jolt.BroadPhaseLayer(0));
  settings.mObjectLayerPairFilter = pairs;
  settings.mBroadPhaseLayerInterface = phases;
  settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(phases, 1, pairs, 1);
  return new Jolt.JoltInterface(settings);
}

function solid(radius, scale, at) {
  const settings = new Jolt.ConvexHullShapeSettings();
  settings.mMaxConvexRadius = radius;
  for (const [x, y, z] of corners) settings.mPoints.push_back(new Jolt.Vec3(scale * x, scale * y, scale * z));
  const shape = settings.Create().Get(), placed = new Jolt.TransformedShape();
  shape.AddRef();
  placed.mShape = shape;
  placed.SetWorldTransform(new Jolt.RVec3(...at), new Jolt.Quat(0, 0, 0, 1), new Jolt.Vec3(1, 1, 1));
  return placed;
}

/** What CollideShape finds for the solid and a second one of the same shape, moved by `shift`. */
function collide({ radius = 0, scale = 1, shift = 0, separation = 0, tolerance = 1e-4 } = {}) {
  const a = solid(radius, scale, [0, 0, 0]), b = solid(radius, scale, [shift, 0, 0]);
  const settings = new Jolt.CollideShapeSettings(), found = new Jolt.CollideShapeClosestHitCollisionCollector();
  settings.mMaxSeparationDistance = separation;
  settings.mCollisionTolerance = settings.mPenetrationTolerance = tolerance;
  b.CollideShape(a.mShape, new Jolt.Vec3(1, 1, 1), a.GetCenterOfMassTransform(), settings, new Jolt.RVec3(0, 0, 0), found,
                 new Jolt.ShapeFilter());
  return found.HadHit() ? `depth ${found.mHit.mPenetrationDepth.toFixed(4)}` : 'no collision';
}

console.log('Jolt (jolt-physics 1.1.0): a tetrahedron of 8 m against its equal at the same place; right is depth 2.2520');
console.log(`convex radius 0                     ${collide()}`);
console.log(`the same, tolerances 1e-6           ${collide({ tolerance: 1e-6 })}`);
console.log(`the same at a quarter of the size   ${collide({ scale: 0.25 })}, where right is 0.5630`);
console.log(`mMaxSeparationDistance 0.1          ${collide({ separation: 0.1 })}`);
console.log(`convex radius 0.05                  ${collide({ radius: 0.05 })}`);
console.log(`moved by 1 mm                       ${collide({ shift: 0.001 })}`);
