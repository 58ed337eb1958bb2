(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The lines of a certificate file, one at a time, and the fields of a line. *)

(* what the grammar forbids: the line, and what was expected there *)
exception Malformed of int * string

type text =
  | Whole of string
  | Cut_off of string (* the last line, without its line feed *)
  | Too_long
  | No_more

type t = {
  channel : in_channel;
  block : bytes;
  mutable start : int;
  mutable stop : int;
  mutable number : int; (* of the line at hand, from 1 *)
  mutable text : text;
  mutable bytes : int; (* of this certificate so far *)
  mutable numbers : int;
}

(* verify/check/FORMAT.md, section 8 *)
let longest_line = 16_777_216
let longest_number = 100_000
let most_bytes = 1_000_000_000
let most_numbers = 10_000_000

(* so many digits fit into OCaml's integers: of 63 bits, or of 32 in a browser *)
let few_digits = if Sys.int_size >= 63 then 18 else 9

let refill r =
  r.start <- 0;
  r.stop <- input r.channel r.block 0 (Bytes.length r.block);
  r.stop > 0

(* any line, a comment too *)
let step r =
  let line = Buffer.create 80 in
  let any = ref false and ended = ref false and long = ref false in
  while (not !ended) && (r.start < r.stop || refill r) do
    any := true;
    let stop =
      match Bytes.index_from_opt r.block r.start '\n' with Some i when i < r.stop -> ended := true; i | _ -> r.stop in
    let length = stop - r.start in
    if Buffer.length line + length > longest_line then long := true else Buffer.add_subbytes line r.block r.start length;
    r.start <- (if !ended then stop + 1 else stop)
  done;
  r.number <- r.number + 1;
  r.text <-
    (if not !any then No_more
     else if !long then Too_long
     else if !ended then Whole (Buffer.contents line)
     else Cut_off (Buffer.contents line))

let has_prefix p s = String.length s >= String.length p && String.sub s 0 (String.length p) = p

let count_bytes r = match r.text with Whole s | Cut_off s -> r.bytes <- r.bytes + String.length s | Too_long | No_more -> ()

let rec advance r =
  step r;
  match r.text with Whole s when has_prefix "#" s -> advance r | _ -> count_bytes r

(* the line at hand is a certificate's first *)
let begin_certificate r =
  r.bytes <- 0;
  r.numbers <- 0;
  count_bytes r

let opened channel =
  let r = { channel; block = Bytes.create 65536; start = 0; stop = 0; number = 0; text = No_more; bytes = 0; numbers = 0 } in
  advance r;
  r

(* on to the next line that begins a certificate, if the line at hand does not *)
let rec to_next_certificate r =
  match r.text with
  | No_more -> ()
  | (Whole s | Cut_off s) when has_prefix "fathom-certificate" s -> ()
  | _ -> step r; to_next_certificate r

let malformed r expected = raise (Malformed (r.number, "expected " ^ expected))

let at_hand r expected =
  if r.bytes > most_bytes then malformed r "a certificate of at most 1000000000 bytes";
  match r.text with
  | Whole s -> s
  | Cut_off _ -> malformed r (expected ^ ", but the line has no end: the text is cut off")
  | Too_long -> malformed r (expected ^ ", but the line is too long")
  | No_more -> malformed r (expected ^ ", but the text ends")

(* ---- the fields of a line, from left to right ---- *)
type fields = { lines : t; expected : string; s : string; mutable at : int }

let fields lines expected = { lines; expected; s = at_hand lines expected; at = 0 }
let wrong f = malformed f.lines f.expected

(* that many numbers stand on the line *)
let spend f count =
  f.lines.numbers <- f.lines.numbers + count;
  if f.lines.numbers > most_numbers then malformed f.lines "a certificate of at most 10000000 numbers"
let at_end f = f.at = String.length f.s
let finish f = if not (at_end f) then wrong f

let literal f word =
  let n = String.length word in
  if String.length f.s - f.at < n || String.sub f.s f.at n <> word then wrong f;
  f.at <- f.at + n

let blank f = literal f " "

let natural f =
  let first = f.at in
  while f.at < String.length f.s && f.s.[f.at] >= '0' && f.s.[f.at] <= '9' do f.at <- f.at + 1 done;
  let n = f.at - first in
  if n = 0 then wrong f;
  if n > longest_number then malformed f.lines "numbers of at most 100000 digits";
  if n <= few_digits then Z.of_int (int_of_string (String.sub f.s first n)) else Z.of_substring f.s ~pos:first ~len:n

let integer f =
  if f.at < String.length f.s && f.s.[f.at] = '-' then (f.at <- f.at + 1; Z.neg (natural f)) else natural f

let rational f =
  let num = integer f in
  if f.at < String.length f.s && f.s.[f.at] = '/' then begin
    f.at <- f.at + 1;
    let den = natural f in
    if Z.equal den Z.zero then wrong f;
    Q.make num den
  end
  else Q.of_bigint num
