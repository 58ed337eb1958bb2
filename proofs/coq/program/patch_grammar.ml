(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The grammar of format 4 (verify/check/FORMAT.md): format 2 with patches and rates. *)
open Lines
open Grammar

type corner = { corner_a : (Z.t * Q.t) array; corner_b : (Z.t * Q.t) array }
type side = { of_b : bool; inward : Z.t * Z.t * Z.t; at : Z.t }
type patch = { corners : corner part; sides : side part }
type rate = { v : Proved.point; w : Proved.point; sign : Z.t; root : Q.t }

type t = { signed : Signed_grammar.t; patches : patch part; rates : rate part }

(* as many as the number before them says *)
let weights f =
  let count = natural f in
  spend f 1;
  let found = ref [] and got = ref 0 in
  while Z.gt count (Z.of_int !got) do
    blank f;
    let i = natural f in blank f;
    found := (i, rational f) :: !found;
    spend f 2;
    incr got
  done;
  Array.of_list (List.rev !found)

let corner f =
  let corner_a = weights f in blank f;
  { corner_a; corner_b = weights f }

let side f =
  spend f 5;
  let of_b = f.s <> "" && f.s.[0] = 'b' in
  literal f (if of_b then "b" else "a");
  blank f;
  let x = integer f in blank f;
  let y = integer f in blank f;
  let z = integer f in blank f;
  { of_b; inward = (x, y, z); at = natural f }

let three f =
  let qx = rational f in blank f;
  let qy = rational f in blank f;
  { Proved.qx = ratio qx; qy = ratio qy; qz = ratio (rational f) }

let rate f =
  spend f 8;
  let v = three f in blank f;
  let w = three f in blank f;
  let sign = integer f in blank f;
  { v; w; sign; root = rational f }

(* the line at hand, and those of its corners and sides *)
let patch r counts =
  let f = fields r "patch, and the numbers of its corners and sides" in
  literal f "patch ";
  let corners = natural f in blank f;
  let sides = natural f in
  finish f;
  spend f 2;
  let line = r.number in
  let corners = rows r line corners "twice the number of weights, and as many indices and rationals" corner in
  let sides = rows r line sides "a or b, three integers, and the number of a corner" side in
  counts := Array.length sides.items :: Array.length corners.items :: !counts;
  { corners; sides }

let patches r counts =
  let f = fields r "patches and a count" in
  literal f "patches ";
  let count = natural f in
  finish f;
  let line = r.number and found = ref [] and lines = ref [] and got = ref 0 and before = !counts in
  counts := [];
  advance r;
  while Z.gt count (Z.of_int !got) do
    lines := r.number :: !lines;
    found := patch r counts :: !found;
    advance r;
    incr got
  done;
  counts := List.rev_append (List.rev !counts) (!got :: before);
  { line; items = Array.of_list (List.rev !found); lines_of = Array.of_list (List.rev !lines) }

let certificate r name =
  let signed, counts = Signed_grammar.all_but_footer ~patched:true r name in
  let counts = ref counts in
  let patches = patches r counts in
  let rates =
    if Signed_grammar.starts r "rates" then begin
      let rates = counted r "rates" "six rationals, a sign and a rational: a rate" rate in
      counts := Array.length rates.items :: !counts;
      advance r;
      rates
    end
    else nothing r.number in
  Signed_grammar.footer_behind r !counts;
  { signed = { signed with end_line = r.number }; patches; rates }
