(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What a line printed for a certificate of format 5 says about the points as they stand in the file.  Definitions only: to be read and
   believed, with geometry/unions.v and geometry/meshes.v. *)
Require Import Reals List ZArith.
From Fathom.checker Require Import verdict tiling.
From Fathom.geometry Require Import meaning unions meshes.
From Fathom.soundness Require Import printed.
Open Scope R_scope.

(* the point of that number, from 0; what names no point is refused *)
Definition place (points : list point) (i : N) : pt := nth (N.to_nat i) (map real points) origin.
Definition real_triangle (points : list point) (ijk : numbers_of_triangle) : triangle :=
  Triangle (place points (fst (fst ijk))) (place points (snd (fst ijk))) (place points (snd ijk)).
Definition real_tile (points : list point) (q : tile) : list pt := map (place points) (tile_corners q).

Definition says_tiling (points : list point) (mesh : list numbers_of_triangle) (tiles : list tile) (s : tiling_statement) : Prop :=
  let Ps := map (real_tile points) tiles in
  tiled (map (real_triangle points) mesh) Ps /\ solid_pieces Ps
  /\ Z.of_nat (length mesh) = triangles_told s /\ Z.of_nat (length tiles) = pieces_told s.
