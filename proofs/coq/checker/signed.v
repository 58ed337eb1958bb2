(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The checker of format 2: signed depths of round and curved bodies.  Integers and lists only. *)
Require Import List ZArith Bool.
From Fathom Require Import printed.
From Fathom.checker Require Import vector sequence table polytope support certificate body cone.
Import ListNotations.
Open Scope Z_scope.

(* In units of 1/scale; of a half-space { x : <n,x> <= d } d is in units of 1/scale too, if n is an integer vector. *)
Definition zcore := core zvec Z.
Definition zbody := body zvec Z.

(* x |x|: the order of these squares is that of the numbers *)
Definition signed_square (x : Z) : Z := x * Z.abs x.

(* ---- how far a core reaches ---- *)
(* the height h/unit is at least that of the atom in direction s *)
Definition tall (s : zvec) (unit h : Z) (a : atom zvec) : bool :=
  let g := h - unit * zdot s (center a) in
  let u := zdot s (axis_u a) in let v := zdot s (axis_v a) in let w := zdot s (axis_w a) in
  (0 <=? g) && (unit * unit * (u * u + v * v + w * w) <=? g * g).
Fixpoint all_tall (s : zvec) (unit : Z) (ts : list (list (atom zvec))) (hs : list Z) : bool :=
  match ts, hs with
  | [], [] => true
  | t :: ts', h :: hs' =>
      if match t with [] => false | _ => forallb (tall s unit h) t end then all_tall s unit ts' hs' else false
  | _, _ => false
  end.

(* <s,x> is at most this fraction on the core; the heights, in units of 1/unit, are those of a shape's terms *)
Definition reach (s : zvec) (c : zcore) (unit : Z) (hs : list Z) : option (Z * Z) :=
  match c with
  | Points L => match greatest s L with Some h => Some (h, 1) | None => None end
  | Terms [] => None
  | Terms ts => if (0 <? unit) && all_tall s unit ts hs then Some (fold_left Z.add hs 0, unit) else None
  | Half_space n d => if same_sense n s then Some (zdot n s * d, zdot n n) else None
  end.

Record heights := Heights { height_unit : Z; heights_a : list Z; heights_b : list Z }.

Definition sum_of_fractions (p q : option (Z * Z)) : option (Z * Z) :=
  match p, q with Some (x, d), Some (y, e) => Some (x * e + y * d, d * e) | _, _ => None end.
Definition outer_height (A B : zcore) (H : heights) (n : zvec) : option (Z * Z) :=
  sum_of_fractions (reach n B (height_unit H) (heights_b H)) (reach (zneg n) A (height_unit H) (heights_a H)).

(* H^[2] = q <n,n>, and H^[2] <= (x/y)^[2] <n,n> *)
Definition height_root (A B : zcore) (qn qd : Z) (n : zvec) : bool :=
  match outer_height A B (Heights 1 [] []) n with
  | Some (h, d) => negb (is_zero n) && (signed_square h * qd =? qn * (d * d) * zdot n n)
  | None => false
  end.
Definition height_within (A B : zcore) (H : heights) (x y : Z) (n : zvec) : bool :=
  match outer_height A B H n with
  | Some (h, d) => negb (is_zero n) && (signed_square h * (y * y) <=? signed_square x * (d * d) * zdot n n)
  | None => false
  end.

(* ---- points in a core ---- *)
(* of each term the number of an atom, and the point's parameters in units of 1/unit *)
Definition inner_point := list (N * zvec).
Record inner_points := Inner_points { parameter_unit : Z; inner_a : list inner_point; inner_b : list inner_point }.

(* in units of 1/unit of those of the atoms *)
Fixpoint place (unit : Z) (ts : list (table (atom zvec))) (l : inner_point) (p : zvec) : option zvec :=
  match ts, l with
  | [], [] => Some p
  | t :: ts', (i, y) :: l' =>
      match member t i with
      | Some a =>
          if zdot y y <=? unit * unit
          then place unit ts' l' (zadd p (zadd (zscal unit (center a))
            (zadd (zscal (zx y) (axis_u a)) (zadd (zscal (zy y) (axis_v a)) (zscal (zz y) (axis_w a))))))
          else None
      | None => None
      end
  | _, _ => None
  end.

Definition places (unit : Z) (ts : list (table (atom zvec))) (ls : list inner_point) : option (list zvec) :=
  every (fun l => place unit ts l zzero) ls.

Definition core_points (c : zcore) (unit : Z) (ls : list inner_point) : option (list zvec) :=
  match c with
  | Points L => Some (each (zscal unit) L)
  | Terms ts => places unit (each numbered ts) ls
  | Half_space _ _ => None
  end.

(* ---- the claims ---- *)
(* the lower side of an enclosure; of a half-space the core points are enough *)
Inductive lower :=
  | By_facets (q : inner)
  | By_mean (unit : Z) (weights_a weights_b : list (N * Z))
  | By_half_space.

Inductive signed_claim :=
  (* points that overlap: the depth of the cores is the root of qn/qd, and these are some of its directions; complete: all of them *)
  | Deep (qn qd : Z) (complete : bool) (directions : list direction) (q : inner)
  (* points that touch or are apart: the distance of the cores is the root of qn/qd; weights in units of 1/unit; if they touch, perhaps all
     vectors u with h(u) = 0 *)
  | Beside (qn qd : Z) (n : zvec) (unit : Z) (weights_a weights_b : list (N * Z)) (all : option zcone)
  (* a half-space and points: the signed depth of the cores is the signed root of qn/qd *)
  | On_plane (qn qd : Z) (n : zvec)
  (* ln/ld <= signed depth <= hn/hd *)
  | Between (ln ld hn hd : Z) (n : zvec) (outer : heights) (inside : inner_points) (proof : lower).

(* the weights of either body sum to unit, and the difference of the weighted sums passes the test *)
Definition mean_is (test : zvec -> bool) (A B : list zvec) (unit : Z) (WA WB : list (N * Z)) : bool :=
  match weighed (numbered A) WA, weighed (numbered B) WB with
  | Some (s, x), Some (t, y) => (0 <? unit) && (s =? unit) && (t =? unit) && test (zsub y x)
  | _, _ => false
  end.

Definition check_beside (A B : zcore) (qn qd : Z) (n : zvec) (unit : Z) (WA WB : list (N * Z)) (all : option zcone) : bool :=
  match A, B with
  | Points LA, Points LB =>
      (0 <=? qn) && (0 <? qd)
      && height_root A B (- qn) qd n
      && mean_is (fun z => zdot z z * qd =? qn * (unit * unit)) LA LB unit WA WB
      && match all with None => true | Some k => (qn =? 0) && cone_ok LA LB k end
  | _, _ => false
  end.

Definition check_on_plane (A B : zcore) (qn qd : Z) (n : zvec) : bool :=
  match A, B with Half_space _ _, Points _ => true | Points _, Half_space _ _ => true | _, _ => false end
  && (0 <? qd) && height_root A B qn qd n.

(* <s,x> of a half-space, or its greatest value of points in units of 1/unit: a fraction *)
Definition inner_reach (s : zvec) (c : zcore) (unit : Z) (points : option (list zvec)) : option (Z * Z) :=
  match c, points with
  | Half_space _ _, _ => reach s c 1 []
  | _, Some L => match greatest s L with Some h => Some (h, unit) | None => None end
  | _, None => None
  end.
Definition one_half_space (A B : zcore) : bool :=
  match A, B with
  | Half_space _ _, Half_space _ _ => false
  | Half_space _ _, _ => true
  | _, Half_space _ _ => true
  | _, _ => false
  end.

(* rho: the sum of the radii in units of 1/m *)
Definition check_between (m rho : Z) (A B : zcore) (ln ld hn hd : Z) (n : zvec) (outer : heights) (inside : inner_points) (proof :
  lower) : bool :=
  let lo := ln * m - rho * ld in
  let hi := hn * m - rho * hd in
  let k := parameter_unit inside in
  let points_a := core_points A k (inner_a inside) in
  let points_b := core_points B k (inner_b inside) in
  (0 <? ld) && (0 <? hd) && (ln * hd <=? hn * ld) && (0 <? k)
  && height_within A B outer hi hd n
  && match proof, points_a, points_b with
     | By_facets q, Some LA, Some LB =>
         let least := k * Z.max 0 lo in inner_ok (least * least) (ld * ld) (make_facets LA LB (vertices q) (facets q))
     | By_mean unit WA WB, Some LA, Some LB =>
         mean_is (fun z => zdot z z * (ld * ld) <=? signed_square (- lo) * (unit * k * (unit * k))) LA LB unit WA WB
     | By_half_space, _, _ =>
         one_half_space A B
         && match sum_of_fractions (inner_reach n B k points_b) (inner_reach (zneg n) A k points_a) with
            | Some (l, d) => signed_square lo * (d * d) * zdot n n <=? signed_square l * (ld * ld)
            | None => false
            end
     | _, _, _ => false
     end.

(* the bodies in units of 1/m; squared lengths are measured in these units *)
Definition signed_check (m : Z) (A B : zbody) (c : signed_claim) : bool :=
  (0 <? m) && (0 <=? radius A) && (0 <=? radius B)
  && match c with
     | Deep qn qd complete dirs q =>
         match core_of A, core_of B with Points LA, Points LB => check_depth LA LB (qn * (m * m)) qd complete dirs q | _, _ => false end
     | Beside qn qd n unit WA WB all => check_beside (core_of A) (core_of B) (qn * (m * m)) qd n unit WA WB all
     | On_plane qn qd n => check_on_plane (core_of A) (core_of B) (qn * (m * m)) qd n
     | Between ln ld hn hd n outer inside proof => check_between m (radius A + radius B) (core_of A) (core_of B) ln ld hn hd n outer
       inside proof
     end.
