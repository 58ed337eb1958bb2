// SPDX-License-Identifier: GPL-3.0-or-later
// Places and lengths of the input, which may be beyond binary64, as the pictures have them.
import { fractionOf, integersOf, nearest, timesPowerOfTwo } from "./numbers.js";

/** {place: an exact point, length: an exact length, drawn: a length in binary64, back: its inverse}, as (p - center) 2^exponent; center. */
export function placesOf({ scale }) {
  const { center, exponent } = scale ?? { center: ["0", "0", "0"], exponent: 0 };
  const up = BigInt(Math.max(0, exponent)), down = BigInt(Math.max(0, -exponent));
  const scaled = (p, q) => nearest(`${p << up}/${q << down}`);
  const place = (point) => point.map((c, i) => {
    const [[p, r], q] = integersOf([c, center[i]]);
    return scaled(p - r, q);
  });
  return {
    center, place, length: (x) => scaled(...fractionOf(x)),
    drawn: (x) => timesPowerOfTwo(x, exponent), back: (x) => timesPowerOfTwo(x, -exponent),
  };
}
