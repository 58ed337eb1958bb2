(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* fathom-check-proved FILE...   checks certificates (verify/check/FORMAT.md) with the function that Coq proved sound.  - is standard input.
   One line per certificate; exit code 0 all accepted, 1 some refused, 2 some malformed, nothing there, or wrong usage. *)

let usage = "usage: fathom-check-proved CERTIFICATES...\n\
\  Checks each certificate of each file (- is standard input) with the checker extracted from Coq, and prints one line for each.\n\
\  Exit code: 0 all accepted, 1 some refused, 2 some malformed, no certificate, or wrong usage.\n"

let worst = ref 0
let verdict code line = worst := max !worst code; print_string line; print_char '\n'; flush stdout

(* printable ASCII, all else as %XX *)
let escaped name =
  let b = Buffer.create 80 in
  String.iter (fun c -> if c >= ' ' && c <= '~' && c <> '%' then Buffer.add_char b c else Printf.bprintf b "%%%02X" (Char.code c)) name;
  Buffer.contents b

let proved (g : Grammar.t) =
  match g.claim with
  | Depth q ->
    "penetrating depth_squared=" ^ Q.to_string q
    ^ if g.all then Printf.sprintf " optima=%d" (Array.length g.directions.items) else ""
  | Bounds (lo, hi) -> Printf.sprintf "penetrating depth_squared_in=[%s,%s]" (Q.to_string lo) (Q.to_string hi)
  | Touching -> "touching depth_squared=0"
  | Disjoint -> "disjoint depth_squared=0"

let refused name line reason = verdict 1 (Printf.sprintf "s REFUSED %s:%d: %s" name line reason)
let malformed name line reason = verdict 2 (Printf.sprintf "s MALFORMED %s:%d: %s" name line reason)

let judge name g =
  match Prepare.certificate g with
  | exception Prepare.Refused (line, reason) -> refused name line reason
  | c ->
    if Proved.check c then verdict 0 (Printf.sprintf "s VERIFIED %s %s" (proved g) name)
    else begin
      let line, reason = Reasons.reason g c in
      refused name line reason
    end

(* one certificate, from its first line on *)
let one (r : Lines.t) file =
  let first = r.number in
  let name = ref file in
  match Grammar.certificate r name with
  | g ->
    (try judge !name g with
     | Lines.Malformed (line, reason) -> malformed !name line reason
     | Stack_overflow | Out_of_memory -> malformed !name first "expected a certificate of a size that this checker can hold");
    Lines.advance r
  | exception Lines.Malformed (line, reason) ->
    malformed !name line reason;
    if r.number = first then Lines.step r;
    Lines.to_next_certificate r

let stream channel file =
  match Lines.opened channel with
  | exception Sys_error reason -> malformed file 1 ("expected a file that can be read: " ^ reason)
  | r ->
    (try
       one r file;
       while r.text <> Lines.No_more do one r file done
     with Sys_error reason -> malformed file r.number ("expected a file that can be read: " ^ reason))

let input name =
  let file = if name = "-" then "<stdin>" else escaped name in
  if name = "-" then (set_binary_mode_in stdin true; stream stdin file)
  else
    match open_in_bin name with
    | exception Sys_error reason -> malformed file 0 ("expected a file that can be read: " ^ escaped reason)
    | channel -> Fun.protect ~finally:(fun () -> close_in_noerr channel) (fun () -> stream channel file)

let () =
  match List.tl (Array.to_list Sys.argv) with
  | [ "--help" ] | [ "-h" ] -> print_string usage
  | words ->
    let files = match words with "--" :: rest -> rest | _ -> words in
    let is_option w = String.length w > 1 && w.[0] = '-' in
    if files = [] || (files == words && List.exists is_option words) then (prerr_string usage; exit 2);
    (try List.iter input files; flush stdout
     with Sys_error reason ->
       prerr_endline ("fathom-check-proved: cannot write: " ^ reason);
       close_out_noerr stdout;
       exit 2);
    exit !worst
