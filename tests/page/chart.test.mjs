// SPDX-License-Identifier: GPL-3.0-or-later
// Projections of the charts, clipping, strips, what a click finds, and what a selection lights.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  arcCurve,
  arcOnChart,
  arcOnPlane,
  chartAxes,
  chartPlace,
  clippedSegment,
  curveAbove,
  curvePoint,
  planePlace,
} from "../../view/page/web/arcs.js";
import {
  chartPolylines,
  chartProjection,
  chartSide,
  chartTicks,
  hemisphereShown,
  nearestArc,
  nextPairOfArc,
  pairsOfArc,
  pathText,
  stripBorders,
} from "../../view/page/web/chartpainter.js";
import { crossingsSentence } from "../../view/page/web/chartparts.js";
import { hemisphereOfChoice, liesBelow, litArcs, litInDiagrams } from "../../view/page/web/lit.js";
import { cubes, lowerFrame, pair, randomDirection, randomNumbers, upperFrame, wedge } from "./bodies.mjs";

const upper = chartAxes(upperFrame),
  lower = chartAxes(lowerFrame);
const near = (p, q, by = 1e-9) => p.forEach((x, i) => assert.ok(Math.abs(x - q[i]) <= by, `${p} is not ${q}`));
const none = { pair: null, facet: null, coincidence: null };

test("longitude is atan2(x, z), latitude asin(y); the lower chart is seen from outside", () => {
  const h = Math.SQRT1_2;
  near(chartPlace([0, 0, 1], upper), [0, 0]);
  near(chartPlace([h, 0, h], upper), [45, 0]);
  near(chartPlace([0, h, h], upper), [0, 45]);
  near(chartPlace([1, 0, 0], upper), [90, 0]);
  near(chartPlace([0, 0, -1], lower), [0, 0]);
  near(chartPlace([-h, 0, -h], lower), [45, 0]);
  near(chartPlace([0, -h, -h], lower), [0, -45]);
});

test("a hemisphere fits the square from -90 to 90", () => {
  const random = randomNumbers(5),
    projection = chartProjection(upperFrame, false);
  for (let i = 0; i < 500; ++i) {
    const n = randomDirection(random),
      place = projection.place(n);
    assert.equal(place === null, n[2] < 0);
    if (place) assert.ok(place.every((x) => x >= 0 && x <= chartSide));
  }
});

test("verticals are vertical in both projections", () => {
  const at = (y) => {
    const r = Math.sqrt(1 - y * y);
    return [0.6 * r, y, 0.8 * r];
  };
  for (const plane of [false, true]) {
    const projection = chartProjection(upperFrame, plane),
      xs = [-0.7, -0.2, 0, 0.5, 0.9].map((y) => projection.place(at(y))[0]);
    for (const x of xs) assert.ok(Math.abs(x - xs[0]) < 1e-9);
    assert.ok(projection.place(at(0.5))[1] < projection.place(at(-0.2))[1], "up is up");
  }
});

test("the polyline of an arc stays within a tenth of a degree of it", () => {
  const random = randomNumbers(6);
  for (let i = 0; i < 100; ++i) {
    const curve = arcCurve(wedge(randomDirection(random), randomDirection(random)), 0),
      points = arcOnChart(curve, upper),
      part = curveAbove(curve, upper.z);
    assert.equal(points === null, part === null);
    if (!points) continue;
    for (let k = 1; k < 20; ++k) {
      const place = chartPlace(curvePoint(curve, part[0] + ((part[1] - part[0]) * k) / 20), upper);
      const arc = nearestArc({ a: [{ edge: 0, points }], b: [] }, place, Math.abs(place[1]) > 85 ? 5 : 0.3);
      assert.ok(arc, `${place} is off the polyline`);
    }
  }
});

test("an arc that begins or ends at (0, 1, 0) is there at its own longitude", () => {
  for (const nodes of [
    [
      [1, 0, 0],
      [0, 1, 0],
    ],
    [
      [0, 1, 0],
      [1, 0, 0],
    ],
  ])
    for (const [longitude] of arcOnChart(arcCurve(wedge(...nodes), 0), upper)) assert.ok(Math.abs(longitude - 90) < 1e-3);
});

test("in the paper's plane arcs are segments of straight lines, clipped to the window", () => {
  const random = randomNumbers(7);
  for (let i = 0; i < 200; ++i) {
    const curve = arcCurve(wedge(randomDirection(random), randomDirection(random)), 0),
      ends = arcOnPlane(curve, upper, 4);
    if (!ends) continue;
    const [p, q] = ends,
      part = curveAbove(curve, upper.z),
      c = planePlace(curvePoint(curve, (part[0] + part[1]) / 2), upper);
    const area = (q[0] - p[0]) * (c[1] - p[1]) - (q[1] - p[1]) * (c[0] - p[0]),
      size = Math.hypot(q[0] - p[0], q[1] - p[1]) * (1 + Math.hypot(...c));
    assert.ok(Math.abs(area) <= 1e-6 * (1 + size), "straight");
    for (const x of [...p, ...q]) assert.ok(Math.abs(x) <= 4 + 1e-9, "clipped");
  }
});

test("clipping: inside, across, beside, through a corner", () => {
  assert.deepEqual(clippedSegment([0, 0], [1, 1], 2), [
    [0, 0],
    [1, 1],
  ]);
  assert.deepEqual(clippedSegment([-4, 0], [4, 0], 2), [
    [-2, 0],
    [2, 0],
  ]);
  assert.deepEqual(clippedSegment([0, 0], [0, 8], 2), [
    [0, 0],
    [0, 2],
  ]);
  assert.equal(clippedSegment([3, -9], [3, 9], 2), null);
  assert.equal(clippedSegment([3, 0], [0, 9], 2), null);
});

test("both axes are labelled from -90 to 90 degrees, of the plane from -4 to 4", () => {
  const labels = chartTicks(false).map(([, label]) => label);
  assert.deepEqual([labels[0], labels.at(-1)], ["\u221290\u00b0", "90\u00b0"]);
  assert.deepEqual(
    chartTicks(true).map(([value]) => value),
    [-4, -3, -2, -1, 0, 1, 2, 3, 4],
  );
});

test("the lit arc of a half that only the perturbation gives has a point on the border", () => {
  const projection = chartProjection(upperFrame, false),
    below = [Math.SQRT1_2, 0, -Math.SQRT1_2],
    border = [0.6, 0.8, 0];
  for (const nodes of [
    [border, below],
    [below, border],
  ]) {
    const [x, y] = projection.point(arcCurve(wedge(...nodes), 0));
    near([x, y], [chartSide, ((90 - (Math.asin(0.8) * 180) / Math.PI) / 180) * chartSide], 1e-6);
  }
});

test("a strip lies between its walls; at infinity it ends with the picture", () => {
  const data = cubes(),
    projection = chartProjection(upperFrame, false),
    walls = [
      ["a", 0],
      ["a", 5],
      ["b", 0],
    ];
  // Of -A: node 0 is (-1, 0, 0), node 5 is (0, 0, 1). Of B: node 0 is (1, 0, 0).
  assert.deepEqual(stripBorders([0, 1], walls, data.bodies, projection), [0, chartSide / 2]);
  assert.deepEqual(stripBorders([1, null], walls, data.bodies, projection), [chartSide / 2, chartSide]);
  assert.deepEqual(stripBorders([null, null], walls, data.bodies, projection), [0, chartSide]);
  assert.deepEqual(
    stripBorders([1, 2], walls, data.bodies, chartProjection(upperFrame, true)),
    [chartSide / 2, chartSide],
    "a wall outside of the window",
  );
});

test("polylines leave out the other hemisphere", () => {
  const data = cubes(),
    edges = [...data.bodies.b.arcs.keys()];
  const isBelow = (e) => data.bodies.b.arcs[e].includes(5);
  const shown = chartPolylines(data.bodies.b, edges, chartProjection(upperFrame, false)).map(({ edge }) => edge);
  for (const e of edges.filter((e) => data.bodies.b.arcs[e].includes(4))) assert.ok(shown.includes(e));
  for (const e of edges.filter(isBelow)) assert.ok(!shown.includes(e) || data.bodies.b.arcs[e].some((n) => n !== 5));
  assert.equal(
    pathText([
      [0, 1.26],
      [2, 3],
    ]),
    "M0 1.3L2 3",
  );
});

test("a click finds the nearest arc within reach, and goes round its pairs, largest first", () => {
  const lists = {
    a: [
      {
        edge: 3,
        points: [
          [0, 0],
          [10, 0],
        ],
      },
    ],
    b: [
      {
        edge: 8,
        points: [
          [0, 6],
          [10, 6],
        ],
      },
    ],
  };
  assert.deepEqual(nearestArc(lists, [5, 2], 9), { name: "a", edge: 3 });
  assert.deepEqual(nearestArc(lists, [5, 4], 9), { name: "b", edge: 8 });
  assert.equal(nearestArc(lists, [25, 2], 9), null);
  const data = cubes({ pairs: [pair({ a: [3] }), pair({ a: [3, 4], b: [1, 2] }), pair({ a: [3], chart: 1 }), pair({ a: [5] })] });
  assert.deepEqual(pairsOfArc(data, "a", 3, 0), [1, 0]);
  assert.equal(nextPairOfArc(data, "a", 3, 0, null), 1);
  assert.equal(nextPairOfArc(data, "a", 3, 0, 1), 0);
  assert.equal(nextPairOfArc(data, "a", 3, 0, 0), 1);
  assert.equal(nextPairOfArc(data, "b", 11, 0, 0), null);
});

test("of both hemispheres the one in front is shown", () => {
  assert.deepEqual(
    ["upper", "lower", "both", "both"].map((hemisphere, i) => hemisphereShown({ hemisphere }, i === 2 ? 1 : 0)),
    [0, 1, 1, 0],
  );
});

test("a pair lights exactly its arcs; a facet of a body its node, an edge its arc, a vertex the border of its face", () => {
  const facet = (a, b) => ({ vertices: [], normal: [0, 0, 1], distance: 1, a, b, pairs: [], optimal: false });
  const ids = (data, name, vertices) => vertices.map((v) => data.bodies[name].ids[v]);
  let data = cubes({ pairs: [pair({ a: [0, 1], b: [2, 3, 4] })] });
  const { a, b } = data.bodies;
  data = cubes({
    pairs: data.pairs,
    sum: {
      kind: "P",
      vertices: [],
      facets: [facet(ids(data, "a", a.facets[4]), ids(data, "b", [0])), facet(ids(data, "a", a.edges[7]), ids(data, "b", b.edges[2]))],
    },
  });
  assert.deepEqual(litArcs(litInDiagrams(data, { ...none, pair: 0, facet: 1 })), [
    ["a", 0],
    ["a", 1],
    ["b", 2],
    ["b", 3],
    ["b", 4],
  ]);
  const lit = litInDiagrams(data, { ...none, facet: 0 });
  assert.deepEqual(lit.a, { arcs: [], nodes: [4] });
  assert.deepEqual(lit.b.arcs, b.edgesAt[0]);
  assert.deepEqual(litArcs(litInDiagrams(data, { ...none, facet: 1 })), [
    ["a", 7],
    ["b", 2],
  ]);
  assert.deepEqual(litArcs(litInDiagrams(data, none)), []);
});

test("a coincidence lights all its features", () => {
  let data = cubes();
  const { a } = data.bodies,
    ids = (vertices) => vertices.map((v) => a.ids[v]);
  data = cubes({ coincidences: [{ kind: "parallel_edges_of_a", count: 1, listed: [{ a: [ids(a.edges[0]), ids(a.edges[5])], b: [] }] }] });
  assert.deepEqual(litInDiagrams(data, { ...none, coincidence: "0.0" }), { a: { arcs: [0, 5], nodes: [] }, b: { arcs: [], nodes: [] } });
});

test("a choice asks for its hemisphere: a pair for its chart, a coincidence for where its nodes are", () => {
  let data = cubes();
  const { a, b } = data.bodies, ids = (body, vertices) => vertices.map((v) => body.ids[v]);
  // Facet 4 has the outward normal (0, 0, 1): its node is above in B's diagram, below in that of -A.
  const listed = [
    { a: [], b: [ids(b, b.facets[4])] },
    { a: [ids(a, a.facets[4])], b: [] },
  ];
  data = cubes({ pairs: [pair({ chart: 1 })], coincidences: [{ kind: "equal_normals", count: 2, listed }] });
  const asked = (chosen, ...changed) => hemisphereOfChoice(data, { ...none, ...chosen }, new Set(changed));
  assert.equal(asked({ pair: 0 }, "pair"), 1);
  assert.equal(asked({ pair: 0, coincidence: "0.0" }, "coincidence"), null, "a pair stays in sight");
  assert.equal(asked({ coincidence: "0.0" }, "coincidence"), 0);
  assert.equal(asked({ coincidence: "0.1" }, "coincidence"), 1);
  assert.equal(asked({ coincidence: "0.1" }, "plane"), null);
  assert.equal(asked({}, "pair", "coincidence"), null);
  assert.equal(liesBelow(data, { a: { arcs: [], nodes: [4] }, b: { arcs: [], nodes: [] } }), true);
});

test("dots are crossings of a chosen pair; what is left out is said", () => {
  const p = { stages: { sum: { kind: "P" } } };
  assert.equal(crossingsSentence(p, 6, 144), "144 dots are where arcs of pair 6 cross: normals of facets of P.");
  assert.equal(crossingsSentence(p, 0, 1), "The dot is where arcs of pair 0 cross: the normal of a facet of P.");
  assert.match(crossingsSentence(p, 0, 0), /only once they are perturbed/);
  assert.match(crossingsSentence(p, 0, 5001), /The first 5000 are drawn\.$/);
  assert.match(crossingsSentence({ stages: { sum: { kind: "Q" } } }, 3, 0), /not drawn: P is not listed/);
});
