// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import test from "node:test";
import { changeOfKey } from "../../view/page/web/keys.js";

const data = { order: [4, 1, 7], optima: [0, 1, 2] }, state = { optimum: 0, pair: null };

test("j and k step through the pairs in the order of the list, and stop at its ends", () => {
  assert.deepEqual(changeOfKey("j", data, state), { pair: 4 });
  assert.deepEqual(changeOfKey("k", data, state), { pair: 7 });
  assert.deepEqual(changeOfKey("j", data, { ...state, pair: 4 }), { pair: 1 });
  assert.deepEqual(changeOfKey("j", data, { ...state, pair: 7 }), { pair: 7 });
  assert.deepEqual(changeOfKey("k", data, { ...state, pair: 4 }), { pair: 4 });
  assert.equal(changeOfKey("j", { order: [], optima: [] }, state), null);
});

test("arrows step through the optima, round and round; a facet that was looked at gives way", () => {
  assert.deepEqual(changeOfKey("ArrowRight", data, { ...state, optimum: 2 }), { optimum: 0, facet: null });
  assert.deepEqual(changeOfKey("ArrowLeft", data, state), { optimum: 2, facet: null });
  assert.equal(changeOfKey("ArrowLeft", { order: [], optima: [0] }, state), null);
});

test("digits name sections, Esc chooses nothing, other keys are not ours", () => {
  for (const key of ["1", "2", "3", "4", "5"]) assert.deepEqual(changeOfKey(key, data, state), { section: Number(key) });
  assert.deepEqual(changeOfKey("Escape", data, state), { pair: null, facet: null, coincidence: null, step: 0 });
  for (const key of ["0", "6", "a", "Tab", "Enter", " ", "J"]) assert.equal(changeOfKey(key, data, state), null);
});
