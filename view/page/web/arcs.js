// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs of Gaussian diagrams as curves on the unit sphere, and where they fall in a chart. Places only: nothing is decided here.
//
// A curve is {u, w, angle}: the points cos(t) u + sin(t) w for t in [0, angle]. An arc of a body of rank 3 is shorter than pi, that of a
// polygon's edge is a half-circle, that of a segment a full circle.

import { across, cross, dot, middle, minus, norm, unit } from "./geometry.js";

/** The unit vector along p, or null for the zero vector. */
const unitOrNull = (p) => (norm(p) > 0 ? unit(p) : null);

// Nodes have five or six digits: an arc whose sine is below this takes its circle from elsewhere.
const leastSine = 1e-3;

/** The curve of a body's edge, or null where the data does not say. `nodes` stand in for the body's own where they have been moved. */
export function arcCurve(body, edge, nodes = body.nodes) {
  const [from, to] = body.arcs[edge] ?? [];
  if (from === null && to === null) return fullCircle(body, edge);
  const p = nodes[from] && unitOrNull(nodes[from]),
    q = nodes[to] && unitOrNull(nodes[to]);
  if (!p || !q) return null;
  const normal = cross(p, q),
    sine = norm(normal);
  const circle = sine > leastSine ? unitOrNull(normal) : shortOrHalfCircle(body, edge, p, q);
  if (!circle) return { u: p, w: across(p), angle: 0 };
  const w = unitOrNull(cross(circle, p));
  return { u: p, w, angle: Math.max(0, Math.atan2(dot(q, w), dot(q, p))) || (dot(p, q) < 0 ? Math.PI : 0) };
}

function fullCircle(body, edge) {
  const circle = body.circles?.[edge] ?? edgeDirection(body, edge);
  if (!circle) return null;
  const u = across(circle);
  return { u, w: cross(circle, u), angle: 2 * Math.PI };
}

function edgeDirection(body, edge) {
  const [v, w] = body.edges[edge];
  return unitOrNull(minus(body.vertices[w], body.vertices[v]));
}

/** The circle of an arc whose nodes are too close to each other, or too nearly opposite, to say it. */
function shortOrHalfCircle(body, edge, p, q) {
  if (body.circles?.[edge]) return unitOrNull(body.circles[edge]);
  const along = edgeDirection(body, edge);
  if (!along) return null;
  const circle = unitOrNull(
    minus(
      along,
      p.map((x) => x * dot(along, p)),
    ),
  );
  if (!circle) return null;
  const ahead = dot(p, q) < 0 ? outwardAt(body, edge) : q;
  return dot(cross(circle, p), ahead) < 0 ? circle.map((x) => -x) : circle;
}

/** The outward side of an edge, or its opposite for -A: an arc that is nearly a half-circle passes there half way. */
function outwardAt(body, edge) {
  const outward = minus(body.vertices[body.edges[edge][0]], middle(body.vertices));
  return body.arcs_of === "-A" ? outward.map((x) => -x) : outward;
}

export function curvePoint({ u, w }, t) {
  const c = Math.cos(t),
    s = Math.sin(t);
  return [c * u[0] + s * w[0], c * u[1] + s * w[1], c * u[2] + s * w[2]];
}

/** The part [t0, t1] of a curve where <point, pole> >= 0, or null. A curve on the equator itself counts whole. */
export function curveAbove(curve, pole) {
  const x = dot(curve.u, pole),
    y = dot(curve.w, pole);
  if (Math.hypot(x, y) < 1e-7) return [0, curve.angle];
  const nearest = Math.atan2(y, x);
  if (curve.angle > 2 * Math.PI - 1e-9) return [nearest - Math.PI / 2, nearest + Math.PI / 2];
  for (const turn of [0, 2 * Math.PI]) {
    const first = Math.max(0, nearest + turn - Math.PI / 2),
      last = Math.min(curve.angle, nearest + turn + Math.PI / 2);
    if (first < last || (first === last && curve.angle === 0)) return [first, last];
  }
  return null;
}

/** Points of a curve from t0 to t1, no two further apart than `step`. */
export function curvePoints(curve, t0 = 0, t1 = curve.angle, step = 0.06) {
  const count = Math.max(1, Math.ceil((t1 - t0) / step));
  return Array.from({ length: count + 1 }, (_, i) => curvePoint(curve, t0 + ((t1 - t0) * i) / count));
}

/** A chart's frame with its third axis: r = v x z points to the right. */
export function chartAxes({ v, z }) {
  return { v, z, r: cross(v, z) };
}

const degrees = 180 / Math.PI;

/** Longitude and latitude about v, in degrees: a hemisphere is the square from -90 to 90, and verticals are vertical. */
export function chartPlace(n, { r, v, z }) {
  const latitude = Math.asin(Math.max(-1, Math.min(1, dot(n, v))));
  return [Math.atan2(dot(n, r), Math.max(0, dot(n, z))) * degrees, latitude * degrees];
}

/** The central projection to the paper's plane z = 1. */
export function planePlace(n, { r, v, z }) {
  return [dot(n, r) / dot(n, z), dot(n, v) / dot(n, z)];
}

/** A curve in the chart of longitude and latitude: a polyline that stays within a tenth of a degree, or null in the other hemisphere. */
export function arcOnChart(curve, axes) {
  const part = curveAbove(curve, axes.z);
  if (!part) return null;
  // At (0, 1, 0) there is no longitude: ends are taken from just inside.
  const inset = Math.min(1e-5, (part[1] - part[0]) / 4),
    place = (t) => chartPlace(curvePoint(curve, t), axes);
  const first = part[0] + inset,
    last = part[1] - inset,
    start = place(first),
    points = [start];
  const halve = (t, p, s, q, depth) => {
    const m = (t + s) / 2,
      c = place(m);
    const off = Math.hypot(c[0] - (p[0] + q[0]) / 2, c[1] - (p[1] + q[1]) / 2);
    if (depth > 9 || (off < 0.1 && s - t < 0.5)) return void points.push(q);
    halve(t, p, m, c, depth + 1);
    halve(m, c, s, q, depth + 1);
  };
  halve(first, start, last, place(last), 0);
  return points;
}

/** A curve in the paper's plane, where it is a segment, clipped to |x|, |y| <= reach; null outside. */
export function arcOnPlane(curve, axes, reach) {
  const part = curveAbove(curve, axes.z);
  if (!part || Math.hypot(dot(curve.u, axes.z), dot(curve.w, axes.z)) < 1e-7) return null;
  const inset = Math.min(1e-4, (part[1] - part[0]) / 4);
  return clippedSegment(planePlace(curvePoint(curve, part[0] + inset), axes), planePlace(curvePoint(curve, part[1] - inset), axes), reach);
}

/** A segment clipped to a square, by Liang and Barsky. */
export function clippedSegment(p, q, reach) {
  let first = 0,
    last = 1;
  for (const i of [0, 1]) {
    const along = q[i] - p[i];
    for (const [step, room] of [
      [-along, p[i] + reach],
      [along, reach - p[i]],
    ]) {
      if (step === 0 && room < 0) return null;
      if (step < 0) first = Math.max(first, room / step);
      if (step > 0) last = Math.min(last, room / step);
    }
  }
  if (first > last) return null;
  const at = (t) => [p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])];
  return [at(first), at(last)];
}
