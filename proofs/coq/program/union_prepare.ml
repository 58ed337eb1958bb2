(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Format 3: what the proved function is told beside the pieces, and why it said no.  Nothing here is trusted, as in prepare.ml and
   reasons.ml. *)
open Grammar
open Union_grammar
open Prepare

let vector (x, y, z) = { Proved.zx = x; zy = y; zz = z }
let vectors part = Array.to_list (Array.map vector part.items)
let points part = Array.to_list part.items
let pieces parts = Array.to_list (Array.map points parts)

(* ---- hints ---- *)
module Places = Map.Make (struct
  type t = Q.t * Q.t * Q.t
  let compare (a, b, c) (x, y, z) =
    let first = Q.compare a x in
    if first <> 0 then first else let second = Q.compare b y in if second <> 0 then second else Q.compare c z
end)

(* the number of the optimum that is the foot point of a half-space *)
let foot_finder unit ways =
  let none = Z.of_int (List.length ways) in
  let numbered = ref Places.empty in
  let over x = Q.make x unit in
  List.iteri (fun k { Proved.zx; zy; zz } -> numbered := Places.add (over zx, over zy, over zz) (Z.of_int k) !numbered) ways;
  fun (({ Proved.zx; zy; zz } as n), c) ->
    let square = Proved.zdot n n in
    if Z.equal square Z.zero then none
    else
      let part x = Q.make (Z.mul c x) square in
      Option.value ~default:none (Places.find_opt (part zx, part zy, part zz) !numbered)

let rec determinant rows columns =
  match columns with
  | [] -> Z.one
  | _ ->
    let first = List.hd rows and rest = List.tl rows in
    let term (sign, sum) k =
      let minor = determinant rest (List.filter (( <> ) k) columns) in
      (Z.neg sign, Z.add sum (Z.mul sign (Z.mul first.(k) minor))) in
    snd (List.fold_left term (Z.one, Z.zero) columns)

(* The rule of FORMAT.md, check 5: with G the products of the normals and c the offsets, adj(G) c; if det G = 0, a column of adj(G). *)
let multipliers half_spaces =
  let constraints = Array.of_list half_spaces in
  let normals = Array.map fst constraints and offsets = Array.map snd constraints in
  let r = Array.length normals in
  if r > 4 then []
  else begin
    let gram = Array.map (fun n -> Array.map (Proved.zdot n) normals) normals in
    let all = List.init r Fun.id in
    let without i = List.filter (( <> ) i) all in
    let adjugate =
      Array.init r (fun i -> Array.init r (fun j ->
          let minor = determinant (List.map (Array.get gram) (without j)) (without i) in
          if (i + j) land 1 = 0 then minor else Z.neg minor)) in
    let times row = List.fold_left (fun sum k -> Z.add sum (Z.mul row.(k) offsets.(k))) Z.zero all in
    if Z.sign (determinant (Array.to_list gram) all) <> 0 then List.map (fun i -> times adjugate.(i)) all
    else
      (* adj(G) is symmetric: a row is a column *)
      match List.find_opt (Array.exists (fun x -> Z.sign x <> 0)) (Array.to_list adjugate) with
      | None -> []
      | Some column -> Array.to_list column
  end

(* ---- all of it ---- *)
let of_piece parts i = parts.(Z.to_int i)

let polytope g p =
  let i, j = p.pair in
  let there parts i = in_range (Array.length parts) i in
  demand p.polytope_line (there g.pieces_a i && there g.pieces_b j) "a polytope of a piece that is not there";
  let size part = Array.length part.items in
  demand_ranges (size (of_piece g.pieces_a i)) (size (of_piece g.pieces_b j)) p.vertices p.facets;
  { Proved.piece_a = i; piece_b = j; corner_points = Array.to_list p.vertices.items; sides = hinted p.facets.items }

let nearest (d : Union_limits.denominators) p =
  let near_a, near_b = p.near in
  { Proved.near_a; near_b; weight_unit = d.of_weights; near_weights_a = weights d.of_weights p.weights_a;
    near_weights_b = weights d.of_weights p.weights_b }

let claim g (d : Union_limits.denominators) =
  match g.claim with
  | Depth (q, optima, polytopes, tree) ->
    (* in units of 1/(m e), where m is the unit of the points and e that of the optima *)
    let way { Proved.qx; qy; qz } =
      let part (x : Proved.ratio) = Z.mul d.of_points (Z.mul x.num (Z.divexact d.of_optima x.den)) in
      { Proved.zx = part qx; zy = part qy; zz = part qz } in
    let ways = List.rev (Array.fold_left (fun l o -> (way o.way, vectors o.way_separations) :: l) [] optima) in
    Proved.Union_deep
      ( Q.num q, Q.den q, d.of_optima, ways, foot_finder d.of_optima (List.rev (List.rev_map fst ways)),
        Array.to_list (Array.map (polytope g) polytopes), Array.to_list tree.items, multipliers )
  | Touching p -> Proved.Union_touching (vectors p.separations, nearest d p)
  | Apart (q, p) -> Proved.Union_apart (Q.num q, Q.den q, vectors p.separations, nearest d p)

(* ---- why not: only the wording of a refusal hangs on this ---- *)
let find g m claim =
  let integral parts = Array.map (fun part -> Proved.each (Proved.integral m) (points part)) parts in
  let a = integral g.pieces_a and b = integral g.pieces_b in
  let whole line parts lists =
    demand line (Array.length parts > 0) "a body without pieces";
    Array.iteri (fun k list -> demand parts.(k).line (Proved.solid list) "the points of this piece lie in one plane") lists in
  whole g.line_a g.pieces_a a;
  whole g.line_b g.pieces_b b;
  let a = Array.to_list a and b = Array.to_list b in
  let units = Z.mul m m in
  let separate part test = demand part.line (Proved.all_pairs test a b (vectors part)) "not one separation for each pair of pieces" in
  match g.claim, claim with
  | Depth (q, optima, polytopes, tree), Proved.Union_deep (qn, qd, unit, ways, way_at, told, _, _) ->
    demand g.claim_line (Q.sign q > 0) "the squared depth is not positive";
    demand g.claim_line (Array.length optima > 0) "no optimum";
    let square = Z.mul (Z.mul qn units) (Z.mul unit unit) in
    List.iteri
      (fun k (t, _) ->
         let o = optima.(k) in
         demand o.optimum_line (Z.equal (Z.mul (Proved.zdot t t) qd) square) "this optimum is not at the depth claimed";
         separate o.way_separations (Proved.keeps_out unit t))
      ways;
    ignore (List.fold_left
        (fun (k, last) (t, _) ->
           demand optima.(k).optimum_line (match last with Some s -> Proved.before s t | None -> true) "the optima do not ascend strictly";
           (k + 1, Some t))
        (0, None) ways);
    let target =
      { Proved.square_n = Z.mul qn units; square_d = qd; way_unit = unit; ways = Proved.numbered (List.rev (List.rev_map fst ways));
        way_at } in
    let tables lists = Proved.numbered (Proved.each Proved.numbered lists) in
    let ta = tables a and tb = tables b in
    let cut k p =
      match Proved.cut_of target ta tb p with
      | Some cut -> cut
      | None -> raise (Refused (polytopes.(k).polytope_line, "this polytope has no facets, or is not convex and closed")) in
    let cuts = Proved.numbered (Array.to_list (Array.mapi cut (Array.of_list told))) in
    let left = ref [ Proved.all_of_space ] in
    Array.iteri
      (fun k node ->
         match Proved.step target cuts multipliers !left node with
         | Some cells -> left := cells
         | None ->
           raise (Refused (tree.lines_of.(k), match node with
             | _ when !left = [] -> "a node behind the tree"
             | Proved.Leaf _ -> "these constraints are not of this path, or do not put the cell as far away as is claimed"
             | Proved.Split _ -> "no such polytope or facet, or a facet without a child is near, or its optimum is not listed")))
      tree.items;
    demand tree.line (!left = []) "the tree is cut off"
  | Touching p, Proved.Union_touching (_, near) ->
    let zero = { Proved.zx = Z.zero; zy = Z.zero; zz = Z.zero } in
    separate p.separations (Proved.keeps_out Z.one zero);
    demand p.near_line (Proved.near_is (fun _ z -> Z.equal (Proved.zdot z z) Z.zero) a b near)
      "the weights are not those of one common point"
  | Apart (q, p), Proved.Union_apart (qn, qd, _, near) ->
    demand g.claim_line (Q.sign q > 0) "the squared distance is not positive";
    let qn = Z.mul qn units in
    separate p.separations (Proved.keeps_apart qn qd);
    demand p.near_line
      (Proved.near_is (fun unit z -> Z.equal (Z.mul (Proved.zdot z z) qd) (Z.mul qn (Z.mul unit unit))) a b near)
      "the weights are not those of points at this distance"
  | _ -> ()

let reason g m claim =
  match find g m claim with
  | () -> (g.claim_line, "the claim is not proved")
  | exception Refused (line, text) -> (line, text)
