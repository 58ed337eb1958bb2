(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Prints what the main theorems rest on; compared with assumptions.expected. *)
From Fathom.geometry Require Import depth kinds width minkowski wording combinations signed_depth existence rounded ways_out gaps seams patches rates_overlap rates_plane
  rates_moving.
From Fathom.soundness Require Import main corollaries facets_listed verdict_sound example cone_sound signed_sound union_sound union_example patch_sound patch_verdict_sound
  patch_example.

Print Assumptions check_sound.
Print Assumptions verdict_sound.
Print Assumptions verdict_width.
Print Assumptions every_facet_listed.
Print Assumptions no_facet_twice.
Print Assumptions check_sound_AGHRS.
Print Assumptions check_sound_translation.
Print Assumptions check_sound_width.
Print Assumptions check_sound_disjoint.
Print Assumptions check_sound_touching.
Print Assumptions accepted_agree.
Print Assumptions depth2_unique.
Print Assumptions depth_exists.
Print Assumptions nearest_points.
Print Assumptions depth_AGHRS.
Print Assumptions width_depth.
Print Assumptions facet_kinds.
Print Assumptions naive_algorithm.
Print Assumptions three_states.
Print Assumptions hull_comb.
Print Assumptions cubes_depth.
Print Assumptions cubes_verdict.
Print Assumptions forgeries_refused.
Print Assumptions signed_verdict_sound.
Print Assumptions theorem_R.
Print Assumptions signed_depth_exists.
Print Assumptions gaps_meet.
Print Assumptions shortest_translation.
Print Assumptions R_least.
Print Assumptions R_most.
Print Assumptions signed_depth_unique.
Print Assumptions signed_depth_within.
Print Assumptions signed_depth_depth.
Print Assumptions signed_depth_touch.
Print Assumptions ways_out_touch.
Print Assumptions cone_sound.
Print Assumptions union_verdict_sound.
Print Assumptions union_check_sound.
Print Assumptions union_deep_pairs.
Print Assumptions overlap_pairs.
Print Assumptions overlap_pieces.
Print Assumptions union_depth2_unique.
Print Assumptions union_depth2_whole.
Print Assumptions seam_depth.
Print Assumptions seam_verdict.
Print Assumptions unions_refused.
Print Assumptions patched_verdict_sound.
Print Assumptions check_patch_sound.
Print Assumptions round_cornered.
Print Assumptions body_patch_moved.
Print Assumptions rate_unique.
Print Assumptions patched_verdict_rates.
Print Assumptions patched_verdict_rates_half_space.
Print Assumptions rate_points.
Print Assumptions rate_plane.
Print Assumptions rate_half_space_moves.
Print Assumptions cubes_patch.
Print Assumptions cubes_rates.
Print Assumptions patch_forgeries_refused.
