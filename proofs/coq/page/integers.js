// SPDX-License-Identifier: GPL-3.0-or-later
// zarith's functions in C, as JavaScript over BigInt: those that fathom-check-proved calls. An integer is a number if it fits into 32 bits, as
// zarith's are immediate if they fit into OCaml's, and else a BigInt; so equal ones are identical. js_of_ocaml links what `Provides` names.
// tests/browser/integers.ml compares each with zarith.

//Provides: fathom_integer const
function fathom_integer(x) { return x >= -2147483648 && x <= 2147483647 ? Number(x) : x; }

//Provides: ml_z_init
function ml_z_init(unit) { return 0; }

//Provides: ml_z_neg const
//Requires: fathom_integer
function ml_z_neg(a) { return fathom_integer(-BigInt(a)); }

//Provides: ml_z_abs const
//Requires: fathom_integer
function ml_z_abs(a) { return a < 0 ? fathom_integer(-BigInt(a)) : a; }

//Provides: ml_z_succ const
//Requires: fathom_integer
function ml_z_succ(a) { return fathom_integer(BigInt(a) + BigInt(1)); }

//Provides: ml_z_pred const
//Requires: fathom_integer
function ml_z_pred(a) { return fathom_integer(BigInt(a) - BigInt(1)); }

//Provides: ml_z_add const
//Requires: fathom_integer
function ml_z_add(a, b) { return fathom_integer(BigInt(a) + BigInt(b)); }

//Provides: ml_z_sub const
//Requires: fathom_integer
function ml_z_sub(a, b) { return fathom_integer(BigInt(a) - BigInt(b)); }

//Provides: ml_z_mul const
//Requires: fathom_integer
function ml_z_mul(a, b) { return fathom_integer(BigInt(a) * BigInt(b)); }

// of numbers of 32 bits: a double tells such products from longer ones
//Provides: ml_z_mul_overflows const
function ml_z_mul_overflows(a, b) { return a * b === (a * b | 0) ? 0 : 1; }

// zarith's own masks are made by this
//Provides: ml_z_shift_left const
//Requires: fathom_integer
function ml_z_shift_left(a, places) { return fathom_integer(BigInt(a) << BigInt(places)); }

// ---- division: towards zero, downwards, upwards ----

//Provides: fathom_divisor
//Requires: caml_raise_zero_divide
function fathom_divisor(b) {
  if (b === 0) caml_raise_zero_divide();
  return BigInt(b);
}

//Provides: ml_z_div
//Requires: fathom_integer, fathom_divisor
function ml_z_div(a, b) { return fathom_integer(BigInt(a) / fathom_divisor(b)); }

//Provides: ml_z_divexact
//Requires: ml_z_div
function ml_z_divexact(a, b) { return ml_z_div(a, b); }

//Provides: ml_z_rem
//Requires: fathom_integer, fathom_divisor
function ml_z_rem(a, b) { return fathom_integer(BigInt(a) % fathom_divisor(b)); }

//Provides: ml_z_div_rem
//Requires: ml_z_div, ml_z_rem
function ml_z_div_rem(a, b) { return [0, ml_z_div(a, b), ml_z_rem(a, b)]; }

//Provides: ml_z_fdiv
//Requires: ml_z_div, ml_z_rem, ml_z_pred
function ml_z_fdiv(a, b) {
  var quotient = ml_z_div(a, b), rest = ml_z_rem(a, b);
  return rest !== 0 && (rest < 0) !== (b < 0) ? ml_z_pred(quotient) : quotient;
}

//Provides: ml_z_cdiv
//Requires: ml_z_div, ml_z_rem, ml_z_succ
function ml_z_cdiv(a, b) {
  var quotient = ml_z_div(a, b), rest = ml_z_rem(a, b);
  return rest !== 0 && (rest < 0) === (b < 0) ? ml_z_succ(quotient) : quotient;
}

//Provides: ml_z_divisible const
function ml_z_divisible(a, b) { return b === 0 ? +(a === 0) : +(BigInt(a) % BigInt(b) === BigInt(0)); }

//Provides: ml_z_gcd const
//Requires: fathom_integer
function ml_z_gcd(a, b) {
  while (typeof a !== "number" || typeof b !== "number") {
    if (b === 0) return a < 0 ? fathom_integer(-a) : a;
    var rest = fathom_integer(BigInt(a) % BigInt(b));
    a = b;
    b = rest;
  }
  while (b !== 0) {
    var next = a % b;
    a = b;
    b = next;
  }
  return fathom_integer(BigInt(Math.abs(a)));
}

// the greatest common divisor g of numbers that are not 0, the s of g = a s + b t, and that it is a's
//Provides: ml_z_gcdext_intern
//Requires: fathom_integer, fathom_divisor
function ml_z_gcdext_intern(a, b) {
  var r = fathom_divisor(a), next = fathom_divisor(b), s = BigInt(1), t = BigInt(0);
  while (next != 0) {
    var quotient = r / next, rest = r - quotient * next, factor = s - quotient * t;
    r = next;
    next = rest;
    s = t;
    t = factor;
  }
  return r < 0 ? [0, fathom_integer(-r), fathom_integer(-s), 1] : [0, fathom_integer(r), fathom_integer(s), 1];
}

// ---- comparisons ----

//Provides: ml_z_compare const
function ml_z_compare(a, b) { return a < b ? -1 : +(a > b); }

//Provides: ml_z_equal const
function ml_z_equal(a, b) { return +(a === b); }

//Provides: ml_z_sign const
function ml_z_sign(a) { return a < 0 ? -1 : +(a > 0); }

// ---- texts, bits, and OCaml's integers ----

//Provides: ml_z_numbits const
function ml_z_numbits(a) {
  if (a == 0) return 0;
  var text = (a < 0 ? -BigInt(a) : BigInt(a)).toString(16);
  return 4 * (text.length - 1) + (32 - Math.clz32(parseInt(text.charAt(0), 16)));
}

//Provides: ml_z_to_int
//Requires: caml_raise_constant, caml_named_value
function ml_z_to_int(a) {
  if (typeof a !== "number") caml_raise_constant(caml_named_value("ml_z_overflow"));
  return a;
}

// decimal digits are all that the program prints and reads
//Provides: ml_z_format
//Requires: caml_jsbytes_of_string, caml_string_of_jsbytes, caml_failwith
function ml_z_format(format, a) {
  if (caml_jsbytes_of_string(format) !== "%d") caml_failwith("Z.format: only %d is supported");
  return caml_string_of_jsbytes(String(a));
}

//Provides: ml_z_of_substring_base
//Requires: caml_jsbytes_of_string, caml_invalid_argument, fathom_integer
function ml_z_of_substring_base(base, text, at, length) {
  var digits = caml_jsbytes_of_string(text).substr(at, length);
  if ((base !== 0 && base !== 10) || !/^-?[0-9]+$/.test(digits)) caml_invalid_argument("Z.of_substring_base: invalid digit");
  return fathom_integer(BigInt(digits));
}
