(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Bodies that may be round or curved (printed.v), over other vectors and numbers. *)
Require Import List.
From Fathom Require Import printed.
From Fathom.checker Require Import sequence.
Import ListNotations.

Section Map.
  Variables (V U V' U' : Type) (f : V -> V') (offset length : U -> U').
  Definition map_atom (a : atom V) : atom V' := Atom (f (center a)) (f (axis_u a)) (f (axis_v a)) (f (axis_w a)).
  Definition map_core (c : core V U) : core V' U' :=
    match c with
    | Points L => Points (each f L)
    | Terms ts => Terms (each (each map_atom) ts)
    | Half_space n d => Half_space (f n) (offset d)
    end.
  Definition map_body (b : body V U) : body V' U' := Body (map_core (core_of b)) (length (radius b)).
End Map.
Arguments map_atom {V V'}.
Arguments map_core {V U V' U'}.
Arguments map_body {V U V' U'}.

(* each vector and each number passes *)
Section All.
  Variables (V U : Type) (f : V -> bool) (g : U -> bool).
  Definition all_atom (a : atom V) : bool := f (center a) && f (axis_u a) && f (axis_v a) && f (axis_w a).
  Definition all_body (b : body V U) : bool :=
    match core_of b with
    | Points L => forallb f L
    | Terms ts => forallb (forallb all_atom) ts
    | Half_space n d => f n && g d
    end && g (radius b).
End All.
Arguments all_body {V U}.
