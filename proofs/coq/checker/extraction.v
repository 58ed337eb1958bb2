(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The checker as OCaml, with zarith's integers for Coq's.  Beside the checker itself its parts are given out:
   the program asks them why a certificate was refused. *)
Require Import ZArith List.
From Fathom.checker Require Import vector sequence table polytope support certificate verdict body cone signed signed_verdict.
From Fathom.checker Require Import patch patch_verdict unions union_verdict tiling plane impact.
Require Import Extraction ExtrOcamlBasic ExtrOcamlZBigInt.
Extraction "proved.ml" verdict.verdict with_integers same_vectors
  make_facets numbered facet_ok bounded listed canonical tangent within height common_point zdot
  signed_verdict.signed_verdict in_units same_body height_root height_within
  patch_verdict.patched_verdict directions_of spots check_patch check_rate
  union_verdict.union_verdict solid all_pairs keeps_out keeps_apart cut_of step all_of_space near_is before integral each
  plane.plane_verdict plane.plane_signed_verdict plane.plane_union_verdict
  tiling.tiling_verdict every numbered_point centred tile_facets supporting distinct
  impact.impact_verdict integral_motion apart_on near_at.
