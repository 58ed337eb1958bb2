(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* From the points as they stand in the file to the statement that is printed: what is not proved of these very points has no statement. *)
Require Import List ZArith Bool.
From Fathom Require Import printed.
From Fathom.checker Require Import vector sequence certificate.
Import ListNotations.
Open Scope Z_scope.

(* in units of 1/m; right only if r is a multiple of that *)
Definition units (m : Z) (r : ratio) : Z := num r * (m / den r).
Definition integral (m : Z) (p : point) : zvec := Zvec (units m (qx p)) (units m (qy p)) (units m (qz p)).
Definition divides (m : Z) (r : ratio) : bool := (0 <? den r) && (den r * (m / den r) =? m).
Definition fits (m : Z) (p : point) : bool := divides m (qx p) && divides m (qy p) && divides m (qz p).

(* m: a common denominator of all coordinates *)
Definition with_integers (m : Z) (A B : list point) (c : claim) : certificate :=
  Certificate m (each (integral m) A) (each (integral m) B) c.

Fixpoint same_vectors (A B : list zvec) : bool :=
  match A, B with
  | [], [] => true
  | u :: A', v :: B' => if same_vector u v then same_vectors A' B' else false
  | _, _ => false
  end.

Definition count {T : Type} (l : list T) : Z := fold_left (fun n _ => n + 1) l 0.

Definition stated (c : claim) : statement :=
  match c with
  | Depth qn qd complete dirs _ => Depth_is (Ratio qn qd) (if complete then Some (count dirs) else None)
  | Bounds ln ld hn hd _ _ => Depth_between (Ratio ln ld) (Ratio hn hd)
  | Touching _ _ _ _ => They_touch
  | Disjoint _ => They_are_apart
  end.

(* of a width, B must be A again *)
Definition verdict (width : bool) (m : Z) (A B : list point) (c : claim) : option statement :=
  let C := with_integers m A B c in
  if forallb (fits m) A && forallb (fits m) B && (negb width || same_vectors (body_a C) (body_b C)) && check C
  then Some (stated c) else None.
