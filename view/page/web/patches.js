// SPDX-License-Identifier: GPL-3.0-or-later
// Where the bodies touch after a way out, in places of the pictures.
import { differenceOf, nearest, unitOf } from "./numbers.js";

/** [{way: index of an optimum, direction, a: [place], b: [place]}] of the answer's patches; a and b are one point each, a segment or a polygon. */
export function patchesOf(depth, stages) {
  const scale = stages.scale ?? { center: ["0", "0", "0"], exponent: 0 }, unit = 2 ** scale.exponent;
  const place = (point) => {
    const along = point.core ? unitOf(point.normal).map((c) => c * nearest(point.distance)) : [0, 0, 0];
    return (point.core ?? point).map((c, i) => (differenceOf(c, scale.center[i]) + along[i]) * unit);
  };
  return (depth.manifold?.patches ?? []).map(({ optimum, direction, corners }, i) => ({
    way: optimum ?? i, direction: unitOf(direction), a: corners.map((corner) => place(corner.a)), b: corners.map((corner) => place(corner.b)),
  }));
}
