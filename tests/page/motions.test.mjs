// SPDX-License-Identifier: GPL-3.0-or-later
// Motions of A as fathom has them, and patches in places of the pictures.
import assert from "node:assert/strict";
import test from "node:test";
import { minus, norm } from "../../view/page/web/geometry.js";
import { meetingOf } from "../../view/page/web/contact.js";
import { carrier, carrierOf } from "../../view/page/web/motions.js";
import { patchesOf } from "../../view/page/web/patches.js";

const path = { along: ["1", "0", "-1/2"], turn: ["0", "0", "2"], steps: 2, values: [] };
const near = (p, q, law) => assert.ok(norm(minus(p, q)) < 1e-12, `${law}: ${p}, ${q}`);

test("A is turned by the quaternion (1, s w / 2), and then moved by s v", () => {
  const at = carrier(path, 2, {});  // s = 1: a quarter turn about z
  near(at([0, 0, 0]), [1, 0, -0.5], "law: the origin is moved by v");
  near(at([1, 0, 3]), [1, 1, 2.5], "law: what is beside it is turned first");
  const half = carrier(path, 1, {});  // s = 1/2: the quaternion (1, 0, 0, 1/2)
  near(half([1, 0, 0]), [0.5 + 0.6, 0.8, -0.25], "law: the turn is that of a rational rotation");
});

test("places of the pictures are moved and scaled as bodies are", () => {
  const scale = { center: ["4", "-1", "1/2"], exponent: 3 };
  const staged = (p) => p.map((x, i) => (x - [4, -1, 0.5][i]) * 8);
  for (const p of [[0, 0, 0], [4, -1, 0.5], [5, 2, -3]])
    near(carrier(path, 1, { scale })(staged(p)), staged(carrier(path, 1, {})(p)), "law: in other places, the same motion");
});

test("if B moves, A is where it is seen from B", () => {
  const still = { along: ["0", "0", "0"], steps: 2, values: [] }, scale = { center: ["4", "-1", "1/2"], exponent: 3 };
  const seen = carrier({ ...still, along_b: path.along, turn_b: path.turn }, 2, {});
  near(seen([1, 0, -0.5]), [0, 0, 0], "law: what B's origin is carried to is at its origin");
  near(seen([1, 1, 2.5]), [1, 0, 3], "law: what B turns to is turned back");
  for (const p of [[0, 0, 0], [4, -1, 0.5], [5, 2, -3]])
    for (const stages of [{}, { scale }])
      near(carrier({ ...path, along_b: path.along, turn_b: path.turn }, 1, stages)(p), p, "law: where both move alike, nothing changes");
});

test("where nothing is chosen A stands", () => {
  const data = { motions: [{ name: "by the twist", path }], stages: {} };
  assert.equal(carrierOf(data, { motion: 0, step: 0 }), null);
  assert.equal(carrierOf({ motions: [], stages: {} }, { motion: 0, step: 0 }), null);
  near(carrierOf(data, { motion: 0, step: 9 })([0, 0, 0]), [1, 0, -0.5], "law: no step is beyond the last");
});

test("patches have their way, and exact places beyond binary64 are drawn where they are", () => {
  const far = (x) => `${10n ** 20n + BigInt(x)}`, round = { core: ["1", "0", "0"], normal: ["0", "3", "4"], distance: "-5" };
  const at = (x) => ({ a: [far(x), "0", "1/2"], b: round }), stages = { scale: { center: [far(0), "0", "0"], exponent: -1 } };
  const [first, second] = patchesOf({ manifold: { patches: [{ direction: ["0", "0", "2"], corners: [at(1), at(2)] },
    { optimum: 0, direction: ["1", "0", "0"], corners: [at(3)] }] } }, stages);
  assert.deepEqual([first.way, first.direction, first.a], [0, [0, 0, 1], [[0.5, 0, 0.25], [1, 0, 0.25]]]);
  assert.deepEqual([second.way, second.a], [0, [[1.5, 0, 0.25]]], "law: of unions a patch names its way");
  near(patchesOf({ manifold: { patches: [{ direction: ["0", "3", "4"], corners: [at(1)] }] } }, {})[0].b[0], [1, -3, -4], "law: round bodies reach beyond their cores");
  assert.deepEqual(patchesOf({ manifold: { patches: null } }, stages), [], "law: where none are told there are none");
});

test("bodies of any size, at any distance, are carried and drawn as those of size 1", () => {
  for (const power of [-1100, -1070, 1100, 2000]) {
    const unit = power < 0 ? `1/${1n << BigInt(-power)}` : `${1n << BigInt(power)}`, zero = ["0", "0", "0"];
    const scale = { center: [unit, "0", "0"], exponent: -power }, corner = { a: [unit, "0", unit], b: { core: zero, normal: ["0", "0", "2"], distance: unit } };
    const [patch] = patchesOf({ manifold: { patches: [{ direction: ["1", "0", "0"], corners: [corner] }] } }, { scale });
    assert.deepEqual([patch.a, patch.b], [[[0, 0, 1]], [[-1, 0, 1]]], `law: no place is lost (2^${power})`);
    near(carrier({ along: [unit, "0", "0"], turn: ["0", "0", "2"], steps: 1 }, 1, { scale })([0, 0, 0]), [0, 1, 0], `law: nor a motion (2^${power})`);
  }
  const far = { center: ["100000000000000000000", "0", "0"], exponent: 0 }, turn = { along: ["100000000000000000000", "-99999999999999999999", "0"], turn: ["0", "0", "2"], steps: 1 };
  near(carrier(turn, 1, { scale: far })([0, 0, 0]), [0, 1, 0], "law: O is carried exactly");
  const tiny = { status: "penetrating", stages: { scale: { center: ["0", "0", "0"], exponent: 1070 } }, bodies: { a: { vertices: [] }, b: { vertices: [] } },
    depth: { witness_f64: { b: [2 ** -1070, 0, 0] } } };
  assert.deepEqual(meetingOf(tiny, { isFirst: true, a: [], b: [] }), [1, 0, 0], "law: a witness is where it is drawn");
});
