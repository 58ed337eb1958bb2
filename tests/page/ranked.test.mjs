// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import test from "node:test";
import { gapOf, kindOfFacet } from "../../view/page/web/ranked.js";

const facets = (...squares) => squares.map((distance_squared) => ({ distance_squared }));

test("the gap is that from the nearest facets to the first one beyond them", () => {
  assert.deepEqual(gapOf(facets("1/4", "1/4", "1", "4")), { ties: 2, second: 1, gap: 0.5, share: 1 });
  assert.deepEqual(gapOf(facets("1/4")), { ties: 1, second: null, gap: null, share: null });
  assert.equal(gapOf([]), null);
  assert.equal(gapOf(facets("0", "1")).share, null);
});

test("facets that nearly tie do not tie", () => {
  const q = 10n ** 50n, told = gapOf(facets("1", `${q + 1n}/${q}`));
  assert.equal(told.ties, 1);
  assert.equal(told.second, 1);
  assert.ok(Math.abs(told.gap / 5e-51 - 1) < 1e-12);
});

test("the contact at a facet names A's feature first", () => {
  assert.equal(kindOfFacet({ a: [3], b: [1, 2, 5] }), "vertex-facet");
  assert.equal(kindOfFacet({ a: [3, 4], b: [1, 2] }), "edge-edge");
  assert.equal(kindOfFacet({ a: [1, 2, 3, 4], b: [1, 2, 3] }), "facet-facet");
});
