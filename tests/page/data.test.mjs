// SPDX-License-Identifier: GPL-3.0-or-later
// The indexes over the data: a tetrahedron A, whose hull leaves out input point 1, and a segment B.
import assert from "node:assert/strict";
import test from "node:test";
import { contactText, meetingOf, wayOf } from "../../view/page/web/contact.js";
import { makeData, readData } from "../../view/page/web/data.js";

const stages = {
  status: "penetrating",
  a: {
    ids: [0, 2, 3, 4], vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], edges: [[0, 1], [0, 2], [1, 2], [0, 3], [1, 3], [2, 3]],
    facets: [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]],
  },
  b: { ids: [0, 1], vertices: [[0.2, 0.2, -1], [0.2, 0.2, 0.5]], edges: [[0, 1]], facets: [] },
  contact: {
    direction: [0, 0, 1], translation: [0, 0, 0.5], features: null, kind: null,
    optima: [{ direction: [0, 0, 1], translation: [0, 0, 0.5], features: { a: [0, 2, 3], b: [1] }, kind: "facet-vertex" }],
  },
  pairs: [{ a: [0], b: [0] }, { a: [0, 1, 2], b: [0] }, { a: [3], b: [0] }],
  sum: {
    kind: "P",
    facets: [
      { normal: [0, 0, 1], distance: 0.5, a: [0, 2, 3], b: [1], pairs: [] },
      { normal: [1, 0, 0], distance: 2, a: [0, 3], b: [0, 1], pairs: [1, 2] },
    ],
  },
  coincidences: [{ kind: "parallel_edges", count: 7, listed: [{ a: [[2, 3]], b: [[0, 1]], decided_by: ["E11"] }] }],
};
const data = makeData({ status: "penetrating" }, stages, "case");

test("features are edges of the hull, by ids of input points", () => {
  assert.deepEqual(data.verticesOf("a", [0, 2, 3]), [0, 1, 2]);
  assert.deepEqual(data.verticesOf("a", [1]), []);
  assert.deepEqual(data.edgesOf("a", [0, 1, 2]), [0, 1, 2]);
  assert.deepEqual(data.edgesOf("a", [1, 3]), [4]);
  assert.deepEqual(data.edgesOf("b", [0]), []);
});

test("pairs are ordered by their crossings, first found first, and know their facets", () => {
  assert.deepEqual(data.order, [1, 0, 2]);
  assert.deepEqual(data.facetsOfPair(1), [1]);
  assert.deepEqual(data.facetsOfPair(0), []);
});

test("coincidences by name", () => {
  const item = data.coincidence("0.0");
  assert.deepEqual([item.kind, item.count, item.a, item.b, item.decided_by], ["parallel_edges", 7, [[1, 2]], [[0, 1]], ["E11"]]);
  for (const name of ["0.1", "1.0", "", "x.y"]) assert.equal(data.coincidence(name), null);
});

test("the way out is the chosen optimum's, or the facet's that is looked at; it ends where the features meet", () => {
  const way = wayOf(data, { facet: null, optimum: 0 });
  assert.deepEqual(meetingOf(data, way), [0.2, 0.2, 0.5]);
  assert.equal(contactText(way, data), "A's facet 0 2 3 meets B's point 1");
  const other = wayOf(data, { facet: 1, optimum: 0 });
  assert.deepEqual(other.translation, [2, 0, 0]);
  assert.deepEqual([other.a, other.b], [[0, 2], [0, 1]]);
  assert.deepEqual(meetingOf(data, { direction: [0, 0, 1], translation: [0, 0, 0.5], a: [3], b: [0, 1] }), [0, 0, 1.5]);
});

test("without features the way ends at the answer's witness, in the picture's units", () => {
  const scale = { center: ["1/2", "0", "0"], exponent: 1 };
  const contact = { direction: [0, 0, 1], translation: [0, 0, 2], features: null, optima: [] };
  const round = makeData({ status: "penetrating", witness_f64: { b: [1, 2, 3] } }, { ...stages, scale, contact }, "");
  assert.deepEqual(meetingOf(round, wayOf(round, { facet: null, optimum: 0 })), [1, 4, 6]);
});

test("bodies that touch do so about the middle of what lies in the plane between them", () => {
  const square = (x, y, z) => [[x, y, z], [x + 2, y, z], [x + 2, y + 2, z], [x, y + 2, z]];
  const solid = (z, side, x) => ({ ids: [0, 1, 2, 3, 4], vertices: [...square(x, 0, z), [x + 1, 1, z + side]], edges: [], facets: [] });
  const contact = { direction: [0, 0, 1], translation: [0, 0, 0], features: null, optima: [] };
  const touching = makeData({ status: "touching" }, { a: solid(0, 1, 1), b: solid(0, -1, 0), contact }, "");
  assert.deepEqual(meetingOf(touching, wayOf(touching, { facet: null, optimum: 0 })), [1.5, 1, 0]);
});

test("of bodies that are apart the way leads from A to B", () => {
  const contact = { direction: [0, 0, -1], translation: [0, 0, 3], features: { a: [4], b: [0] }, optima: [] };
  const apart = makeData({ status: "disjoint" }, { ...stages, contact }, "");
  assert.deepEqual(wayOf(apart, { facet: null, optimum: 0 }).direction, [0, 0, 1]);
});

test("data without most of it is no error", () => {
  const empty = makeData({}, { status: "touching", a: {}, b: {}, contact: null }, "");
  assert.deepEqual([empty.optima, empty.pairs, empty.facets, empty.order], [[], [], [], []]);
  assert.equal(wayOf(empty, { facet: null, optimum: 0 }), null);
});

test("the blocks of a page are read", () => {
  const blocks = { depth: '{"status":"touching"}', stages: JSON.stringify(stages), case: '{"id":"x"}\n' };
  const read = readData({ getElementById: (id) => ({ textContent: blocks[id] }) });
  assert.equal(read.status, "touching");
  assert.equal(read.caseText, '{"id":"x"}\n');
});
