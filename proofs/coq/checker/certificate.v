(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The checker: a certificate, and the function that accepts it.  Integers and lists only: no proofs, no real numbers. *)
Require Import List ZArith Bool.
From Fathom.checker Require Import vector sequence table polytope support.
Import ListNotations.
Open Scope Z_scope.

(* A vertex (j, i) is b_j - a_i; a facet is its cycle of (vertex, number of the facet across the edge that leaves it); find gives the
   number of the listed direction that has the sense of a facet's normal. *)
Record inner := Inner { vertices : list (N * N); facets : list (list (N * N)); find : zvec -> N }.

(* A direction, and a multiplier with <direction, multiplier> = 1, which shows that the direction is primitive (it is
   looked at only where that matters). *)
Definition direction := (zvec * zvec)%type.

Inductive claim :=
  (* depth^2 = qn/qd, and these are some of the nearest facets' directions; complete: all of them *)
  | Depth (qn qd : Z) (complete : bool) (directions : list direction) (q : inner)
  (* penetrating, and ln/ld <= depth^2 <= hn/hd *)
  | Bounds (ln ld hn hd : Z) (n : zvec) (q : inner)
  (* h(n) = 0, and a common point; the weights are in units of 1/unit *)
  | Touching (n : zvec) (unit : Z) (weights_a weights_b : list (N * Z))
  | Disjoint (n : zvec).

(* the bodies are the hulls of A/scale and B/scale *)
Record certificate := Certificate { scale : Z; body_a : list zvec; body_b : list zvec; claimed : claim }.

(* strictly ascending, and no coordinates with a common factor *)
Definition canonical (dirs : list direction) : bool :=
  match dirs with [] => false | n :: r => along_pairs (fun u v => before (fst u) (fst v)) n r end
  && forallb (fun n => zdot (fst n) (snd n) =? 1) dirs.

Definition check_depth (A B : list zvec) (qn qd : Z) (complete : bool) (dirs : list direction) (q : inner) : bool :=
  let Fs := make_facets A B (vertices q) (facets q) in
  (0 <? qn) && (0 <? qd)
  && match dirs with [] => false | _ => true end
  && forallb (fun n => tangent A B qn qd (fst n)) dirs
  && inner_ok qn qd Fs
  && (negb complete || canonical dirs && (let T := numbered (each fst dirs) in forallb (listed qn qd T (find q)) Fs)).

Definition check_bounds (A B : list zvec) (ln ld hn hd : Z) (n : zvec) (q : inner) : bool :=
  (0 <=? ln) && (0 <? ld) && (0 <? hn) && (0 <? hd)
  && within A B hn hd n
  && inner_ok ln ld (make_facets A B (vertices q) (facets q)).

Definition check_touching (A B : list zvec) (n : zvec) (unit : Z) (WA WB : list (N * Z)) : bool :=
  negb (is_zero n) && height_is (fun h => h =? 0) A B n && common_point A B unit WA WB.

Definition check_disjoint (A B : list zvec) (n : zvec) : bool := height_is (fun h => h <? 0) A B n.

(* squared lengths are measured in the units of the integer points *)
Definition check (c : certificate) : bool :=
  let A := body_a c in
  let B := body_b c in
  let s := scale c * scale c in
  (0 <? scale c)
  && match claimed c with
     | Depth qn qd complete dirs q => check_depth A B (qn * s) qd complete dirs q
     | Bounds ln ld hn hd n q => check_bounds A B (ln * s) ld (hn * s) hd n q
     | Touching n unit WA WB => check_touching A B n unit WA WB
     | Disjoint n => check_disjoint A B n
     end.
