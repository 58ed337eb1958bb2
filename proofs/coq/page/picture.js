// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of two bodies: outlines of their convex parts, and the edges of those with few corners. It can be turned; bodies of the plane are
// seen from above. In binary64; nothing here decides anything but pixels.

const dot3 = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus3 = (a, b) => a.map((x, i) => x - b[i]);
const cross3 = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const plus3 = (a, b, s = 1) => a.map((x, i) => x + s * b[i]);
const unit3 = (a) => a.map((x) => x / (Math.hypot(...a) || 1));

const isPolytope = ({ terms, radius, plane }) => !plane && radius === 0 && terms.length === 1 && terms[0].every((atom) => atom.length === 1);

/** The point of a part that is farthest in a direction of length 1. */
function farthest({ terms, radius }, direction) {
  let sum = direction.map((x) => radius * x);
  for (const atoms of terms) {
    let most = -Infinity, best = null;
    for (const [center, ...axes] of atoms) {
      const along = axes.map((axis) => dot3(axis, direction)), length = Math.hypot(...along), height = dot3(center, direction) + length;
      if (height <= most) continue;
      most = height;
      best = axes.reduce((p, axis, i) => (length > 0 ? plus3(p, axis, along[i] / length) : p), center);
    }
    if (best) sum = plus3(sum, best);
  }
  return sum;
}

/** The corners of the hull of points of a plane, in order. */
function hullOf(points) {
  const sorted = [...points].sort((p, q) => p[0] - q[0] || p[1] - q[1]);
  const chain = (list) => {
    const kept = [];
    for (const p of list) {
      const turns = () => {
        const [q, r] = kept.slice(-2);
        return (r[0] - q[0]) * (p[1] - q[1]) - (r[1] - q[1]) * (p[0] - q[0]);
      };
      while (kept.length >= 2 && turns() <= 0) kept.pop();
      kept.push(p);
    }
    return kept.slice(0, -1);
  };
  return sorted.length < 3 ? sorted : [...chain(sorted), ...chain(sorted.reverse())];
}

/** The edges of the hull of points: seen along one, all others lie within less than half a turn. */
function hullEdges(points) {
  const edges = [], small = 1e-9;
  for (let i = 0; i < points.length; ++i)
    for (let j = i + 1; j < points.length; ++j) {
      const along = minus3(points[j], points[i]), length = Math.hypot(...along);
      if (!(length > 0)) continue;
      const n = unit3(along), f = unit3(cross3(n, Math.abs(n[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0])), g = cross3(n, f), angles = [];
      const beyond = points.some((p) => {
        const v = minus3(p, points[i]), x = dot3(v, f), y = dot3(v, g), t = dot3(v, n);
        if (Math.hypot(x, y) > small * Math.hypot(...v)) angles.push(Math.atan2(y, x));
        else return t < -small * length || t > length * (1 + small);
        return false;
      });
      angles.sort((s, t) => s - t);
      const gap = Math.max(...angles.map((t, k) => (angles[k + 1] ?? angles[0] + 2 * Math.PI) - t), angles.length ? 0 : 2 * Math.PI);
      if (!beyond && gap > Math.PI + small) edges.push([points[i], points[j]]);
    }
  return edges;
}

const axes3 = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

/** The middle and half of the extent of all that is bounded, and of the nearest points of the rest. */
function extentOf(bodies) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  const note = (p) => p.forEach((x, i) => {
    low[i] = Math.min(low[i], x);
    high[i] = Math.max(high[i], x);
  });
  for (const { parts, points } of bodies) {
    points?.forEach(note);
    for (const part of parts)
      if (!part.plane) axes3.forEach((axis) => [1, -1].forEach((s) => note(farthest(part, axis.map((x) => s * x)))));
  }
  const extent = () => ![...low, ...high].every(Number.isFinite) ? { middle: [0, 0, 0], half: 1 }
    : { middle: low.map((l, i) => (l + high[i]) / 2), half: Math.hypot(...minus3(high, low)) / 2 || 1 };
  const { middle } = extent();
  for (const { parts } of bodies) parts.forEach(({ plane }) => plane && note(footOf(plane, middle)));
  return extent();
}

const mostWork = 4e6;  // for edges: the cubes of the numbers of corners

/** An SVG element of {a, b, flat}, as of bodiesOf, which turns by dragging and by arrow keys unless it is flat. */
function pictureOf({ a, b, flat }) {
  const named = [['a', a], ['b', b]], { middle, half } = extentOf([a, b]);
  let left = mostWork;
  for (const [, body] of named)
    for (const part of body.parts) {
      const corners = isPolytope(part) && !flat ? part.terms[0].map(([p]) => p) : [];
      left -= corners.length ** 3;
      if (corners.length && left > 0) body.edges.push(...hullEdges(corners));
    }
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  svg.setAttribute('viewBox', '-1.05 -1.05 2.1 2.1');
  svg.setAttribute('class', flat ? 'bodies' : 'bodies turning');
  svg.setAttribute('role', 'img');
  svg.setAttribute('aria-label', `Body A and body B${flat ? ', bodies of the plane' : '; arrow keys turn the picture'}`);
  let [turn, tilt] = flat ? [0, Math.PI / 2] : [0.5, 0.4];
  const draw = () => {
    const right = [Math.cos(turn), Math.sin(turn), 0];
    const up = [-Math.sin(turn) * Math.sin(tilt), Math.cos(turn) * Math.sin(tilt), Math.cos(tilt)];
    const seen = (p) => {
      const v = minus3(p, middle).map((x) => x / half);
      return [dot3(v, right), -dot3(v, up)];
    };
    const path = (points, ring) => points.map(([x, y], i) => `${i ? 'L' : 'M'}${x.toFixed(4)} ${y.toFixed(4)}`).join('') + (ring ? 'Z' : '');
    const outline = (part) => {
      if (isPolytope(part)) return hullOf(part.terms[0].map(([p]) => seen(p)));
      if (part.plane) return planeAt(part.plane, middle, half, flat).map(seen);
      return Array.from({ length: 180 }, (_, k) => {
        const t = k * Math.PI / 90;
        return seen(farthest(part, plus3(right.map((x) => Math.cos(t) * x), up, Math.sin(t))));
      });
    };
    svg.replaceChildren(...named.flatMap(([name, { parts, edges }]) => {
      const element = (kind, d) => {
        const shape = document.createElementNS(svg.namespaceURI, 'path');
        shape.setAttribute('class', `${kind} of-${name}`);
        shape.setAttribute('d', d);
        return shape;
      };
      const all = (lines) => lines.map((line) => path(line.map(seen), false)).join('');
      return [...parts.map((part) => element('outline', path(outline(part), true))), ...(edges.length ? [element('edges', all(edges))] : [])];
    }));
  };
  draw();
  if (flat) return svg;
  svg.setAttribute('tabindex', '0');
  const turned = (x, y) => {
    turn -= x;
    tilt = Math.max(-1.5, Math.min(1.5, tilt + y));
    draw();
  };
  svg.addEventListener('pointerdown', (event) => svg.setPointerCapture(event.pointerId));
  svg.addEventListener('pointermove', (event) => event.buttons && turned(event.movementX / 150, event.movementY / 150));
  const keys = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };
  svg.addEventListener('keydown', (event) => {
    if (!keys[event.key]) return;
    event.preventDefault();
    turned(...keys[event.key]);
  });
  return svg;
}

/** The point of the boundary of a half-space that is nearest to another. */
const footOf = ([normal, offset], p) => plus3(p, normal, (offset - dot3(normal, p)) / (dot3(normal, normal) || 1));

/** A square of the boundary of a half-space, near the rest; of a half-plane, what of it can be seen. */
function planeAt(plane, middle, half, flat) {
  const n = unit3(plane[0]), foot = footOf(plane, middle), corners = [[1, 1], [-1, 1], [-1, -1], [1, -1]];
  const f = unit3(cross3(n, Math.abs(n[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0])), g = cross3(n, f);
  if (flat) return corners.map(([s, t]) => plus3(plus3(foot, n, (s - 1) * 2 * half), g, t * 4 * half));
  return corners.map(([s, t]) => plus3(plus3(foot, f, s * half), g, t * half));
}
