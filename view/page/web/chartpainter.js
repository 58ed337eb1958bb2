// SPDX-License-Identifier: GPL-3.0-or-later
// Paints charts: one hemisphere of both Gaussian diagrams in a square, by longitude and latitude or in the paper's plane z = 1.
// Pure text and numbers; chart.js puts them on the page.
import { arcCurve, arcOnChart, arcOnPlane, chartAxes, chartPlace, curvePoint, planePlace } from "./arcs.js";
import { dot } from "./geometry.js";

/** The square of a chart in the units of its picture, and the room for labels at its left and below. */
export const chartSide = 640;
export const chartMargin = { left: 66, bottom: 58, right: 22, top: 12 };

/** How far the paper's plane is shown: |x|, |y| at most. */
export const planeReach = 4;

/** How a chart is projected: place(direction) and path(curve) in picture units; null for what is not shown. */
export function chartProjection(frame, plane) {
  const axes = chartAxes(frame),
    reach = plane ? planeReach : 90;
  const picture = ([x, y]) => [((x + reach) / (2 * reach)) * chartSide, ((reach - y) / (2 * reach)) * chartSide];
  const within = ([x, y]) => Math.abs(x) <= reach && Math.abs(y) <= reach;
  const raw = plane ? planePlace : chartPlace;
  return {
    axes,
    plane,
    reach,
    picture,
    place(direction) {
      if (dot(direction, axes.z) < -1e-9) return null;
      const p = raw(direction, axes);
      return p.every(Number.isFinite) && within(p) ? picture(p) : null;
    },
    abscissa(direction) {
      const [x] = raw(direction, axes);
      return Number.isFinite(x) && Math.abs(x) <= reach ? picture([x, 0])[0] : null;
    },
    path(curve) {
      const points = plane ? arcOnPlane(curve, axes, reach) : arcOnChart(curve, axes);
      return points && points.map(picture);
    },
    /** Where an arc that only the perturbation lifts over the equator is shown: at its end there. */
    point(curve) {
      const ends = [0, curve.angle].map((t) => curvePoint(curve, t)),
        height = (p) => dot(p, axes.z);
      return picture(chartPlace(height(ends[0]) >= height(ends[1]) ? ends[0] : ends[1], axes));
    },
  };
}

/** The polylines of one body's arcs in a chart: [{edge, points}], those outside left out. */
export function chartPolylines(body, edges, projection, nodes = body.nodes) {
  const result = [];
  for (const edge of edges) {
    const curve = arcCurve(body, edge, nodes),
      points = curve && projection.path(curve);
    if (points) result.push({ edge, points });
  }
  return result;
}

const short = (x) => Number(x.toFixed(1));

/** A polyline as the d of an SVG path. */
export function pathText(points) {
  return points.map(([x, y], i) => `${i === 0 ? "M" : "L"}${short(x)} ${short(y)}`).join("");
}

/** The ticks of an axis: [value, label]. Both axes have the same. */
export function chartTicks(plane) {
  const values = plane ? [-4, -3, -2, -1, 0, 1, 2, 3, 4] : [-90, -60, -30, 0, 30, 60, 90];
  return values.map((v) => [v, `${v < 0 ? "\u2212" : ""}${Math.abs(v)}${plane ? "" : "\u00b0"}`]);
}

/** The borders of a strip in picture units; walls at infinity, or outside, are the borders of the picture. */
export function stripBorders(strip, walls, bodies, projection) {
  const sides = strip.map((wall, i) => {
    if (wall === null) return i * chartSide;
    const [name, node] = walls[wall],
      direction = bodies[name].nodes[node];
    const x = projection.abscissa(direction);
    return x ?? (dot(direction, projection.axes.r) < 0 ? 0 : chartSide);
  });
  return sides[0] <= sides[1] ? sides : null;
}

/** The arc nearest to a point of the picture within `reach`, of lists of polylines by body: {name, edge} or null. */
export function nearestArc(lists, [x, y], reach) {
  let best = null,
    least = reach;
  for (const name of ["a", "b"])
    for (const { edge, points } of lists[name])
      for (let i = 0; i + 1 < points.length; ++i) {
        const distance = distanceToSegment(x, y, points[i], points[i + 1]);
        if (distance < least) [best, least] = [{ name, edge }, distance];
      }
  return best;
}

function distanceToSegment(x, y, [px, py], [qx, qy]) {
  const dx = qx - px,
    dy = qy - py,
    square = dx * dx + dy * dy;
  const t = square > 0 ? Math.max(0, Math.min(1, ((x - px) * dx + (y - py) * dy) / square)) : 0;
  return Math.hypot(px + t * dx - x, py + t * dy - y);
}

/** The canonical pairs that an arc of this body belongs to, largest first. */
export function pairsOfArc(data, name, edge, chart) {
  return data.order.filter((i) => data.pairs[i].chart === chart && data.pairs[i][name].includes(edge));
}

/** The pair to choose when an arc is clicked: the largest that holds it, or the one after the present pair among those. */
export function nextPairOfArc(data, name, edge, chart, present) {
  const pairs = pairsOfArc(data, name, edge, chart);
  return pairs.length === 0 ? null : pairs[(pairs.indexOf(present) + 1) % pairs.length];
}

/** Which hemisphere is shown: 0 upper or 1 lower. "both" shows the one that faces the reader. */
export function hemisphereShown(selection, facing) {
  return selection.hemisphere === "both" ? facing : selection.hemisphere === "lower" ? 1 : 0;
}
