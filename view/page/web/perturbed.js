// SPDX-License-Identifier: GPL-3.0-or-later
// The symbolic perturbation, made visible: B stays, -A is mapped by I + E, the chart's frame is tilted by a, b, c. In the program these
// are infinitesimals, each smaller than any power of the one before; here they are numbers that one can see. Nothing is decided by them.
import { cross, times, unit } from "./geometry.js";

/** The infinitesimals from the largest to the smallest: e1, ..., e12, as kernels/predicates/perturbation.hpp ranks them. */
export const infinitesimalNames = ["a", "b", "c", "E11", "E12", "E13", "E21", "E22", "E23", "E31", "E32", "E33"];

const largestSeen = 0.24,
  shrinks = 0.84;

/** The sizes that stand for the infinitesimals in the picture, by name, where epsilon in [0, 1] is the slider's. */
export function seenSizes(epsilon) {
  return Object.fromEntries(infinitesimalNames.map((name, i) => [name, largestSeen * epsilon * shrinks ** i]));
}

/** The matrix I + E, its rows. */
export function seenMatrix(sizes) {
  return [1, 2, 3].map((i) => [1, 2, 3].map((j) => (i === j ? 1 : 0) + sizes[`E${i}${j}`]));
}

const applied = (rows, p) => rows.map((row) => row[0] * p[0] + row[1] * p[1] + row[2] * p[2]);

/** The cofactors of a matrix: they map circles as it maps nodes, since Mn x Mm = cof(M) (n x m). */
export function cofactors([p, q, r]) {
  return [cross(q, r), cross(r, p), cross(p, q)];
}

/** The body whose diagram is that of -A, moved. */
export function movedDiagram(body, sizes) {
  const matrix = seenMatrix(sizes),
    circles = body.circles?.map((d) => unit(applied(cofactors(matrix), d)));
  return { ...body, nodes: body.nodes.map((n) => unit(applied(matrix, n))), circles };
}

/** The tilted frame of a hemisphere: v = (a, 1, b), z = +-(c, -ac - b, 1), orthogonal; as unit vectors. */
export function tiltedFrame({ a, b, c }, lower) {
  const z = unit([c, -a * c - b, 1]);
  return { v: unit([a, 1, b]), z: lower ? times(z, -1) : z };
}

/** How large a monomial such as "E12 b^2" is in the picture; null for a name that it does not know. */
export function seenMonomial(name, sizes) {
  let value = 1;
  for (const factor of name.split(" ")) {
    const [symbol, power = "1"] = factor.split("^");
    if (symbol === "1") continue;
    if (!(symbol in sizes)) return null;
    value *= sizes[symbol] ** Number(power);
  }
  return value;
}
