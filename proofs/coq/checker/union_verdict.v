(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Format 3: from the pieces as they stand in the file to the statement that is printed. *)
Require Import List ZArith Bool.
From Fathom.checker Require Import sequence verdict unions.
Open Scope Z_scope.

Inductive union_status :=
  (* the squared depth, and how many shortest ways out there are *)
  | Pieces_penetrate (q : ratio) (optima : Z)
  | Pieces_touch
  (* the squared distance *)
  | Pieces_apart (q : ratio).
(* with the number of pieces of either body *)
Record union_statement := Union_statement { pieces_a : Z; pieces_b : Z; union_status_is : union_status }.

Definition union_stated (c : union_claim) : union_status :=
  match c with
  | Union_deep qn qd _ optima _ _ _ _ => Pieces_penetrate (Ratio qn qd) (count optima)
  | Union_touching _ _ => Pieces_touch
  | Union_apart qn qd _ _ => Pieces_apart (Ratio qn qd)
  end.

(* m: a common denominator of all coordinates *)
Definition union_verdict (m : Z) (As Bs : list (list point)) (c : union_claim) : option union_statement :=
  if forallb (forallb (fits m)) As && forallb (forallb (fits m)) Bs
     && union_check m (each (each (integral m)) As) (each (each (integral m)) Bs) c
  then Some (Union_statement (count As) (count Bs) (union_stated c)) else None.
