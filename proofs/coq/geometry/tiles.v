(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The facets of a convex polytope around O, cut into triangles: their winding number is 1 inside and 0 outside. *)
Require Import Reals Lra Psatz List ZArith Lia.
From Fathom.checker Require Import sequence.
From Fathom.geometry Require Import meaning space hulls faces flats facets difference meshes crossings.
Import ListNotations.
Open Scope R_scope.

(* a convex polygon in the plane <normal_of,x> = height_of *)
Record face := Face { normal_of : pt; height_of : R; first_of : pt; second_of : pt; others_of : list pt }.
Definition cycle (f : face) : list pt := first_of f :: second_of f :: others_of f.
(* the triangles from its first corner *)
Definition fan_of (f : face) : list triangle := map (fun e => Triangle (first_of f) (fst e) (snd e)) (pairs (second_of f) (others_of f)).
Definition fans (Fs : list face) : list triangle := concat (map fan_of Fs).
Definition under (Fs : list face) (x : pt) : Prop := below _ normal_of height_of Fs x.

Lemma under_dec : forall Fs x, under Fs x \/ exists f, In f Fs /\ height_of f < dot (normal_of f) x.
Proof.
  intros Fs x. induction Fs as [|f Fs IH]; [left; intros f []|]. destruct (Rle_dec (dot (normal_of f) x) (height_of f)) as [L|L].
  - destruct IH as [H|(g & Hg & H)]; [left; intros h [<-|Hh]; auto|right; exists g; simpl; auto].
  - right. exists f. simpl. split; auto. lra.
Qed.

(* two linear functions, each of one value at three points that span space *)
Lemma same_form : forall m h n c p u w z, det p u w <> 0 -> dot m p = h -> dot m u = h -> dot m w = h ->
  dot n p = c -> dot n u = c -> dot n w = c -> c * dot m z = h * dot n z.
Proof.
  intros m h n c p u w z D Mp Mu Mw Np Nu Nw. assert (E1 := cramer_dot m p u w z). assert (E2 := cramer_dot n p u w z).
  rewrite Mp, Mu, Mw in E1. rewrite Np, Nu, Nw in E2. apply Rmult_eq_reg_l with (det p u w); auto.
  replace (det p u w * (c * dot m z)) with (c * (det p u w * dot m z)) by ring.
  replace (det p u w * (h * dot n z)) with (h * (det p u w * dot n z)) by ring. rewrite E1, E2. ring.
Qed.
Lemma dot_ext : forall u v, (forall z, dot u z = dot v z) -> u = v.
Proof.
  intros u v H. assert (X := H (mk 1 0 0)). assert (Y := H (mk 0 1 0)). assert (Z := H (mk 0 0 1)).
  unfold dot in *; simpl in *. pteq; lra.
Qed.

(* the line the other way *)
Lemma beside_back : forall x v p q, beside x (scal (-1) v) p q = - beside x v p q.
Proof. intros. unfold beside, dot; simpl. ring. Qed.
Lemma passes_back : forall x v T, passes x (scal (-1) v) T = (- passes x v T)%Z.
Proof. intros x v T. unfold passes. cbv zeta. rewrite !beside_back, !Ropp_involutive. ring. Qed.
Lemma total_back : forall x v l, total (passes x (scal (-1) v)) l = (- total (passes x v) l)%Z.
Proof.
  intros x v l. induction l as [|T l IH]; [reflexivity|]. cbn [total fold_right]. unfold total in IH. rewrite IH, passes_back. lia.
Qed.

Lemma beside_along : forall x v s p q, beside (add x (scal s v)) v p q = beside x v p q.
Proof. intros. unfold beside, dot, cross; simpl. ring. Qed.
Lemma passes_along : forall x v s T, passes (add x (scal s v)) v T = passes x v T.
Proof. intros. unfold passes. cbv zeta. rewrite !beside_along. reflexivity. Qed.

(* a line in general position: it meets no edge of a triangle *)
Definition threads (x v : pt) (T : triangle) : Prop :=
  beside x v (corner_1 T) (corner_2 T) <> 0 /\ beside x v (corner_2 T) (corner_3 T) <> 0 /\ beside x v (corner_3 T) (corner_1 T) <> 0.
Lemma threads_back : forall x v T, threads x v T -> threads x (scal (-1) v) T.
Proof. intros x v T (A & B & C). unfold threads. rewrite !beside_back. repeat split; lra. Qed.

Lemma last_step : forall (T : Type) (l : list T) c d, last (d :: l) c = last l d.
Proof. intros T l. induction l as [|e l IH]; intros c d; [reflexivity|]. change (last (e :: l) c = last (e :: l) d). rewrite !IH.
reflexivity. Qed.

(* A convex polytope with O inside: the hull of Vs, and below all its facets. *)
Record convex_faces (Vs : list pt) (Fs : list face) : Prop := Convex_faces {
  faces_raised : forall f, In f Fs -> 0 < height_of f;
  faces_level : forall f p, In f Fs -> In p (cycle f) -> dot (normal_of f) p = height_of f;
  faces_listed : forall f p, In f Fs -> In p (cycle f) -> In p Vs;
  faces_support : forall p, In p Vs -> under Fs p;
  faces_strict : forall f u w, In f Fs -> In (u, w) (pairs (second_of f) (others_of f)) -> 0 < det (first_of f) u w;
  faces_proper : forall f, In f Fs -> others_of f <> [];
  faces_edges : forall f u w y, In f Fs -> In (u, w) (chain (first_of f) (second_of f :: others_of f) (first_of f)) ->
    under Fs y -> dot (normal_of f) y = height_of f -> 0 <= det u w y;
  faces_distinct : forall l f k, Fs = l ++ f :: k -> forall g s, In g (l ++ k) -> 0 < s -> normal_of g <> scal s (normal_of f);
  faces_filled : forall x, under Fs x -> conv Vs x }.

Section Piece.
  Variables (Vs : list pt) (Fs : list face).
  Hypothesis Hfaces : convex_faces Vs Fs.
  Let raised := faces_raised Vs Fs Hfaces.
  Let level := faces_level Vs Fs Hfaces.
  Let strict := faces_strict Vs Fs Hfaces.
  Let proper := faces_proper Vs Fs Hfaces.
  Let edges := faces_edges Vs Fs Hfaces.
  Let distinct := faces_distinct Vs Fs Hfaces.

  Lemma corner_under : forall f p, In f Fs -> In p (cycle f) -> under Fs p.
  Proof. intros f p Hf Hp. apply (faces_support Vs Fs Hfaces), (faces_listed Vs Fs Hfaces f); auto. Qed.

  (* where the line meets the plane of f *)
  Definition hit (x v : pt) (f : face) : pt := add x (scal (dot (normal_of f) (sub (first_of f) x) / dot (normal_of f) v) v).

  Lemma hit_level : forall x v f, In f Fs -> dot (normal_of f) v <> 0 -> dot (normal_of f) (hit x v f) = height_of f.
  Proof.
    intros x v f Hf Hv. unfold hit. rewrite dot_add_r, dot_scal_r, dot_sub_r, (level f (first_of f)) by (simpl; auto). field. auto.
  Qed.

  Lemma hit_back : forall x v f, dot (normal_of f) v <> 0 -> hit x (scal (-1) v) f = hit x v f.
  Proof. intros x v f Hv. unfold hit. rewrite dot_scal_r, scal_scal. f_equal. f_equal. field. auto. Qed.

  Lemma beside_hit : forall x v f u w, In f Fs -> dot (normal_of f) v <> 0 -> In u (cycle f) -> In w (cycle f) ->
    height_of f * beside x v u w = det u w (hit x v f) * dot (normal_of f) v.
  Proof.
    intros x v f u w Hf Hv Hu Hw. assert (Y := hit_level x v f Hf Hv). assert (E : beside x v u w = beside (hit x v f) v u w).
    { unfold hit. rewrite beside_along. reflexivity. }
    rewrite E. set (y := hit x v f) in *. clearbody y. assert (C := cramer_dot (normal_of f) u w y v).
    rewrite (level f u), (level f w), Y in C by auto. rewrite C. unfold beside, det, dot, cross; simpl. ring.
  Qed.

  Lemma pair_in_cycle : forall f u w, In (u, w) (pairs (second_of f) (others_of f)) -> In u (cycle f) /\ In w (cycle f).
  Proof. intros f u w H. apply pairs_members in H. unfold cycle. simpl in *. tauto. Qed.

  (* ---- one facet and a line ---- *)
  Section Facet.
    Variables (x v : pt) (f : face).
    Hypothesis Hf : In f Fs.
    Hypothesis Hv : 0 < dot (normal_of f) v.
    Hypothesis Hl : forall T, In T (fan_of f) -> threads x v T.
    Let p := first_of f.
    Let a := second_of f.
    Let y := hit x v f.
    Let Yl : dot (normal_of f) y = height_of f := hit_level x v f Hf (Rgt_not_eq _ _ Hv).

    Lemma sign_pos : forall u w, In u (cycle f) -> In w (cycle f) -> 0 < beside x v u w <-> 0 < det u w y.
    Proof.
      intros u w Hu Hw. assert (E := beside_hit x v f u w Hf (Rgt_not_eq _ _ Hv) Hu Hw). fold y in E. assert (C := raised f Hf).
      split; intros H; [apply Rmult_lt_reg_r with (dot (normal_of f) v)|apply Rmult_lt_reg_l with (height_of f)]; auto; nra.
    Qed.
    Lemma sign_neg : forall u w, In u (cycle f) -> In w (cycle f) -> beside x v u w < 0 <-> det u w y < 0.
    Proof.
      intros u w Hu Hw. assert (E := beside_hit x v f u w Hf (Rgt_not_eq _ _ Hv) Hu Hw). fold y in E. assert (C := raised f Hf).
      split; intros H; [apply Rmult_lt_reg_r with (dot (normal_of f) v)|apply Rmult_lt_reg_l with (height_of f)]; auto; nra.
    Qed.
    Lemma sign_no : forall u w, In u (cycle f) -> In w (cycle f) -> beside x v u w <> 0 -> det u w y <> 0.
    Proof.
      intros u w Hu Hw H E. apply H. assert (B := beside_hit x v f u w Hf (Rgt_not_eq _ _ Hv) Hu Hw). fold y in B. rewrite E in B.
      assert (C := raised f Hf). nra.
    Qed.

    Lemma first_in : In p (cycle f). Proof. simpl; auto. Qed.
    Lemma second_in : In a (cycle f). Proof. simpl; auto. Qed.
    Hint Resolve first_in second_in : core.

    Lemma fan_in : forall u w, In (u, w) (pairs a (others_of f)) -> In (Triangle p u w) (fan_of f).
    Proof. intros u w H. apply in_map_iff. exists (u, w). auto. Qed.

    Lemma beside_swap : forall q u, beside x v q u = - beside x v u q.
    Proof. intros. unfold beside, dot, cross; simpl; ring. Qed.

    (* in a triangle of the fan, strictly *)
    Lemma in_triangle : forall u w, In (u, w) (pairs a (others_of f)) -> passes x v (Triangle p u w) <> 0%Z ->
      passes x v (Triangle p u w) = 1%Z /\ 0 < det p u y /\ 0 < det u w y /\ 0 < det w p y.
    Proof.
      intros u w H N. destruct (pair_in_cycle f u w H) as [Hu Hw]. destruct (Hl _ (fan_in u w H)) as (A & B & C). simpl in A, B, C.
      assert (D := strict f u w Hf H). fold p in D.
      assert (S : det p u y + det u w y + det w p y = det p u w).
      { assert (E := cramer_dot (normal_of f) p u w y). rewrite Yl, (level f p), (level f u), (level f w) in E by auto.
        apply Rmult_eq_reg_r with (height_of f); [|assert (Q := raised f Hf); lra]. rewrite E. unfold det, dot, cross; simpl; ring. }
      unfold passes in *. cbn [corner_1 corner_2 corner_3] in *.
      destruct (Rlt_dec 0 (beside x v p u)) as [a1|a1], (Rlt_dec 0 (beside x v u w)) as [a2|a2], (Rlt_dec 0 (beside x v w p)) as [a3|a3];
        revert N; known; intros N; try (exfalso; apply N; reflexivity).
      - split; [reflexivity|]. rewrite <- !sign_pos by auto. auto.
      - exfalso. assert (b1 : beside x v p u < 0) by lra. assert (b2 : beside x v u w < 0) by lra.
      assert (b3 : beside x v w p < 0) by lra.
        apply sign_neg in b1, b2, b3; auto. lra.
    Qed.

    Lemma triangle_under : forall u w, In (u, w) (pairs a (others_of f)) -> passes x v (Triangle p u w) <> 0%Z -> under Fs y.
    Proof.
      intros u w H N. destruct (in_triangle u w H N) as (_ & A & B & C). destruct (pair_in_cycle f u w H) as [Hu Hw].
      assert (D := strict f u w Hf H). fold p in D. intros g Hg. assert (E := cramer_dot (normal_of g) p u w y).
      assert (Gp := corner_under f p Hf first_in g Hg). assert (Gu := corner_under f u Hf Hu g Hg).
      assert (Gw := corner_under f w Hf Hw g Hg).
      assert (S : det p u y + det u w y + det w p y = det p u w).
      { assert (E' := cramer_dot (normal_of f) p u w y). rewrite Yl, (level f p), (level f u), (level f w) in E' by auto.
        apply Rmult_eq_reg_r with (height_of f); [|assert (Q := raised f Hf); lra]. rewrite E'. unfold det, dot, cross; simpl; ring. }
      replace (det y u w) with (det u w y) in E by (unfold det, dot, cross; simpl; ring).
      replace (det p y w) with (det w p y) in E by (unfold det, dot, cross; simpl; ring).
      apply Rmult_le_reg_l with (det p u w); auto. rewrite E, <- S. nra.
    Qed.

    Lemma outside_facet : ~ under Fs y -> total (passes x v) (fan_of f) = 0%Z.
    Proof.
      intros N. apply total_zero. intros T HT. apply in_map_iff in HT. destruct HT as ([u w] & <- & H). cbn [fst snd].
      destruct (Z.eq_dec (passes x v (Triangle p u w)) 0) as [E|E]; auto. exfalso. apply N. exact (triangle_under u w H E).
    Qed.

    Section Inside.
      Hypothesis Hy : under Fs y.

      Lemma edge_strict : forall u w, In (u, w) (chain p (a :: others_of f) p) -> beside x v u w <> 0 -> 0 < det u w y.
      Proof.
        intros u w H N. assert (E := edges f u w y Hf H Hy Yl).
        assert (In u (cycle f) /\ In w (cycle f)) as [Hu Hw].
        { apply chain_members in H. unfold cycle. fold p a. simpl in *. destruct H as [H1 [H2|H2]]; [tauto|subst; auto]. }
        assert (F := sign_no u w Hu Hw N). lra.
      Qed.

      Lemma fan_edge : forall u w, In (u, w) (pairs a (others_of f)) -> In (u, w) (chain p (a :: others_of f) p).
      Proof.
        intros u w. simpl. intros H. right. revert H. generalize a. induction (others_of f) as [|b r IH]; simpl; intros c H; [tauto|].
        destruct H as [H|H]; auto.
      Qed.

      Lemma passes_term : forall u w, In (u, w) (pairs a (others_of f)) -> 0 < beside x v p a ->
        passes x v (Triangle p u w) = (unit_step (beside x v p u) - unit_step (beside x v p w))%Z.
      Proof.
        intros u w H Pa. destruct (pair_in_cycle f u w H) as [Hu Hw]. destruct (Hl _ (fan_in u w H)) as (A & B & C). simpl in A, B, C.
        assert (E := edge_strict u w (fan_edge u w H) B). apply sign_pos in E; auto.
        unfold passes. cbn [corner_1 corner_2 corner_3]. rewrite (beside_swap w p) in *.
        destruct (Rlt_dec 0 (beside x v p u)) as [a1|a1], (Rlt_dec 0 (beside x v p w)) as [a2|a2]; known; try reflexivity.
        exfalso. assert (b1 : beside x v p u < 0) by lra. apply sign_neg in b1; auto. apply sign_pos in a2; auto.
        apply sign_pos in Pa; auto. assert (D := strict f u w Hf H). fold p in D. assert (G := cramer_dot (cross p a) p u w y).
        assert (Gu := edges f p a u Hf (or_introl eq_refl) (corner_under f u Hf Hu) (level f u Hf Hu)).
        assert (Gw := edges f p a w Hf (or_introl eq_refl) (corner_under f w Hf Hw) (level f w Hf Hw)).
        fold p a in Gu, Gw.
        replace (dot (cross p a) y) with (det p a y) in G by (unfold det, dot, cross; simpl; ring).
        replace (dot (cross p a) p) with 0 in G by (unfold det, dot, cross; simpl; ring).
        replace (dot (cross p a) u) with (det p a u) in G by (unfold det, dot, cross; simpl; ring).
        replace (dot (cross p a) w) with (det p a w) in G by (unfold det, dot, cross; simpl; ring).
        replace (det p y w) with (- det p w y) in G by (unfold det, dot, cross; simpl; ring).
        assert (0 < det p u w * det p a y) by (apply Rmult_lt_0_compat; auto). nra.
      Qed.

      Lemma inside_facet : total (passes x v) (fan_of f) = 1%Z.
      Proof.
        assert (Hr := proper f Hf). assert (FE := fan_edge). assert (PT := passes_term). assert (ES := edge_strict).
        destruct (others_of f) as [|b r] eqn:Er; [congruence|]. clear Hr.
        assert (A : beside x v p a <> 0).
        { destruct (Hl (Triangle p a b)) as (A & _); auto. apply fan_in. rewrite Er. simpl. auto. }
        assert (Pa : 0 < beside x v p a). { apply sign_pos; auto. apply ES; simpl; auto. }
        assert (G : forall l c, (forall u w, In (u, w) (pairs c l) -> passes x v (Triangle p u w)
            = (unit_step (beside x v p u) - unit_step (beside x v p w))%Z) ->
          total (passes x v) (map (fun e => Triangle p (fst e) (snd e)) (pairs c l))
          = (unit_step (beside x v p c) - unit_step (beside x v p (last l c)))%Z).
        { induction l as [|d l IH]; intros c H; [simpl; lia|]. cbn [pairs map total fold_right fst snd].
          change (fold_right _ _ _) with (total (passes x v) (map (fun e => Triangle p (fst e) (snd e)) (pairs d l))).
          rewrite IH by (intros; apply H; simpl; auto). rewrite (H c d) by (simpl; auto).
          rewrite last_step. lia. }
        unfold fan_of. rewrite Er. fold p a. rewrite G by (intros; apply PT; auto).
        assert (L : forall l (c : pt), In (last l c, p) (chain c l p)).
        { induction l as [|d l IH]; intros c; [simpl; auto|]. rewrite last_step. simpl. auto. }
        assert (M : forall l (c d : pt), exists u, In (u, last (d :: l) c) (pairs c (d :: l))).
        { induction l as [|e l IH]; intros c d; [exists c; simpl; auto|]. destruct (IH d e) as (u & Hu). exists u.
          rewrite last_step. right. exact Hu. }
        destruct (M r a b) as (u & Hu). set (z := last (b :: r) a) in *.
        assert (Z : beside x v z p <> 0). { destruct (Hl (Triangle p u z)) as (_ & _ & C); auto. apply fan_in. rewrite Er. auto. }
        assert (Hz : In z (cycle f)). { apply (pair_in_cycle f u z). rewrite Er. auto. }
        assert (Pz : 0 < beside x v z p).
        { apply sign_pos; auto. apply ES; auto. simpl. right. apply (L (b :: r) a). }
        rewrite (beside_swap z p) in Pz. known. reflexivity.
      Qed.
    End Inside.
  End Facet.

  (* the line goes through the facet once, exactly if it meets its plane in the polytope *)
  Lemma facet_passes : forall x v f, In f Fs -> (forall T, In T (fan_of f) -> threads x v T) -> total (passes x v) (fan_of f) <> 0%Z ->
    dot (normal_of f) v <> 0 /\ under Fs (hit x v f) /\ total (passes x v) (fan_of f) = (unit_step (dot (normal_of f) v) - unit_step (-
      dot (normal_of f) v))%Z.
  Proof.
    intros x v f Hf Hl N. destruct (Rtotal_order (dot (normal_of f) v) 0) as [L|[E|L]].
    - assert (Hl' : forall T, In T (fan_of f) -> threads x (scal (-1) v) T) by (intros T HT; apply threads_back; auto).
      assert (Hv' : 0 < dot (normal_of f) (scal (-1) v)) by (rewrite dot_scal_r; lra).
      assert (S := total_back x v (fan_of f)).
      destruct (under_dec Fs (hit x v f)) as [U|(g & Hg & U)].
      + assert (I := inside_facet x (scal (-1) v) f Hf Hv' Hl'). rewrite hit_back in I by lra. specialize (I U).
        split; [lra|]. split; auto. known. lia.
      + exfalso. apply N. assert (O := outside_facet x (scal (-1) v) f Hf Hv' Hl'). rewrite hit_back in O by lra.
        rewrite S in O. assert (- total (passes x v) (fan_of f) = 0)%Z; [|lia]. apply O. intros K. specialize (K g Hg). lra.
    - exfalso. apply N, total_zero. intros T HT. assert (Hs := HT). apply in_map_iff in HT. destruct HT as ([u w] & <- & H).
    cbn [fst snd] in *.
      destruct (pair_in_cycle f u w H) as [Hu Hw]. destruct (Hl _ Hs) as (A & B & C). cbn [corner_1 corner_2 corner_3] in *.
      assert (Z : beside x v (first_of f) u + beside x v u w + beside x v w (first_of f) = 0).
      { apply Rmult_eq_reg_l with (height_of f); [|assert (Q := raised f Hf); lra]. rewrite Rmult_0_r.
        assert (D := cramer_dot (normal_of f) (first_of f) u w v). rewrite E, (level f (first_of f)), (level f u), (level f w) in D by
          (simpl; auto).
        transitivity (height_of f * (det v u w + det (first_of f) v w + det (first_of f) u v)); [unfold beside, det, dot, cross; simpl;
          ring|lra]. }
      unfold passes. cbn [corner_1 corner_2 corner_3].
      destruct (Rlt_dec 0 (beside x v (first_of f) u)), (Rlt_dec 0 (beside x v u w)), (Rlt_dec 0 (beside x v w (first_of f))); known;
        try reflexivity; exfalso; lra.
    - destruct (under_dec Fs (hit x v f)) as [U|(g & Hg & U)].
      + split; [lra|]. split; auto. rewrite inside_facet by auto. known. reflexivity.
      + exfalso. apply N, outside_facet; auto. intros K. specialize (K g Hg). lra.
  Qed.
  Lemma facet_inside : forall x v f, In f Fs -> (forall T, In T (fan_of f) -> threads x v T) -> 0 < dot (normal_of f) v ->
    under Fs (hit x v f) -> total (passes x v) (fan_of f) = 1%Z.
  Proof. intros x v f Hf Hl L U. apply inside_facet; auto. Qed.

  (* no other facet's plane holds that point *)
  Lemma hit_alone : forall x v l f k, Fs = l ++ f :: k -> (forall T, In T (fan_of f) -> threads x v T) ->
    total (passes x v) (fan_of f) <> 0%Z -> forall g, In g (l ++ k) -> dot (normal_of g) (hit x v f) < height_of g.
  Proof.
    intros x v l f k E Hl N g Ig. assert (Hf : In f Fs) by (rewrite E; apply in_app_iff; simpl; auto).
    assert (Hg : In g Fs). { rewrite E. apply in_app_iff in Ig. apply in_app_iff. simpl. tauto. }
    destruct (facet_passes x v f Hf Hl N) as (Nv & U & _).
    assert (V : exists w, hit x w f = hit x v f /\ 0 < dot (normal_of f) w /\ (forall T, In T (fan_of f) -> threads x w T)
      /\ total (passes x w) (fan_of f) <> 0%Z).
    { destruct (Rlt_dec 0 (dot (normal_of f) v)) as [L|L]; [exists v; auto|]. exists (scal (-1) v). rewrite hit_back by auto.
      split; auto. split; [rewrite dot_scal_r; lra|]. split; [intros T HT; apply threads_back; auto|]. rewrite total_back. lia. }
    destruct V as (w & Ew & Pw & Hw & Nw). rewrite <- Ew in U |- *. clear v Ew Hl N Nv. assert (Hh := U g Hg).
    destruct (Req_dec (dot (normal_of g) (hit x w f)) (height_of g)) as [Eg|Eg]; [|lra]. exfalso.
    assert (T : exists u z, In (u, z) (pairs (second_of f) (others_of f)) /\ passes x w (Triangle (first_of f) u z) <> 0%Z).
    { unfold fan_of in Nw. induction (pairs (second_of f) (others_of f)) as [|[u z] r IH]; [exfalso; apply Nw; reflexivity|].
      destruct (Z.eq_dec (passes x w (Triangle (first_of f) u z)) 0) as [Z|Z]; [|exists u, z; simpl; auto].
      destruct IH as (u' & z' & I & P').
      - cbn [map total fold_right fst snd] in Nw. rewrite Z in Nw. exact Nw.
      - exists u', z'. simpl. auto. }
    destruct T as (u & z & Huz & Np). destruct (in_triangle x w f Hf Pw Hw u z Huz Np) as (_ & A & B & C).
    destruct (pair_in_cycle f u z Huz) as [Hu Hz]. set (p := first_of f) in *. set (y := hit x w f) in *.
    assert (Hp : In p (cycle f)) by (simpl; auto). assert (D := strict f u z Hf Huz). fold p in D.
    assert (Yl : dot (normal_of f) y = height_of f) by (apply hit_level; auto; lra).
    assert (S : det p u y + det u z y + det z p y = det p u z).
    { assert (F := cramer_dot (normal_of f) p u z y). rewrite Yl, (level f p), (level f u), (level f z) in F by auto.
      apply Rmult_eq_reg_r with (height_of f); [|assert (Q := raised f Hf); lra]. rewrite F. unfold det, dot, cross; simpl; ring. }
    assert (F := cramer_dot (normal_of g) p u z y). rewrite Eg in F.
    replace (det y u z) with (det u z y) in F by (unfold det, dot, cross; simpl; ring).
    replace (det p y z) with (det z p y) in F by (unfold det, dot, cross; simpl; ring).
    assert (Gp := corner_under f p Hf Hp g Hg). assert (Gu := corner_under f u Hf Hu g Hg). assert (Gz := corner_under f z Hf Hz g Hg).
    assert (Ep : dot (normal_of g) p = height_of g) by nra. assert (Eu : dot (normal_of g) u = height_of g) by nra.
    assert (Ez : dot (normal_of g) z = height_of g) by nra.
    assert (Cf := raised f Hf). assert (Cg := raised g Hg).
    apply (distinct l f k E g (height_of g / height_of f)); auto; [apply Rdiv_lt_0_compat; auto|].
    apply dot_ext. intros q. rewrite dot_scal_l.
    assert (K := same_form (normal_of g) (height_of g) (normal_of f) (height_of f) p u z q (Rgt_not_eq _ _ D) Ep Eu Ez
      (level f p Hf Hp) (level f u Hf Hu) (level f z Hf Hz)).
    apply Rmult_eq_reg_l with (height_of f); [|lra]. rewrite K. field. lra.
  Qed.
End Piece.
