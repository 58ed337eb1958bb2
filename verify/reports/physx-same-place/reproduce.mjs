// SPDX-License-Identifier: CC0-1.0
// npm install physx-js-webidl@2.7.3; node reproduce.mjs
import loadPhysX from 'physx-js-webidl';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

// The package is made for web pages: it must not see `process` while it starts.
const wasmBinary = readFileSync(createRequire(import.meta.url).resolve('physx-js-webidl/physx-js-webidl.wasm'));
const node = globalThis.process;
globalThis.process = undefined;
globalThis.window = {};
const PhysX = await loadPhysX({ wasmBinary });
globalThis.process = node;

const top = PhysX.PxTopLevelFunctions.prototype, number = top.PHYSICS_VERSION;
top.CreateFoundation(number, new PhysX.PxDefaultAllocator(), new PhysX.PxDefaultErrorCallback());
const cooking = new PhysX.PxCookingParams(new PhysX.PxTolerancesScale());

function mesh(corners) {
  const list = new PhysX.PxArray_PxVec3(corners.length);
  corners.forEach(([x, y, z], i) => list.set(i, new PhysX.PxVec3(x, y, z)));
  const about = new PhysX.PxConvexMeshDesc();
  about.flags = new PhysX.PxConvexFlags(PhysX.PxConvexFlagEnum.eCOMPUTE_CONVEX);
  about.points.stride = 12;
  about.points.count = corners.length;
  about.points.data = list.begin();
  return new PhysX.ConvexMeshSupport(top.CreateConvexMesh(cooking, about));
}

/** PxGjkQuery::proximityInfo of a body and its equal, moved by `shift`. */
function depth(body, shift) {
  const near = new PhysX.PxGjkQueryProximityInfoResult(), at = new PhysX.PxTransform(PhysX.PxIDENTITYEnum.PxIdentity);
  const there = new PhysX.PxTransform(PhysX.PxIDENTITYEnum.PxIdentity);
  there.p.x = shift;
  const isNear = PhysX.PxGjkQuery.prototype.proximityInfo(body, body, at, there, 0, 1, near), n = near.separatingAxis;
  return isNear ? `depth ${(-near.separation).toFixed(4)} along (${[n.x, n.y, n.z].map((x) => (x + 0).toFixed(4)).join(' ')})` : 'apart';
}

const box = new PhysX.ConvexGeomSupport(new PhysX.PxBoxGeometry(0.5, 0.5, 0.5));
const cube = mesh([-0.5, 0.5].flatMap((x) => [-0.5, 0.5].flatMap((y) => [-0.5, 0.5].map((z) => [x, y, z]))));
const tetrahedron = mesh([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]);

console.log(`PhysX ${number >> 24}.${(number >> 16) & 255}.${(number >> 8) & 255}: PxGjkQuery::proximityInfo of a body and its equal`);
console.log(`unit box at the same place           ${depth(box, 0)}; right is 1 along an axis`);
console.log(`tetrahedron at the same place        ${depth(tetrahedron, 0)}; right is 2 along an axis`);
console.log(`unit box, moved by 1 mm              ${depth(box, 0.001)}; right is 0.999`);
console.log(`tetrahedron, moved by 1 mm           ${depth(tetrahedron, 0.001)}; right is 1.999`);
console.log(`cube as a convex mesh, same place    ${depth(cube, 0)}; right is 1 along an axis`);
