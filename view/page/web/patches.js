// SPDX-License-Identifier: GPL-3.0-or-later
// Where the bodies touch after a way out, in places of the pictures.
import { plus, times } from "./geometry.js";
import { unitOf } from "./numbers.js";
import { placesOf } from "./places.js";

/** [{way: index of an optimum, direction, a: [place], b: [place]}] of the answer's patches; a and b are one point each, a segment or a polygon. */
export function patchesOf(depth, stages) {
  const places = placesOf(stages);
  const place = (point) => (point.core ? plus(places.place(point.core), times(unitOf(point.normal), places.length(point.distance))) : places.place(point));
  return (depth.manifold?.patches ?? []).map(({ optimum, direction, corners }, i) => ({
    way: optimum ?? i, direction: unitOf(direction), a: corners.map((corner) => place(corner.a)), b: corners.map((corner) => place(corner.b)),
  }));
}
