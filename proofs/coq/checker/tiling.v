(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Format 5: a mesh and convex pieces that tile its solid.  Integers and lists only.
   A flag is a plane, a line in it and a point on the line, none of them oriented.
   Each edge of a polygon adds 1 to the flag of its end and
   takes 1 from that of its start; what the triangles of the mesh add, the facets of the pieces must take away. *)
Require Import List ZArith Bool.
From Fathom Require Import printed.
From Fathom.checker Require Import vector sequence table polytope verdict.
Import ListNotations.
Open Scope Z_scope.

(* by the numbers of its corners *)
Definition numbers_of_triangle := (N * N * N)%type.
(* The numbers of its corners, each once; and its facets, whose corners are numbered by their places in that list, each with the number of
   the facet across the edge that leaves it: a hint, of which nothing is assumed. *)
Record tile := Tile { tile_corners : list N; tile_sides : list (list (N * N)) }.

(* the plane's normal and the line's direction, of any length; the point's number; and the sum so far *)
Record entry := Entry { entry_normal : zvec; entry_direction : zvec; entry_point : N; entry_sum : Z }.

Definition collinear (u v : zvec) : bool := negb (is_zero u) && negb (is_zero v) && is_zero (zcross u v).

(* no facet has the sense of another one *)
Fixpoint distinct (Fs : list facet) : bool :=
  match Fs with
  | [] => true
  | f :: Fs' => if forallb (fun g => negb (same_sense (normal f) (normal g))) Fs' then distinct Fs' else false
  end.
Definition supporting (vs : list zvec) (Fs : list facet) : bool :=
  forallb (fun f => forallb (fun v => zdot (normal f) v <=? offset f) vs) Fs.

Section Sums.
  (* hints: a common denominator of some points, and where in the table a flag is looked for *)
  Variables (common : list point -> Z) (slot : zvec -> zvec -> N -> positive).
  Variable points : table point.

  Definition add_flag (c : Z) (n d : zvec) (i : N) (t : option (table entry)) : option (table entry) :=
    match t with
    | None => None
    | Some t =>
        let k := slot n d i in
        match get k t with
        | None => if collinear n n && collinear d d then Some (put k (Entry n d i c) t) else None
        | Some e =>
            if collinear n (entry_normal e) && collinear d (entry_direction e) && (i =? entry_point e)%N
            then Some (put k (Entry (entry_normal e) (entry_direction e) i (c + entry_sum e)) t) else None
        end
    end.

  (* an edge from u to v, each the number of a point and the point in some units *)
  Definition add_edge (c : Z) (n : zvec) (u v : N * zvec) (t : option (table entry)) : option (table entry) :=
    let d := zsub (snd v) (snd u) in
    add_flag c n d (fst v) (add_flag (- c) n d (fst u) t).

  (* a triangle without an area has no plane, and adds nothing *)
  Definition add_triangle (t : option (table entry)) (ijk : numbers_of_triangle) : option (table entry) :=
    let '(i, j, k) := ijk in
    match member points i, member points j, member points k with
    | Some p, Some q, Some r =>
        let m := common [p; q; r] in
        if (0 <? m) && fits m p && fits m q && fits m r
        then
          let u := (i, integral m p) in
          let v := (j, integral m q) in
          let w := (k, integral m r) in
          let n := zcross (zsub (snd v) (snd u)) (zsub (snd w) (snd u)) in
          if is_zero n then t else add_edge 1 n u v (add_edge 1 n v w (add_edge 1 n w u t))
        else None
    | _, _, _ => None
    end.

  Definition numbered_point (i : N) : option (N * point) := match member points i with Some p => Some (i, p) | None => None end.

  (* the corners, moved and scaled so that their sum is O, each with the number of its point *)
  Definition centred (m : Z) (ps : list (N * point)) : list (N * zvec) :=
    let vs := each (fun ip => integral m (snd ip)) ps in
    let k := count vs in
    let s := fold_left zadd vs zzero in
    each (fun ip => (fst ip, zsub (zscal k (integral m (snd ip))) s)) ps.

  Definition add_side (corners : table (N * zvec)) (n : zvec) (side : list (N * N)) (t : option (table entry)) : option (table entry) :=
    match side with
    | [] => None
    | u :: r =>
        fold_chain (fun t v w => match member corners (fst v), member corners (fst w) with
                                 | Some p, Some q => add_edge (-1) n p q t
                                 | _, _ => None
                                 end) t u r u
    end.

  Definition tile_facets (ws : list (N * zvec)) (sides : list (list (N * N))) : list (list (N * N) * facet) :=
    let T := numbered (each snd ws) in each (fun side => (side, make_facet T side)) sides.
  Definition tile_ok (ws : list (N * zvec)) (Fs : list facet) : bool :=
    (0 <? count ws) && inner_ok 0 1 Fs && supporting (each snd ws) Fs && distinct Fs.

  Definition add_tile (t : option (table entry)) (q : tile) : option (table entry) :=
    match every numbered_point (tile_corners q) with
    | None => None
    | Some ps =>
        let m := common (each snd ps) in
        if (0 <? m) && forallb (fun ip => fits m (snd ip)) ps
        then
          let ws := centred m ps in
          let sides := tile_facets ws (tile_sides q) in
          if tile_ok ws (each snd sides)
          then let T := numbered ws in fold_left (fun t lf => add_side T (normal (snd lf)) (fst lf) t) sides t
          else None
        else None
    end.
End Sums.

Definition sums (common : list point -> Z) (slot : zvec -> zvec -> N -> positive) (points : list point) (mesh : list numbers_of_triangle)
    (tiles : list tile) : option (table entry) :=
  let P := numbered points in
  fold_left (add_tile common slot P) tiles (fold_left (add_triangle common slot P) mesh (Some Empty)).

Definition tiling_verdict (common : list point -> Z) (slot : zvec -> zvec -> N -> positive) (points : list point)
    (mesh : list numbers_of_triangle) (tiles : list tile) : option tiling_statement :=
  match tiles, sums common slot points mesh tiles with
  | _ :: _, Some t =>
      if all_entries (fun e => entry_sum e =? 0) t then Some (Tiling_statement (count mesh) (count tiles)) else None
  | _, _ => None
  end.
