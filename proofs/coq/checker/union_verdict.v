(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Format 3: from the pieces as they stand in the file to the statement that is printed. *)
Require Import List ZArith Bool.
From Fathom Require Import printed.
From Fathom.checker Require Import sequence verdict unions.
Open Scope Z_scope.

Definition union_stated (c : union_claim) : statement :=
  match c with
  | Union_deep qn qd _ optima _ _ _ _ => Depth_is (Ratio qn qd) (Some (count optima))
  | Union_touching _ _ => They_touch
  | Union_apart qn qd _ _ => Distance_is (Ratio qn qd)
  end.

(* m: a common denominator of all coordinates *)
Definition union_verdict (m : Z) (As Bs : list (list point)) (c : union_claim) : option union_statement :=
  if forallb (forallb (fits m)) As && forallb (forallb (fits m)) Bs
     && union_check m (each (each (integral m)) As) (each (each (integral m)) Bs) c
  then Some (Union_statement (count As) (count Bs) (union_stated c)) else None.
