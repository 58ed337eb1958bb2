// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies and data for the tests of sections 3 to 5, as `fathom stages` gives them.
import { makeData } from "../../view/page/web/data.js";

const axes = [
  [1, 0, 0],
  [-1, 0, 0],
  [0, 1, 0],
  [0, -1, 0],
  [0, 0, 1],
  [0, 0, -1],
];

/** The cube [-1, 1]^3, as A (nodes negated) or B. Facet f has the outward normal axes[f]. */
export function cube(name) {
  const vertices = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1, (i >> 1) & 1, (i >> 2) & 1].map((bit) => 2 * bit - 1));
  const isOn = (f, v) => axes[f].reduce((sum, x, i) => sum + x * vertices[v][i], 0) === 1;
  const facets = axes.map((_, f) => vertices.flatMap((_, v) => (isOn(f, v) ? [v] : [])));
  const edges = [],
    arcs = [];
  for (let v = 0; v < 8; ++v)
    for (let w = v + 1; w < 8; ++w) {
      const common = axes.flatMap((_, f) => (isOn(f, v) && isOn(f, w) ? [f] : []));
      if (common.length === 2) (edges.push([v, w]), arcs.push(common));
    }
  const sign = name === "a" ? -1 : 1,
    nodes = axes.map((n) => n.map((x) => sign * x || 0));
  return { rank: 3, ids: vertices.map((_, v) => 10 + v), vertices, edges, facets, arcs_of: name === "a" ? "-A" : "B", nodes, arcs };
}

export const upperFrame = { v: [0, 1, 0], z: [0, 0, 1] },
  lowerFrame = { v: [0, 1, 0], z: [0, 0, -1] };

const chart = (hemisphere, frame) => ({
  hemisphere,
  frame,
  a: { nodes: [], arcs: [] },
  b: { nodes: [], arcs: [] },
  walls: [
    ["a", 5],
    ["b", 4],
  ],
});

export const pair = (changes = {}) => ({
  chart: 0,
  stored_of: "a",
  rising: true,
  a: [0],
  b: [1],
  strip: [null, 0],
  closest: null,
  evaluated: 1,
  engine: "scanned",
  ...changes,
});

/** Data of two cubes with these fields of the stages in place of the plain ones. */
export function cubes(changes = {}) {
  const stages = {
    status: "penetrating",
    a: cube("a"),
    b: cube("b"),
    charts: [chart("upper", upperFrame), chart("lower", lowerFrame)],
    pairs: [],
    cutting: null,
    sum: { kind: "none", vertices: [], facets: [] },
    coincidences: [],
    scale: { center: ["0", "0", "0"], exponent: 0, unit: "1" },
    ...changes,
  };
  return makeData({ status: "penetrating" }, stages);
}

/** Numbers in [0, 1), the same in every run. */
export function randomNumbers(seed) {
  let state = seed >>> 0;
  return () => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 4294967296;
}

export function randomDirection(random) {
  for (;;) {
    const p = [0, 0, 0].map(() => 2 * random() - 1),
      length = Math.hypot(...p);
    if (length > 0.1 && length < 1) return p.map((x) => x / length);
  }
}

export const distance = (p, q) => Math.hypot(...p.map((x, i) => x - q[i]));

/** A body of one edge between two facets with these normals. */
export const wedge = (from, to, more = {}) => ({
  rank: 3,
  vertices: [
    [0, 0, 0],
    [0, 0, 1],
  ],
  edges: [[0, 1]],
  nodes: [from, to],
  arcs: [[0, 1]],
  arcs_of: "B",
  ...more,
});
