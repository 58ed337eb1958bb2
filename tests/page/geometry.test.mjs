// SPDX-License-Identifier: GPL-3.0-or-later
import assert from "node:assert/strict";
import test from "node:test";
import {
  across, creases, cross, dot, edgesOfPolygons, frameOf, inOrder, meetingPoint, norm, sideView, unit,
} from "../../view/page/web/geometry.js";

const near = (p, q) => assert.ok(norm(p.map((x, i) => x - q[i])) < 1e-12, `${p} is not ${q}`);

test("a frame shows all points within one cube, with one scale unless extents differ a hundredfold", () => {
  const even = frameOf([[0, 0, 0], [4, 2, 1]]);
  near(even.place([0, 0, 0]), [-1, -0.5, -0.25]);
  near(even.place([4, 2, 1]), [1, 0.5, 0.25]);
  assert.equal(even.apart, false);
  const apart = frameOf([[0, 0, 0], [1000, 2, 1]]);
  assert.equal(apart.apart, true);
  near(apart.place([1000, 2, 1]), [1, 1, 1]);
  near(apart.move([500, 1, 0.5]), [1, 1, 1]);
});

test("flat, single and huge sets of points have finite frames", () => {
  for (const points of [[[1, 1, 1]], [[0, 0, 3], [1, 1, 3]], [[-1e308, 0, 0], [1e308, 1e308, 1]], [[0, 0, 0], [1e-310, 0, 0]], []]) {
    const frame = frameOf(points);
    for (const p of points) frame.place(p).forEach((x) => assert.ok(Math.abs(x) <= 1, `${x}`));
    assert.ok(frame.scale.every((s) => s > 0 && Number.isFinite(s)));
  }
});

test("seen from the side, the arrow points to the right and is hardly foreshortened", () => {
  for (const arrow of [[1, 0, 0], [0, 0, -1], [0, 0, 1], [-0.3, 0.2, 0.9], [1e-12, 0, 0]]) {
    const { from, up } = sideView(arrow);
    assert.ok(dot(cross(up, from), unit(arrow)) > 0.85);
    assert.ok(Math.abs(dot(from, unit(arrow))) < 0.4);
    assert.ok(dot(from, up) > 0);
  }
});

test("a vector across another is a unit vector, orthogonal to it", () => {
  for (const v of [[0, 0, 1], [1, 1, 1], [0, 1e-200, 0]]) {
    assert.ok(Math.abs(dot(across(v), unit(v))) < 1e-12);
    assert.ok(Math.abs(norm(across(v)) - 1) < 1e-12);
  }
});

test("features of contact meet within both", () => {
  const z = [0, 0, 1], square = [[0, 0, 0], [2, 2, 0], [2, 0, 0], [0, 2, 0]];
  near(meetingPoint([[1, 1, 0]], square, z), [1, 1, 0]);
  near(meetingPoint([[-1, 1, 0], [3, 1, 0]], [[1, 0, 0], [1, 5, 0]], z), [1, 1, 0]);
  near(meetingPoint([[0, 0, 0], [2, 0, 0]], [[1, 0, 0], [5, 0, 0]], z), [1.5, 0, 0]);
  near(meetingPoint([[-1, 1, 0], [1, 1, 0]], square, z), [0.5, 1, 0]);
  near(meetingPoint(square, [[-1, 1, 0], [1, 1, 0]], z), [0.5, 1, 0]);
  near(meetingPoint(square, square.map(([x, y]) => [x + 1, y + 1, 0]), z), [1.5, 1.5, 0]);
});

test("of a mesh the sharp edges are seen, and those at its border", () => {
  const corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1]];
  assert.deepEqual(creases(corners, [[0, 1, 2], [0, 2, 3]]).length, 4);  // two triangles of one square
  assert.deepEqual(creases(corners, [[2, 1, 0], [0, 1, 4]]).length, 5);  // a right angle
});

test("edges of polygons are distinct, and corners come in order", () => {
  assert.equal(edgesOfPolygons([[0, 1, 2], [2, 1, 3]]).length, 5);
  const ordered = inOrder([[0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1, 0]], [0, 0, 1]);
  ordered.forEach((p, i) => assert.equal(norm(p.map((x, k) => x - ordered[(i + 1) % 4][k])), 1));
});
