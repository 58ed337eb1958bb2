(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A cube in two pieces and another cube: a certificate of format 3 checked inside Coq, and the closed theorem that follows; and
   forgeries. *)
Require Import Reals Lra List ZArith NArith.
From Fathom.checker Require Import vector verdict unions union_verdict.
From Fathom.geometry Require Import meaning unions.
From Fathom.soundness Require Import statement union_statement union_sound.
Import ListNotations.
Open Scope Z_scope.

Definition block (x y z x' y' z' : Z) :=
  [Zvec x y z; Zvec x' y z; Zvec x y' z; Zvec x' y' z; Zvec x y z'; Zvec x' y z'; Zvec x y' z'; Zvec x' y' z'].
(* in halves: [0,1]^3, which is cut at x = 1/2, and [1/2,3/2] x [0,1] x [0,1] *)
Definition As := [block 0 0 0 1 2 2; block 1 0 0 2 2 2].
Definition Bs := [block 1 0 0 3 2 2].
(* all of P_i0: a box *)
Definition all_of (i : N) := Polytope i 0
  [(0, 7); (1, 6); (2, 5); (3, 4); (4, 3); (5, 2); (6, 1); (7, 0)]%N
  [[(1, 5); (3, 2); (7, 4); (5, 3)]; [(0, 3); (4, 4); (6, 2); (2, 5)]; [(2, 1); (6, 4); (7, 0); (3, 5)];
   [(0, 5); (1, 0); (5, 4); (4, 1)]; [(4, 3); (5, 0); (7, 2); (6, 1)]; [(0, 1); (2, 2); (3, 0); (1, 3)]]%N.
(* O is on the plane x = 0 of P_00; beyond it P_10 has the one near facet *)
Definition seam_of n qn qd optima tree :=
  Union_deep qn qd 1 (map (fun t => (t, repeat (Zvec (-1) 0 0) n)) optima) (fun _ => 0%N) [all_of 0; all_of 1] tree (map (fun _ => 1)).
Definition seam := seam_of 2.
Definition way := Zvec (-1) 0 0.
Definition nodes := [Split 0 [1%N]; Split 1 [1%N]; Leaf [1%N]].

Theorem seam_depth : union_depth2_is (map (map (frac 2)) As) (map (map (frac 2)) Bs) (1 / 4).
Proof.
  assert (H : union_check 2 As Bs (seam 1 4 [way] nodes) = true) by (vm_compute; reflexivity). apply union_check_sound in H. apply H.
Qed.

(* a wrong common denominator has no line; nor has a longer way, an optimum too many, a tree too short, too long or too near, a flat
   piece *)
Definition halves (v : zvec) := let r n := Ratio n 2 in Point (r (zx v)) (r (zy v)) (r (zz v)).
Theorem seam_verdict : map (fun m => union_verdict m (map (map halves) As) (map (map halves) Bs) (seam 1 4 [way] nodes)) [2; 3; 4; 0; -2]
  = [Some (Union_statement 2 1 (Depth_is (Ratio 1 4) (Some 1))); None; None; None; None].
Proof. vm_compute. reflexivity. Qed.
Theorem unions_refused : map (union_check 2 As Bs)
  [seam 1 5 [way] nodes; seam 1 3 [way] nodes; seam 1 4 [] nodes; seam 1 4 [way; way] nodes; seam 1 4 [way; Zvec 0 1 0] nodes;
   seam 1 4 [way] [Split 0 [1%N]; Split 1 [1%N]]; seam 1 4 [way] (nodes ++ [Leaf [1%N]]); seam 1 4 [way] [Split 0 []];
   seam 1 4 [way] [Split 0 [1%N]; Leaf [0%N]]; seam 1 4 [way] [Split 0 [2%N]; Leaf [0%N]]; seam 1 4 [way] []] = repeat false 11
  /\ map (fun L => union_check 2 (As ++ [L]) Bs (seam_of 3 1 4 [way] nodes)) [block 1 0 0 2 1 1; block 1 0 0 1 1 1] = [true; false].
Proof. split; vm_compute; reflexivity. Qed.
