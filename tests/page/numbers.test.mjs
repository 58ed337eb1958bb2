// SPDX-License-Identifier: GPL-3.0-or-later
// Decimals of exact numbers: the nearest binary64, however large, small or near a tie.
import assert from "node:assert/strict";
import test from "node:test";
import { decimalsOf, gapOfRoots, nearest, nearestRoot, textOf, unitOf } from "../../view/page/web/numbers.js";

/** The exact value of a binary64 as "p/q". */
function exact(x) {
  let shift = 0n;
  while (!Number.isInteger(x)) {
    x *= 2;
    shift += 1n;
  }
  return [BigInt(x), 1n << shift];
}

test("a binary64 comes back as itself, of every size and sign", () => {
  const extremes = [1e300, 1e-300, 5e-324, -5e-324, 2.2250738585072014e-308, Number.MAX_VALUE];
  for (const x of [0, 1, -1, 0.1, -0.1, 1 / 3, 0.47761546311385563, ...extremes]) {
    const [p, q] = exact(x);
    assert.equal(nearest(`${p}/${q}`), x);
    const root = nearestRoot(`${p * p}/${q * q}`);
    assert.equal(root, Math.abs(x));
  }
});

test("just above and below a tie go to different sides, and a tie goes to the even one", () => {
  const big = 10n ** 60n, tie = (2n ** 53n + 1n) * big;  // half way between 2^53 and 2^53 + 2
  assert.equal(nearest(`${tie}/${big}`), 2 ** 53);
  assert.equal(nearest(`${tie + 1n}/${big}`), 2 ** 53 + 2);
  assert.equal(nearest(`${tie - 1n}/${big}`), 2 ** 53);
  assert.equal(nearest(`${(2n ** 53n + 3n) * big}/${big}`), 2 ** 53 + 4);
  assert.equal(nearestRoot(`${tie * tie + 1n}/${big * big}`), 2 ** 53 + 2);
  assert.equal(nearestRoot(`${tie * tie}/${big * big}`), 2 ** 53);
  assert.equal(nearestRoot(`${(2n ** 53n + 1n) ** 2n + 1n}`), 2 ** 53 + 2);
});

test("halves of the least subnormal number are rounded once", () => {
  const least = 1n << 1074n;
  assert.equal(nearest(`1/${2n * least}`), 0);
  assert.equal(nearest(`3/${2n * least}`), 1e-323);
  assert.equal(nearest(`${2n ** 70n + 1n}/${least << 71n}`), 5e-324);
});

test("what is beyond the finite numbers is infinite", () => assert.equal(nearest((2n ** 1025n).toString()), Infinity));

test("the gap of near ties keeps its digits", () => {
  const q = 10n ** 40n, gap = gapOfRoots(`${q + 2n}/${q}`, "1");
  assert.ok(Math.abs(gap / 1e-40 - 1) < 1e-12, String(gap));
  assert.equal(gapOfRoots("2", "2"), 0);
  for (const big of [10n ** 300n, 2n ** 900n]) {
    assert.ok(Math.abs(gapOfRoots(`${4n * big * big}`, `${big * big}`) / Number(big) - 1) < 1e-15);
    assert.ok(Math.abs(gapOfRoots(`4/${big * big}`, `1/${big * big}`) * Number(big) - 1) < 1e-15);
    assert.ok(Math.abs(gapOfRoots(`${(big + 1n) ** 2n}`, `${big * big}`) - 1) < 1e-15);
  }
});

test("the gap of huge numbers may be tiny", () => {
  const big = 10n ** 600n, gap = gapOfRoots(`${(big + 1n) ** 2n}/${10n ** 600n}`, `${big ** 2n}/${10n ** 600n}`);
  assert.ok(Math.abs(gap * 1e300 - 1) < 1e-15);
});

test("unit vectors and translations", () => {
  assert.deepEqual(unitOf(["3", "0", "-4"]), [0.6, 0, -0.8]);
  assert.deepEqual(decimalsOf(["1/3", "-1/2", "0"]), [1 / 3, -0.5, 0]);
  assert.deepEqual(decimalsOf({ normal: ["0", "0", "2"], alpha: "1/2", beta: "3" }), [0, 0, 4]);
  assert.equal(textOf(-0), "0");
});
