// SPDX-License-Identifier: GPL-3.0-or-later
// The table of canonical pairs: its order, its fold, its cells.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  closestSentence,
  pairCells,
  pairHeadings,
  pairRows,
  pairSentence,
  pairSize,
  shownUpTo,
} from "../../view/page/web/pairrows.js";
import { cubes, pair } from "./bodies.mjs";

const some = cubes({
  pairs: [
    pair(),
    pair({ a: [0, 1], b: [2, 3, 4] }),
    pair({ chart: 1, stored_of: "b" }),
    pair({ a: [0], b: [1, 2] }),
    pair({ a: [5, 6, 7], b: [1, 2], rising: false }),
  ],
});

test("larger pairs come first, equal ones in the order in which they were found; 1 x 1 are folded", () => {
  assert.deepEqual(pairRows(some), { large: [1, 4, 3], single: [0, 2] });
  assert.deepEqual(some.order, [1, 4, 3, 0, 2], "j and k go the same way");
  assert.equal(pairSize(some.pairs[4]), 6);
});

test("the cells of a row", () => {
  assert.deepEqual(pairCells(some, 2), ["2", "lower", "B", "1 \u00d7 1", "\u2013", "1", "scanned"]);
  const closest = { a: 0, b: 2, distance: 0.25, distance_squared: "1/16" };
  const data = cubes({ pairs: [pair({ a: [0, 1], b: [2, 3, 4], closest, evaluated: 6, engine: null })] });
  assert.deepEqual(pairCells(data, 0), ["0", "upper", "\u2212A", "2 \u00d7 3", "0.25", "6", "\u2013"]);
  const scaled = cubes({ pairs: [pair({ closest: { a: 0, b: 2, distance: 0.70711, distance_squared: "2" } })], scale: { exponent: -1 } });
  assert.equal(pairCells(scaled, 0)[4], "1.4142135623730951", "of one crossing too: rounded once, in the unit of the input");
  assert.equal(pairHeadings.length, pairCells(data, 0).length);
});

test("sentences say hemisphere, sizes, sense and the closest lines by points of the input", () => {
  assert.match(
    pairSentence(some, 1),
    /pair 1, upper hemisphere: 2 edges of A and 3 edges of B, 6 crossings\. The arcs of \u2212A span .* those of B .* below to above\./,
  );
  assert.match(pairSentence(some, 4), /from above to below/);
  assert.match(pairSentence(some, 2), /lower hemisphere: 1 edge of A and 1 edge of B, 1 crossing\. The arcs of B span/);
  assert.equal(closestSentence(some, 0), null);
  const data = cubes({ pairs: [pair({ closest: { a: 0, b: 1, distance: 1 }, engine: "cleared", evaluated: 0 })] }),
    [v, w] = data.bodies.a.edges[0];
  assert.match(closestSentence(data, 0), new RegExp(`edge 0 of A \\(points ${10 + v} and ${10 + w}\\).*cleared at once, 0 evaluated`));
});

test("rows are shown a step at a time, as far as the chosen one", () => {
  assert.equal(shownUpTo(-1, 200, 200, 5000), 200);
  assert.equal(shownUpTo(199, 200, 200, 5000), 200);
  assert.equal(shownUpTo(200, 200, 200, 5000), 400);
  assert.equal(shownUpTo(4999, 200, 200, 5000), 5000);
  assert.equal(shownUpTo(-1, 200, 200, 7), 7);
});
