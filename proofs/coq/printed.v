(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the lines say that fathom-check-proved prints. Whoever believes these definitions, and Coq,
   need read no other file, and of polytopes the first part only. In brackets stand theorems which
   show that a definition means what it should. *)
Require Import Reals List ZArith. Import ListNotations. Local Open Scope R_scope.
Set Implicit Arguments. Set Contextual Implicit. (* types are left out where they can be inferred *)

(* ==== 1. Polytopes ==== *)
Record pt := mk { px : R; py : R; pz : R }.
Definition origin := mk 0 0 0.
Definition add (u v : pt) := mk (px u + px v) (py u + py v) (pz u + pz v).
Definition sub (u v : pt) := mk (px u - px v) (py u - py v) (pz u - pz v).
Definition scal (k : R) (u : pt) := mk (k * px u) (k * py u) (k * pz u).
Definition dot (u v : pt) : R := px u * px v + py u * py v + pz u * pz v.
Definition norm2 (u : pt) : R := dot u u.

Definition set := pt -> Prop.
Definition convex (C : set) :=
  forall u v l, 0 <= l <= 1 -> C u -> C v -> C (add (scal l u) (scal (1 - l) v)).
(* the least convex set that holds S: all finite convex combinations of its points [hull_comb] *)
Definition hull (S : set) (p : pt) := forall C, convex C -> (forall s, S s -> C s) -> C p.
Definition conv (L : list pt) : set := hull (fun p => In p L).
Definition interior (S : set) t := exists e, 0 < e /\ forall s, norm2 (sub s t) < e * e -> S s.
(* A moved by t meets B exactly if t is in difference_of B A [meet_iff, gaps_meet] *)
Definition difference_of (S T : set) (p : pt) := exists s t, S s /\ T t /\ p = sub s t.

(* U and G are the translations of A by which it overlaps B, and by which it meets B. q > 0: it
   overlaps B, and q is the least squared length of one that ends this. q < 0: -q is that of one by
   which they meet. There is just one q [depth2_once; depth2_exists, union_depth2_exists] *)
Definition depth2 (U G : set) (q : R) :=
  0 < q /\ (forall t, norm2 t < q -> U t) /\ (exists t, norm2 t = q /\ ~ U t)
  \/ q = 0 /\ G origin /\ ~ U origin
  \/ q < 0 /\ (forall t, G t -> - q <= norm2 t) /\ (exists t, norm2 t = - q /\ G t).
(* exactly k translations of that length end it: as many as facets are so near [facets_exits] *)
Definition exits (U : set) (q : R) (k : Z) :=
  exists ts, Z.of_nat (length ts) = k /\ NoDup ts /\ forall t, In t ts <-> norm2 t = q /\ ~ U t.
(* S is between two planes of normal n at squared distance w; the least [width_said, body_width] *)
Definition slab (S : set) (n : pt) (w : R) := n <> origin
  /\ forall a b, S a -> S b -> dot n (sub b a) * dot n (sub b a) <= w * norm2 n.
Definition width2 (S : set) (w : R) := (exists n, slab S n w) /\ forall n v, slab S n v -> w <= v.
(* numbers and points as they stand in a certificate *)
Record ratio := Ratio { num : Z; den : Z }.
Record point := Point { qx : ratio; qy : ratio; qz : ratio }.
Definition value (r : ratio) := IZR (num r) / IZR (den r).
Definition real (p : point) := mk (value (qx p)) (value (qy p)) (value (qz p)).

(* depth_squared=q [optima=k]; depth_squared_in=[lo,hi]; touching; disjoint; distance_squared=q *)
Inductive statement := Depth_is (q : ratio) (optima : option Z) | Depth_between (lo hi : ratio)
  | They_touch | They_are_apart | Distance_is (q : ratio).
Definition says_of (U G : set) (s : statement) :=
  match s with
  | Depth_is q optima => 0 < value q /\ depth2 U G (value q)
      /\ forall k, optima = Some k -> exits U (value q) k
  | Depth_between lo hi => exists q, 0 < q /\ depth2 U G q /\ value lo <= q <= value hi
  | They_touch => depth2 U G 0
  | They_are_apart => ~ G origin
  | Distance_is q => 0 < value q /\ depth2 U G (- value q)
  end.
Definition says (A B : list pt) (s : statement) :=
  let G := difference_of (conv B) (conv A) in says_of (interior G) G s.
(* dimension=2: of bodies of the plane. Upright, without an end above or below, they have the ways
   out that they have in the plane [plane_depth, plane_exits]; no z of a point counts *)
Definition upright (S : set) (p : pt) := exists z, S (mk (px p) (py p) z).
Definition says_plane (A B : list pt) (s : statement) :=
  let G := upright (difference_of (conv B) (conv A)) in says_of (interior G) G s.
(* with --width: it is said of A and A, and the depth is the width *)
Definition says_width (S : set) := forall q, 0 <= q ->
  let G := difference_of S S in depth2 (interior G) G q -> width2 S q.

(* ==== 2. Unions of polytopes ==== *)
Definition union (Ls : list (list pt)) (p : pt) := exists L, In L Ls /\ conv L p.
Definition solid_pieces Ls := Ls <> [] /\ forall L, In L Ls -> exists p, interior (conv L) p.
(* A moved by t and B overlap, each as a whole: just then do two of their pieces [overlap_pieces] *)
Definition overlap_at As Bs t := exists p, interior (union As) (sub p t) /\ interior (union Bs) p.

(* pieces=mxn, and what is said of the depth *)
Record union_statement := Union_statement { pieces_a : Z; pieces_b : Z; union_says : statement }.
Definition says_union (As Bs : list (list pt)) (s : union_statement) :=
  solid_pieces As /\ solid_pieces Bs
  /\ Z.of_nat (length As) = pieces_a s /\ Z.of_nat (length Bs) = pieces_b s
  /\ says_of (overlap_at As Bs) (difference_of (union Bs) (union As)) (union_says s).
(* dimension=2 [inside_upright] *)
Definition solid_up Ls := Ls <> [] /\ forall L, In L Ls -> exists p, interior (upright (conv L)) p.
Definition overlap_up As Bs t :=
  exists p, interior (upright (union As)) (sub p t) /\ interior (upright (union Bs)) p.
Definition says_plane_union (As Bs : list (list pt)) (s : union_statement) :=
  solid_up As /\ solid_up Bs
  /\ Z.of_nat (length As) = pieces_a s /\ Z.of_nat (length Bs) = pieces_b s
  /\ says_of (overlap_up As Bs) (upright (difference_of (union Bs) (union As))) (union_says s).

(* ==== 3. Round and curved bodies ==== *)
(* A core with a radius: a hull of points; a Minkowski sum of hulls of atoms, each of them an affine
   image of the unit ball; or a half-space <n, x> <= d. *)
Record atom (V : Type) := Atom { center : V; axis_u : V; axis_v : V; axis_w : V }.
Inductive core (V U : Type) :=
  Points (L : list V) | Terms (ts : list (list (atom V))) | Half_space (n : V) (d : U).
Record body (V U : Type) := Body { core_of : core V U; radius : U }.
Definition real_atom '(Atom c u v w) := Atom (real c) (real u) (real v) (real w).
Definition real_body (b : body point ratio) := Body match core_of b with
  Points L => Points (map real L) | Terms ts => Terms (map (map real_atom) ts)
  | Half_space n d => Half_space (real n) (value d) end (value (radius b)).
Definition in_atom (a : atom pt) (p : pt) := exists x y z, x * x + y * y + z * z <= 1
  /\ p = add (center a) (add (scal x (axis_u a)) (add (scal y (axis_v a)) (scal z (axis_w a)))).
Definition in_term (t : list (atom pt)) := hull (fun p => exists a, In a t /\ in_atom a p).
Definition sum_of (S T : set) (p : pt) := exists s t, S s /\ T t /\ p = add s t.
Fixpoint in_terms (ts : list (list (atom pt))) : set :=
  match ts with [] => fun p => p = origin | t :: r => sum_of (in_term t) (in_terms r) end.
Definition in_core (c : core pt R) : set := match c with
  Points L => conv L | Terms ts => in_terms ts | Half_space n d => fun x => dot n x <= d end.
Definition thick (S : set) (r : R) (p : pt) := exists s, S s /\ norm2 (sub p s) <= r * r.
Definition in_body (b : body pt R) := thick (in_core (core_of b)) (radius b).
Definition gaps (A B : body pt R) := difference_of (in_body B) (in_body A).
Definition core_gaps (A B : body pt R) := difference_of (in_core (core_of B)) (in_core (core_of A)).
(* the root of depth2, with its sign [theorem_R, shortest_translation] *)
Definition signed_depth_is (G : set) (v : R) := depth2 (interior G) G (v * Rabs v).
(* the sums of multiples of the ls and multiples >= 0 of the rs *)
Inductive sums_of (ls rs : list pt) : set := no_sum : sums_of ls rs origin
  | line_sum k l u : In l ls -> sums_of ls rs u -> sums_of ls rs (add (scal k l) u)
  | ray_sum k r u : 0 <= k -> In r rs -> sums_of ls rs u -> sums_of ls rs (add (scal k r) u).
(* K consists of the sums of k lines and r rays, of which none could be spared [cone_sound] *)
Definition cone_is (K : set) (k r : Z) := exists ls rs,
  Z.of_nat (length ls) = k /\ Z.of_nat (length rs) = r /\ (forall u, K u <-> sums_of ls rs u)
  /\ (forall xs l ys, ls = xs ++ l :: ys -> ~ sums_of (xs ++ ys) [] l)
  /\ (forall xs q ys, rs = xs ++ q :: ys -> ~ sums_of ls (xs ++ ys) q /\ ~ K (scal (-1) q)).
Definition polar (G : set) (u : pt) := forall g, G g -> dot u g <= 0.

(* signed_depth=sqrt(square)+rho with the square's sign [optima=k] [cone=k+r]; signed_depth_in=.. *)
Inductive status := Penetrating | In_touch | Disjoint_bodies | Undecided.
Inductive signed_statement := Root_between (s : status) (lo hi : ratio)
  | Root_is (s : status) (square rho : ratio) (optima : option Z) (cone : option (Z * Z)).
Definition sign_is (s : status) (v : R) := match s with
  Penetrating => 0 < v | In_touch => v = 0 | Disjoint_bodies => v < 0 | Undecided => True end.
Definition root_is (q : ratio) (x : R) := x * Rabs x = value q.
(* of cores with the differences C, of bodies with the differences G, of radii with the sum r *)
Definition says_gaps (C G : set) (radii : R) (s : signed_statement) :=
  match s with
  | Root_between st lo hi =>
      exists v, signed_depth_is G v /\ value lo <= v <= value hi /\ sign_is st v
  | Root_is st q rho optima cone => exists x r, root_is q x /\ signed_depth_is C x
      /\ r = radii /\ value rho = r /\ signed_depth_is G (x + r) /\ sign_is st (x + r)
      /\ (forall k, optima = Some k -> exits (interior G) ((x + r) * (x + r)) k)
      /\ (forall k m, cone = Some (k, m) -> cone_is (polar C) k m
            /\ (0 < r -> forall t, norm2 t = r * r -> (~ interior G t <-> polar C t)))
  end.
Definition says_signed (A B : body pt R) (s : signed_statement) :=
  says_gaps (core_gaps A B) (gaps A B) (radius A + radius B) s.
(* dimension=2 *)
Definition says_plane_signed (A B : body pt R) (s : signed_statement) :=
  says_gaps (upright (core_gaps A B)) (upright (gaps A B)) (radius A + radius B) s.

(* ==== 4. Contact patches and rates ==== *)
Definition cross (u v : pt) :=
  mk (py u * pz v - pz u * py v) (pz u * px v - px u * pz v) (px u * py v - py u * px v).
(* C is the hull of ps, each there once, and none in the hull of the others [round_cornered] *)
Definition cornered (C : set) (ps : list pt) := (forall p, C p <-> conv ps p) /\ NoDup ps
  /\ forall p, In p ps -> ~ hull (fun q => In q ps /\ q <> p) p.
(* of cores at the signed depth d: d n is a shortest way out, or brings them together *)
Definition optimal (G : set) (d : R) (n : pt) := norm2 n = 1 /\ forall g, G g -> dot n g <= d.
(* the points of A's core that are in B's when A has been moved by d n [body_patch_moved] *)
Definition patch_of A B d n p := in_core (core_of A) p /\ in_core (core_of B) (add p (scal d n)).
(* A's point p has the velocity v + w x p: how fast the plane with the normal n is left behind *)
Definition speed (v w n p : pt) : R := - dot n (add v (cross w p)).
(* r: the least, over all optimal n, of the greatest speed on the patch [patched_verdict_rates] *)
Definition rate_is (A B : body pt R) (d : R) (v w : pt) (r : R) :=
  (forall n, optimal (core_gaps A B) d n -> exists p, patch_of A B d n p /\ r <= speed v w n p)
  /\ exists n, optimal (core_gaps A B) d n /\ forall p, patch_of A B d n p -> speed v w n p <= r.

(* patches=k+..: the corners on each of the directions listed; whole: these are all; rates=k *)
Record rate := Rate { rate_v : point; rate_w : point; rate_square : ratio; rate_unit : Z }.
Record patched_statement := Patched_statement { depth_says : signed_statement; whole : bool;
  corners_at : list (point * list point); rates_are : list rate }.
Definition directed (n u : pt) := norm2 u = 1 /\ exists k, 0 < k /\ u = scal k n.
Definition says_patched (A B : body pt R) (s : patched_statement) :=
  says_signed A B (depth_says s) /\ exists d, signed_depth_is (core_gaps A B) d
  /\ (forall n ps, In (n, ps) (corners_at s) -> exists u, directed (real n) u
        /\ optimal (core_gaps A B) d u /\ cornered (patch_of A B d u) (map real ps))
  /\ (whole s = true -> forall u, optimal (core_gaps A B) d u ->
        exists n ps, In (n, ps) (corners_at s) /\ directed (real n) u)
  /\ (forall st q rho k cone, depth_says s = Root_is st q rho (Some k) cone ->
        Z.of_nat (length (corners_at s)) = k)
  /\ (forall r, In r (rates_are s) -> exists x, root_is (rate_square r) x
        /\ rate_is A B d (real (rate_v r)) (real (rate_w r)) x).

(* ==== 5. Closed meshes, and the pieces of their solids ==== *)
Record triangle := Triangle { corner_1 : pt; corner_2 : pt; corner_3 : pt }.
Definition tips (T : triangle) := [corner_1 T; corner_2 T; corner_3 T].
Definition front T := cross (sub (corner_2 T) (corner_1 T)) (sub (corner_3 T) (corner_1 T)).
(* the ray from x along v leaves T through its front, or enters there, or does neither *)
Definition hits (x v : pt) (T : triangle) := exists s, 0 < s /\ conv (tips T) (add x (scal s v)).
Definition crossing_is (x v : pt) (T : triangle) (k : Z) := let d := dot (front T) v in
  k = 1%Z /\ hits x v T /\ 0 < d \/ k = (-1)%Z /\ hits x v T /\ d < 0
  \/ k = 0%Z /\ ~ (hits x v T /\ d <> 0).
Fixpoint sum_is {T : Type} (f : T -> Z -> Prop) (l : list T) (n : Z) :=
  match l with [] => n = 0%Z | t :: l' => exists k, f t k /\ sum_is f l' (n - k) end.
Definition winding_is (M : list triangle) (x v : pt) := sum_is (crossing_is x v) M.
Definition is_in (x : pt) (L : list pt) (k : Z) := k = 1%Z /\ conv L x \/ k = 0%Z /\ ~ conv L x.
(* x is on no plane of a triangle, and v parallel to no plane through x and an edge *)
Definition generic (M : list triangle) (x v : pt) := forall T, In T M -> front T = origin \/
  dot (front T) (sub (corner_1 T) x) <> 0 /\ forall p q, In p (tips T) -> In q (tips T) ->
    p = q \/ dot v (cross (sub p x) (sub q x)) <> 0.
(* the point of that number, from 0; the triangle of the points of these numbers *)
Definition point_at (points : list point) (i : N) := nth (N.to_nat i) (map real points) origin.
Definition real_triangle (points : list point) '(i, j, k) :=
  Triangle (point_at points i) (point_at points j) (point_at points k).

(* solid triangles=m pieces=n. The winding number depends on x alone, and is not negative; off the
   pieces' boundaries it is the number of those that hold x; they are the closure of where it is
   positive [winding_exists, triangle_crossings, tiled_overlap]. *)
Record tiling_statement := Tiling_statement { triangles_told : Z; pieces_told : Z }.
Definition says_tiling (M : list triangle) (Ps : list (list pt)) (s : tiling_statement) :=
  Z.of_nat (length M) = triangles_told s /\ Z.of_nat (length Ps) = pieces_told s /\ solid_pieces Ps
  /\ (forall x v w n, generic M x v -> generic M x w ->
        winding_is M x v n -> winding_is M x w n /\ (0 <= n)%Z)
  /\ (forall x v n, generic M x v -> (forall L, In L Ps -> conv L x -> interior (conv L) x) ->
        winding_is M x v n -> sum_is (is_in x) Ps n)
  /\ (forall p, union Ps p <-> forall e, 0 < e -> exists x v n,
        norm2 (sub x p) < e * e /\ generic M x v /\ winding_is M x v n /\ (0 < n)%Z).

(* ==== 6. Two bodies in motion ==== *)
(* where a body's origin is, and the quaternion by which it is turned, of any length *)
Record pose (V U : Type) := Pose { spot : V; scalar : U; axis : V }.
Definition length2 (o : pose pt R) := scalar o * scalar o + norm2 (axis o).
(* where its point x is: all distances are kept, and all senses [placed_rigid, placed_sense] *)
Definition placed (o : pose pt R) (x : pt) := add (spot o) (scal (/ length2 o)
  (add (scal (scalar o * scalar o - norm2 (axis o)) x)
    (scal 2 (add (scal (dot (axis o) x) (axis o)) (scal (scalar o) (cross (axis o) x)))))).
Record motion (V U : Type) := Motion { at_start : pose V U; at_end : pose V U }.
Definition mean (t : R) (u v : pt) := add (scal (1 - t) u) (scal t v).
Definition pose_at '(Motion o e : motion pt R) (t : R) := Pose (mean t (spot o) (spot e))
  ((1 - t) * scalar o + t * scalar e) (mean t (axis o) (axis e)).
Definition real_pose (o : pose point ratio) :=
  Pose (real (spot o)) (value (scalar o)) (real (axis o)).
Definition real_motion '(Motion o e) := Motion (real_pose o) (real_pose e).
(* at the time t both have a place; some points of them are at most d from each other *)
Definition have_place (M N : motion pt R) (t : R) :=
  0 <= t <= 1 /\ 0 < length2 (pose_at M t) /\ 0 < length2 (pose_at N t).
Definition as_near (A B : list pt) (M N : motion pt R) (t d : R) := exists a b, conv A a /\ conv B b
  /\ norm2 (sub (placed (pose_at M t) a) (placed (pose_at N t) b)) <= d * d.

(* until=e: from the time 0 to e they have no point in common, but maybe after i and before j where
   near=(i,j):d+.. is said, and then they are as near as d at j; at=t: at t they have one *)
Record impact_statement := Impact { until : option ratio; meet_at : option ratio;
  near_in : list (ratio * ratio * ratio) }.
Definition says_impact (A B : list pt) (M N : motion pt R) (s : impact_statement) :=
  (forall e, until s = Some e -> forall t, 0 <= t <= value e ->
    have_place M N t /\ ~ as_near A B M N t 0
    \/ exists i j d, In (i, j, d) (near_in s) /\ value i < t < value j)
  /\ (forall t, meet_at s = Some t ->
    have_place M N (value t) /\ as_near A B M N (value t) 0)
  /\ (forall i j d, In (i, j, d) (near_in s) ->
    have_place M N (value j) /\ as_near A B M N (value j) (value d)).
