// SPDX-License-Identifier: GPL-3.0-or-later
// The selection: what stands in the address comes back, what the data does not have is dropped, the pointer chooses nothing.
import assert from "node:assert/strict";
import test from "node:test";
import { createSelection, hashOf, stateOf } from "../../view/page/web/selection.js";

const coincidence = (name) => (/^[01]\.[0-3]$/.test(name) ? {} : null);
const data = { optima: [0, 1, 2, 3, 4, 5], pairs: new Array(20), facets: new Array(9), motions: [{ path: { steps: 4 } }, { path: { steps: 10 } }], coincidence };

function address(hash) {
  const listeners = {};
  const result = { location: { hash, pathname: "/page.html", search: "" }, addEventListener: (name, f) => { listeners[name] = f; } };
  result.history = { replaceState: (_, __, url) => { result.location.hash = url.startsWith("#") ? url : ""; } };
  result.go = (to) => { result.location.hash = to; listeners.hashchange(); };
  return result;
}

test("every field that differs from the first selection stands in the address and comes back", () => {
  const states = [
    {}, { optimum: 5 }, { pair: 0 }, { pair: 19, facet: 8 }, { coincidence: "1.3" }, { hemisphere: "lower", plane: true }, { moved: 1 },
    { moved: 0.125, section: 3 }, { motion: 1, step: 10 },
    { optimum: 1, pair: 2, facet: 3, coincidence: "0.0", hemisphere: "upper", plane: true, moved: 0.5, section: 5 },
  ];
  for (const state of states) {
    const there = address("");
    const sender = createSelection(data, there);
    sender.set(state);
    const reader = createSelection(data, address(there.location.hash));
    assert.deepEqual(reader.get(), sender.get());
    assert.equal(reader.hash(), hashOf(sender.get()));
  }
});

test("the address of the first selection is empty", () => {
  const there = address("");
  const selection = createSelection(data, there);
  selection.set({ pair: 3 });
  assert.equal(there.location.hash, "#pair=3");
  selection.clear();
  assert.equal(there.location.hash, "");
});

test("values that the data does not have are dropped, one by one", () => {
  const text = "#pair=20&facet=-1&optimum=2&coincidence=7.7&moved=2&motion=2&step=11&section=6&hemisphere=left&%E0=1&=&a";
  const selection = createSelection(data, address(text));
  assert.deepEqual(selection.get(), createSelection(data, address("#optimum=2")).get());
  selection.set({ pair: 1.5, facet: 4, unknown: 1 });
  assert.equal(selection.get().pair, null);
  assert.equal(selection.get().facet, 4);
});

test("links to sections keep the rest", () => {
  assert.deepEqual(stateOf("#where"), { section: 3 });
  const there = address("#pair=3");
  const selection = createSelection(data, there);
  there.go("#cost");
  assert.equal(selection.hash(), "pair=3&section=5");
  assert.equal(there.location.hash, "#pair=3&section=5");
  there.go("#facet=2");
  assert.equal(selection.hash(), "facet=2");
});

test("listeners hear what changed, and nothing if nothing did", () => {
  const selection = createSelection(data), heard = [];
  const end = selection.subscribe((state, changed) => heard.push([...changed]));
  assert.equal(heard[0].length, 10);
  selection.set({ pair: 4, moved: 0.5 });
  selection.set({ pair: 4 });
  assert.deepEqual(heard.slice(1), [["pair", "moved"]]);
  end();
  selection.set({ pair: 5 });
  assert.equal(heard.length, 2);
});

test("the pointer shows without choosing", () => {
  const there = address(""), selection = createSelection(data, there);
  selection.set({ facet: 1 });
  selection.preview({ facet: 2 });
  assert.equal(selection.get().facet, 2);
  assert.equal(selection.chosen().facet, 1);
  assert.equal(there.location.hash, "#facet=1");
  selection.preview(null);
  assert.equal(selection.get().facet, 1);
});

test("listeners hear of a choice under the pointer, though nothing else is shown", () => {
  const selection = createSelection(data), heard = [];
  selection.preview({ facet: 2 });
  selection.subscribe((state, changed) => heard.push([...changed]));
  selection.set({ facet: 2 });
  selection.preview(null);
  assert.deepEqual(heard.slice(1), [["facet"]]);
});
