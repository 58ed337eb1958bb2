// SPDX-License-Identifier: GPL-3.0-or-later
// The table of section 5.
import assert from "node:assert/strict";
import { test } from "node:test";
import { boundRatio, costRows, timeText } from "../../view/page/web/costrows.js";

const bound = (stage, changes = {}) => ({
  stage,
  what: "things",
  count: 30,
  bound: "m + n",
  bound_value: 120,
  source: "AGHRS (1)",
  ...changes,
});

test("the ratio is count / bound, to three digits; none without a bound", () => {
  assert.equal(boundRatio(bound("x")), 0.25);
  assert.equal(boundRatio(bound("x", { count: 1, bound_value: 3 })), 0.333);
  assert.equal(boundRatio(bound("x", { bound_value: null })), null);
  assert.equal(boundRatio(bound("x", { bound_value: 0 })), null);
});

test("times stand beside their stage, once; stages of which only the time is known come last", () => {
  const rows = costRows({
    bounds: [bound("charts"), bound("charts", { what: "others" }), bound("lines", { seconds: 0.5 }), bound("lines", { seconds: 0.5 })],
    seconds: { charts: 0.25, lines: 0.5, hulls: 1 },
  });
  assert.deepEqual(
    rows.map(({ stage, seconds }) => [stage, seconds]),
    [
      ["charts", 0.25],
      ["charts", undefined],
      ["lines", 0.5],
      ["lines", undefined],
      ["hulls", 1],
    ],
  );
  assert.equal(rows[4].count, null);
  assert.deepEqual(costRows({}), []);
});

test("times are for people", () => {
  assert.equal(timeText(0.00001234), "12.3 \u00b5s");
  assert.equal(timeText(0.0456), "45.6 ms");
  assert.equal(timeText(7), "7 s");
  assert.equal(timeText(undefined), "\u2013");
});
