(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Two unit cubes that overlap by 1/10: a certificate checked inside Coq, and the closed theorem that follows; and forgeries. *)
Require Import Reals Lra List ZArith NArith.
From Fathom.checker Require Import vector certificate verdict.
From Fathom.geometry Require Import meaning.
From Fathom.soundness Require Import statement main.
Import ListNotations.
Open Scope Z_scope.

Definition A := [Zvec 0 0 0; Zvec 10 0 0; Zvec 0 10 0; Zvec 10 10 0; Zvec 0 0 10; Zvec 10 0 10; Zvec 0 10 10; Zvec 10 10 10].
Definition B := [Zvec 9 0 0; Zvec 19 0 0; Zvec 9 10 0; Zvec 19 10 0; Zvec 9 0 10; Zvec 19 0 10; Zvec 9 10 10; Zvec 19 10 10].
(* the inner polytope is all of P here: a box *)
Definition box := Inner
  [(0, 7); (1, 6); (2, 5); (3, 4); (4, 3); (5, 2); (6, 1); (7, 0)]%N
  [[(1, 5); (3, 2); (7, 4); (5, 3)];
     [(0, 3); (4, 4); (6, 2); (2, 5)];
     [(2, 1); (6, 4); (7, 0); (3, 5)];
     [(0, 5); (1, 0); (5, 4); (4, 1)];
     [(4, 3); (5, 0); (7, 2); (6, 1)];
     [(0, 1); (2, 2); (3, 0); (1, 3)]]%N (fun _ => 0%N).
Definition left := (Zvec (-1) 0 0, Zvec (-1) 0 0).

Definition cubes := Certificate 10 A B (Depth 1 100 true [left] box).

Theorem cubes_depth : depth2_is (map (frac 10) A) (map (frac 10) B) (1 / 100).
Proof. assert (H : check cubes = true) by (vm_compute; reflexivity). apply check_sound in H. apply H. Qed.

(* the line that the program prints of it: a wrong common denominator, or a width that it is not, has none *)
Definition tenths (v : zvec) := let r n := Ratio n 10 in Point (r (zx v)) (r (zy v)) (r (zz v)).
Theorem cubes_verdict : map (fun wm => verdict (fst wm) (snd wm) (map tenths A) (map tenths B) (claimed cubes))
  [(false, 10); (false, 20); (false, 15); (false, 0); (false, -10); (true, 10)]
  = let yes := Some (Depth_is (Ratio 1 100) (Some 1)) in [yes; yes; None; None; None; None].
Proof. vm_compute. reflexivity. Qed.

(* nothing is proved by a direction that is zero, by a claim of a little more or less, or by a facet the wrong way round *)
Definition zero := (Zvec 0 0 0, Zvec 0 0 0).
Definition turned := Inner (vertices box) (map (@rev _) (facets box)) (find box).
Theorem forgeries_refused : map check
  [Certificate 10 A B (Depth 1 100 false [zero] box); Certificate 10 A B (Touching zzero 1 [(0%N, 1)] [(0%N, 1)]);
   Certificate 10 A B (Depth 1 99 false [left] box); Certificate 10 A B (Depth 1 101 false [left] box);
   Certificate 10 A B (Depth 1 100 false [left] turned); Certificate 10 A B (Depth 1 100 false [] box);
   Certificate 0 A B (Depth 1 100 false [left] box); Certificate 10 A [] (Disjoint (Zvec 1 0 0))]
  = repeat false 8.
Proof. vm_compute. reflexivity. Qed.
