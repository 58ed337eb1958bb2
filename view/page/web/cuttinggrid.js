// SPDX-License-Identifier: GPL-3.0-or-later
// The blocks of a cutting, level by level, as rectangles. Blocks are half-open: rows [first, last), columns [first, last).

export const blockFates = ["cleared", "refined", "scanned", "won"];

export const fateSentences = {
  cleared: "proved to be strictly farther than the best so far",
  refined: "cut once more",
  scanned: "each of its crossings looked at",
  won: "holds the pair\u2019s closest lines",
};

/** The blocks that stand after the first `level` levels: those of that level, and of the ones before all that were not refined. */
export function blocksAt(cutting, level) {
  return cutting.levels.flatMap((at, k) =>
    k > level ? [] : at.blocks.filter((block) => k === level || block.fate !== "refined").map((block) => ({ ...block, level: k })),
  );
}

/** How many crossings each fate covers after these levels: {cleared, refined, scanned, won}. */
export function crossingsByFate(blocks) {
  const result = Object.fromEntries(blockFates.map((fate) => [fate, { blocks: 0, crossings: 0 }]));
  for (const { rows, columns, fate } of blocks) {
    result[fate].blocks += 1;
    result[fate].crossings += (rows[1] - rows[0]) * (columns[1] - columns[0]);
  }
  return result;
}

/** The size of a cell in the picture: rows and columns are equally high and wide as long as both sides stay readable. */
export function gridCells(rows, columns, widest = 640, highest = 420) {
  const width = Math.min(28, widest / columns),
    height = Math.min(28, highest / rows);
  const square = Math.min(width, height),
    most = 4 * square;
  return { width: Math.min(width, most), height: Math.min(height, most) };
}

/** What a level did, as a sentence. */
export function levelSentence(cutting, level) {
  const { side, blocks } = cutting.levels[level];
  const whole = side === null ? "The whole grid is one block." : `The chain of ${side === "a" ? "\u2212A (rows)" : "B (columns)"} was cut.`;
  const counts = blockFates.map((fate) => [fate, blocks.filter((block) => block.fate === fate).length]).filter(([, count]) => count > 0);
  const fates = counts.map(([fate, count]) => `${count} ${fate}`).join(", ");
  return `Level ${level} of ${cutting.levels.length - 1}. ${whole} Blocks of this level: ${fates}.`;
}
