(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Cores that touch: is a cone all of the set K of vectors u with h(u) = 0? *)
Require Import List ZArith Bool.
From Fathom.checker Require Import vector sequence table polytope support certificate.
Import ListNotations.
Open Scope Z_scope.

(* K: all sums of multiples of the lineality's vectors and multiples >= 0 of the rays.  A ray comes with a multiplier that shows it to be
   primitive.  The differences (j, i), of b_j and a_i, show that K is not larger. *)
Record zcone := Zcone { lineality : list zvec; rays : list direction; differences : list (N * N) }.

Definition independent (l : list zvec) : bool :=
  match l with
  | [] => true
  | [u] => negb (is_zero u)
  | [u; v] => negb (is_zero (zcross u v))
  | [u; v; w] => negb (zdet u v w =? 0)
  | _ => false
  end.

Definition level (A B : list zvec) (n : zvec) : bool := support.height_is (fun h => h =? 0) A B n.

(* the rays on the plane through O with normal d *)
Definition on_plane (rs : list zvec) (d : zvec) : list zvec :=
  fold_left (fun l r => if zdot d r =? 0 then r :: l else l) rs [].

Fixpoint first {T : Type} (f : T -> bool) (l : list T) : option T :=
  match l with [] => None | x :: l' => if f x then Some x else first f l' end.

(* of two rays the one that is not r *)
Definition partner (r : zvec) (z : list zvec) : option zvec :=
  match z with
  | [a; b] => if same_vector r a then Some b else if same_vector r b then Some a else None
  | _ => None
  end.
Definition has_partner (r : zvec) (z : list zvec) : bool := match partner r z with Some _ => true | None => false end.
(* the ray has two different partners *)
Definition between_two (zs : list (list zvec)) (r : zvec) : bool :=
  match first (has_partner r) zs with
  | Some z => existsb (fun z' => match partner r z, partner r z' with Some a, Some b => negb (same_vector a b) | _, _ => false end) zs
  | None => false
  end.
(* three rays or more: each difference is the normal of a face with two rays, and each ray is between two faces *)
Definition many_rays (rs ds : list zvec) : bool :=
  let zs := each (on_plane rs) ds in
  forallb (fun z => match z with [_; _] => true | _ => false end) zs && forallb (between_two zs) rs.

(* a difference that is below the ray r, and level with the other ray *)
Definition bounded_below (ds : list zvec) (r : zvec) (others : list zvec) : bool :=
  existsb (fun d => (zdot d r <? 0) && forallb (fun o => zdot d o =? 0) others) ds.
Definition few_rays (ls rs ds : list zvec) : bool :=
  let level := fold_left (fun l d => if forallb (fun r => zdot d r =? 0) rs then d :: l else l) ds [] in
  match rs with
  | [] => true
  | [r] => bounded_below ds r []
  | [r; r'] => negb (is_zero (zcross r r')) && bounded_below ds r [r'] && bounded_below ds r' [r]
  | _ => false
  end
  && match ls ++ rs with
     | [p] => match level with [] => false | _ => true end
              && forallb (fun d => existsb (fun d' => 0 <? zdot p (zcross d d')) level) level
     | [_; _] => existsb (fun d => existsb (fun d' => zdot d d' <? 0) level) level
     | [_; _; _] => true
     | _ => false
     end.

Definition cone_ok (A B : list zvec) (k : zcone) : bool :=
  let ls := lineality k in
  let rs := each fst (rays k) in
  let TA := numbered A in
  let TB := numbered B in
  let ds := each (difference TA TB) (differences k) in
  independent ls
  && forallb (fun l => level A B l && level A B (zneg l)) ls
  && match rs with [] => true | _ => canonical (rays k) end
  && forallb (fun r => forallb (fun l => zdot r l =? 0) ls && level A B r) rs
  && match rs with _ :: _ :: _ :: _ => many_rays rs ds | _ => few_rays ls rs ds end.
