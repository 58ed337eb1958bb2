// SPDX-License-Identifier: GPL-3.0-or-later
// What each stage cost, beside the paper's bound: the rows of a table.

/** count / bound to three digits, or null where there is no bound. */
export function boundRatio({ count, bound_value: bound }) {
  return bound > 0 ? Number((count / bound).toPrecision(3)) : null;
}

/** Seconds for people. */
export function timeText(seconds) {
  if (seconds === undefined || seconds === null) return "\u2013";
  const [scale, unit] = seconds < 1e-3 ? [1e6, "\u00b5s"] : seconds < 1 ? [1e3, "ms"] : [1, "s"];
  return `${Number((seconds * scale).toPrecision(3))} ${unit}`;
}

/** The rows of the stages: bounds with their counts, and stages of which only the time is known. */
export function costRows({ bounds = [], seconds = {} }) {
  const rows = bounds.map((bound) => ({ ...bound, seconds: bound.seconds ?? undefined, ratio: boundRatio(bound) }));
  for (const [stage, time] of Object.entries(seconds)) {
    const row = rows.find((other) => other.stage === stage);
    if (row) row.seconds = time;
    else rows.push({ stage, what: null, count: null, bound: null, bound_value: null, source: null, seconds: time, ratio: null });
  }
  // A stage's time is said once, beside its first count.
  const said = new Set();
  return rows.map((row) => {
    const again = said.has(row.stage);
    said.add(row.stage);
    return again ? { ...row, seconds: undefined } : row;
  });
}
