(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The checker of format 3: bodies that are unions of convex pieces.  Integers and lists only. *)
Require Import List ZArith Bool.
From Fathom.checker Require Import vector sequence table polytope support certificate verdict cone signed.
Import ListNotations.
Open Scope Z_scope.

(* some four points do not lie in one plane *)
Definition solid (L : list zvec) : bool :=
  match L with
  | [] => false
  | a :: _ =>
      match first (fun b => negb (is_zero (zsub b a))) L with
      | None => false
      | Some b =>
          match first (fun c => negb (is_zero (zcross (zsub b a) (zsub c a)))) L with
          | None => false
          | Some c => existsb (fun d => negb (zdet (zsub b a) (zsub c a) (zsub d a) =? 0)) L
          end
      end
  end.
Definition all_solid (Ls : list (list zvec)) : bool := match Ls with [] => false | _ => forallb solid Ls end.

(* ---- separations: of each pair of pieces a vector, those of the first piece of a first ---- *)
(* the vectors behind those of this piece of a *)
Fixpoint row (test : list zvec -> list zvec -> zvec -> bool) (A : list zvec) (Bs : list (list zvec)) (us : list zvec) :
  option (list zvec) :=
  match Bs, us with
  | [], _ => Some us
  | B :: Bs', u :: us' => if test A B u then row test A Bs' us' else None
  | _ :: _, [] => None
  end.
Fixpoint all_pairs (test : list zvec -> list zvec -> zvec -> bool) (As Bs : list (list zvec)) (us : list zvec) : bool :=
  match As, us with
  | [], [] => true
  | [], _ :: _ => false
  | A :: As', _ => match row test A Bs us with Some us' => all_pairs test As' Bs us' | None => false end
  end.

(* h(u) <= <u,t> for t = v/unit;   h(u)^[2] <= -q <u,u> for q = qn/qd *)
Definition keeps_out (unit : Z) (v : zvec) (A B : list zvec) (u : zvec) : bool :=
  negb (is_zero u) && height_is (fun h => h * unit <=? zdot u v) A B u.
Definition keeps_apart (qn qd : Z) (A B : list zvec) (u : zvec) : bool :=
  negb (is_zero u) && height_is (fun h => signed_square h * qd <=? - qn * zdot u u) A B u.

(* ---- half-spaces that are as far away as is claimed ---- *)
(* { x : <n,x> >= c } *)
Definition constraint := (zvec * Z)%type.
Definition opposite (h : constraint) : constraint := (zneg (fst h), - snd h).

(* the squared depth square_n/square_d; the optima are the ways over way_unit, and way_at gives the number of the one that is the foot point
   of a half-space: a hint, of which nothing is assumed *)
Record target := Target { square_n : Z; square_d : Z; way_unit : Z; ways : table zvec; way_at : constraint -> N }.

Definition done (g : target) (h : constraint) : bool :=
  let n := fst h in
  let c := snd h in
  let nn := zdot n n in
  (0 <? c)
  && match c * c * square_d g ?= square_n g * nn with
     | Lt => false
     | Gt => true
     | Eq => match member (ways g) (way_at g h) with
             | Some v => same_vector (zscal nn v) (zscal (c * way_unit g) n)
             | None => false
             end
     end.

(* ---- the inner polytopes ---- *)
(* A vertex (l, k) is point l of piece_b minus point k of piece_a; facets as in certificate.v. *)
Record polytope := Polytope { piece_a : N; piece_b : N; corner_points : list (N * N); sides : list (list (N * N)) }.

(* x is in the interior of some P_ij, or in one of the half-spaces that are beyond its facets.  To split a cell: these by number, and all
   that are not done. *)
Record cut := Cut { beyond : table constraint; not_done : list (N * constraint) }.

Definition named (A B : table zvec) (lk : N * N) : bool :=
  match member B (fst lk), member A (snd lk) with Some _, Some _ => true | _, _ => false end.

(* what is beyond the plane of f, a facet of the polytope of the points k v - s *)
Definition half_space (k : Z) (s : zvec) (f : facet) : constraint := (zscal k (normal f), offset f + zdot (normal f) s).

Definition numbered_not_done (g : target) (hs : list constraint) : list (N * constraint) :=
  snd (fold_left (fun state h => (N.succ (fst state), if done g h then snd state else (fst state, h) :: snd state)) hs (0%N, [])).

(* the inner polytope has O inside when it is moved by minus the mean of its vertices *)
Definition cut_of (g : target) (TA TB : table (table zvec)) (q : polytope) : option cut :=
  match member TA (piece_a q), member TB (piece_b q) with
  | Some A, Some B =>
      if forallb (named A B) (corner_points q)
      then
        let vs := each (difference A B) (corner_points q) in
        let k := count vs in
        let s := fold_left zadd vs zzero in
        let TV := numbered (each (fun v => zsub (zscal k v) s) vs) in
        let Fs := each (make_facet TV) (sides q) in
        if (0 <? k) && inner_ok 0 1 Fs
        then let hs := each (half_space k s) Fs in Some (Cut (numbered hs) (numbered_not_done g hs))
        else None
      else None
  | _, _ => None
  end.

Fixpoint cuts_of (g : target) (TA TB : table (table zvec)) (qs : list polytope) (found : list cut) : option (list cut) :=
  match qs with
  | [] => Some (rev_append found [])
  | q :: qs' => match cut_of g TA TB q with Some c => cuts_of g TA TB qs' (c :: found) | None => None end
  end.

(* ---- the tree, as the list of its nodes in preorder ---- *)
(* A cell of space by its constraints, which are numbered from 0. *)
Record cell := Cell { held : table constraint; next : positive }.
Definition all_of_space := Cell Empty 1.
Definition part (c : cell) (h : constraint) : cell := Cell (put (next c) h (held c)) (Pos.succ (next c)).

Inductive node :=
  (* by the number of a polytope, and of those of its facets that have a child *)
  | Split (cut_by : N) (children : list N)
  (* the numbers of constraints *)
  | Leaf (far : list N).

(* the children of a cell, the last one first, with what is left of the cell; and the half-spaces of the children by number *)
Fixpoint children_of (hs : table constraint) (c : cell) (fs : list N) (cells : list cell) (marks : table constraint) :
  option (list cell * table constraint) :=
  match fs with
  | [] => Some (cells, marks)
  | f :: fs' =>
      match member hs f with
      | Some h => children_of hs (part c (opposite h)) fs' (part c h :: cells) (put (N.succ_pos f) h marks)
      | None => None
      end
  end.

Definition marked (marks : table constraint) (ih : N * constraint) : bool :=
  match member marks (fst ih) with
  | Some h => same_vector (fst h) (fst (snd ih)) && (snd h =? snd (snd ih))
  | None => false
  end.

Fixpoint members (hs : table constraint) (is : list N) (found : list constraint) : option (list constraint) :=
  match is with
  | [] => Some (rev_append found [])
  | i :: is' => match member hs i with Some h => members hs is' (h :: found) | None => None end
  end.
(* the sum, with multipliers that are not negative *)
Fixpoint combined (hs : list constraint) (ls : list Z) (sum : constraint) : option constraint :=
  match hs, ls with
  | [], [] => Some sum
  | h :: hs', l :: ls' =>
      if 0 <=? l then combined hs' ls' (zadd (fst sum) (zscal l (fst h)), snd sum + l * snd h) else None
  | _, _ => None
  end.

(* multipliers: hints *)
Definition far_away (g : target) (multipliers : list constraint -> list Z) (c : cell) (is : list N) : bool :=
  match members (held c) is [] with
  | Some hs => match combined hs (multipliers hs) (zzero, 0) with Some h => done g h | None => false end
  | None => false
  end.

(* cells: those whose nodes are still to come, in this order *)
Definition step (g : target) (cuts : table cut) (multipliers : list constraint -> list Z) (cells : list cell) (n : node) :
  option (list cell) :=
  match n, cells with
  | _, [] => None
  | Leaf is, c :: cells' => if far_away g multipliers c is then Some cells' else None
  | Split s fs, c :: cells' =>
      match member cuts s with
      | Some by_facets =>
          match children_of (beyond by_facets) c fs [] Empty with
          | Some (children, marks) =>
              if forallb (marked marks) (not_done by_facets) then Some (rev_append children cells') else None
          | None => None
          end
      | None => None
      end
  end.
Fixpoint walk (g : target) (cuts : table cut) (multipliers : list constraint -> list Z) (cells : list cell) (nodes : list node) : bool :=
  match nodes with
  | [] => match cells with [] => true | _ => false end
  | n :: nodes' => match step g cuts multipliers cells n with Some cells' => walk g cuts multipliers cells' nodes' | None => false end
  end.

(* ---- the claims ---- *)
(* pieces by number, and weights in units of 1/weight_unit *)
Record nearest := Nearest { near_a : N; near_b : N; weight_unit : Z; near_weights_a : list (N * Z); near_weights_b : list (N * Z) }.

Inductive union_claim :=
  (* depth^2 = qn/qd; each optimum, over unit, comes with its separations; way_at and multipliers are hints *)
  | Union_deep (qn qd unit : Z) (optima : list (zvec * list zvec)) (way_at : constraint -> N)
      (polytopes : list polytope) (tree : list node) (multipliers : list constraint -> list Z)
  | Union_touching (separations : list zvec) (common : nearest)
  (* the squared distance is qn/qd *)
  | Union_apart (qn qd : Z) (separations : list zvec) (common : nearest).

Definition check_union_deep (As Bs : list (list zvec)) (qn qd unit : Z) (optima : list (zvec * list zvec)) (way_at : constraint -> N)
    (polytopes : list polytope) (tree : list node) (multipliers : list constraint -> list Z) : bool :=
  let g := Target qn qd unit (numbered (each fst optima)) way_at in
  (0 <? qn) && (0 <? qd) && (0 <? unit)
  && match optima with [] => false | t :: r => along_pairs (fun u v => before (fst u) (fst v)) t r end
  && forallb (fun t => (zdot (fst t) (fst t) * qd =? qn * (unit * unit)) && all_pairs (keeps_out unit (fst t)) As Bs (snd t)) optima
  && match cuts_of g (numbered (each numbered As)) (numbered (each numbered Bs)) polytopes [] with
     | Some cuts => walk g (numbered cuts) multipliers [all_of_space] tree
     | None => false
     end.

(* the difference of the weighted means passes the test *)
Definition near_is (test : Z -> zvec -> bool) (As Bs : list (list zvec)) (p : nearest) : bool :=
  match member (numbered As) (near_a p), member (numbered Bs) (near_b p) with
  | Some A, Some B => mean_is (test (weight_unit p)) A B (weight_unit p) (near_weights_a p) (near_weights_b p)
  | _, _ => false
  end.

(* the pieces in units of 1/m; squared lengths are measured in these units *)
Definition union_check (m : Z) (As Bs : list (list zvec)) (c : union_claim) : bool :=
  (0 <? m) && all_solid As && all_solid Bs
  && match c with
     | Union_deep qn qd unit optima way_at polytopes tree multipliers =>
         check_union_deep As Bs (qn * (m * m)) qd unit optima way_at polytopes tree multipliers
     | Union_touching us p =>
         all_pairs (keeps_out 1 zzero) As Bs us && near_is (fun _ => is_zero) As Bs p
     | Union_apart qn qd us p =>
         let q := qn * (m * m) in
         (0 <? qn) && (0 <? qd)
         && all_pairs (keeps_apart q qd) As Bs us && near_is (fun unit z => zdot z z * qd =? q * (unit * unit)) As Bs p
     end.
