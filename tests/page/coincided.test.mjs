// SPDX-License-Identifier: GPL-3.0-or-later
// The visible perturbation, and the names of coincidences.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { coincidenceKinds, coincidenceSentences, involvedText, spokenName } from "../../view/page/web/coincidences.js";
import { cross, dot, norm } from "../../view/page/web/geometry.js";
import {
  cofactors,
  infinitesimalNames,
  movedDiagram,
  seenMatrix,
  seenMonomial,
  seenSizes,
  tiltedFrame,
} from "../../view/page/web/perturbed.js";
import { cube, distance, lowerFrame, randomDirection, randomNumbers, upperFrame } from "./bodies.mjs";

const applied = (rows, p) => rows.map((row) => dot(row, p));

test("each size is smaller than the one before, and all grow with epsilon from 0", () => {
  const sizes = infinitesimalNames.map((name) => seenSizes(0.5)[name]);
  sizes.slice(1).forEach((size, i) => assert.ok(size > 0 && size < sizes[i]));
  for (const name of infinitesimalNames) {
    assert.equal(seenSizes(0)[name], 0);
    assert.ok(seenSizes(1)[name] > seenSizes(0.5)[name]);
  }
});

test("the order is that of the program: ranks in kernels/predicates/perturbation.hpp", () => {
  const text = readFileSync(new URL("../../kernels/predicates/perturbation.hpp", import.meta.url), "utf8");
  const ranks = text
      .match(/rank\{([^}]*)\}/)[1]
      .split(",")
      .map(Number),
    names = ["E11", "E12", "E13", "E21", "E22", "E23", "E31", "E32", "E33", "a", "b", "c"];
  assert.deepEqual(
    infinitesimalNames,
    [...names].sort((x, y) => ranks[names.indexOf(x)] - ranks[names.indexOf(y)]),
  );
});

test("at epsilon 0 nothing moves; beyond it the nodes that coincided are apart", () => {
  const a = cube("a"),
    b = cube("b"),
    opposite = [1, 0, 3, 2, 5, 4];
  for (const epsilon of [0, 0.3]) {
    const moved = movedDiagram(a, seenSizes(epsilon));
    moved.nodes.forEach((n, f) => {
      const gap = distance(n, b.nodes[opposite[f]]);
      if (epsilon === 0) assert.ok(gap < 1e-15, "coincident normals");
      else assert.ok(gap > 0.005, "taken apart");
      assert.ok(Math.abs(norm(n) - 1) < 1e-12);
    });
    assert.deepEqual(a.nodes, cube("a").nodes, "the body itself stays");
  }
});

test("E_ij is row i, column j of I + E", () => {
  const sizes = { ...seenSizes(0), E12: 0.5, E33: 0.25 };
  assert.deepEqual(seenMatrix(sizes), [
    [1, 0.5, 0],
    [0, 1, 0],
    [0, 0, 1.25],
  ]);
});

test("circles move by the cofactors: Mn x Mm = cof(M) (n x m)", () => {
  const random = randomNumbers(8),
    matrix = seenMatrix(seenSizes(0.7));
  for (let i = 0; i < 50; ++i) {
    const n = randomDirection(random),
      m = randomDirection(random);
    assert.ok(distance(cross(applied(matrix, n), applied(matrix, m)), applied(cofactors(matrix), cross(n, m))) < 1e-12);
  }
});

test("the tilted frame stays orthogonal, and is the chart's at epsilon 0", () => {
  for (const lower of [false, true]) {
    const { v, z } = tiltedFrame(seenSizes(1), lower);
    assert.ok(Math.abs(dot(v, z)) < 1e-15);
    assert.ok(v[1] > 0.9 && (lower ? -z[2] : z[2]) > 0.9);
    const plain = tiltedFrame(seenSizes(0), lower),
      frame = lower ? lowerFrame : upperFrame;
    assert.ok(distance(plain.v, frame.v) === 0 && distance(plain.z, frame.z) === 0);
  }
});

test("a monomial is the product of its powers", () => {
  const sizes = seenSizes(0.5);
  assert.equal(seenMonomial("E11", sizes), sizes.E11);
  assert.ok(Math.abs(seenMonomial("E12 b^2", sizes) - sizes.E12 * sizes.b ** 2) < 1e-15);
  assert.equal(seenMonomial("1", sizes), 1);
  assert.equal(seenMonomial("E44", sizes), null);
});

test("every kind that a study of polytopes counts has its sentence", () => {
  const text = readFileSync(new URL("../../include/fathom/study.hpp", import.meta.url), "utf8");
  const names = [...text.match(/coincidence_names\{([^}]*)\}/)[1].matchAll(/"(\w+)"/g)].map((match) => match[1]);
  assert.ok(names.length > 10);
  assert.deepEqual(Object.keys(coincidenceSentences), names);
});

test("kinds that occur keep their index; the others are named", () => {
  const { present, absent } = coincidenceKinds([
    { kind: "ties", count: 0, listed: [] },
    { kind: "parallel_edges", count: 3, listed: [] },
  ]);
  assert.deepEqual(
    present.map(({ kind, index }) => [kind, index]),
    [["parallel_edges", 1]],
  );
  assert.ok(absent.includes("ties") && !absent.includes("parallel_edges"));
  assert.equal(spokenName("parallel_edges_of_b"), "parallel edges of B");
});

test("features are written as points of the input", () => {
  assert.equal(involvedText({ a: [[3, 7]], b: [[0, 1], [2]] }), "A 3 7, B 0 1, B 2");
  assert.equal(involvedText({ a: [[1, 2, 3]] }, 2), "A 1 2 \u2026 (3 in all)");
});

test("features of shapes are named, by what they have", () => {
  const features = { a: { feature: "axis", direction: ["0", "0", "1"], point: ["0", "1/2", "0"] }, b: { feature: "radius", length: "1/3" } };
  assert.equal(involvedText({ a: [], b: [], features }), "A axis (0, 0, 1) at (0, 1/2, 0), B radius 1/3");
});
