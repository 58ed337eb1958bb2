// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn on the sphere, as lists of coordinates: segments of arcs by body and hemisphere, the walls of a strip.
import { arcCurve, curveAbove, curvePoints } from "./arcs.js";
import { cross, dot, minus, times, unit } from "./geometry.js";

/** Pairs of successive points, flat: x y z x y z ... at this distance from the centre. */
export function segmentsOf(polylines, radius = 1) {
  const result = [];
  for (const points of polylines)
    for (let i = 0; i + 1 < points.length; ++i) result.push(...times(points[i], radius), ...times(points[i + 1], radius));
  return result;
}

/** The polylines of one body's arcs, cut at the equator: [upper, lower], where `pole` is the upper hemisphere's. */
export function halvesOfArcs(body, edges, pole, step = 0.06) {
  const halves = [[], []],
    poles = [pole, times(pole, -1)];
  for (const edge of edges) {
    const curve = arcCurve(body, edge);
    if (!curve) continue;
    poles.forEach((p, i) => {
      const part = curveAbove(curve, p);
      if (part) halves[i].push(curvePoints(curve, part[0], part[1], step));
    });
  }
  return halves;
}

/** The half of a great circle from -v to v through a direction n: a wall. */
export function wallOnSphere(n, { v }, step = 0.06) {
  return curvePoints({ u: times(v, -1), w: unit(minus(n, times(v, dot(n, v)))), angle: Math.PI }, 0, Math.PI, step);
}

/** The walls on either side of a pair's strip; those at infinity are left out. */
export function stripOnSphere(pair, chart, bodies) {
  return pair.strip.flatMap((wall) =>
    wall === null ? [] : [wallOnSphere(bodies[chart.walls[wall][0]].nodes[chart.walls[wall][1]], chart.frame)],
  );
}

/** The equator, whose poles are +-z. */
export function equatorOf({ v, z }) {
  return curvePoints({ u: v, w: cross(v, z), angle: 2 * Math.PI });
}

/** Where the camera stands to face a hemisphere: a little above and beside its pole, so that the ball looks round. */
export function stationOf({ v, z }, distance) {
  const right = cross(v, z);
  return times(unit(z.map((x, i) => x + 0.22 * v[i] + 0.22 * right[i])), distance);
}

/** Which hemisphere faces a camera: 0 upper, 1 lower. */
export const facingOf = (position, pole) => (dot(position, pole) < 0 ? 1 : 0);
