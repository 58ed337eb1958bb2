// SPDX-License-Identifier: GPL-3.0-or-later
// Decimals of the exact numbers in the data, which are strings: "p" or "p/q". Each is the nearest binary64, ties to even, as fathom
// prints it, so that a number on the page is the one that `depth --json` says.

const sizeInBits = (n) => BigInt(n === 0n ? 0 : n.toString(2).length);

/** The binary64 nearest to whole / 2^shift, where the exact value lies strictly between whole and whole + 1 if inexact. */
function rounded(whole, shift, inexact) {
  // Keep 53 bits, or fewer where the result is subnormal: one unit of the result is 2^-least.
  const bits = sizeInBits(whole);
  const least = shift - (bits - 53n) < 1074n ? shift - (bits - 53n) : 1074n;
  const drop = shift - least;
  if (drop <= 0n) return timesPowerOfTwo(Number(whole), -shift);
  const kept = whole >> drop, rest = whole - (kept << drop), half = 1n << (drop - 1n);
  const up = rest > half || (rest === half && (inexact || (kept & 1n) === 1n));
  return timesPowerOfTwo(Number(up ? kept + 1n : kept), -least);
}

/** x times 2^exponent, also where that power is beyond binary64; rounded once. */
export function timesPowerOfTwo(x, exponent) {
  let e = Number(exponent);
  for (; e < -1000 && Math.abs(x) >= 1; e += 500) x *= 2 ** -500;
  for (; e > 1000 && Number.isFinite(x); e -= 1000) x *= 2 ** 1000;
  return x * 2 ** e;
}

/** Numerator and denominator, the latter positive. */
export function fractionOf(text) {
  const [p, q = "1"] = String(text).split("/");
  return [BigInt(p), BigInt(q)];
}

/** The binary64 nearest to "p/q". */
export function nearest(text) {
  const [p, q] = fractionOf(text), n = p < 0n ? -p : p;
  if (n === 0n) return 0;
  const shift = 70n - sizeInBits(n) + sizeInBits(q);
  const top = shift > 0n ? n << shift : n, bottom = shift < 0n ? q << -shift : q;
  const x = rounded(top / bottom, shift, top % bottom !== 0n);
  return p < 0n ? -x : x;
}

/** Such numbers as integers over one positive denominator: [[integer], denominator]. */
export function integersOf(texts) {
  const fractions = texts.map(fractionOf), whole = fractions.reduce((product, [, q]) => product * q, 1n);
  return [fractions.map(([p, q]) => p * (whole / q)), whole];
}

/** The binary64 nearest to the square root of "p/q" >= 0. */
export function nearestRoot(text) {
  const [n, q] = fractionOf(text);
  if (n <= 0n) return 0;
  const half = (140n - sizeInBits(n) + sizeInBits(q)) / 2n;  // the root is taken of n/q * 4^half, an integer of some 140 bits
  const top = half > 0n ? n << (2n * half) : n, bottom = half < 0n ? q << (-2n * half) : q;
  const square = top / bottom, root = integerRoot(square);
  return rounded(root, half, root * root !== square || top % bottom !== 0n);
}

function integerRoot(n) {
  let x = 1n << (sizeInBits(n) / 2n + 1n);
  for (;;) {
    const y = (x + n / x) >> 1n;
    if (y >= x) return x;
    x = y;
  }
}

/** How much longer the root of a square is than that of another, to nearly all digits of a binary64 however near they are. */
export function gapOfRoots(longer, shorter) {
  const [p, q] = fractionOf(longer), [r, s] = fractionOf(shorter), rise = p * s - r * q;
  if (rise === 0n) return 0;
  const half = (sizeInBits(p) - sizeInBits(q)) / 2n;  // squares in units of 4^half are near 1: they neither overflow nor vanish
  const scaled = (n, d) => nearestRoot(half > 0n ? `${n}/${d << (2n * half)}` : `${n << (-2n * half)}/${d}`);
  const roots = BigInt(Math.round((scaled(p, q) + scaled(r, s)) * 2 ** 50));  // times 2^(half - 50)
  const power = half - 50n, over = q * s * roots;
  return nearest(power > 0n ? `${rise}/${over << power}` : `${rise << -power}/${over}`);
}

/** The unit vector of an integer direction, each component the nearest binary64. */
export function unitOf(direction) {
  const v = direction.map(BigInt), square = v.reduce((sum, c) => sum + c * c, 0n);
  return v.map((c) => (c < 0n ? -1 : 1) * nearestRoot(`${c * c}/${square}`));
}

/** Decimals of an exact vector: three rationals; or, of round bodies, alpha n + beta n/|n| with an irrational |n|. */
export function decimalsOf(vector) {
  if (Array.isArray(vector)) return vector.map(nearest);
  const unit = unitOf(vector.normal), alpha = nearest(vector.alpha ?? "0"), beta = nearest(vector.beta ?? "0");
  return vector.normal.map((c, i) => alpha * nearest(c) + beta * unit[i]);
}

/** A number as text: that of JSON. -0 is 0. */
export function textOf(x) {
  return x === null || x === undefined ? "beyond binary64" : String(x === 0 ? 0 : x);
}

/** A vector as text. */
export function vectorText(v) {
  return v ? `(${v.map(textOf).join(", ")})` : "beyond binary64";
}

/** A gap, or a share, to a few digits. */
export function roughly(x, digits = 3) {
  return String(Number(x.toPrecision(digits)));
}
