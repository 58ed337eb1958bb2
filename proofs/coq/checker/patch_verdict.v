(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Format 4: format 2 with patches, and the rates at which the depth changes. *)
Require Import List ZArith Bool.
From Fathom Require Import printed.
From Fathom.checker Require Import vector sequence table verdict body signed signed_verdict patch.
Import ListNotations.
Open Scope Z_scope.

Record patched_claim := Patched { base : signed_claim; patches : list patch; rates : list rate }.

(* the square of the cores' depth, its directions, and whether these are all *)
Definition directions_of (c : signed_claim) : option (Z * Z * list zvec * bool) :=
  match c with
  | Deep qn qd complete dirs _ => Some (qn, qd, each fst dirs, complete)
  | Beside qn qd n _ _ _ _ => Some (- qn, qd, [n], 0 <? qn)
  | On_plane qn qd n => Some (qn, qd, [n], true)
  | Between _ _ _ _ _ _ _ _ => None
  end.

Definition contacts := list (zvec * list quotient).

(* one patch for each direction; done: those before, the last one first *)
Fixpoint check_patches (check : zvec -> patch -> option (list quotient)) (ns : list zvec) (ps : list patch)
  (done : contacts) : option contacts :=
  match ns, ps with
  | [], [] => Some (rev_append done [])
  | n :: ns', p :: ps' =>
      match check n p with Some ends => check_patches check ns' ps' ((n, ends) :: done) | None => None end
  | _, _ => None
  end.

(* the speed at x/(m k) along n, times e m k |n| *)
Definition zspeed (m : Z) (v w n : zvec) (p : quotient) : Z := - (zdot n v * (m * snd p) + zdet n w (fst p)).

(* the least over the directions of the greatest speed, against the root of the square *)
Definition rate_against (test : Z -> Z -> bool) (m : Z) (r : rate) (v w n : zvec) (p : quotient) : bool :=
  let unit := rate_unit r * m * snd p in
  test (signed_square (zspeed m v w n p) * den (rate_square r)) (num (rate_square r) * (unit * unit) * zdot n n).
Definition check_rate (m : Z) (cs : contacts) (r : rate) : bool :=
  let v := integral (rate_unit r) (rate_v r) in
  let w := integral (rate_unit r) (rate_w r) in
  (0 <? rate_unit r) && (0 <? den (rate_square r)) && fits (rate_unit r) (rate_v r) && fits (rate_unit r) (rate_w r)
  && forallb (fun c => existsb (rate_against Z.geb m r v w (fst c)) (snd c)) cs
  && existsb (fun c => forallb (rate_against Z.leb m r v w (fst c)) (snd c)) cs.

Definition file_point (m : Z) (p : quotient) : point :=
  let r x := Ratio x (m * snd p) in Point (r (zx (fst p))) (r (zy (fst p))) (r (zz (fst p))).

Definition integer_point (n : zvec) : point :=
  let r x := Ratio x 1 in Point (r (zx n)) (r (zy n)) (r (zz n)).

Definition patched_verdict (width : bool) (m : Z) (rho : ratio) (A B : body point ratio) (c : patched_claim)
  : option patched_statement :=
  match signed_verdict width m rho A B (base c), directions_of (base c) with
  | Some s, Some (qn, qd, ns, all) =>
      let a := core_of (in_units m A) in
      let b := core_of (in_units m B) in
      let check := check_patch a b (numbered (spots a)) (numbered (spots b)) (qn * (m * m)) qd in
      match check_patches check ns (patches c) [] with
      | Some cs =>
          if match rates c with [] => true | _ => all && forallb (check_rate m cs) (rates c) end
          then Some (Patched_statement s all (each (fun c => (integer_point (fst c), each (file_point m) (snd c))) cs)
            (rates c))
          else None
      | None => None
      end
  | _, _ => None
  end.
