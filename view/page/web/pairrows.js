// SPDX-License-Identifier: GPL-3.0-or-later
// The canonical pairs as rows of a table: the larger ones, then those of one crossing, folded.

import { nearestRoot, textOf } from "./numbers.js";

export const pairSize = (pair) => pair.a.length * pair.b.length;

/** The rows: {large: [pair index..], single: [pair index..]} in the order of data.order, greatest first. */
export function pairRows({ order, pairs }) {
  return { large: order.filter((i) => pairSize(pairs[i]) > 1), single: order.filter((i) => pairSize(pairs[i]) === 1) };
}

/** The cells of a pair's row, as text: #, hemisphere, stored of, |A_i| x |B_i|, closest distance, evaluated, engine. */
export function pairCells(data, i) {
  const pair = data.pairs[i],
    { closest } = pair;
  return [
    String(i),
    data.charts[pair.chart]?.hemisphere ?? "",
    pair.stored_of === "a" ? "\u2212A" : "B",
    `${pair.a.length} \u00d7 ${pair.b.length}`,
    closest ? textOf(nearestRoot(closest.distance_squared)) : "\u2013",
    String(pair.evaluated),
    pair.engine ?? "\u2013",
  ];
}

export const pairHeadings = ["#", "hemisphere", "stored of", "|A\u1d62| \u00d7 |B\u1d62|", "closest distance", "evaluated", "engine"];

/** What a pair is, in sentences. */
export function pairSentence(data, i) {
  const pair = data.pairs[i],
    hemisphere = data.charts[pair.chart]?.hemisphere ?? "",
    crossings = pairSize(pair);
  const stored = pair.stored_of === "a" ? "\u2212A" : "B",
    query = pair.stored_of === "a" ? "B" : "\u2212A";
  const sense = pair.rising ? "from below to above" : "from above to below";
  return (
    `Canonical pair ${i}, ${hemisphere} hemisphere: ${edgesText(pair.a.length)} of A and ${edgesText(pair.b.length)} of B, ` +
    `${crossings === 1 ? "1 crossing" : `${crossings} crossings`}. ` +
    `The arcs of ${stored} span the strip; going right, those of ${query} cross them ${sense}.`
  );
}

const edgesText = (count) => (count === 1 ? "1 edge" : `${count} edges`);

/** Where the closest pair of lines of a pair is, or null. */
export function closestSentence(data, i) {
  const { closest, evaluated, engine } = data.pairs[i];
  if (!closest) return null;
  const points = (name) => data.bodies[name].edges[closest[name]].map((v) => data.bodies[name].ids[v]).join(" and ");
  const work =
    { scanned: "each crossing was looked at", cleared: "all crossings were cleared at once", cut: "the grid was cut" }[engine] ?? "";
  return (
    `Its closest lines: edge ${closest.a} of A (points ${points("a")}) and edge ${closest.b} of B (points ${points("b")})` +
    `${work ? `; ${work}, ${evaluated} evaluated` : ""}.`
  );
}

/** How many of a list are shown so that the one at `position` is among them: a step at a time. */
export function shownUpTo(position, shown, step, length) {
  return Math.min(length, Math.max(shown, Math.ceil((position + 1) / step) * step));
}
