// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors as arrays of three numbers, and what the 3-D pictures need of them. Nothing here decides anything but pixels.

export const plus = (a, b) => a.map((x, i) => x + b[i]);
export const minus = (a, b) => a.map((x, i) => x - b[i]);
export const times = (a, s) => a.map((x) => x * s);
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const norm = (a) => Math.hypot(...a);
export const unit = (a) => {
  const most = Math.max(...a.map(Math.abs));
  if (!(most > 0)) return [0, 0, 1];
  const scaled = times(a, 1 / most);
  return times(scaled, 1 / norm(scaled));
};
export const middle = (points) => times(points.reduce(plus, [0, 0, 0]), 1 / Math.max(1, points.length));

/** A unit vector across v: the one nearest to `wish` unless that is along v. */
export function across(v, wish = [0, 0, 1]) {
  const n = unit(v);
  for (const w of [wish, [0, 0, 1], [0, 1, 0], [1, 0, 0]]) {
    const rest = minus(w, times(n, dot(n, w)));
    if (norm(rest) > 0.1) return unit(rest);
  }
  return [1, 0, 0];
}

/** How places become those of a picture: (p - center) * scale along each axis, so that all shown points lie within [-1, 1]^3. */
export function frameOf(points) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const p of points)
    for (let i = 0; i < 3; ++i) {
      if (p[i] < low[i]) low[i] = p[i];
      if (p[i] > high[i]) high[i] = p[i];
    }
  const halves = low.map((l, i) => Math.max(0, high[i] / 2 - l / 2) || 0), longest = Math.max(...halves, 5e-324);
  const shortest = Math.min(...halves.filter((h) => h > 0), longest), apart = longest > 100 * shortest;
  const inverse = (x) => Math.min(1 / x, Number.MAX_VALUE);
  const scale = halves.map((h) => inverse(apart && h > 0 ? h : longest));
  const center = low.map((l, i) => (points.length ? l / 2 + high[i] / 2 : 0));
  const least = Math.min(...scale);
  return {
    center, scale, apart,
    place: (p) => p.map((x, i) => (x - center[i]) * scale[i]),
    move: (t) => t.map((x, i) => x * scale[i]),
    back: (p) => p.map((x, i) => x / scale[i] + center[i]),
    normal: (n) => unit(n.map((x, i) => x * (least / scale[i]))),  // of a plane, which stays a plane where axes are scaled apart
  };
}

/** The camera's direction: a little from above and aside, yet across the arrow, which then points to the right. `second`: up if it can be. */
export function sideView(arrow, second = null) {
  if (!(norm(arrow) > 0)) return { from: unit([0.6, -1, 0.55]), up: [0, 0, 1] };
  const right = unit(arrow), up = across(right, second ?? (Math.abs(right[2]) < 0.8 ? [0, 0, 1] : [-right[2], 0, 0]));
  const toward = cross(right, up);  // seen from here the arrow points to the right
  return { from: unit(plus(plus(toward, times(up, 0.38)), times(right, 0.34))), up };
}

/** Upon the plane of x and y. */
export const planeView = { from: [0, 0, 1], up: [0, 1, 0] };

/** The triangles of a convex polygon's corners, as indices into the polygon. */
export function fan(count) {
  const result = [];
  for (let i = 2; i < count; ++i) result.push([0, i - 1, i]);
  return result;
}

/** Distinct edges of polygons, each [v, w] with v < w. */
export function edgesOfPolygons(polygons) {
  const seen = new Set(), result = [];
  for (const polygon of polygons)
    polygon.forEach((v, i) => {
      const w = polygon[(i + 1) % polygon.length], key = v < w ? `${v},${w}` : `${w},${v}`;
      if (v === w || seen.has(key)) return;
      seen.add(key);
      result.push(v < w ? [v, w] : [w, v]);
    });
  return result;
}

/** The edges of a mesh where its faces turn by more than a third of a right angle, and those with one face: what one sees of it. */
export function creases(vertices, polygons) {
  const normals = polygons.map((polygon) => normalOf(polygon.map((v) => vertices[v]))), faces = new Map();
  polygons.forEach((polygon, f) => polygon.forEach((v, i) => {
    const w = polygon[(i + 1) % polygon.length], key = v < w ? `${v},${w}` : `${w},${v}`;
    if (!faces.has(key)) faces.set(key, { edge: v < w ? [v, w] : [w, v], own: [] });
    faces.get(key).own.push(f);
  }));
  const isSharp = ([f, g]) => g === undefined || dot(normals[f], normals[g]) < Math.cos(Math.PI / 6);
  return [...faces.values()].filter(({ own }) => isSharp(own)).map(({ edge }) => edge);
}

/** The unit normal of a polygon's corners, counter-clockwise from where it points to. */
export function normalOf(corners) {
  let sum = [0, 0, 0];
  for (let i = 2; i < corners.length; ++i) sum = plus(sum, cross(minus(corners[i - 1], corners[0]), minus(corners[i], corners[0])));
  return unit(sum);
}

/** The corners of a convex polygon in space in their order round its middle, seen against the normal. */
export function inOrder(points, normal) {
  if (points.length < 3) return points;
  const m = middle(points), x = across(normal, minus(points[0], m)), y = cross(unit(normal), x);
  const angle = (p) => Math.atan2(dot(minus(p, m), y), dot(minus(p, m), x));
  return [...points].sort((p, q) => angle(p) - angle(q));
}

/** A point where two convex features in one plane meet: each a vertex, an edge or a facet's corners. The middle of what they share. */
export function meetingPoint(a, b, normal) {
  if (a.length === 0 || b.length === 0) return middle([...a, ...b]);
  if (a.length === 1) return a[0];
  if (b.length === 1) return b[0];
  const x = across(normal), y = cross(unit(normal), x), origin = middle([...a, ...b]);
  const flat = (points) => inOrder(points, normal).map((p) => [dot(minus(p, origin), x), dot(minus(p, origin), y)]);
  const fa = flat(a), fb = flat(b), edges = fa.length === 2 && fb.length === 2;
  const shared = edges ? crossing(fa, fb) : fb.length > 2 ? clipped(fa, fb) : clipped(fb, fa);
  if (shared.length === 0) return origin;
  const m = [0, 1].map((i) => shared.reduce((sum, p) => sum + p[i], 0) / shared.length);
  return plus(origin, plus(times(x, m[0]), times(y, m[1])));
}

/** Where two segments of the plane cross; of parallel ones the ends of what they share. */
function crossing([p, q], [r, s]) {
  const u = [q[0] - p[0], q[1] - p[1]], v = [s[0] - r[0], s[1] - r[1]], d = u[0] * v[1] - u[1] * v[0];
  if (Math.abs(d) > 1e-6 * Math.hypot(...u) * Math.hypot(...v)) {
    const k = ((r[0] - p[0]) * v[1] - (r[1] - p[1]) * v[0]) / d;
    return [[p[0] + k * u[0], p[1] + k * u[1]]];
  }
  const along = (z) => ((z[0] - p[0]) * u[0] + (z[1] - p[1]) * u[1]) / (u[0] * u[0] + u[1] * u[1]);
  const [from, to] = [along(r), along(s)].sort((i, j) => i - j), clamp = (k) => Math.min(1, Math.max(0, k));
  return [clamp(from), clamp(to)].map((k) => [p[0] + k * u[0], p[1] + k * u[1]]);
}

/** The part of a polygon, or segment, within a convex polygon that is counter-clockwise: cut by one side after the other. */
function clipped(subject, around) {
  let left = subject;
  for (let i = 0; i < around.length && left.length > 0; ++i) {
    const p = around[i], q = around[(i + 1) % around.length];
    const side = (z) => (q[0] - p[0]) * (z[1] - p[1]) - (q[1] - p[1]) * (z[0] - p[0]);
    const next = [];
    const count = left.length === 2 ? 1 : left.length;
    for (let k = 0; k < count; ++k) {
      const from = left[k], to = left[(k + 1) % left.length], f = side(from), t = side(to);
      if (f >= 0) next.push(from);
      if ((f >= 0) !== (t >= 0)) next.push([0, 1].map((c) => from[c] + (f / (f - t)) * (to[c] - from[c])));
      if (left.length === 2 && t >= 0) next.push(to);
    }
    left = next;
  }
  return left;
}
