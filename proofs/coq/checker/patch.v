(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The patch of a direction n: where A's core, moved by t = (H/<n,n>) n, has points in common with
   B's.  Are its corners all of it? *)
Require Import List ZArith Bool.
From Fathom Require Import printed.
From Fathom.checker Require Import vector sequence table support verdict body signed.
Import ListNotations.
Open Scope Z_scope.

(* a point of A in units of 1/unit, and the point of B that it is moved to, by weights in these
   units (none of a half-space); named_by: the number of a side that names this corner *)
Record patch_corner := Corner { corner_unit : Z; corner_a : list (N * Z); corner_b : list (N * Z); named_by : N }.
(* The patch is on the side of inward of a plane that touches the face of a body, of b or a, and
   goes through a corner, through which the next side's plane goes too. *)
Record side := Side { of_b : bool; inward : zvec; side_corner : N }.
(* ascending: the numbers of the corners in their lexicographic order *)
Record patch := Patch { patch_corners : list patch_corner; patch_sides : list side; ascending : list N }.

Definition spots (c : zcore) : list zvec := match c with Points L => L | _ => [] end.

(* the points of L where <s, .> is greatest *)
Definition face (s : zvec) (L : list zvec) : list zvec :=
  match greatest s L with
  | Some g => fold_left (fun l p => if zdot s p =? g then p :: l else l) L []
  | None => []
  end.
Definition level_with (n : zvec) (F : list zvec) (x : zvec) (u : Z) : bool :=
  match F with p :: _ => zdot n x =? u * zdot n p | [] => false end.

(* (x, k) is x/k *)
Definition quotient := (zvec * Z)%type.
Definition quotient_before (p q : quotient) : bool := before (zscal (snd q) (fst p)) (zscal (snd p) (fst q)).

Section Of_direction.
  Variables (A B : zcore) (TA TB : table zvec) (n : zvec).
  (* H = h/d; the points of A and B on the planes that n has at the two bodies *)
  Variables (h d : Z) (FA FB : list zvec).

  (* of a half-space, which has no points to be weighed, the end is where the other one leads *)
  Definition end_of (c : patch_corner) : option quotient :=
    let u := corner_unit c in
    match weighed TA (corner_a c), weighed TB (corner_b c) with
    | Some (s, x), Some (t, y) =>
        match A, B with
        | Points _, Points _ =>
            if (0 <? u) && (s =? u) && (t =? u) && same_vector (zscal (d * zdot n n) (zsub y x)) (zscal (u * h) n)
            then Some (x, u) else None
        | Points _, Half_space _ _ =>
            if (0 <? u) && (s =? u) && level_with n FA x u then Some (x, u) else None
        | Half_space _ _, Points _ =>
            if (0 <? u) && (t =? u) && level_with n FB y u
            then Some (zsub (zscal (d * zdot n n) y) (zscal (u * h) n), u * (d * zdot n n)) else None
        | _, _ => None
        end
    | _, _ => None
    end.

  (* a side, how low the face is in its direction, and its corner *)
  Record flank := Flank { normal_of : zvec; level_of : Z; end_at : quotient }.
  Definition flank_of (ends : table quotient) (s : side) : option flank :=
    match greatest (zneg (inward s)) (if of_b s then FB else FA), member ends (side_corner s) with
    | Some g, Some p => if zdot n (inward s) =? 0 then Some (Flank (inward s) (- g) p) else None
    | _, _ => None
    end.

  Definition through (f : flank) (p : quotient) : bool := zdot (normal_of f) (fst p) =? level_of f * snd p.
  Definition turns (f g : flank) : bool :=
    (0 <? zdet n (normal_of f) (normal_of g)) && through f (end_at f) && through g (end_at f).

  Fixpoint all_named (flanks : table flank) (cs : list patch_corner) (ends : list quotient) : bool :=
    match cs, ends with
    | [], [] => true
    | c :: cs', p :: ends' =>
        if match member flanks (named_by c) with
           | Some f => same_vector (fst (end_at f)) (fst p) && (snd (end_at f) =? snd p)
           | None => false
           end
        then all_named flanks cs' ends' else false
    | _, _ => false
    end.

  Definition all_different (ends : list quotient) (order : list N) : bool :=
    match every (member (numbered ends)) order with
    | Some (p :: l) => along_pairs quotient_before p l && (count (p :: l) =? count ends)
    | _ => false
    end.

  Definition ends_of (pt : patch) : option (list quotient) :=
    match every end_of (patch_corners pt) with
    | Some ends =>
        match every (flank_of (numbered ends)) (patch_sides pt) with
        | Some (f :: fs) =>
            if along_chain turns f fs f && all_named (numbered (f :: fs)) (patch_corners pt) ends
               && all_different ends (ascending pt)
            then Some ends else None
        | _ => None
        end
    | None => None
    end.
End Of_direction.

(* the corners' points of A, if the cores' signed depth is the root of qn/qd in direction n *)
Definition check_patch (A B : zcore) (TA TB : table zvec) (qn qd : Z) (n : zvec) (pt : patch)
  : option (list quotient) :=
  match outer_height A B (Heights 1 [] []) n with
  | Some (h, d) =>
      if negb (is_zero n) && (signed_square h * qd =? qn * (d * d) * zdot n n)
      then ends_of A B TA TB n h d (face (zneg n) (spots A)) (face n (spots B)) pt else None
  | None => None
  end.
