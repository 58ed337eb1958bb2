// SPDX-License-Identifier: CC0-1.0
// Golden cases of fathom, and whether an answer to one is right: fathom_golden.py says what the words mean. Node 18, without packages.
//
// For a vector u, h(u) is the greatest <u,b> less the least <u,a>, over the points b of B and a of A; its separating distance is h(u)/|u|.
import { readFileSync } from 'node:fs';

/** The cases of an export as JSON, by its path or URL. */
export const read = (path) => JSON.parse(readFileSync(path, 'utf8')).cases;

/** The sample of fifty cases, which lies beside this file. */
export const sample = () => read(new URL('fathom_golden_sample.json', import.meta.url));

/**
 * The separating distance of a direction of any length; infinite if it is zero, infinite or NaN. Off by less than 2^-47 of `largest`.
 * Throws a RangeError if it has not as many numbers as a point: three, or two where `dimension` is 2.
 */
export function separatingDistance(golden, direction) {
  const dimension = golden.dimension ?? 3;
  if (direction.length !== dimension) throw new RangeError(`expected a direction of ${dimension} numbers, found ${direction.length}`);
  const longest = Math.max(...direction.map(Math.abs));
  if (!(longest > 0 && longest < Infinity)) return Infinity;
  const u = direction.map((x) => x / longest / 8);  // an eighth, so that no sum overflows
  const along = (p) => u.reduce((sum, x, i) => sum + x * p[i], 0);
  const height = golden.b.reduce((most, p) => Math.max(most, along(p)), -Infinity) - golden.a.reduce((least, p) => Math.min(least, along(p)), Infinity);
  return height / Math.sqrt(along(u));
}

/** By how much an answer may be off: the tolerance, and what rounding costs it and the separating distance. */
export function allowance(golden, { relative, absolute = 0 }) {
  const wrong = Math.max(relative * Math.abs(golden.signed_depth), absolute * golden.size);
  return wrong + 32 * Number.EPSILON * golden.largest + 2 ** -1068;
}

/** Whether "A and B overlap by `depth`; A gets free along `direction`" is right; null if no direction is claimed. A distance is a depth below 0. */
export function accept(golden, direction, depth, tolerance) {
  const allowed = allowance(golden, tolerance);
  if (!(Math.abs(depth - golden.signed_depth) <= allowed)) return false;
  return direction == null || separatingDistance(golden, direction) - golden.signed_depth <= allowed;
}

/** Whether "A and B do not overlap" is right, without a distance. */
export const acceptApart = (golden, tolerance) => golden.signed_depth <= allowance(golden, tolerance);
