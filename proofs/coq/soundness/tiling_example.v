(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The example of FORMAT.md, section 14: a tetrahedron cut in two, checked inside Coq, and the closed theorem that follows; and forgeries. *)
Require Import Reals List ZArith NArith.
From Fathom.checker Require Import vector verdict tiling.
From Fathom.geometry Require Import meaning meshes.
From Fathom.soundness Require Import tiling_sound.
Import ListNotations.
Open Scope Z_scope.

Definition whole (x y z : Z) := Point (Ratio x 1) (Ratio y 1) (Ratio z 1).
Definition corners := [whole 0 0 0; whole 0 0 2; whole 0 2 0; whole 1 1 0; whole 2 0 0].
Definition mesh : list numbers_of_triangle := [(0, 2, 4); (0, 4, 1); (0, 1, 2); (1, 4, 2)]%N.

(* hints: the facet across an edge, of a tetrahedron; a number for each flag, if its vectors are short *)
Definition sides : list (list (N * N)) := [[(0, 1); (1, 3); (2, 2)]; [(0, 2); (3, 3); (1, 0)]; [(0, 0); (2, 3); (3, 1)];
  [(1, 1); (3, 2); (2, 0)]]%N.
Definition axis (v : zvec) :=
  let g := Z.gcd (Z.gcd (zx v) (zy v)) (zz v) in
  let u := Zvec (zx v / g) (zy v / g) (zz v / g) in if before u zzero then zneg u else u.
Definition code (v : zvec) := let u := axis v in zx u + 8 + 16 * (zy u + 8 + 16 * (zz u + 8)).
Definition slot (n d : zvec) (i : N) := Z.to_pos (1 + code n + 4096 * (code d + 4096 * Z.of_N i)).

Definition judged := tiling_verdict (fun _ => 1) slot.
Definition halves := [Tile [0; 1; 2; 3] sides; Tile [0; 1; 3; 4] sides]%N.

Theorem halves_tile :
  says_tiling (map (real_triangle corners) mesh) (map (real_tile corners) halves) (Tiling_statement 4 2).
Proof. apply (tiling_verdict_sound (fun _ => 1) slot). vm_compute. reflexivity. Qed.

(* a piece left out, twice, or turned; a triangle left out, turned, or of no point; a point moved; all of it left out; and without hints *)
Theorem tilings_refused :
  [judged corners mesh [Tile [0; 1; 2; 3] sides]%N; judged corners mesh (Tile [0; 1; 2; 3] sides :: halves)%N;
   judged corners mesh [Tile [0; 1; 2; 3] sides; Tile [1; 0; 3; 4] sides]%N; judged corners (tl mesh) halves;
   judged corners ((0, 4, 2) :: tl mesh)%N halves; judged corners ((0, 2, 5) :: tl mesh)%N halves;
   judged [whole 0 0 0; whole 0 0 2; whole 0 2 0; whole 1 1 1; whole 2 0 0] mesh halves; judged corners [] [];
   tiling_verdict (fun _ => 0) slot corners mesh halves; tiling_verdict (fun _ => 1) (fun _ _ _ => 1%positive) corners mesh halves]
  = repeat None 10.
Proof. vm_compute. reflexivity. Qed.

(* a triangle without an area is not looked at, and a common denominator may be any *)
Theorem tilings_accepted :
  [judged corners ((2, 3, 4) :: mesh)%N halves; tiling_verdict (fun _ => 6) slot corners mesh halves]
  = [Some (Tiling_statement 5 2); Some (Tiling_statement 4 2)].
Proof. vm_compute. reflexivity. Qed.
