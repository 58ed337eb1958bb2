(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The members of a list by number, from 0, each found in logarithmic time. *)
Require Import List ZArith Bool Lia.
Import ListNotations.

Section Table.
  Variable T : Type.

  Inductive table := Empty | Node (even : table) (here : option T) (odd : table).

  Fixpoint get (k : positive) (t : table) : option T :=
    match t with
    | Empty => None
    | Node even here odd => match k with xH => here | xO k' => get k' even | xI k' => get k' odd end
    end.

  Fixpoint put (k : positive) (x : T) (t : table) : table :=
    match k, t with
    | xH, Empty => Node Empty (Some x) Empty
    | xH, Node even _ odd => Node even (Some x) odd
    | xO k', Empty => Node (put k' x Empty) None Empty
    | xO k', Node even here odd => Node (put k' x even) here odd
    | xI k', Empty => Node Empty None (put k' x Empty)
    | xI k', Node even here odd => Node even here (put k' x odd)
    end.

  Definition numbered (l : list T) : table :=
    snd (fold_left (fun state x => (Pos.succ (fst state), put (fst state) x (snd state))) l (xH, Empty)).
  Definition member (t : table) (i : N) : option T := get (N.succ_pos i) t.

  (* f holds for every member *)
  Fixpoint all_entries (f : T -> bool) (t : table) : bool :=
    match t with
    | Empty => true
    | Node even here odd => (match here with Some x => f x | None => true end) && all_entries f even && all_entries f odd
    end.

  Lemma get_put : forall k x j t y, get j (put k x t) = Some y -> y = x \/ get j t = Some y.
  Proof.
    induction k; intros x j t y; destruct t, j; simpl; intros H; auto;
      try (destruct j; discriminate); try discriminate;
      try (apply IHk in H; destruct H as [H|H]; auto; destruct j; discriminate);
      try (inversion H; auto).
  Qed.

  Lemma get_put_same : forall k x t, get k (put k x t) = Some x.
  Proof. induction k; intros x t; destruct t; simpl; auto. Qed.
  Lemma get_put_other : forall k j x t, j <> k -> get j (put k x t) = get j t.
  Proof.
    induction k; intros j x t N; destruct t, j; simpl; try congruence; try (rewrite IHk by congruence); auto; try (destruct j;
      reflexivity).
  Qed.
  Lemma member_nth : forall l i, member (numbered l) i = nth_error l (N.to_nat i).
  Proof.
    intros l i. unfold member, numbered.
    assert (G : forall l k t j, (forall h, (k <= h)%positive -> get h t = None) ->
      get j (snd (fold_left (fun state x => (Pos.succ (fst state), put (fst state) x (snd state))) l (k, t)))
      = if (j <? k)%positive then get j t else nth_error l (Pos.to_nat j - Pos.to_nat k)).
    { induction l0 as [|x l0 IH]; intros k t j H.
      - simpl. destruct (Pos.ltb_spec j k) as [L|L]; auto. rewrite H by auto. destruct (Pos.to_nat j - Pos.to_nat k)%nat; auto.
      - cbn [fold_left fst snd]. rewrite IH.
        + destruct (Pos.ltb_spec j (Pos.succ k)) as [L|L], (Pos.ltb_spec j k) as [M|M]; try lia.
          * apply get_put_other. lia.
          * assert (j = k) as -> by lia. rewrite get_put_same. replace (Pos.to_nat k - Pos.to_nat k)%nat with O by lia. auto.
          * replace (Pos.to_nat j - Pos.to_nat k)%nat with (S (Pos.to_nat j - Pos.to_nat (Pos.succ k))) by lia. auto.
        + intros h Hh. rewrite get_put_other by lia. apply H. lia. }
    rewrite G by (intros h _; destruct h; auto). destruct (Pos.ltb_spec (N.succ_pos i) 1) as [L|L]; [lia|].
    f_equal. destruct i; simpl; lia.
  Qed.

  (* what is found was in the list *)
  Lemma member_in : forall l i x, member (numbered l) i = Some x -> In x l.
  Proof.
    intros l i x. unfold member, numbered. generalize (N.succ_pos i). intros k.
    assert (G : forall l s, get k (snd (fold_left
        (fun state x => (Pos.succ (fst state), put (fst state) x (snd state))) l s)) = Some x ->
      In x l \/ get k (snd s) = Some x).
    { induction l0 as [|y l0 IH]; simpl; intros s H; auto.
      apply IH in H. destruct H as [H|H]; auto. simpl in H. apply get_put in H.
      destruct H as [H|H]; auto. }
    intros H. apply G in H. destruct H as [H|H]; auto. simpl in H. destruct k; discriminate.
  Qed.

  (* the sum of f over all members *)
  Fixpoint sum_of (f : T -> Z) (t : table) : Z :=
    match t with
    | Empty => 0
    | Node even here odd => (match here with Some x => f x | None => 0 end) + sum_of f even + sum_of f odd
    end%Z.
  Lemma sum_put : forall f k x t, sum_of f (put k x t) = (sum_of f t + f x - match get k t with Some y => f y | None => 0 end)%Z.
  Proof. induction k; intros x t; destruct t as [|even [y|] odd]; simpl; rewrite ?IHk; simpl; try destruct k; simpl; lia. Qed.
  Lemma sum_zero : forall f g t, all_entries g t = true -> (forall x, g x = true -> f x = 0%Z) -> sum_of f t = 0%Z.
  Proof.
    intros f g t H F. induction t as [|even IHe here odd IHo]; simpl in *; [reflexivity|]. apply andb_true_iff in H. destruct H as [H Ho].
    apply andb_true_iff in H. destruct H as [Hh He]. rewrite IHe, IHo by auto. destruct here; [rewrite F by auto|]; reflexivity.
  Qed.
End Table.
Arguments get {T}.
Arguments put {T}.
Arguments numbered {T}.
Arguments member {T}.
Arguments all_entries {T}.
Arguments sum_of {T}.
Arguments Empty {T}.
Arguments Node {T}.

(* the same places, other members *)
Fixpoint table_map {T U : Type} (f : T -> U) (t : table T) : table U :=
  match t with
  | Empty => Empty
  | Node even here odd => Node (table_map f even) (match here with Some x => Some (f x) | None => None end) (table_map f odd)
  end.
Lemma put_map : forall (T U : Type) (f : T -> U) k x t, put k (f x) (table_map f t) = table_map f (put k x t).
Proof. induction k; intros x t; destruct t as [|even here odd]; simpl; rewrite <- ?IHk; reflexivity. Qed.
Lemma member_map : forall (T U : Type) (f : T -> U) l i,
  member (numbered (map f l)) i = match member (numbered l) i with Some x => Some (f x) | None => None end.
Proof.
  intros T U f l i. unfold member, numbered.
  assert (G : forall l k t, snd (fold_left (fun state x => (Pos.succ (fst state), put (fst state) x (snd state))) (map f l) (k,
    table_map f t))
    = table_map f (snd (fold_left (fun state x => (Pos.succ (fst state), put (fst state) x (snd state))) l (k, t)))).
  { induction l0 as [|x l0 IH]; intros k t; [reflexivity|]. cbn [map fold_left fst snd]. rewrite put_map. apply IH. }
  assert (E := G l xH Empty). cbn [table_map] in E. rewrite E. generalize (snd (fold_left
    (fun state x => (Pos.succ (fst state), put (fst state) x (snd state))) l (xH, Empty))) (N.succ_pos i).
  intros t k. revert t. induction k; intros t; destruct t as [|even here odd]; simpl; auto.
Qed.
