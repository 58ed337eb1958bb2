// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "cli/args/arguments.hpp"
#include "cli/args/values.hpp"
#include "verify/harness/variants.hpp"
#include "verify/judge/truth.hpp"

namespace fathom::cli {
namespace {

const Values words_of_engines{nullptr, {engine_names.begin(), engine_names.end()}};

/// The values of --policy, with one example of those that have a number: "within=5%".
Values policies() {
  std::vector<std::string> words;
  for (const auto kind : judging::policy_kinds) words.push_back(judging::policy_text({kind, mpq_class(1, 20)}));
  return {wrong_policy, words};
}

Option flag(std::string commands, std::string names, std::string meaning) {
  return {std::move(commands), std::move(names), "", std::move(meaning)};
}

Option file(std::string commands, std::string names, std::string value, FileUse use, std::string meaning) {
  return {std::move(commands), std::move(names), std::move(value), std::move(meaning), {}, use};
}

/// The commands on two bodies or a stream; those among them that answer streams with several
/// threads; and all commands that place bodies by poses.
constexpr const char *on_bodies = "depth,width,approx,ray,metric,impact,study,stages,explain",
                     *on_streams = "depth,width,approx,ray,metric,impact,study,stages",
                     *with_bodies = "depth,width,approx,ray,metric,impact,study,stages,explain,cases",
                     *with_meshes = "depth,width,approx,ray,metric,impact,study,stages,explain,cases,solid,robot",
                     *with_robots = "depth,width,approx,ray,metric,impact,study,stages,explain,cases,robot",
                     *of_two = "depth,approx,ray,metric,study,stages,explain,cases";

// Meanings that options of two commands share.
const std::string pieces =
    "each body is the union of convex pieces, each of which stands for its hull: the groups of an OBJ file, the solids "
    "of an STL file, the nodes of a scene (glTF, COLLADA, 3MF), or the mesh files of a folder; another mesh, or a "
    "shape, is one piece";
const std::string pose =
    "how A is placed, exactly: \"r11 r12 r13 t1; r21 ...; r31 ...\", 4 x 4 numbers, \"xyz=X,Y,Z quat=W,X,Y,Z\" (or "
    "xyzw=X,Y,Z,W, or rpy=ROLL,PITCH,YAWdeg or rad), in the plane \"r11 r12 t1; r21 r22 t2\" or \"xy=X,Y "
    "half_angle=T\", or @FILE with one of these";

std::vector<Option> make_table() {
  return {
      {"depth,width",
       "--method",
       "NAME",
       "how: auto, exact, certificate (an expanding polytope; exact where that takes too many points), shallow (the "
       "part of B - A near O: "
       "for bodies that overlap a little), or naive (the hull of all vertex differences). auto is certificate; the "
       "result names the one "
       "that ran",
       {nullptr, {"auto", "exact", "certificate", "shallow", "naive"}}},
      {"depth,width", "--closest-lines", "NAME",
       "engine inside the exact method: cutting (the default), sampled, or naive (all pairs of lines)",
       words_of_engines},
      {"depth,width",
       "--seed",
       "N",
       "of the closest lines' random order, which changes the work and not the answer; 1 unless given",
       {wrong_integer<0, UINT64_MAX>}},
      {"depth,width",
       "--digits",
       "N",
       "add an enclosure of the depth to N significant digits. Of curved bodies, bounds so near are looked for, unless "
       "--bits says how "
       "near",
       {wrong_digits}},
      {"depth,width",
       "--bits",
       "K",
       "how near the bounds of curved bodies are to be: within 2^-K of the value, or of the bodies' extent; 40 unless "
       "given, at most 1000",
       {wrong_bits}},
      {"approx",
       "--delta",
       "DELTA",
       "the translation may be longer than the depth by a factor of 1 + DELTA; 1/100 unless given. About 4 / DELTA "
       "rays are shot",
       {wrong_delta}},
      {"ray", "--direction", "X,Y,Z", "where A is to move; X,Y in the plane", {wrong_vector}},
      flag("ray", "--growth",
           "instead of a direction: the growth distance, the least factor by which both bodies are scaled about their "
           "centers so that they touch. It is below 1 if they penetrate, above 1 if they are apart"),
      {"ray",
       "--center-a",
       "X,Y,Z",
       "with --growth: about which point A is scaled, where the bodies stand, X,Y in the plane; the mean of A's "
       "corners "
       "unless given",
       {wrong_point}},
      {"ray", "--center-b", "X,Y,Z", "the same for B", {wrong_point}},
      file("metric", "--ball", "Q", FileUse::read,
           "the unit ball: a mesh with O inside its hull. Symmetric about O it makes a norm, else a gauge"),
      file("impact", "--from", "POSE", FileUse::read,
           "where A is at t = 0, exactly: \"xyz=X,Y,Z quat=W,X,Y,Z\" (or xyzw=X,Y,Z,W, or rpy=ROLL,PITCH,YAWdeg or "
           "rad), or @FILE with it. Quaternions are not normalised: A turns by (1 - t) q0 + t q1, the shorter way"),
      file("impact", "--to", "POSE", FileUse::read, "where A is at t = 1"),
      file("impact", "--b-from", "POSE", FileUse::read, "where B is at t = 0; at rest as it is given unless given"),
      file("impact", "--b-to", "POSE", FileUse::read, "where B is at t = 1; at rest unless given"),
      {"impact",
       "--bits",
       "K",
       "the first contact is found within 2^-K, on the grid of its multiples; 40 unless given, at most 1000",
       {wrong_integer<1, 1000>}},
      {"impact",
       "--delta",
       "LENGTH",
       "bodies that come so near for 2^-K, and cannot be shown to be apart, graze each other; 2^-K of the greatest "
       "coordinate unless given",
       {wrong_fit}},
      flag("impact", "--json", "one JSON object per line, schema fathom/impact/1"),
      file("impact", "--certificate", "FILE", FileUse::placed,
           "write the proof to FILE; for a stream: a directory, one file for each case"),

      flag("approx", "--json", "one JSON object per line, schema fathom/result/2"),
      flag("ray", "--json", "one JSON object per line, schema fathom/ray/1; with --growth fathom/growth/1"),
      flag("metric", "--json", "one JSON object per line, schema fathom/metric/1"),

      {"cases",
       "--family",
       "NAMES",
       "cases of these families, in turn: names with commas between them, with * and ? for any letters; may be "
       "repeated; all: every one",
       {},
       FileUse::none,
       Repeats::lists},
      {"cases", "--count", "N", "so many, with successive seeds (1)", {wrong_integer<1, 1'000'000'000>}},
      {"cases", "--seed", "N", "the first seed (1)", {wrong_integer<0, UINT64_MAX>}},
      {"cases",
       "--size",
       "N",
       "about so many points a body, of unions pieces (the family's usual size)",
       {wrong_integer<1, 1'000'000>}},
      flag("cases", "--catalogue", "all named degenerate pairs"),
      {"cases",
       "--small-world",
       "N",
       "pair N, from 0, of all pairs of tetrahedra with corners in {0, 1, 2}^3, flat ones included, once up to the "
       "symmetries of that cube; with --count those after it too. Each says of what kind it is",
       {wrong_integer<0, UINT64_MAX>}},
      flag("cases", "--list", "the families, with a line on each"),
      flag("cases", "--from", "the meshes A and B as one case, vertices as read"),
      flag("cases", "--shapes",
           "after --list, --catalogue, --family all: those of round and curved bodies, not those of polytopes"),
      flag("cases", "--unions", "likewise: those of bodies that are not convex, as unions of convex pieces"),
      flag("cases", "--plane", "after --list, --family all: those of bodies of the plane"),
      file("cases", "--from-fcl", "FILE", FileUse::read,
           "the failures in a log or a text of FCL (\"Error with configuration\"; -: standard input): boxes and Convex "
           "with their poses; "
           "the "
           "placed points are rounded once to binary64"),

      {with_meshes, "first", "", ""},
      {with_bodies, "second", "", ""},
      flag(with_meshes, "--exact-decimals", "decimals in text meshes are exact, instead of the nearest binary64"),
      file(of_two, "--pose-a", "POSE", FileUse::read, pose),
      file("width", "--pose-a,--pose", "POSE", FileUse::read, pose),
      file(of_two, "--pose-b", "POSE", FileUse::read, "the same for B"),
      {with_robots,
       "--joints",
       "NAME=VALUE,...",
       "of robots, FILE.urdf#LINK: where joints stand, in radians or lengths; the others at 0, or at the limit that is "
       "nearest to 0. A joint that mimics another follows it",
       {wrong_joints}},
      {with_robots,
       "--package-path",
       "DIR",
       "of robots: a folder in which package://NAME/... is looked for, as DIR/NAME or as a package DIR of that name; "
       "may be repeated. Meshes are read from there and from the folder of the robot's file alone",
       {},
       FileUse::read,
       Repeats::each},
      flag(on_bodies, "--require-convex",
           "a mesh with faces that is not convex is an error, exit code 2; else its hull is taken, and the result says "
           "so"),
      {on_streams,
       "--threads",
       "N",
       "cases of a stream that are answered at once; as many as there are cores unless given. The output is the same "
       "with any number",
       {wrong_threads}},
      file("depth,width", "--certificate", "FILE", FileUse::placed,
           "write the proof of the answer to FILE; for a stream: a directory, one file for each case"),
      flag("depth,width", "--embed-certificate", "with --json: add the proof to each result"),
      file("depth", "--svg", "FILE", FileUse::placed,
           "draw the bodies and the way out as SVG to FILE; for a stream: a directory, one file for each case; with "
           "--along: the curve"),
      flag("depth,width", "--counters", "add what the run did, in counts"),
      flag("depth,width,approx,ray,metric,impact,solid,robot", "--exact",
           "text: the exact numbers, as fractions in full and directions as integers, where else the nearest decimals "
           "stand"),
      {"approx,ray", "--digits", "N", "add an enclosure of the length to N significant digits", {wrong_digits}},
      flag("depth,width", "--json", "one JSON object per line, schema fathom/result/2"),
      {"width", "--delta", "DELTA", "approximate within a factor of 1 + DELTA, by rays", {wrong_delta}},
      {"depth", "--optima", "N", "count all ties, and list the first N; without it all are listed", {wrong_optima}},
      {"depth",
       "--along",
       "X,Y,Z[,WX,WY,WZ]",
       "the signed depth along a path instead: A is moved by s X,Y,Z for s from 0 to 1, and before that turned about "
       "the origin by the quaternion (1, s W/2), if there is a W. It is positive while the bodies penetrate, 0 when "
       "they touch, and minus the distance when they are apart: one continuous curve, exact at each step. Of bodies "
       "of the plane X,Y[,W]",
       {wrong_motion}},
      {"depth",
       "--steps",
       "N",
       "with --along: how many steps the path has; 32 unless given",
       {wrong_integer<1, 1'000'000>}},
      flag("depth", "--csv", "with --along: a header, then one row for each place"),
      flag(
          "depth", "--patch",
          "add where the bodies touch after each shortest way out: all contact points, with the features that they are "
          "on; and whether the depth is smooth there, with its gradient by the pose"),
      {"depth",
       "--patch-slack",
       "LENGTH",
       "with --patch: each patch also with slack, all contact points along the way out that are at most LENGTH short "
       "of "
       "touching after it",
       {wrong_tolerance}},
      {"depth",
       "--twist",
       "VX,VY,VZ,WX,WY,WZ",
       "add how fast the signed depth changes while A begins to move, its point p with the velocity V + W x p: exact, "
       "from one side. Of bodies of the plane VX,VY,W",
       {wrong_twist}},
      {"explain",
       "--twist",
       "VX,VY,VZ,WX,WY,WZ",
       "follow this motion of A, its point p with the velocity V + W x p at first, in place of the four usual "
       "ones, and add how fast the signed depth then changes: exact, from one side",
       {wrong_twist}},
      {"depth,explain", "--twist-b", "VX,VY,VZ,WX,WY,WZ", "the same for B, alone or beside --twist", {wrong_twist}},
      flag("depth", "--pieces", pieces + ". With --json one object, schema fathom/union/1"),
      flag("explain", "--pieces", pieces),
      flag("robot", "--pieces", "each mesh is the union of convex pieces: the groups of an OBJ file"),
      flag("robot", "--solid", "each mesh is what it goes around, convex or not, instead of its hull"),
      flag("depth,explain", "--skip-flat",
           "with --pieces: go on without pieces that are flat, and name them; else the first is an error"),
      flag("solid", "--skip-flat",
           "with --judge: go on without pieces that are flat, and name them; else the first is an error"),
      flag("depth,explain", "--solid",
           "each body is what its closed mesh goes around, convex or not, with cavities: cut into convex pieces, "
           "exactly. A mesh that is not closed, or has a part inside out, is an error. With depth --json one object, "
           "schema fathom/union/1"),
      {"depth,impact,study,stages,explain", "--case", "ID", "one case of a stream alone: the first with this id"},
      flag("study", "--all", "list every coincidence, not the first 20 of a kind (in tables: the first)"),
      flag("study", "--json", "one JSON object per line, schema fathom/study/1"),
      flag("study", "--csv", "a header, then one row of counts per case, or per size"),
      file("study", "--html", "FILE", FileUse::written,
           "write the page of explain, opened at what coincided; of a stream a table of its cases"),
      {"study", "--sweep", "FAMILY",
       "instead of two bodies: how crossings, canonical subsets and work grow with the size of this family's pairs, by "
       "the exact method; "
       "`fathom cases --list` names the families"},
      {"study",
       "--sizes",
       "LOW..HIGH",
       "with --sweep: about so many points a body. LOW..HIGH takes 1, 2 and 5 times the powers of ten in between; "
       "10..1000 unless given",
       {wrong_sizes}},
      {"study", "--closest-lines", "NAME,...",
       "with --sweep: the pairs of lines that these engines evaluate, side by side: cutting, sampled, naive (all pairs "
       "of lines)",
       words_of_engines, FileUse::none, Repeats::lists},
      flag("study", "--times", "with --sweep: add the seconds that each size took, which differ from run to run"),
      {"study", "--seed", "N", "with --sweep: of the family's pairs; 1 unless given", {wrong_integer<0, UINT64_MAX>}},
      file("study", "--svg", "FILE", FileUse::placed,
           "with --sweep: write a chart of the counts to FILE, on logarithmic axes, with the exponents of growth"),
      flag("stages", "--times", "add the seconds that each stage took, which differ from run to run"),
      flag("stages", "--json", "one JSON object per line, schema fathom/stages/1: every stage, for pictures"),
      file("stages", "--svg", "FILE", FileUse::placed,
           "draw both charts as SVG to FILE, in longitude and latitude; for a stream: a directory, one file for each "
           "case"),
      file("explain", "-o,--output", "FILE", FileUse::written, "the page: one HTML file, which needs no network"),
      file("solid", "-o,--output", "FILE", FileUse::written,
           "the pieces: an OBJ file with a group for each, exactly, for --pieces and for other programs"),
      file("solid", "--certificate", "FILE", FileUse::written,
           "write the proof that the pieces tile what the mesh goes around to FILE"),
      file(
          "solid", "--judge", "PIECES", FileUse::read,
          "judge convex pieces of another program, in groups of an OBJ file or in a folder of meshes: by which volumes "
          "do they miss the solid, stick out of it and overlap? Exit code 1 unless they tile it"),
      flag("solid", "--json", "one JSON object, schema fathom/solid/1"),
      flag("robot", "--json", "one JSON object, schema fathom/robot/1"),
      flag("explain", "--times", "add how long each stage took: then the page differs from run to run"),

      {"certify", "--subject", "COMMAND",
       "a program that speaks the protocol of verify/PROTOCOL.md, as a shell command"},
      {"certify", "--adapter", "NAME",
       "a library by the name that --list-adapters shows; its settings may follow: libccd-epa,epa_tolerance=1e-12"},
      file("certify", "--replay", "FILE", FileUse::read,
           "replies that were recorded: an optional hello, then one a line; - for standard input"),
      file("certify", "--claims", "FILE", FileUse::read,
           "judge what others have published about pairs of bodies, without a subject: one JSON object a line; - for "
           "standard input"),
      flag("certify", "--worst",
           "put the cases of verify/worst, which are part of the program, in the place of a stream: one for each class "
           "of error that libraries make"),
      flag("certify", "--list-adapters", "the names for --adapter, and whether each is built"),
      {"certify", "--jobs", "N", "subjects at once; as many as there are processors unless given", {wrong_threads}},
      {"certify", "--time-out", "S", "seconds that a case may take; 10 unless given", {wrong_time}},
      {"certify", "--tol-rel", "Q", "a depth may be wrong by Q times itself; 1/1000 unless given,", {wrong_tolerance}},
      {"certify",
       "--tol-abs",
       "Q",
       "or by Q times the longest side of the bodies; 1/1000000 unless given,",
       {wrong_tolerance}},
      {"certify",
       "--tol-ulps",
       "N",
       "or by N units in the last place; 0 unless given: the largest of the three",
       {wrong_count}},
      {"certify",
       "--fit",
       "N",
       "put each case to the subject scaled by a power of two, so that the longest side of its bodies is less than N "
       "and at least N/2",
       {wrong_fit}},
      {"certify",
       "--twist",
       "VX,VY,VZ,WX,WY,WZ",
       "ask subjects that tell it for the derivative of the signed depth while A begins to move, its point p with the "
       "velocity V + W x p, in cases without a twist of their own",
       {wrong_twist}},
      {"certify", "--twist-b", "VX,VY,VZ,WX,WY,WZ", "the same for B, alone or beside --twist", {wrong_twist}},
      {"certify",
       "--patch-slack",
       "LENGTH",
       "hold contacts against the patch with this slack, not the exact one: all lines along which the bodies overlap "
       "by "
       "the depth less LENGTH. How far it reaches beyond the contacts is reported",
       {wrong_tolerance}},
      {"certify", "--policy", "POLICY",
       "which depths pass that are the separating distance of their own direction, though a shorter way out exists: as "
       "the subject's "
       "hello claims "
       "(declared, unless given), none (minimum), all (separating), or up to P % above the depth (within=P%)",
       policies()},
      {"certify",
       "--method",
       "NAME",
       "find every truth again by exact (AGHRS's pipeline) or naive (the hull of all vertex differences), and compare "
       "it, and every "
       "judgement, field by field; may be repeated",
       {wrong_second_method, {"exact", "naive"}},
       FileUse::none,
       Repeats::each},
      file("certify", "--report", "FILE", FileUse::journal,
           "write each verdict as it is found, schema fathom/verdict/1"),
      flag("certify", "--resume", "go on with the report that is there: what it holds is not run again"),
      flag("certify", "--overwrite", "replace the report that is there"),
      flag("certify", "--all-rows", "in the table, a row for each family; else those that pass share one"),
      flag("certify", "--json", "the same lines on standard output, instead of the table"),
      {"certify", "--metamorphic{all}", "[=LIST]",
       fmt::format("each case also under symmetries, any of {} with commas between them; all without a list",
                   fmt::join(harness::variant_names, ", "))},
      file("certify", "--expect-fail", "FILE", FileUse::read_list,
           "known failures: a run that differs from the list in any way fails"),
      file("certify", "--write-expect-fail", "FILE", FileUse::written_list,
           "write such a list; comments of one that is there stay"),
      {"certify", "--max-errors", "N", "exit code 0 as long as no more cases fail", {wrong_count}},
      file("certify", "--junit", "FILE", FileUse::written, "write JUnit XML"),
      file("certify", "--html", "FILE", FileUse::written,
           "write one page with tables, histograms and pictures of failures"),
      file("certify", "--certificates", "DIR", FileUse::folder, "write the proof of the truth about each failing case"),
      file("certify", "--shrink", "DIR", FileUse::folder, "reduce one failing case of each verdict to a small one"),
      file("certify", "--harness", "FILE", FileUse::read,
           "with --shrink, your own program with @A@ and @B@ where the bodies go, as {{x, y, z}, ...}, or @A_JSON@ and "
           "@B_JSON@"),
      {"certify", "--print-input", "ID", "print what the subject reads for the case of this id, and ask nothing"},
      file("certify", "--write-requests", "FILE", FileUse::written,
           "write what the subject reads for every case, the exact answer, and which claims pass, and ask nothing: "
           "verify/examples/replay.py puts them to it without fathom"),
      {"certify", "first", "", ""},

      {"certify diff", "reports", "", "", {}, FileUse::none, Repeats::each},
      flag("certify diff", "--json", "one JSON object, schema fathom/diff/1"),
      file("certify diff", "--html", "FILE", FileUse::written, "write a page for a browser"),

      {"check", "--threads", "N",
       "how many certificates are checked at once; as many as there are cores unless given. The output is the same "
       "with any number"},
      flag("check", "--proved",
           "by the checker that was extracted from the Coq proof: alone, or with --case, --results, --echo and --width "
           "after this one"),
      {"man", "--all", "DIR", "write every page as a file into the folder, made if need be"},
  };
}

}  // namespace

bool Option::belongs_to(std::string_view command) const {
  const std::vector<std::string> owners = words_of(commands);
  return std::ranges::find(owners, command) != owners.end();
}

std::span<const Option> common_options() {
  static const std::vector<Option> table = make_table();
  return table;
}

}  // namespace fathom::cli
