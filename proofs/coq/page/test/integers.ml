(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What zarith's functions return that fathom-check-proved calls, on edge values and random ones: compiled with zarith and with integers.js this
   prints the same. *)

let power n k = let rec go x k = if k = 0 then x else go (Z.mul x (Z.of_int n)) (k - 1) in go Z.one k

(* around where a number stops to fit: 30 to 33 bits, 52 to 54, 61 to 65 *)
let edges =
  let powers = List.map (power 2) [ 0; 1; 29; 30; 31; 32; 33; 52; 53; 54; 61; 62; 63; 64; 65; 128 ] @ List.map (power 10) [ 9; 18; 19; 300 ] in
  let near x = [ Z.pred x; x; Z.succ x ] in
  List.sort_uniq Z.compare (List.concat_map (fun x -> List.concat_map (fun y -> [ y; Z.neg y ]) (near x)) powers)

(* of 1 to 90 digits; the same on every machine *)
let random =
  let state = ref 12345 in
  let below n = state := ((!state * 5) + 7919) land 0xffffff; (!state lsr 7) mod n in
  List.init 60 (fun i ->
      let digits = String.init (1 + (i * 3 / 2)) (fun _ -> Char.chr (48 + below 10)) in
      Z.of_string ((if below 2 = 0 then "-" else "") ^ digits))

let line words = print_string (String.concat " " words); print_char '\n'
let truth b = if b then "yes" else "no"
let or_raise f = match f () with x -> Z.to_string x | exception Division_by_zero -> "by zero"
let number q = Z.to_string (Q.num q) ^ "/" ^ Z.to_string (Q.den q)

let one a =
  let text = Z.to_string a in
  line
    [ text; truth (Z.equal a (Z.of_substring ("x" ^ text ^ "y") ~pos:1 ~len:(String.length text))); Z.to_string (Z.neg a);
      Z.to_string (Z.abs a); Z.to_string (Z.succ a); Z.to_string (Z.pred a); string_of_int (Z.sign a); string_of_int (Z.numbits a);
      String.concat " " (List.map (fun k -> Z.to_string (Z.shift_left a k)) [ 0; 1; 31; 32; 64; 100 ]);
      (if Z.numbits a < 31 then string_of_int (Z.to_int a) else "");
      (if Z.numbits a > 64 then match Z.to_int a with _ -> "fits" | exception Z.Overflow -> "overflows" else "") ]

let two a b =
  let quotient, rest = try Big_int_Z.quomod_big_int a b with Division_by_zero -> (Z.zero, Z.zero) in
  let divided = if Z.equal b Z.zero then [] else
      let q, r = Z.div_rem a b in
      [ Z.to_string q; Z.to_string r; Z.to_string (Z.cdiv a b); Z.to_string (Z.fdiv a b); Z.to_string (Z.divexact (Z.mul a b) b);
        truth (Z.divisible a b); truth (Z.divisible (Z.mul a b) b); number (Q.make a b) ] in
  let bezout = if Z.equal a Z.zero || Z.equal b Z.zero then [] else
      let g, s, t = Z.gcdext a b in
      [ Z.to_string g; truth (Z.equal g (Z.add (Z.mul a s) (Z.mul b t))) ] in
  line
    ([ Z.to_string (Z.add a b); Z.to_string (Z.sub a b); Z.to_string (Z.mul a b); or_raise (fun () -> Z.div a b); or_raise (fun () -> Z.rem a b);
       Z.to_string quotient; Z.to_string rest; Z.to_string (Z.gcd a b); Z.to_string (Z.lcm a b); string_of_int (Z.compare a b);
       truth (Z.equal a b); truth (Z.equal a (Z.sub (Z.add a b) b)); Z.to_string (Z.min a b); Z.to_string (Z.max a b) ]
     @ divided @ bezout)

let () =
  let all = edges @ random in
  List.iter one all;
  List.iter (fun a -> List.iter (two a) all) all
