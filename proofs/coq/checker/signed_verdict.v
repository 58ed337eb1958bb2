(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Format 2: from the bodies as they stand in the file to the statement that is printed. *)
Require Import List ZArith Bool.
From Fathom Require Import printed.
From Fathom.checker Require Import vector sequence support certificate verdict body cone signed.
Import ListNotations.
Open Scope Z_scope.

(* { x : <n,x> <= d } in units of 1/m: with m n for n, the offset is m (m d) *)
Definition in_units (m : Z) (b : body point ratio) : zbody := map_body (integral m) (fun d => units m d * m) (units m) b.

Fixpoint same_atoms (t u : list (atom zvec)) : bool :=
  match t, u with
  | [], [] => true
  | a :: t', b :: u' =>
      if same_vector (center a) (center b) && same_vector (axis_u a) (axis_u b) && same_vector (axis_v a) (axis_v b)
         && same_vector (axis_w a) (axis_w b)
      then same_atoms t' u' else false
  | _, _ => false
  end.
Fixpoint same_terms (ts us : list (list (atom zvec))) : bool :=
  match ts, us with
  | [], [] => true
  | t :: ts', u :: us' => if same_atoms t u then same_terms ts' us' else false
  | _, _ => false
  end.
Definition same_body (A B : zbody) : bool :=
  (radius A =? radius B)
  && match core_of A, core_of B with
     | Points K, Points L => same_vectors K L
     | Terms ts, Terms us => same_terms ts us
     | _, _ => false
     end.

(* the sign of the signed root of s plus rho *)
Definition status_of_root (s rho : ratio) : status :=
  match signed_square (num rho) * den s ?= - num s * (den rho * den rho) with
  | Gt => Penetrating
  | Eq => In_touch
  | Lt => Disjoint_bodies
  end.
Definition status_between (lo hi : ratio) : status :=
  if 0 <? num lo then Penetrating
  else if num hi <? 0 then Disjoint_bodies
  else if (num lo =? 0) && (num hi =? 0) then In_touch else Undecided.

Definition signed_stated (rho : ratio) (c : signed_claim) : signed_statement :=
  let root s := Root_is (status_of_root s rho) s rho in
  match c with
  | Deep qn qd complete dirs _ => root (Ratio qn qd) (if complete then Some (count dirs) else None) None
  | Beside qn qd _ _ _ _ all =>
      root (Ratio (- qn) qd) None match all with Some k => Some (count (lineality k), count (rays k)) | None => None end
  | On_plane qn qd _ => root (Ratio qn qd) None None
  | Between ln ld hn hd _ _ _ _ => Root_between (status_between (Ratio ln ld) (Ratio hn hd)) (Ratio ln ld) (Ratio hn hd)
  end.

(* rho: what the radii are said to add up to; m: a common denominator of all lengths; of a width, B must be A again *)
Definition signed_verdict (width : bool) (m : Z) (rho : ratio) (A B : body point ratio) (c : signed_claim) : option signed_statement :=
  let ZA := in_units m A in
  let ZB := in_units m B in
  if all_body (fits m) (divides m) A && all_body (fits m) (divides m) B
     && (0 <? den rho) && ((radius ZA + radius ZB) * den rho =? num rho * m)
     && (negb width || same_body ZA ZB) && signed_check m ZA ZB c
  then Some (signed_stated rho c) else None.
