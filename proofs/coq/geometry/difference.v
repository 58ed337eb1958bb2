(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* P as the hull of a finite list; its support function; the facets of P as facets of that list. *)
Require Import Reals Lra Psatz List.
From Fathom.geometry Require Import meaning space hulls flats facets.
Import ListNotations.
Open Scope R_scope.

Definition differences (A B : list pt) : list pt := map (fun ab => sub (snd ab) (fst ab)) (list_prod A B).

Lemma differences_in : forall A B p, In p (differences A B) <-> diffs A B p.
Proof.
  intros A B p. unfold differences, diffs. rewrite in_map_iff. split.
  - intros ((a, b) & <- & H). apply in_prod_iff in H. exists a, b. tauto.
  - intros (a & b & Ia & Ib & ->). exists (a, b). split; auto. apply in_prod; auto.
Qed.

Lemma P_conv : forall A B p, P A B p <-> conv (differences A B) p.
Proof. intros A B p. split; apply hull_mono; intros s; apply differences_in. Qed.

Lemma interior_iff : forall (S T : pt -> Prop) t, (forall p, S p <-> T p) -> interior S t <-> interior T t.
Proof. intros S T t E. split; intros (e & He & H); exists e; split; auto; intros s Hs; apply E; auto. Qed.
Lemma interior_P_conv : forall A B t, interior (P A B) t <-> interior (conv (differences A B)) t.
Proof. intros. apply interior_iff. intros. apply P_conv. Qed.
Lemma interior_in : forall (S : pt -> Prop) t, interior S t -> S t.
Proof.
  intros S t (e & He & H). apply H. replace (norm2 (sub t t)) with 0 by (unfold norm2, dot; simpl; ring). nra.
Qed.

Lemma interior_spanning : forall A B t, interior (P A B) t -> spanning (differences A B).
Proof.
  intros A B t H. apply interior_P_conv in H. destruct (spanning_or_flat (differences A B)) as [S|S]; auto.
  exfalso. exact (flat_no_interior _ t S H).
Qed.

Lemma facet_plane_P : forall A B u v w n h, facet_plane (differences A B) u v w n h ->
  facet_direction A B n /\ height_is A B n h.
Proof.
  intros A B u v w n h (Iu & Iv & Iw & U & V & W & Hc & Hn & Hb).
  rewrite differences_in in *.
  assert (Hh : height_is A B n h).
  { split; [|exists u; split; auto; apply hull_in; auto].
    apply hull_halfspace. intros s Hs. apply Hb. apply differences_in. auto. }
  split; auto. split; auto. exists h. split; auto. exists u, v, w. auto 10.
Qed.

(* a plane through t with P on one side *)
Lemma beyond_not_interior : forall A B n h t, n <> origin -> height_is A B n h -> h <= dot n t -> ~ interior (P A B) t.
Proof.
  intros A B n h t Hn [Hh _] Ht. apply (halfspace_not_interior _ n h); auto. apply norm2_pos. auto.
Qed.

Lemma height_unique : forall A B n h h', height_is A B n h -> height_is A B n h' -> h = h'.
Proof.
  intros A B n h h' (H1 & p & Hp & Ep) (H2 & q & Hq & Eq). specialize (H1 q Hq). specialize (H2 p Hp). lra.
Qed.

(* the greatest value over a list *)
Lemma greatest_exists : forall (f : pt -> R) l, l <> [] -> exists m, In m l /\ forall p, In p l -> f p <= f m.
Proof.
  induction l as [|a l IH]; intros H; [congruence|]. destruct l as [|b l].
  - exists a. simpl. split; auto. intros p [<-|[]]. lra.
  - destruct IH as (m & Hm & M); [congruence|]. destruct (Rle_dec (f a) (f m)) as [L|L].
    + exists m. split; [right; auto|]. intros p [<-|Hp]; auto.
    + exists a. split; [left; auto|]. intros p [<-|Hp]; [lra|]. specialize (M p Hp). lra.
Qed.

Lemma height_exists : forall A B n, A <> [] -> B <> [] -> exists h, height_is A B n h.
Proof.
  intros A B n HA HB.
  destruct (greatest_exists (fun p => dot n p) (differences A B)) as (m & Hm & M).
  { destruct A; [congruence|]. destruct B; [congruence|]. discriminate. }
  exists (dot n m). split.
  - apply hull_halfspace. intros s Hs. apply M. apply differences_in. auto.
  - exists m. split; auto. apply hull_in. apply differences_in. auto.
Qed.

Lemma P_nonempty : forall A B p, P A B p -> A <> [] /\ B <> [].
Proof.
  intros A B p H.
  assert (C : convex (fun _ => False)) by (intros u v l _ []).
  split; intros ->; apply (H _ C); intros s (a & b & Ia & Ib & _); [exact Ia|exact Ib].
Qed.
