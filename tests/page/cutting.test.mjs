// SPDX-License-Identifier: GPL-3.0-or-later
// The blocks of a cutting, level by level.
import assert from "node:assert/strict";
import { test } from "node:test";
import { blockFates, blocksAt, crossingsByFate, fateSentences, gridCells, levelSentence } from "../../view/page/web/cuttinggrid.js";

const block = (rows, columns, fate) => ({ rows, columns, fate });
const cutting = {
  pair: 0,
  of: "winner",
  as_searched: true,
  levels: [
    { level: 0, side: null, blocks: [block([0, 5], [0, 8], "refined")] },
    { level: 1, side: "a", blocks: [block([0, 2], [0, 8], "refined"), block([2, 5], [0, 8], "cleared")] },
    { level: 2, side: "b", blocks: [block([0, 2], [0, 3], "won"), block([0, 2], [3, 8], "scanned")] },
  ],
};

test("after each level the blocks partition the grid", () => {
  for (const level of [0, 1, 2]) {
    const covered = new Set();
    for (const { rows, columns } of blocksAt(cutting, level))
      for (let i = rows[0]; i < rows[1]; ++i)
        for (let j = columns[0]; j < columns[1]; ++j) {
          assert.ok(!covered.has(`${i},${j}`), "once");
          covered.add(`${i},${j}`);
        }
    assert.equal(covered.size, 40, `level ${level}`);
  }
});

test("refined blocks are shown at their own level only", () => {
  assert.deepEqual(
    blocksAt(cutting, 1).map(({ fate, level }) => [fate, level]),
    [
      ["refined", 1],
      ["cleared", 1],
    ],
  );
  assert.deepEqual(
    blocksAt(cutting, 2).map(({ fate, level }) => [fate, level]),
    [
      ["cleared", 1],
      ["won", 2],
      ["scanned", 2],
    ],
  );
});

test("crossings by fate: rows and columns are half-open", () => {
  assert.deepEqual(crossingsByFate(blocksAt(cutting, 2)), {
    cleared: { blocks: 1, crossings: 24 },
    refined: { blocks: 0, crossings: 0 },
    scanned: { blocks: 1, crossings: 10 },
    won: { blocks: 1, crossings: 6 },
  });
  for (const fate of blockFates) assert.ok(fateSentences[fate]);
});

test("cells fit the picture, and none is a sliver where there is room", () => {
  for (const [rows, columns] of [
    [1, 1],
    [16, 10],
    [3, 500],
    [400, 2],
    [1000, 1000],
  ]) {
    const { width, height } = gridCells(rows, columns);
    assert.ok(columns * width <= 640 + 1e-9 && rows * height <= 420 + 1e-9, `${rows} x ${columns}`);
    assert.ok(Math.max(width, height) <= 4 * Math.min(width, height) + 1e-9);
  }
  assert.deepEqual(gridCells(16, 10), { width: 26.25 * (28 / 26.25), height: 26.25 });
});

test("a level says which chain was cut, and what became of its blocks", () => {
  assert.equal(levelSentence(cutting, 0), "Level 0 of 2. The whole grid is one block. Blocks of this level: 1 refined.");
  assert.match(levelSentence(cutting, 1), /Level 1 of 2\. The chain of \u2212A \(rows\) was cut\. .*1 cleared, 1 refined\./);
  assert.match(levelSentence(cutting, 2), /B \(columns\).*1 scanned, 1 won\./);
});
