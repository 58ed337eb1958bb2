(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Walks along lists that run in constant stack space once extracted: a certificate may hold many points. *)
Require Import List Bool.
Import ListNotations.

Section Walks.
  Variables T U : Type.

  (* the list map f l *)
  Definition each (f : T -> U) (l : list T) : list U := rev_append (fold_left (fun done x => f x :: done) l []) [].

  (* the list map f l, if f has a value everywhere *)
  Definition every (f : T -> option U) (l : list T) : option (list U) :=
    match fold_left (fun done x => match done with
                                   | Some ys => match f x with Some y => Some (y :: ys) | None => None end
                                   | None => None
                                   end) l (Some []) with
    | Some ys => Some (rev_append ys [])
    | None => None
    end.

  (* chain a [b; c] z = [(a, b); (b, c); (c, z)];   pairs a [b; c] = [(a, b); (b, c)] *)
  Fixpoint chain (a : T) (l : list T) (z : T) : list (T * T) :=
    match l with [] => [(a, z)] | b :: l' => (a, b) :: chain b l' z end.
  Fixpoint pairs (a : T) (l : list T) : list (T * T) :=
    match l with [] => [] | b :: l' => (a, b) :: pairs b l' end.

  (* f holds for every member of chain a l z, of pairs a l *)
  Fixpoint along_chain (f : T -> T -> bool) (a : T) (l : list T) (z : T) : bool :=
    match l with [] => f a z | b :: l' => if f a b then along_chain f b l' z else false end.
  Fixpoint along_pairs (f : T -> T -> bool) (a : T) (l : list T) : bool :=
    match l with [] => true | b :: l' => if f a b then along_pairs f b l' else false end.

  (* the fold over chain a l z *)
  Fixpoint fold_chain (f : U -> T -> T -> U) (acc : U) (a : T) (l : list T) (z : T) : U :=
    match l with [] => f acc a z | b :: l' => fold_chain f (f acc a b) b l' z end.
End Walks.
Arguments each {T U}.
Arguments every {T U}.
Arguments chain {T}.
Arguments pairs {T}.
Arguments along_chain {T}.
Arguments along_pairs {T}.
Arguments fold_chain {T U}.

Lemma each_map : forall (T U : Type) (f : T -> U) l, each f l = map f l.
Proof.
  intros. unfold each. rewrite rev_append_rev, app_nil_r.
  assert (G : forall l done, rev (fold_left (fun done x => f x :: done) l done) = rev done ++ map f l).
  { induction l0 as [|x l0 IH]; simpl; intros; [rewrite app_nil_r; reflexivity|].
    rewrite IH. simpl. rewrite <- app_assoc. reflexivity. }
  rewrite G. reflexivity.
Qed.

Lemma every_spec : forall (T U : Type) (f : T -> option U) l ys, every f l = Some ys ->
  Forall2 (fun x y => f x = Some y) l ys.
Proof.
  intros T U f l ys H. unfold every in H.
  set (g := fun done x => match done with
    | Some ys => match f x with Some y => Some (y :: ys) | None => None end | None => None end) in *.
  assert (none : forall l, fold_left g l None = None) by (induction l0; simpl; auto).
  assert (G : forall l done zs, fold_left g l (Some done) = Some zs ->
    exists ys, zs = rev ys ++ done /\ Forall2 (fun x y => f x = Some y) l ys).
  { induction l0 as [|x l0 IH]; simpl; intros done zs E; [inversion E; exists []; auto|].
    destruct (f x) as [y|] eqn:F; [|rewrite none in E; discriminate].
    destruct (IH _ _ E) as (ys' & -> & F'). exists (y :: ys'). simpl. rewrite <- app_assoc. auto. }
  destruct (fold_left g l (Some [])) as [zs|] eqn:E; [|discriminate]. destruct (G _ _ _ E) as (ys' & -> & F).
  inversion H. rewrite rev_append_rev, !app_nil_r, rev_involutive. auto.
Qed.
Lemma every_in : forall (T U : Type) (f : T -> option U) l ys y, every f l = Some ys -> In y ys ->
  exists x, In x l /\ f x = Some y.
Proof.
  intros T U f l ys y H. apply every_spec in H. induction H as [|x z l ys F _ IH]; simpl; [tauto|].
  intros [<-|I0]; [exists x; auto|]. destruct (IH I0) as (x' & I1 & E). exists x'. auto.
Qed.

Lemma along_chain_spec : forall (T : Type) f l (a z : T), along_chain f a l z = true ->
  forall u v, In (u, v) (chain a l z) -> f u v = true.
Proof.
  induction l as [|b l IH]; simpl; intros a z H u v Huv.
  - destruct Huv as [E|[]]. inversion E; subst; auto.
  - destruct (f a b) eqn:E; [|discriminate]. destruct Huv as [F|F]; [inversion F; subst; auto|eauto].
Qed.

Lemma along_pairs_spec : forall (T : Type) f l (a : T), along_pairs f a l = true ->
  forall u v, In (u, v) (pairs a l) -> f u v = true.
Proof.
  induction l as [|b l IH]; simpl; intros a H u v Huv; [tauto|].
  destruct (f a b) eqn:E; [|discriminate]. destruct Huv as [F|F]; [inversion F; subst; auto|eauto].
Qed.

Lemma pairs_members : forall (T : Type) l (a u v : T), In (u, v) (pairs a l) -> In u (a :: l) /\ In v (a :: l).
Proof.
  induction l as [|b l IH]; simpl; intros a u v H; [tauto|].
  destruct H as [H|H]; [inversion H; subst; tauto|].
  apply IH in H. simpl in H. tauto.
Qed.

Lemma chain_members : forall (T : Type) l (a z u v : T),
  In (u, v) (chain a l z) -> In u (a :: l) /\ (In v l \/ v = z).
Proof.
  induction l as [|d l IH]; simpl; intros a z u v [E|E]; try (inversion E; subst; tauto); try tauto.
  apply IH in E. simpl in E. tauto.
Qed.

Lemma pairs_map : forall (T U : Type) (f : T -> U) l a, pairs (f a) (map f l) = map (fun e => (f (fst e), f (snd e))) (pairs a l).
Proof. intros T U f l. induction l as [|b l IH]; intros a; simpl; [|rewrite IH]; auto. Qed.
Lemma chain_map : forall (T U : Type) (f : T -> U) l a z, chain (f a) (map f l) (f z) = map (fun e => (f (fst e), f (snd e))) (chain a
  l z).
Proof. intros T U f l. induction l as [|b l IH]; intros a z; simpl; [|rewrite IH]; auto. Qed.
