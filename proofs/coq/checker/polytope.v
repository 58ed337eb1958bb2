(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The lower side: is the ball of squared radius qn/qd inside the polytope Q, whose corners are points of P? *)
Require Import List ZArith Bool.
From Fathom.checker Require Import vector sequence table.
Import ListNotations.
Open Scope Z_scope.

(* A corner of a facet: the point, and the number of the facet across the edge that leaves it.
   The number is a hint: nothing is assumed about it. *)
Definition corner := (zvec * N)%type.

(* the facet's plane is <normal, x> = offset *)
Record facet := Facet { corners : list corner; normal : zvec; offset : Z }.

(* the point b_j - a_i; O if there is no such point *)
Definition difference (A B : table zvec) (ji : N * N) : zvec :=
  match member B (fst ji), member A (snd ji) with
  | Some b, Some a => zsub b a
  | _, _ => zzero
  end.

(* the sum of the cross products of successive corners *)
Definition area_normal (l : list corner) : zvec :=
  match l with
  | [] => zzero
  | p :: r => fold_chain (fun acc u v => zadd acc (zcross (fst u) (fst v))) zzero p r p
  end.

(* a facet from its cycle of (vertex, neighbour) numbers *)
Definition make_facet (V : table zvec) (l : list (N * N)) : facet :=
  let L := each (fun vg => (match member V (fst vg) with Some v => v | None => zzero end, snd vg)) l in
  let n := area_normal L in
  Facet L n (match L with [] => 0 | p :: _ => zdot n (fst p) end).

Definition make_facets (A B : list zvec) (V : list (N * N)) (F : list (list (N * N))) : list facet :=
  let TA := numbered A in
  let TB := numbered B in
  let TV := numbered (each (difference TA TB) V) in
  each (make_facet TV) F.

(* the neighbour g across the edge u v: its plane passes through u and v, and strictly above some corner w of f *)
Definition edge_ok (Fs : table facet) (f : facet) (u v : corner) : bool :=
  let g := match member Fs (snd u) with Some g => g | None => f end in
  (zdot (normal g) (fst u) =? offset g) && (zdot (normal g) (fst v) =? offset g)
  && existsb (fun w => (0 <? zdet (fst u) (fst v) (fst w)) && (zdot (normal g) (fst w) <? offset g)) (corners f).

Definition facet_ok (qn qd : Z) (Fs : table facet) (f : facet) : bool :=
  match corners f with
  | p :: a :: b :: r =>
      (0 <? offset f)
      && (qn * zdot (normal f) (normal f) <=? offset f * offset f * qd)
      && forallb (fun v => zdot (normal f) (fst v) =? offset f) (p :: a :: b :: r)
      && along_pairs (fun u v => 0 <? zdet (fst p) (fst u) (fst v)) a (b :: r)
      && along_chain (edge_ok Fs f) p (a :: b :: r) p
  | _ => false
  end.

(* two facets look in opposite senses *)
Definition bounded (Fs : list facet) : bool :=
  match Fs with
  | [] => false
  | f :: _ => (0 <? zdot (normal f) (normal f)) && existsb (fun g => zdot (normal g) (normal f) <? 0) Fs
  end.

Definition inner_ok (qn qd : Z) (Fs : list facet) : bool :=
  let T := numbered Fs in bounded Fs && forallb (facet_ok qn qd T) Fs.

(* a facet at distance exactly qn/qd has a listed direction, where find says: a hint, of which nothing is assumed *)
Definition listed (qn qd : Z) (dirs : table zvec) (find : zvec -> N) (f : facet) : bool :=
  negb (qn * zdot (normal f) (normal f) =? offset f * offset f * qd)
  || match member dirs (find (normal f)) with Some n => same_sense n (normal f) | None => false end.
