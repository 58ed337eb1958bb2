(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The upper side: how far P reaches in a direction; and common points of the two bodies. *)
Require Import List ZArith Bool.
From Fathom.checker Require Import vector sequence table.
Import ListNotations.
Open Scope Z_scope.

Definition greatest (n : zvec) (l : list zvec) : option Z :=
  match l with
  | [] => None
  | p :: r => Some (fold_left (fun m v => Z.max m (zdot n v)) r (zdot n p))
  end.

(* h(n) = max <n,b> - min <n,a> *)
Definition height (A B : list zvec) (n : zvec) : option Z :=
  match greatest n B, greatest (zneg n) A with
  | Some x, Some y => Some (x + y)
  | _, _ => None
  end.

Definition height_is (test : Z -> bool) (A B : list zvec) (n : zvec) : bool :=
  match height A B n with Some h => test h | None => false end.

(* h(n) > 0 and h(n)^2 = q <n,n>;   h(n)^2 <= q <n,n>;   for q = qn/qd *)
Definition tangent (A B : list zvec) (qn qd : Z) (n : zvec) : bool :=
  height_is (fun h => (0 <? h) && (h * h * qd =? qn * zdot n n)) A B n.
Definition within (A B : list zvec) (qn qd : Z) (n : zvec) : bool :=
  height_is (fun h => (0 <? h) && (h * h * qd <=? qn * zdot n n)) A B n.

(* weights (number of a point, weight), all positive: their sum, and the weighted sum of the points *)
Definition weighed (L : table zvec) (W : list (N * Z)) : option (Z * zvec) :=
  fold_left (fun acc iw =>
      match acc, member L (fst iw) with
      | Some (s, x), Some p => if 0 <? snd iw then Some (s + snd iw, zadd x (zscal (snd iw) p)) else None
      | _, _ => None
      end) W (Some (0, zzero)).

(* the weights of either body sum to unit, and the weighted means are the same point *)
Definition common_point (A B : list zvec) (unit : Z) (WA WB : list (N * Z)) : bool :=
  match weighed (numbered A) WA, weighed (numbered B) WB with
  | Some (s, x), Some (t, y) => (0 <? unit) && (s =? unit) && (t =? unit) && same_vector x y
  | _, _ => false
  end.
