// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs as curves on the sphere, their halves, walls, and where the camera stands.
import assert from "node:assert/strict";
import { test } from "node:test";
import { arcCurve, curveAbove, curvePoint, curvePoints } from "../../view/page/web/arcs.js";
import { cross, dot, norm, unit } from "../../view/page/web/geometry.js";
import {
  equatorOf,
  facingOf,
  halvesOfArcs,
  segmentsOf,
  stationOf,
  stripOnSphere,
  wallOnSphere,
} from "../../view/page/web/spheregeometry.js";
import { cube, cubes, distance, lowerFrame, pair, randomDirection, randomNumbers, upperFrame, wedge } from "./bodies.mjs";

test("an arc is the shorter way between its nodes, on the unit sphere", () => {
  const random = randomNumbers(1);
  for (let i = 0; i < 200; ++i) {
    const from = randomDirection(random),
      to = randomDirection(random),
      curve = arcCurve(wedge(from, to), 0);
    assert.ok(distance(curvePoint(curve, 0), from) < 1e-9, "begins at its first node");
    assert.ok(distance(curvePoint(curve, curve.angle), to) < 1e-6, "ends at its second node");
    assert.ok(Math.abs(curve.angle - Math.acos(dot(from, to))) < 1e-6, "as long as the angle between them");
    for (const p of curvePoints(curve)) assert.ok(Math.abs(norm(p) - 1) < 1e-12);
  }
});

test("an arc of nodes that are nearly opposite passes the outward side of its edge, of -A the other side", () => {
  // The edge x = 1, z = 0 of a thin blade: facets up and down, the edge faces +x.
  const from = unit([1e-5, 0, 1]),
    to = unit([1e-5, 0, -1]),
    blade = {
      vertices: [
        [1, -1, 0],
        [1, 1, 0],
        [-1, 0, 1e-5],
        [-1, 0, -1e-5],
      ],
    };
  const half = (more) => {
    const curve = arcCurve(wedge(from, to, { ...blade, ...more }), 0);
    return curvePoint(curve, curve.angle / 2);
  };
  assert.ok(half({})[0] > 0.999);
  assert.ok(half({ arcs_of: "-A", nodes: [from, to].map((n) => n.map((x) => -x)) })[0] < -0.999);
});

test("a half-circle passes circle x from, a full circle comes back", () => {
  const half = arcCurve({ ...wedge([0, 0, 1], [0, 0, -1]), circles: [[0, 1, 0]] }, 0);
  assert.ok(Math.abs(half.angle - Math.PI) < 1e-12);
  assert.ok(distance(curvePoint(half, Math.PI / 2), cross([0, 1, 0], [0, 0, 1])) < 1e-12);
  const full = arcCurve({ ...wedge(null, null), arcs: [[null, null]], circles: [[0, 0, 1]] }, 0);
  assert.equal(full.angle, 2 * Math.PI);
  for (const p of curvePoints(full)) assert.ok(Math.abs(p[2]) < 1e-12, "on its great circle");
});

test("equal nodes make an arc of no length, not NaN", () => {
  const curve = arcCurve(wedge([0, 0, 1], [0, 0, 1]), 0);
  assert.equal(curve.angle, 0);
  assert.ok(curvePoint(curve, 0).every(Number.isFinite));
});

test("halves: above the equator and below it, joined where the arc crosses it, whole together", () => {
  const random = randomNumbers(2);
  for (let i = 0; i < 200; ++i) {
    const body = wedge(randomDirection(random), randomDirection(random)),
      [upper, lower] = halvesOfArcs(body, [0], [0, 0, 1]);
    for (const p of upper.flat()) assert.ok(p[2] >= -1e-9, "upper");
    for (const p of lower.flat()) assert.ok(p[2] <= 1e-9, "lower");
    const length = [...upper, ...lower].reduce(
      (sum, points) => sum + points.slice(1).reduce((s, p, k) => s + distance(p, points[k]), 0),
      0,
    );
    assert.ok(Math.abs(length - arcCurve(body, 0).angle) < 1e-2, "nothing is lost");
  }
});

test("a full circle has a half above every pole, also where it begins there", () => {
  const random = randomNumbers(3);
  for (let i = 0; i < 100; ++i) {
    const circle = randomDirection(random),
      pole = randomDirection(random);
    const curve = arcCurve({ ...wedge(null, null), arcs: [[null, null]], circles: [circle] }, 0),
      [t0, t1] = curveAbove(curve, pole);
    assert.ok(Math.abs(t1 - t0 - Math.PI) < 1e-9);
    for (const p of curvePoints(curve, t0, t1)) assert.ok(dot(p, pole) > -1e-9);
  }
});

test("segments: two points of three coordinates for each step, at the radius", () => {
  const flat = segmentsOf(
    [
      [
        [1, 0, 0],
        [0, 1, 0],
        [0, 0, 1],
      ],
      [
        [1, 0, 0],
        [0, 0, 1],
      ],
    ],
    2,
  );
  assert.equal(flat.length, 3 * 6);
  assert.deepEqual(flat.slice(6, 12), [0, 2, 0, 0, 0, 2]);
});

test("a wall runs from -v to v through its node, within the hemisphere", () => {
  const random = randomNumbers(4);
  for (const frame of [upperFrame, lowerFrame])
    for (let i = 0; i < 50; ++i) {
      const n = randomDirection(random);
      if (dot(n, frame.z) < 0.05) continue;
      const wall = wallOnSphere(n, frame);
      assert.ok(distance(wall[0], [0, -1, 0]) < 1e-12 && distance(wall.at(-1), [0, 1, 0]) < 1e-12);
      assert.ok(
        wall.every((p) => dot(p, frame.z) > -1e-12),
        "hemisphere",
      );
      assert.ok(Math.min(...wall.map((p) => distance(p, n))) < 0.04, "node");
    }
});

test("the strip of a pair has its walls, infinite ones left out", () => {
  const data = cubes({ pairs: [pair({ strip: [null, 1] }), pair({ strip: [0, 1] })] });
  assert.equal(stripOnSphere(data.pairs[0], data.charts[0], data.bodies).length, 1);
  assert.equal(stripOnSphere(data.pairs[1], data.charts[0], data.bodies).length, 2);
});

test("the camera's station faces its hemisphere; the equator is orthogonal to the pole", () => {
  assert.equal(facingOf(stationOf(upperFrame, 5), upperFrame.z), 0);
  assert.equal(facingOf(stationOf(lowerFrame, 5), upperFrame.z), 1);
  assert.ok(Math.abs(norm(stationOf(lowerFrame, 5)) - 5) < 1e-12);
  for (const p of equatorOf(upperFrame)) assert.ok(Math.abs(p[2]) < 1e-12);
});

test("a cube's diagram: twelve arcs of a quarter circle, of A opposite to those of B", () => {
  const a = cube("a"),
    b = cube("b");
  for (let e = 0; e < 12; ++e) {
    const of = (body) => arcCurve(body, e),
      middleOf = (curve) => curvePoint(curve, curve.angle / 2);
    assert.ok(Math.abs(of(a).angle - Math.PI / 2) < 1e-12);
    assert.ok(
      distance(
        middleOf(of(a)),
        middleOf(of(b)).map((x) => -x),
      ) < 1e-12,
    );
  }
});

test("a full circle on the equator is whole in both halves", () => {
  const circle = { ...wedge(null, null), arcs: [[null, null]], circles: [[0, 0, 1]] };
  for (const half of halvesOfArcs(circle, [0], [0, 0, 1])) {
    assert.equal(half.length, 1);
    assert.ok(distance(half[0][0], half[0].at(-1)) < 1e-9, "closed");
  }
});
