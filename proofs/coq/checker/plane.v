(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Bodies of the plane: they are raised here, and what is proved of the raised ones is said of them, if no way out that leaves the plane
   is as short. *)
Require Import List ZArith Bool.
From Fathom Require Import printed.
From Fathom.checker Require Import sequence certificate verdict body signed signed_verdict unions union_verdict.
Import ListNotations.
Open Scope Z_scope.

(* z as it stands in the points does not count *)
Definition leveled (z : ratio) (p : point) : point := Point (qx p) (qy p) z.
Definition flat : list point -> list point := each (leveled (Ratio 0 1)).
Definition prism (h : ratio) (L : list point) : list point :=
  rev_append (rev_append (each (leveled (Ratio (- num h) (den h))) L) []) (each (leveled h) L).

(* h > 0, and q < h^2 *)
Definition is_height (h : ratio) : bool := (0 <? num h) && (0 <? den h).
Definition below (h q : ratio) : bool := (0 <? den q) && (num q * (den h * den h) <? num h * num h * den q).
Definition statement_below (h : ratio) (s : statement) : bool :=
  is_height h && match s with Depth_is q _ => below h q | Depth_between _ hi => below h hi | _ => true end.

Definition plane_verdict (m : Z) (h : ratio) (A B : list point) (c : claim) : option statement :=
  match verdict false m (flat A) (prism h B) c with
  | Some s => if statement_below h s then Some s else None
  | None => None
  end.

Definition plane_union_verdict (m : Z) (h : ratio) (As Bs : list (list point)) (c : union_claim) : option union_statement :=
  match union_verdict m (each (prism h) As) (each (prism h) Bs) c with
  | Some s => if statement_below h (union_says s) then Some s else None
  | None => None
  end.

(* curved cores are none of the plane, nor slanted half-spaces *)
Definition raised_body (f : list point -> list point) (b : body point ratio) : option (body point ratio) :=
  match core_of b with
  | Points L => Some (Body (Points (f L)) (radius b))
  | Half_space n d => if num (qz n) =? 0 then Some b else None
  | Terms _ => None
  end.
(* the roots are below h - rho *)
Definition signed_below (h : ratio) (s : signed_statement) : bool :=
  match s with
  | Root_between _ _ _ => false
  | Root_is _ square rho optima cone =>
      let left := Ratio (num h * den rho - num rho * den h) (den h * den rho) in
      is_height h && (0 <? den rho) && (0 <=? num rho) && is_height left && below left square
      && match optima with Some _ => 0 <? num square | None => true end
      && match cone with Some _ => num square =? 0 | None => true end
  end.

Definition plane_signed_verdict (m : Z) (rho h : ratio) (A B : body point ratio) (c : signed_claim) : option signed_statement :=
  match raised_body flat A, raised_body (prism h) B with
  | Some a, Some b =>
      match signed_verdict false m rho a b c with
      | Some s => if signed_below h s then Some s else None
      | None => None
      end
  | _, _ => None
  end.
