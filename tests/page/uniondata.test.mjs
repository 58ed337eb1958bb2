// SPDX-License-Identifier: GPL-3.0-or-later
// Unions: bodies of several pieces, a tetrahedron each; contacts by points of pieces; pairs of pieces.
import assert from "node:assert/strict";
import test from "node:test";
import { contactText, meetingOf, wayOf } from "../../view/page/web/contact.js";
import { readData } from "../../view/page/web/data.js";
import { changeOfKey } from "../../view/page/web/keys.js";
import { createSelection } from "../../view/page/web/selection.js";
import { makeUnionData, secondNormal } from "../../view/page/web/uniondata.js";

const piece = (x, size = 1) => ({
  ids: [0, 2, 3, 4], vertices: [[x, 0, 0], [x + size, 0, 0], [x, size, 0], [x, 0, size]],
  edges: [[0, 1], [0, 2], [1, 2], [0, 3], [1, 3], [2, 3]], facets: [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]],
});
const contact = (pieces, direction, a, b) => ({ pieces, direction, kind: "vertex-vertex", a, b });
const sum = (pieces, touches, facets = []) => ({ pieces, inside: true, distance: 1, distance_squared: "1", touches, vertices: [], facets, through: [] });
const stages = {
  schema: "fathom/union_stages/1", status: "penetrating", a: [piece(0)], b: [piece(0), piece(10, 3)],
  ways: [
    { translation: [0, 0, 2], clearance: true, contacts: [contact([0, 1], [0, 0, 1], [2], [4]), contact([0, 0], [0, 1, 0], [0], [3])] },
    { translation: [0, 0, -2], clearance: false, contacts: [contact([0, 0], [0, 0, -1], [0], [0])] },
  ],
  sums: [sum([0, 1], [0], [[0, 1, 2]]), sum([0, 0], [0, 1])],
};
const depth = { status: "penetrating", optima: [{}, {}] };
const data = makeUnionData(depth, stages);

test("a body is all of its pieces, one after the other", () => {
  const { b } = data.bodies;
  assert.deepEqual([b.vertices.length, b.edges.length, b.facets.length], [8, 12, 8]);
  assert.deepEqual(b.edges[6], [4, 5]);
  assert.deepEqual(b.facets[4], [4, 6, 5]);
  assert.deepEqual(b.pieces[1].edges, [6, 7, 8, 9, 10, 11]);
  assert.deepEqual(b.mainPart, stages.b[1].vertices, "its letter stands in the largest one");
});

test("contacts are vertices of pieces, by the ids of their points", () => {
  const [first, second] = data.optima[0].contacts;
  assert.deepEqual([first.a, first.b, second.b], [[1], [7], [2]]);
  assert.equal(data.optima[1].clearance, false);
  assert.equal(contactText(wayOf(data, { facet: null, optimum: 0 }), data), "Piece 0 of A touches piece 1 of B. Piece 0 of A touches piece 0 of B.");
  assert.deepEqual(meetingOf(data, data.optima[0]), [1, 0, 2], "where the first contact is: A's point, moved");
  assert.deepEqual(secondNormal(data.optima[0]), [0, 1, 0], "a plane beside that across the way");
  assert.equal(secondNormal(data.optima[1]), null);
});

test("pairs are of pieces, and are chosen as others are", () => {
  assert.deepEqual(data.pairs[0].b, [6, 7, 8, 9, 10, 11]);
  assert.deepEqual([data.facetsOfPair(0), data.facetsOfPair(1)], [[0], []], "one without facets is not drawn");
  const selection = createSelection(data);
  selection.set({ pair: 2, facet: 0 });
  assert.deepEqual([selection.get().pair, selection.get().facet], [null, null]);
  selection.set(changeOfKey("j", data, selection.chosen()));
  assert.equal(selection.get().pair, 0);
  selection.set(changeOfKey("ArrowRight", data, selection.chosen()));
  assert.equal(selection.get().optimum, 1);
});

test("bodies that do not overlap have a way to the contact, and no optima", () => {
  const apart = makeUnionData({ status: "disjoint" }, { ...stages, status: "disjoint", sums: [] });
  assert.deepEqual(apart.optima, []);
  assert.deepEqual(wayOf(apart, { facet: null, optimum: 0 }).translation, [0, 0, 2]);
});

test("the blocks of a page tell unions from convex bodies", () => {
  const blocks = { depth: JSON.stringify(depth), stages: JSON.stringify(stages) };
  assert.equal(readData({ getElementById: (id) => (blocks[id] ? { textContent: blocks[id] } : null) }).isUnion, true);
});
