(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* fathom-check-proved [--width] FILE...   checks certificates (verify/check/FORMAT.md) with the function that Coq proved sound.
   - is standard input.  One line per certificate; exit code 0 all accepted, 1 some refused, 2 some malformed, nothing there, or wrong usage. *)

let usage = "usage: fathom-check-proved [--width] CERTIFICATES...\n\
\  Checks each certificate of each file (- is standard input) with the checker extracted from Coq, and prints one line for each.\n\
\  --width: also refuses a certificate whose b is not a again: its depth is the width of a.\n\
\  Exit code: 0 all accepted, 1 some refused, 2 some malformed, no certificate, or wrong usage.\n"

let worst = ref 0
let verdict code line = worst := max !worst code; print_string line; print_char '\n'; flush stdout

(* codes 33 to 126 but %, all else as %XX *)
let escaped name =
  let b = Buffer.create 80 in
  String.iter (fun c -> if c > ' ' && c <= '~' && c <> '%' then Buffer.add_char b c else Printf.bprintf b "%%%02X" (Char.code c)) name;
  Buffer.contents b

let number (r : Proved.ratio) = Z.to_string r.num ^ if Z.equal r.den Z.one then "" else "/" ^ Z.to_string r.den

(* the proved statement in words: what it means is in printed.v *)
let words : Proved.statement -> string = function
  | Depth_is (q, None) -> "penetrating depth_squared=" ^ number q
  | Depth_is (q, Some k) -> Printf.sprintf "penetrating depth_squared=%s optima=%s" (number q) (Z.to_string k)
  | Depth_between (lo, hi) -> Printf.sprintf "penetrating depth_squared_in=[%s,%s]" (number lo) (number hi)
  | They_touch -> "touching depth_squared=0"
  | They_are_apart -> "disjoint depth_squared=0"
  | Distance_is q -> "disjoint distance_squared=" ^ number q

let status : Proved.status -> string = function
  | Penetrating -> "penetrating"
  | In_touch -> "touching"
  | Disjoint_bodies -> "disjoint"
  | Undecided -> "undecided"

(* likewise of format 2 *)
let signed_words : Proved.signed_statement -> string = function
  | Root_between (s, lo, hi) -> Printf.sprintf "%s signed_depth_in=[%s,%s]" (status s) (number lo) (number hi)
  | Root_is (s, square, rho, optima, cone) ->
    let sign = if Z.sign square.num < 0 then "-" else "" in
    Printf.sprintf "%s signed_depth=%ssqrt(%s)+%s%s%s" (status s) sign (number { square with num = Z.abs square.num }) (number rho)
      (match optima with Some k -> " optima=" ^ Z.to_string k | None -> "")
      (match cone with Some (k, r) -> Printf.sprintf " cone=%s+%s" (Z.to_string k) (Z.to_string r) | None -> "")

(* likewise of format 4 *)
let patched_words (s : Proved.patched_statement) =
  let count (_, corners) = string_of_int (List.length corners) in
  signed_words s.depth_says ^ " patches=" ^ String.concat "+" (Proved.each count s.corners_at)
  ^ if s.rates_are = [] then "" else Printf.sprintf " rates=%d" (List.length s.rates_are)

(* likewise of format 3 *)
let union_words (s : Proved.union_statement) =
  Printf.sprintf "%s pieces=%sx%s" (words s.union_says) (Z.to_string s.pieces_a) (Z.to_string s.pieces_b)

(* likewise of format 5 *)
let tiling_words (s : Proved.tiling_statement) =
  Printf.sprintf "solid triangles=%s pieces=%s" (Z.to_string s.triangles_told) (Z.to_string s.pieces_told)

(* likewise of format 6 *)
let impact_words (s : Proved.impact_statement) =
  let said word = function Some t -> word ^ number t | None -> "" in
  let near ((i, j), d) = Printf.sprintf "(%s,%s):%s" (number i) (number j) (number d) in
  (match s.meet_at, s.near_in with Some _, _ -> "contact" | None, [] -> "apart" | None, _ -> "grazing")
  ^ said " until=" s.until ^ said " at=" s.meet_at
  ^ if s.near_in = [] then "" else " near=" ^ String.concat "+" (Proved.each near s.near_in)

let refused name line reason = verdict 1 (Printf.sprintf "s REFUSED %s:%d: %s" name line reason)
let malformed name line reason = verdict 2 (Printf.sprintf "s MALFORMED %s:%d: %s" name line reason)

let too_large = "expected a certificate of a size that this machine can hold"

(* the words of bodies of the plane *)
let stated in_words plane s = in_words s ^ if plane = None then "" else " dimension=2"

let judge ~width name (given : Grammar.t) =
  let g = Grammar.raised given in
  let denominators = Limits.within g in
  let highest = match g.claim with Depth q -> q | Bounds (_, hi) -> hi | Touching | Disjoint -> Q.zero in
  match Prepare.demand_height ~width g.plane Q.zero highest; Prepare.claim g denominators with
  | exception Prepare.Refused (line, reason) -> refused name line reason
  | claim ->
    let m = denominators.of_points in
    let a = Array.to_list g.a.items and b = Array.to_list g.b.items in
    let found =
      match g.plane with
      | None -> Proved.verdict width m a b claim
      | Some { height; _ } -> Proved.plane_verdict m (Grammar.ratio height) a (Array.to_list given.b.items) claim in
    match found with
    | Some statement -> verdict 0 (Printf.sprintf "s VERIFIED %s %s" (stated words g.plane statement) name)
    | None ->
      let line, reason = Reasons.reason ~width g (Proved.with_integers m a b claim) in
      refused name line reason

let judge_signed ~width name (given : Signed_grammar.t) =
  let g = Signed_grammar.raised given in
  let denominators = Signed_limits.within g in
  let highest = match g.claim with Depth q -> q | _ -> Q.zero in
  match Prepare.demand_height ~width g.plane (Signed_prepare.rho g) highest; Signed_prepare.claim g denominators with
  | exception Prepare.Refused (line, reason) -> refused name line reason
  | claim ->
    let m = denominators.of_lengths in
    let rho = Grammar.ratio (Signed_prepare.rho g) in
    let a = Signed_grammar.proved_body given.a and b = Signed_grammar.proved_body given.b in
    let found =
      match g.plane with
      | None -> Proved.signed_verdict width m rho a b claim
      | Some { height; _ } -> Proved.plane_signed_verdict m rho (Grammar.ratio height) a b claim in
    match found with
    | Some statement -> verdict 0 (Printf.sprintf "s VERIFIED %s %s" (stated signed_words g.plane statement) name)
    | None ->
      let line, reason = Signed_prepare.reason ~width g m claim in
      refused name line reason

let judge_patched ~width name (g : Patch_grammar.t) =
  let denominators = Patch_limits.within g in
  match Patch_prepare.claim g denominators with
  | exception Prepare.Refused (line, reason) -> refused name line reason
  | claim ->
    let m = denominators.of_lengths in
    let rho = Grammar.ratio (Signed_prepare.rho g.signed) in
    let a = Signed_grammar.proved_body g.signed.a and b = Signed_grammar.proved_body g.signed.b in
    match Proved.patched_verdict width m rho a b claim with
    | Some statement -> verdict 0 (Printf.sprintf "s VERIFIED %s %s" (patched_words statement) name)
    | None ->
      let base_holds = Proved.signed_verdict width m rho a b claim.base <> None in
      let line, reason = Patch_prepare.reason ~width g m claim base_holds in
      refused name line reason

(* the depth of a union in itself is no width *)
let judge_union ~width name (given : Union_grammar.t) =
  let g = Union_grammar.raised given in
  let denominators = Union_limits.within g in
  let highest = match g.claim with Depth (q, _, _, _) -> q | _ -> Q.zero in
  let claim () =
    Prepare.demand g.line_a (not width) "a union, which has no width";
    Prepare.demand_height ~width g.plane Q.zero highest;
    Union_prepare.claim g denominators in
  match claim () with
  | exception Prepare.Refused (line, reason) -> refused name line reason
  | claim ->
    let m = denominators.of_points in
    let a = Union_prepare.pieces given.pieces_a and b = Union_prepare.pieces given.pieces_b in
    let found =
      match g.plane with
      | None -> Proved.union_verdict m a b claim
      | Some { height; _ } -> Proved.plane_union_verdict m (Grammar.ratio height) a b claim in
    match found with
    | Some statement -> verdict 0 (Printf.sprintf "s VERIFIED %s %s" (stated union_words g.plane statement) name)
    | None ->
      let line, reason = Union_prepare.reason g m claim in
      refused name line reason

let judge_tiling ~width name (g : Tiling_grammar.t) =
  Tiling_limits.within g;
  match if width then raise (Prepare.Refused (g.points.line, "a solid, which has no width here")) else Tiling_prepare.tiles g with
  | exception Prepare.Refused (line, reason) -> refused name line reason
  | tiles ->
    let points = Array.to_list g.points.items and mesh = Array.to_list g.mesh.items in
    match Proved.tiling_verdict Tiling_prepare.common (Tiling_prepare.slots ()) points mesh (Array.to_list tiles) with
    | Some statement -> verdict 0 (Printf.sprintf "s VERIFIED %s %s" (tiling_words statement) name)
    | None ->
      let line, reason = Tiling_prepare.reason g tiles in
      refused name line reason

let judge_impact ~width name (g : Impact_grammar.t) =
  let units = Impact_prepare.within g in
  match if width then raise (Prepare.Refused (g.a.line, "bodies in motion, which have no width")) else Impact_prepare.claim units g with
  | exception Prepare.Refused (line, reason) -> refused name line reason
  | claim ->
    let a = Array.to_list g.a.items and b = Array.to_list g.b.items in
    let of_a, of_b = g.motions in
    match Proved.impact_verdict units.of_points units.of_turns a b of_a of_b claim with
    | Some statement -> verdict 0 (Printf.sprintf "s VERIFIED %s %s" (impact_words statement) name)
    | None ->
      let line, reason = Impact_prepare.reason units g in
      refused name line reason

(* of any format, its last line and its judge *)
let read ~width r name =
  match Grammar.format_of r with
  | 1 -> let g = Grammar.certificate r name in (g.end_line, fun () -> judge ~width !name g)
  | 2 -> let g = Signed_grammar.certificate r name in (g.end_line, fun () -> judge_signed ~width !name g)
  | 4 -> let g = Patch_grammar.certificate r name in (g.signed.end_line, fun () -> judge_patched ~width !name g)
  | 6 -> let g = Impact_grammar.certificate r name in (g.end_line, fun () -> judge_impact ~width !name g)
  | 5 -> let g = Tiling_grammar.certificate r name in (g.end_line, fun () -> judge_tiling ~width !name g)
  | _ -> let g = Union_grammar.certificate r name in (g.end_line, fun () -> judge_union ~width !name g)

(* one certificate, from its first line on *)
let one ~width (r : Lines.t) file =
  let first = r.number in
  let name = ref file in
  match read ~width r name with
  | end_line, judge ->
    (try judge () with
     | Lines.Malformed (line, reason) -> malformed !name line reason
     | Stack_overflow | Out_of_memory -> malformed !name end_line too_large);
    Lines.advance r
  | exception (Lines.Malformed _ | Stack_overflow | Out_of_memory as fault) ->
    let line, reason = match fault with Lines.Malformed (line, reason) -> (line, reason) | _ -> (r.number, too_large) in
    malformed !name line reason;
    if r.number = first then Lines.step r;
    Lines.to_next_certificate r

(* whatever comes of it, the next file is judged *)
let stream ~width channel file =
  let line = ref 1 in
  try
    let r = Lines.opened channel in
    let next () = line := r.number; one ~width r file in
    next ();
    while r.text <> Lines.No_more do next () done
  with
  | Sys_error reason -> malformed file 0 ("expected a file that can be read: " ^ reason)
  | Stack_overflow | Out_of_memory -> malformed file !line too_large

let input ~width name =
  let file = if name = "-" then "<stdin>" else escaped name in
  if name = "-" then (set_binary_mode_in stdin true; stream ~width stdin file)
  else
    match open_in_bin name with
    | exception Sys_error reason -> malformed file 0 ("expected a file that can be read: " ^ escaped reason)
    | channel -> Fun.protect ~finally:(fun () -> close_in_noerr channel) (fun () -> stream ~width channel file)

(* options and files; none: the words make no sense *)
let rec understood ~width files = function
  | "--" :: rest -> finish ~width (List.rev_append rest files)
  | "--width" :: rest -> understood ~width:true files rest
  | word :: _ when String.length word > 1 && word.[0] = '-' -> None
  | word :: rest -> understood ~width (word :: files) rest
  | [] -> finish ~width files
and finish ~width files = if files = [] then None else Some (width, List.rev files)

let work () =
  match List.tl (Array.to_list Sys.argv) with
  | [ "--help" ] | [ "-h" ] -> print_string usage
  | words ->
    match understood ~width:false [] words with
    | None -> prerr_string usage; worst := 2
    | Some (width, files) -> List.iter (input ~width) files

let () =
  (try work (); flush stdout
   with Sys_error reason ->
     prerr_endline ("fathom-check-proved: cannot write: " ^ reason);
     close_out_noerr stdout;
     worst := 2);
  exit !worst
