(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The grammar of verify/check/FORMAT.md: from lines to a certificate as it stands there.  Each part keeps the number of its line. *)
open Lines

type 'a part = { line : int; items : 'a array; lines_of : int array }

type claim =
  | Depth of Q.t
  | Bounds of Q.t * Q.t
  | Touching
  | Disjoint

(* bodies of the plane: how high they are to be raised *)
type plane = { height : Q.t; height_line : int }

type t = {
  plane : plane option;
  a : Proved.point part;
  b : Proved.point part;
  claim : claim;
  claim_line : int;
  end_line : int;
  all : bool;
  directions : (Z.t * Z.t * Z.t) part;
  vertices : (Z.t * Z.t) part;
  facets : Z.t array part;
  weights_a : (Z.t * Q.t) part;
  weights_b : (Z.t * Q.t) part;
}

let nothing line = { line; items = [||]; lines_of = [||] }

(* as many items as were announced, each on a line of its own; nothing is set aside for lines that may never come *)
let rows r line count expected item =
  let items = ref [] and numbers = ref [] and got = ref 0 in
  while Z.gt count (Z.of_int !got) do
    advance r;
    let f = fields r expected in
    items := item f :: !items;
    finish f;
    numbers := r.number :: !numbers;
    incr got
  done;
  { line; items = Array.of_list (List.rev !items); lines_of = Array.of_list (List.rev !numbers) }

let counted r word expected item =
  let f = fields r (word ^ " and a count") in
  literal f (word ^ " ");
  let count = natural f in
  finish f;
  rows r r.number count expected item

let part r word expected item = advance r; counted r word expected item

(* what stands behind the first word *)
let words_of r expected word item =
  let f = fields r expected in
  literal f word;
  let found = item f in
  finish f;
  found

let ratio q = { Proved.num = Q.num q; den = Q.den q }

let point f =
  spend f 3;
  let qx = rational f in blank f;
  let qy = rational f in blank f;
  { Proved.qx = ratio qx; qy = ratio qy; qz = ratio (rational f) }

let plane_point f =
  spend f 2;
  let qx = rational f in blank f;
  { Proved.qx = ratio qx; qy = ratio (rational f); qz = ratio Q.zero }

(* a line of a body, and what is expected there *)
let points_of = function
  | None -> ("three rationals: a point", point)
  | Some _ -> ("two rationals: a point of the plane", plane_point)

(* as the proved function raises them too *)
let prism plane part =
  match plane with
  | None -> part
  | Some { height; _ } ->
    let at z = Array.map (fun p -> { p with Proved.qz = ratio z }) part.items in
    { part with items = Array.append (at (Q.neg height)) (at height); lines_of = Array.append part.lines_of part.lines_of }

let direction f =
  spend f 3;
  let x = integer f in blank f;
  let y = integer f in blank f;
  (x, y, integer f)

let pair f = spend f 2; let j = natural f in blank f; (j, natural f)
let weight f = spend f 2; let i = natural f in blank f; (i, rational f)

let facet f =
  let count = natural f in
  spend f 1;
  let corners = ref [] and got = ref 0 in
  while not (at_end f) do
    blank f;
    spend f 1;
    corners := natural f :: !corners;
    incr got
  done;
  if not (Z.equal count (Z.of_int !got)) then wrong f;
  Array.of_list (List.rev !corners)

let is_hex c = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F')

(* codes 33 to 126 but %, all else as %XX *)
let id_of f =
  literal f "id ";
  let first = f.at in
  while not (at_end f) do
    let c = f.s.[f.at] in
    if c = '%' then begin
      if f.at + 2 >= String.length f.s || not (is_hex f.s.[f.at + 1] && is_hex f.s.[f.at + 2]) then wrong f;
      f.at <- f.at + 3
    end
    else if c > ' ' && c <= '~' then f.at <- f.at + 1
    else wrong f
  done;
  if f.at = first then wrong f;
  String.sub f.s first (f.at - first)

let claim_of r =
  let expected = "claim depth, bounds, touching or disjoint" in
  let f = fields r expected in
  literal f "claim ";
  let claim =
    match f.s with
    | "claim touching" -> f.at <- String.length f.s; Touching
    | "claim disjoint" -> f.at <- String.length f.s; Disjoint
    | s when has_prefix "claim bounds " s ->
      literal f "bounds ";
      let lo = rational f in blank f;
      Bounds (lo, rational f)
    | _ -> literal f "depth "; Depth (rational f)
  in
  finish f;
  claim

let directions_of r =
  advance r;
  let f = fields r "directions, a count, and some or all" in
  literal f "directions ";
  let count = natural f in
  let all = has_prefix " all" (String.sub f.s f.at (String.length f.s - f.at)) in
  literal f (if all then " all" else " some");
  finish f;
  (all, rows r r.number count "three integers: a direction" direction)

let footer_at r expected counts =
  let f = fields r expected in
  literal f "end";
  let good = ref true in
  List.iter (fun n -> blank f; if not (Z.equal (natural f) (Z.of_int n)) then good := false) counts;
  finish f;
  if not !good then wrong f

let footer r counts = advance r; footer_at r "end and the five counts again" counts

(* the first line: 1 to 6 *)
let format_of r =
  begin_certificate r;
  let f = fields r "fathom-certificate and a format: 1 to 6" in
  literal f "fathom-certificate ";
  let format =
    match f.s with
    | "fathom-certificate 2" -> 2 | "fathom-certificate 3" -> 3 | "fathom-certificate 4" -> 4 | "fathom-certificate 5" -> 5
    | "fathom-certificate 6" -> 6 | _ -> 1 in
  literal f (string_of_int format);
  finish f;
  format

(* name: where the certificate's own is put, as soon as it is known *)
let at r word = match r.text with Whole s -> s = word || has_prefix (word ^ " ") s | _ -> false
let name_of r name =
  if at r "id" then begin
    name := id_of (fields r "id and a text: codes 33 to 126 but %, or % and two hexadecimal digits");
    advance r
  end
let plane_of r =
  if at r "plane" then begin
    let height_line = r.number in
    let height = words_of r "plane and a rational: a height" "plane " rational in
    advance r;
    Some { height; height_line }
  end
  else None

(* of format 1, behind its first line *)
let certificate r name =
  advance r;
  name_of r name;
  let plane = plane_of r in
  let expected, point = points_of plane in
  let a = counted r "a" expected point in
  let b = part r "b" expected point in
  advance r;
  let claim = claim_of r in
  let claim_line = r.number in
  let all, directions = directions_of r in
  let vertices, facets =
    match claim with
    | Depth _ | Bounds _ ->
      let vertices = part r "vertices" "two numbers: a vertex" pair in
      (vertices, part r "facets" "a count and as many corners" facet)
    | _ -> (nothing r.number, nothing r.number) in
  let weights_a, weights_b =
    match claim with
    | Touching ->
      let weights_a = part r "weights_a" "the number of a point and its weight" weight in
      (weights_a, part r "weights_b" "the number of a point and its weight" weight)
    | _ -> (nothing r.number, nothing r.number) in
  let size p = Array.length p.items in
  footer r [ size a; size b; size directions; size vertices + size weights_a; size facets + size weights_b ];
  { plane; a; b; claim; claim_line; end_line = r.number; all; directions; vertices; facets; weights_a; weights_b }

let raised g = { g with b = prism g.plane g.b }
