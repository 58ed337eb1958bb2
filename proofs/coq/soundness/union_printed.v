(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What a line about a certificate of format 3 says, about the pieces as they stand in the file.  Definitions only: to be read and believed,
   with geometry/unions.v. *)
Require Import Reals List ZArith.
From Fathom.checker Require Import verdict union_verdict.
From Fathom.geometry Require Import meaning unions.
From Fathom.soundness Require Import printed.
Open Scope R_scope.

Definition real_pieces (Ls : list (list point)) : list (list pt) := map (map real) Ls.

(* there are exactly k shortest ways out *)
Definition ways_out_number (As Bs : list (list pt)) (q : R) (k : Z) : Prop :=
  exists ts, Z.of_nat (length ts) = k /\ NoDup ts /\ forall t, shortest_way_out As Bs q t <-> In t ts.

Definition status_is (As Bs : list (list pt)) (s : union_status) : Prop :=
  match s with
  | Pieces_penetrate q optima => union_depth2_is As Bs (value q) /\ ways_out_number As Bs (value q) optima
  | Pieces_touch => unions_touch As Bs
  | Pieces_apart q => unions_distance2_is As Bs (value q)
  end.

Definition says_union (As Bs : list (list pt)) (s : union_statement) : Prop :=
  solid_pieces As /\ solid_pieces Bs
  /\ Z.of_nat (length As) = pieces_a s /\ Z.of_nat (length Bs) = pieces_b s
  /\ status_is As Bs (union_status_is s).
