(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The cubes of example.v, now with the square on which they touch when they are just parted: a
   certificate of format 4 checked inside Coq, and the closed theorem that follows; and forgeries.
   *)
Require Import Reals Lra List ZArith NArith.
From Fathom.checker Require Import vector table verdict body signed signed_verdict patch patch_verdict.
From Fathom.geometry Require Import meaning bodies space norm contact.
From Fathom.soundness Require Import statement example patch_sound.
Import ListNotations.
Open Scope Z_scope.

Definition corner i j by_ := Corner 1 [(i, 1)] [(j, 1)] by_.
Definition side_at b x y z k := Side b (Zvec x y z) k.
Arguments side_at b (x y z)%Z k%N.
Definition square_corners := [corner 1 0 3; corner 5 4 0; corner 7 6 1; corner 3 2 2]%N.
Definition square_sides := [side_at false 0 1 0 1; side_at true 0 0 (-1) 2; side_at false 0 (-1) 0 3; side_at true 0 0
  1 0].
Definition square := Patch square_corners square_sides [0; 1; 3; 2]%N.
Definition patch_with n := check_patch (Points A) (Points B) (numbered A) (numbered B) 1 1 n.
Definition there := [Zvec 10 0 0; Zvec 10 0 10; Zvec 10 10 10; Zvec 10 10 0].

(* in tenths *)
Theorem cubes_patch : cornered (meeting (conv (map inj A)) (conv (map inj B)) (mk (-1) 0 0)) (map inj there).
Proof.
  assert (H : patch_with (fst left) square = Some (map (fun p => (p, 1)) there)) by (vm_compute; reflexivity).
  apply (check_patch_sound (Points A) (Points B)) in H; [|reflexivity]. destruct H as (_ & _ & _ & C).
  assert (N : norm (inj (fst left)) = 1%R) by (apply norm_unique; [lra|unfold norm2, dot; simpl; ring]).
  assert (S : signed_root (1 / 1) = 1%R) by (apply signed_sqr_inj; rewrite signed_sqr_root, signed_sqr_pos; lra).
  unfold along in C. rewrite S, N in C.
  replace (scal (1 / 1) (inj (fst left))) with (mk (-1) 0 0) in C by (pteq; lra).
  replace (map at_quotient (map (fun p => (p, 1)) there)) with (map inj there) in C; [exact C|].
  rewrite map_map. apply map_ext. intros p. unfold at_quotient. cbn [fst snd]. rewrite Rinv_1, scal_1. auto.
Qed.

(* the statement: the depth grows at the rate 1 as A moves along x, and at none as it turns about z;
   a wrong rate has none *)
Definition cube L : body point ratio := Body (Points (map tenths L)) (Ratio 0 1).
Definition along_x := Point (Ratio 1 1) (Ratio 0 1) (Ratio 0 1).
Definition along_z := Point (Ratio 0 1) (Ratio 0 1) (Ratio 1 1).
Definition at_rest := Point (Ratio 0 1) (Ratio 0 1) (Ratio 0 1).
Definition cubes_with complete ps rs := patched_verdict false 10 (Ratio 0 1) (cube A) (cube B) (Patched (Deep 1 100
  complete [left] box) ps rs).
Theorem cubes_rates : let rates := [Rate along_x at_rest (Ratio 1 1) 1; Rate at_rest along_z (Ratio 0 1) 1] in
  cubes_with true [square] rates = Some (Patched_statement (Root_is Penetrating (Ratio 1 100) (Ratio 0 1) (Some 1)
    None) true
    [(integer_point (fst left), map tenths there)] rates)
  /\ map (fun r => cubes_with true [square] [r]) [Rate along_x at_rest (Ratio 2 1) 1; Rate along_x at_rest (Ratio (-1)
    1) 1;
       Rate at_rest along_z (Ratio 1 1) 1; Rate along_x at_rest (Ratio 1 1) 0; Rate along_x at_rest (Ratio 1 0) 1] =
         repeat None 5
  /\ map (fun p => cubes_with (fst p) (snd p) [Rate along_x at_rest (Ratio 1 1) 1])
       [(false, [square]); (true, []); (true, [square; square])] = repeat None 3.
Proof. vm_compute. split; [|split]; reflexivity. Qed.

(* a triangle of it, a corner more, or one twice; no corners, no sides; a corner's point elsewhere,
   its ends apart; a side that is zero, not orthogonal, turned round, of another corner, not as low
   as the face, or that does not turn; a wrong direction *)
Definition with_sides l := Patch square_corners l [0; 1; 3; 2]%N.
Definition with_first c := Patch (c :: tl square_corners) square_sides [0; 1; 3; 2]%N.
Theorem patch_forgeries_refused : map (patch_with (fst left))
  [Patch [corner 1 0 2; corner 5 4 0; corner 7 6 1]%N [side_at false 0 1 0 1; side_at true 0 0 (-1) 2; side_at true 0
    (-1) 1 0]
     [0; 1; 2]%N;
   Patch (square_corners ++ [Corner 2 [(1%N, 1); (7%N, 1)] [(0%N, 1); (6%N, 1)] 0]) square_sides [0; 1; 4; 3; 2]%N;
   Patch (square_corners ++ [corner 1 0 3]) square_sides [0; 1; 3; 2]%N;
   Patch (square_corners ++ [corner 1 0 3]) square_sides [0; 4; 1; 3; 2]%N;
   Patch [] [] []; with_sides []; with_first (Corner 2 [(1%N, 1)] [(0%N, 1)] 3); with_first (Corner 0 [] [] 3);
     with_first (corner 0 0 3);
   with_first (corner 1 1 3); with_first (Corner 1 [(1%N, 2); (3%N, -1)] [(0%N, 2); (2%N, -1)] 3); with_first (corner 1
     0 4);
   with_sides (side_at false 0 0 0 1 :: tl square_sides); with_sides (side_at false 1 1 0 1 :: tl square_sides);
   with_sides (side_at false 0 (-1) 0 1 :: tl square_sides); with_sides (side_at false 0 1 0 2 :: tl square_sides);
   with_sides (side_at false 0 2 1 1 :: tl square_sides); with_sides (rev square_sides)] = repeat None 18
  /\ map (fun n => patch_with n square) [zzero; Zvec 1 0 0; Zvec (-1) 0 1] = repeat None 3.
Proof. split; vm_compute; reflexivity. Qed.
