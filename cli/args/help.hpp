// SPDX-License-Identifier: GPL-3.0-or-later
// The words of --help. Examples come first.
#pragma once

#include <string>
#include <string_view>

namespace fathom::cli {

inline constexpr std::string_view general_examples =
    "Examples\n"
    "  fathom depth a.off b.stl                 how deep do two bodies overlap? exactly, with the shortest way out\n"
    "  fathom depth --json a.obj b.ply          the same as one JSON object, with every exact field\n"
    "  fathom depth --json cases.jsonl          many pairs: one case per line in, one result per line out\n"
    "  program | fathom depth --json -          the same as a filter: no answer waits for the next case\n"
    "  fathom width a.off                       the exact width of one body\n"
    "  fathom approx --delta 1/100 a.off b.stl  a way out at most 1/100 longer than the shortest\n"
    "  fathom ray --direction 0,0,1 a.off b.stl how far must A move that way?\n"
    "  fathom metric --ball q.off a.off b.stl   depth in a polyhedral norm or gauge with the unit ball q.off\n"
    "  fathom study a.off b.stl                 what is degenerate about two bodies, by name and in counts\n"
    "  fathom cases --family near_ties          test cases by name, as input for the others\n"
    "  fathom certify --adapter libccd-epa cases.jsonl\n"
    "                                           where is a library wrong, and by how much?\n"
    "  fathom check proof.cert                  is this certificate a proof? by a checker that shares nothing with the rest\n"
    "  fathom golden verify DIR                 is this golden data true, to the last value?\n"
    "  fathom depth --help                      every option of a command\n";

inline constexpr std::string_view depth_examples =
    "Examples\n"
    "  fathom depth a.off b.stl                 exact depth, direction, translation, contact, ties\n"
    "  fathom depth --digits 50 a.off b.stl     with the depth enclosed to 50 digits\n"
    "  fathom depth --exact a.off b.stl         fractions and integers in full, where else decimals stand\n"
    "  fathom depth --json --counters a.off b.off\n"
    "                                           one JSON object, with what the run did\n"
    "  fathom depth --json --optima 10 a.off b.off\n"
    "                                           with ten of the ties listed, and all of them counted\n"
    "  fathom depth --pose-b 'xyz=0,0,1.5 rpy=0,0,45deg' a.off b.off\n"
    "                                           B turned by 45 degrees about z, then moved\n"
    "  fathom depth --exact-decimals a.obj b.obj\n"
    "                                           0.1 means 1/10, not the nearest binary64\n"
    "  fathom depth --certificate proof.cert a.off b.off\n"
    "                                           with a proof that others can check\n"
    "  fathom depth --method naive a.off b.off  the slow independent twin\n"
    "  fathom depth --method shallow a.off b.off\n"
    "                                           the same answer, sooner for large bodies that overlap a little\n"
    "  fathom depth cases.jsonl                 a stream: one line per case\n"
    "  fathom depth --certificate proofs cases.jsonl\n"
    "                                           and one file for each case in the folder proofs\n"
    "  program | fathom depth --json -          the same from standard input\n";

inline constexpr std::string_view width_examples =
    "Examples\n"
    "  fathom width a.off                       the least distance of two parallel planes with the body between them\n"
    "  fathom width --json a.stl                one JSON object\n"
    "  fathom width --delta 1/100 a.off         within a factor of 1 + 1/100, by rays\n"
    "  fathom width --json cases.jsonl          for a stream: the width of body a of each case\n"
    "  program | fathom width --json -          the same from standard input\n";

inline constexpr std::string_view approx_examples =
    "Examples\n"
    "  fathom approx --delta 1/100 a.off b.stl  a separating translation, exact, at most 1 + 1/100 times as long as the depth\n"
    "  fathom approx --delta 0.5 --json a.off b.stl\n"
    "                                           one JSON object, with a lower bound of the depth; 0.5 means 1/2\n"
    "  fathom approx cases.jsonl                a stream: one line per case\n";

inline constexpr std::string_view ray_examples =
    "Examples\n"
    "  fathom ray --direction 0,0,1 a.off b.stl how far up must A move until the interiors are disjoint? exactly\n"
    "  fathom ray --direction=-1/3,0,0.1 --json a.off b.stl\n"
    "                                           one JSON object, with the facet that stops A; 0.1 means 1/10\n"
    "  program | fathom ray --direction 1,0,0 - the same direction for every case of a stream\n";

inline constexpr std::string_view metric_examples =
    "Examples\n"
    "  fathom metric --ball q.off a.off b.stl   the depth where lengths are measured with the unit ball q.off, exactly\n"
    "  fathom metric --ball q.off --json a.off b.stl\n"
    "                                           one JSON object, with every vertex of the ball that decides\n"
    "  fathom metric --ball q.off cases.jsonl   a stream: one line per case\n";

inline constexpr std::string_view study_examples =
    "Examples\n"
    "  fathom study a.off b.stl                 parallel edges, coincident normals, ties, zeros of the predicates: two tables\n"
    "  fathom study --all a.off b.stl           with the features of every coincidence\n"
    "  fathom study --json a.off b.stl          one JSON object\n"
    "  fathom study --csv cases.jsonl           a stream: a header, then one row of counts per case\n"
    "  program | fathom study --json -          the same from standard input, as JSON\n";

inline constexpr std::string_view cases_examples =
    "Examples\n"
    "  fathom cases --list                      the families, with a line on each\n"
    "  fathom cases --family near_ties --count 100 --seed 7\n"
    "                                           one case per line, schema fathom/case/1; the same on every machine\n"
    "  fathom cases --family random_sphere --count 10 --size 50 | fathom depth -\n"
    "                                           generated and answered\n"
    "  fathom cases --catalogue                 all named degenerate pairs\n"
    "  fathom cases --family all --shapes --count 50 | fathom depth -\n"
    "                                           round and curved bodies, of every family in turn\n"
    "  fathom cases --from a.obj b.obj --pose-b \"0 -1 0 1/2; 1 0 0 0; 0 0 1 0\"\n"
    "                                           two meshes as one case; B turned and moved\n"
    "  fathom cases --from-fcl error.log | fathom depth -\n"
    "                                           the pairs that FCL printed when it threw\n";

inline constexpr std::string_view certify_examples =
    "Examples\n"
    "  fathom certify --list-adapters           the libraries for which a subject is built\n"
    "  fathom certify --adapter libccd-epa tests/data/real_cases.jsonl\n"
    "                                           every case through libccd's EPA; a table of verdicts\n"
    "  fathom certify --subject ./mine --report verdicts.jsonl cases.jsonl\n"
    "                                           your own program, by the protocol of verify/PROTOCOL.md\n"
    "  fathom certify --subject ./mine --report verdicts.jsonl --resume cases.jsonl\n"
    "                                           goes on where a run was cut short\n"
    "  fathom certify --replay replies.jsonl cases.jsonl\n"
    "                                           answers that were recorded elsewhere\n"
    "  fathom cases --family near_ties --count 500 | fathom certify --adapter bullet-epa --metamorphic -\n"
    "                                           each case also swapped, moved, reordered and scaled\n"
    "  fathom certify --method exact --adapter bullet-epa --shrink small cases.jsonl\n"
    "                                           each truth found twice, by methods that share nothing; any difference is kept\n"
    "  fathom certify --subject ./mine --expect-fail known.txt --junit junit.xml cases.jsonl\n"
    "                                           in continuous integration: strict about known failures\n"
    "  fathom certify --adapter libccd-epa --shrink small --html page.html cases.jsonl\n"
    "                                           the smallest case of each verdict, and a page to look at\n";

inline constexpr std::string_view footer =
    "Meshes: OFF, OBJ, PLY, STL, or plain lines \"x y z\"; convex hulls are taken. Streams: JSON Lines, schema fathom/case/1.\n"
    "Results go to standard output, everything else to standard error.\n"
    "Exit codes: 0 fine; 1 a verdict failed; 2 usage or bad input (in a stream the other cases are still answered); 3 internal error, out "
    "of\n"
    "memory, or output that cannot be written; 4 incomplete; 130 interrupted.\n";

inline std::string footer_text() { return std::string(footer); }

/// The commands, in the order of the general help.
inline constexpr std::string_view commands[] = {"depth", "width", "approx",  "ray",   "metric",
                                                "study", "cases", "certify", "check", "golden"};

/// Commands that this version does not have yet, so that the message says so instead of calling them unknown.
inline constexpr std::string_view absent_commands[] = {"explain"};

}  // namespace fathom::cli
