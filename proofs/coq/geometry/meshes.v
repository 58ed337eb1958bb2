(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The winding number of a mesh as a sum of signs of determinants, and its solid. That this is what
   printed.v says is shown in mesh_said.v. Definitions only. *)
Require Import Reals List ZArith.
From Fathom.geometry Require Import meaning unions.
Import ListNotations.
Open Scope R_scope.

(* 1 if x > 0, else 0 *)
Definition unit_step (x : R) : Z := if Rlt_dec 0 x then 1%Z else 0%Z.

(* where the line through x along v has the three edges of T; all signs are the same exactly if it goes through T *)
Definition beside (x v p q : pt) : R := dot v (cross (sub p x) (sub q x)).
Definition passes (x v : pt) (T : triangle) : Z :=
  let a := beside x v (corner_1 T) (corner_2 T) in
  let b := beside x v (corner_2 T) (corner_3 T) in
  let c := beside x v (corner_3 T) (corner_1 T) in
  (unit_step a * unit_step b * unit_step c - unit_step (- a) * unit_step (- b) * unit_step (- c))%Z.
(* whether it meets the plane of T at x + s v with s > 0 *)
Definition ahead (x v n p : pt) : Z := unit_step (dot n (sub p x) * dot n v).
(* 1 if the ray leaves through the front of T, -1 if it enters there, 0 if it misses T (crossing_means in crossings.v) *)
Definition crossing (x v : pt) (T : triangle) : Z := (ahead x v (front T) (corner_1 T) * passes x v T)%Z.

(* x is on no plane of a triangle, and the line through x along v neither meets nor is parallel to a line of an edge; triangles without an
   area do not count *)
Definition clear (x v : pt) (T : triangle) : Prop :=
  beside x v (corner_1 T) (corner_2 T) <> 0 /\ beside x v (corner_2 T) (corner_3 T) <> 0
  /\ beside x v (corner_3 T) (corner_1 T) <> 0 /\ dot (front T) (sub (corner_1 T) x) <> 0.
Definition general (M : list triangle) (x v : pt) : Prop := forall T, In T M -> front T = origin \/ clear x v T.

Definition total {T : Type} (f : T -> Z) (l : list T) : Z := fold_right (fun t n => (f t + n)%Z) 0%Z l.
Definition winding (M : list triangle) (x v : pt) : Z := total (crossing x v) M.

(* the mesh is closed: the winding number is one of the point alone; and negative nowhere *)
Definition closed_mesh (M : list triangle) : Prop :=
  forall x v w, general M x v -> general M x w -> winding M x v = winding M x w.
Definition outward (M : list triangle) : Prop := forall x v, general M x v -> (0 <= winding M x v)%Z.
(* the closure of the points with a positive winding number *)
Definition solid_of (M : list triangle) (p : pt) : Prop :=
  forall e, 0 < e -> exists x v, norm2 (sub x p) < e * e /\ general M x v /\ (0 < winding M x v)%Z.

(* n of these hulls hold x *)
Fixpoint held_by (Ls : list (list pt)) (x : pt) (n : Z) : Prop :=
  match Ls with
  | [] => n = 0%Z
  | L :: Ls' => conv L x /\ held_by Ls' x (n - 1) \/ ~ conv L x /\ held_by Ls' x n
  end.

(* the convex pieces are the mesh's solid; off their boundaries the winding number is the number of pieces that hold the point *)
Definition tiled (M : list triangle) (Ps : list (list pt)) : Prop :=
  closed_mesh M /\ outward M
  /\ (forall x v, general M x v -> (forall L, In L Ps -> conv L x -> interior (conv L) x) -> held_by Ps x (winding M x v))
  /\ forall p, solid_of M p <-> union Ps p.
