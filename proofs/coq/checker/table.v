(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The members of a list by number, from 0, each found in logarithmic time. *)
Require Import List ZArith.
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

  Lemma get_put : forall k x j t y, get j (put k x t) = Some y -> y = x \/ get j t = Some y.
  Proof.
    induction k; intros x j t y; destruct t, j; simpl; intros H; auto;
      try (destruct j; discriminate); try discriminate;
      try (apply IHk in H; destruct H as [H|H]; auto; destruct j; discriminate);
      try (inversion H; auto).
  Qed.

  (* all that is ever needed of it: what is found was in the list *)
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
End Table.
Arguments get {T}.
Arguments put {T}.
Arguments numbered {T}.
Arguments member {T}.
Arguments Empty {T}.
