// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of --help, of the man pages and of completion: the table of commands. Options are in
// options.cpp. A test runs every example on the files in examples/data.

#include "cli/args/help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/args/values.hpp"
#include "cli/io/output.hpp"
#include "verify/check/run.hpp"

namespace fathom::cli {
namespace {

constexpr Example diff_examples[] = {
    {"fathom certify --replay replies.jsonl --report after.jsonl cases.jsonl",
     "a report of a second version; the first is verdicts.jsonl"},
    {"fathom certify diff verdicts.jsonl after.jsonl",
     "which cases changed their verdict, and whose error changed most"},
    {"fathom certify diff --html diff.html verdicts.jsonl after.jsonl", "and the same as a page"},
    {"fathom certify diff --json verdicts.jsonl after.jsonl", "as one JSON object"},
};

constexpr ExitMeaning diff_exits[] = {
    {0, "no case that did not fail before fails now"},
    {1, "some do"},
    {2, "usage, or a file that is no report"},
    {3, "internal error, out of memory, or output that cannot be written"},
    {130, "interrupted"},
};

constexpr std::string_view diff_notes[] = {
    "Reports are what certify --report writes, of two versions of a subject, of one with other settings, or of two "
    "subjects. Cases are "
    "told "
    "apart by their ids. Errors are in parts of the largest coordinate of a pair.",
};

constexpr Example golden_examples[] = {
    {"fathom golden generate --level L0 --out data",
     "cases with their exact answers, rounded answers and proofs, in the folder data"},
    {"fathom golden verify data", "proves every value in it, or says what is wrong"},
    {"fathom golden export --format c --count 50 data > golden_cases.h",
     "fifty of its cases, for the tests of another project"},
};

constexpr Example generate_examples[] = {
    {"fathom golden generate --level L0 --seed 1 --out data",
     "the same bytes on every machine; after an interrupt or a kill, the same line goes on"},
    {"fathom golden generate --level L0 --out part --shard 3/8",
     "the third of eight machines; when all are done, the line without --shard completes it"},
    {"mpirun -np 4 fathom golden generate --level L0 --out together",
     "four processes, which take shard after shard; Open MPI wants --oversubscribe for more processes than cores, and "
     "--allow-run-as-root of root"},
    {"fathom golden generate --level P0 --out shapes",
     "spheres, capsules, cylinders and their like; U0: unions of convex pieces; C0: contact patches and gradients; "
     "F0: bodies of the plane"},
    {"zstd -dc data/golden-L0-*.jsonl.zst | fathom depth --json -", "the records are cases for every other command"},
};

constexpr Example verify_examples[] = {
    {"fathom golden verify data", "sums, schemas, counts, every certificate, every value"},
    {"fathom golden verify --method exact data", "the same, and every value computed again by AGHRS's pipeline"},
    {"fathom golden verify --method exact --method naive --state data",
     "by two methods; agreement.json in data then says so"},
    {"zstd -dc data/*.cert.zst | fathom check -", "the certificates alone, by the independent checker"},
};

constexpr Example export_examples[] = {
    {"fathom golden export --format c --exclude flat,huge --max-points 8 --count 50 data > golden_cases.h",
     "C89 arrays, and a function that accepts answers or not"},
    {"fathom golden export --format json --exclude disjoint,touching data > golden_cases.json",
     "all bodies that overlap, for whoever reads JSON"},
    {"fathom golden export --format c --contact edge-edge --only thin_penetration --exact-in binary32 data > "
     "nearly_touching.h",
     "edges across each other that hardly overlap, for a program in float"},
    {"fathom golden export --format json --certificates own.cert cases.jsonl > own.json",
     "one's own cases with their exact answers; fathom check --case own.json own.cert proves them"},
};

constexpr ExitMeaning golden_exits[] = {
    {0, "fine, or verified"},
    {1, "refused"},
    {2, "usage, or a folder that holds something else or cannot be read"},
    {3, "internal error, or files cannot be written"},
    {130, "interrupted"},
};

constexpr std::string_view golden_notes[] = {
    "A release is a folder of zstd files, shard by shard: records as JSON Lines, certificates; of polytopes CSV too. "
    "Its NOTES.md explains every field. The data is in the public domain (CC0-1.0).",
};

constexpr Example general_examples[] = {
    {"fathom depth a.off b.stl", "how deep do two bodies overlap? exactly, with the shortest way out"},
    {"fathom depth --json a.obj b.ply", "the same as one JSON object, with every exact field"},
    {"fathom depth --json cases.jsonl", "many pairs: one case per line in, one result per line out"},
    {"cat cases.jsonl | fathom depth --json -", "the same as a filter: no answer waits for the next case"},
    {"fathom width a.off", "the exact width of one body"},
    {"fathom approx --delta 1/100 a.off b.stl", "a way out at most 1/100 longer than the shortest"},
    {"fathom ray --direction 0,0,1 a.off b.stl", "how far must A move that way?"},
    {"fathom metric --ball q.off a.off b.stl", "depth in a polyhedral norm or gauge with the unit ball q.off"},
    {"fathom study a.off b.stl", "what is degenerate about two bodies, by name and in counts"},
    {"fathom stages --json a.off b.stl", "what the exact method makes on its way: the data of all pictures"},
    {"fathom explain a.off b.stl -o page.html", "why? one page with pictures of every stage"},
    {"fathom solid a.off", "is a mesh closed, and of how many convex pieces is what it goes around?"},
    {"fathom robot arm.urdf", "which links of a robot overlap?"},
    {"fathom cases --family near_ties", "test cases by name, as input for the others"},
    {"fathom certify --adapter libccd-epa cases.jsonl", "where is a library wrong, and by how much?"},
    {"fathom check proof.cert", "is this certificate a proof? by a checker that shares nothing with the rest"},
    {"fathom golden verify data", "is this golden data true, to the last value?"},
    {"fathom depth --help", "every option of a command; so does fathom help depth"},
};

constexpr Example depth_examples[] = {
    {"fathom depth a.off b.stl", "exact depth, direction, translation, contact, ties"},
    {"fathom depth --digits 50 a.off b.stl", "with the depth enclosed to 50 digits"},
    {"fathom depth --exact a.off b.stl", "fractions and integers in full, where else decimals stand"},
    {"fathom depth --json --counters a.off b.off", "one JSON object, with what the run did"},
    {"fathom depth --json --optima 10 a.off b.off", "with ten of the ties listed, and all of them counted"},
    {"fathom depth --pose-b 'xyz=0,0,1.5 rpy=0,0,45deg' a.off b.off", "B turned by 45 degrees about z, then moved"},
    {"fathom depth --exact-decimals a.obj b.obj", "0.1 means 1/10, not the nearest binary64"},
    {"fathom depth --certificate proof.cert a.off b.off", "with a proof that others can check"},
    {"fathom depth --svg way_out.svg a.off b.off", "with a picture: both bodies, the way out, the contact"},
    {"fathom depth --method naive a.off b.off", "the slow independent twin"},
    {"fathom depth --method shallow a.off b.off", "the same answer, sooner for large bodies that overlap a little"},
    {"fathom depth --along 1,0,0 --steps 64 --svg curve.svg a.off b.off",
     "the signed depth while A moves along x, and a chart of it"},
    {"fathom depth --pieces a.obj b.obj", "bodies that are not convex, as unions of the groups in their files"},
    {"fathom depth --solid a.obj b.stl", "closed meshes as they are, not their hulls"},
    {"fathom depth cases.jsonl", "a stream: one line per case"},
    {"fathom depth --certificate proofs cases.jsonl", "and one file for each case in the folder proofs"},
    {"cat cases.jsonl | fathom depth --json -", "the same from standard input"},
};

constexpr Example width_examples[] = {
    {"fathom width a.off", "the least distance of two parallel planes with the body between them"},
    {"fathom width --json a.stl", "one JSON object"},
    {"fathom width --delta 1/100 a.off", "within a factor of 1 + 1/100, by rays"},
    {"fathom width --json cases.jsonl", "for a stream: the width of body a of each case"},
    {"cat cases.jsonl | fathom width --json -", "the same from standard input"},
};

constexpr Example approx_examples[] = {
    {"fathom approx --delta 1/100 a.off b.stl",
     "a separating translation, exact, at most 1 + 1/100 times as long as the depth"},
    {"fathom approx --delta 0.5 --json a.off b.stl", "one JSON object, with a lower bound of the depth; 0.5 means 1/2"},
    {"fathom approx cases.jsonl", "a stream: one line per case"},
};

constexpr Example ray_examples[] = {
    {"fathom ray --direction 0,0,1 a.off b.stl", "how far up must A move until the interiors are disjoint? exactly"},
    {"fathom ray --direction=-1/3,0,0.1 --json a.off b.stl",
     "one JSON object, with the facet that stops A; 0.1 means 1/10"},
    {"cat cases.jsonl | fathom ray --direction 1,0,0 -", "the same direction for every case of a stream"},
    {"fathom ray --growth a.off b.stl", "by which factor do both grow until they touch? exactly, also of bodies apart"},
    {"fathom ray --growth --center-a 0,0,0 --center-b 1,0,0 --json a.off b.stl",
     "about these points; one JSON object, with the proof"},
};

constexpr Example impact_examples[] = {
    {"fathom impact --from \"xyz=0,0,4\" --to \"xyz=0,0,0 quat=1,1/2,0,0\" a.off b.stl",
     "A tips over while it falls: when does it meet B, within 2^-40 of the motion?"},
    {"fathom impact --from \"xyz=0,0,4\" --to \"xyz=0,0,0\" --certificate impact.cert a.off b.stl",
     "the proof, for fathom check: planes that separate them until then"},
    {"fathom impact --json moves.jsonl", "for every case of a stream, by its field \"motion\""},
};

constexpr Example metric_examples[] = {
    {"fathom metric --ball q.off a.off b.stl",
     "the depth where lengths are measured with the unit ball q.off, exactly"},
    {"fathom metric --ball q.off --json a.off b.stl", "one JSON object, with every vertex of the ball that decides"},
    {"fathom metric --ball q.off cases.jsonl", "a stream: one line per case"},
};

constexpr Example study_examples[] = {
    {"fathom study a.off b.stl", "parallel edges, coincident normals, ties, zeros of the predicates: two tables"},
    {"fathom study --all a.off b.stl", "with the features of every coincidence"},
    {"fathom study --json a.off b.stl", "one JSON object"},
    {"fathom study --html page.html a.off b.stl",
     "the page of explain, opened at what coincided: each lights its features"},
    {"fathom study --csv cases.jsonl", "a stream: a header, then one row of counts per case"},
    {"cat cases.jsonl | fathom study --json -", "the same from standard input, as JSON"},
    {"fathom study --sweep crossed_fans --sizes 10..100 --svg growth.svg",
     "how the exact method's work grows with the size of a family's pairs"},
};

constexpr Example stages_examples[] = {
    {"fathom stages a.off b.stl", "diagrams, charts, canonical pairs, the crossing that won: a summary"},
    {"fathom stages --json a.off b.stl", "everything, as one JSON object: for pictures"},
    {"fathom stages --times a.off b.stl", "with the seconds of each stage"},
    {"fathom stages --svg charts.svg a.off b.stl", "both charts as a picture"},
    {"cat cases.jsonl | fathom stages --json -", "a stream: one object per case"},
};

constexpr Example explain_examples[] = {
    {"fathom explain a.off b.stl -o page.html",
     "why is the depth what it is? one page with pictures to turn, for any browser"},
    {"fathom explain cases.jsonl --case deep -o page.html", "of one case of a file"},
    {"fathom explain --pieces a.obj b.obj -o page.html",
     "of bodies that are not convex, as unions of the groups in their files"},
    {"fathom explain --twist 0,0,0,0,0,1 a.off b.stl -o page.html",
     "with the depth as A is moved and turned, beside its tangent"},
    {"fathom explain --times a.off b.stl -o page.html", "with the seconds that each stage took"},
};

constexpr Example solid_examples[] = {
    {"fathom solid a.off", "is the mesh closed? how large is what it goes around, and of how many convex pieces?"},
    {"fathom solid -o pieces.obj a.off", "and the pieces, one group each"},
    {"fathom solid --exact --exact-decimals a.obj", "0.1 means 1/10, so that flat faces stay flat; the volume exactly"},
    {"fathom solid --certificate a.cert a.off", "and the proof that the pieces tile what it goes around: fathom check"},
    {"fathom solid --judge pieces.obj a.off", "do the convex pieces of another program tile it? what is missing?"},
    {"fathom solid --json a.stl", "one JSON object"},
};

constexpr Example robot_examples[] = {
    {"fathom robot arm.urdf", "which links of a robot overlap, and how far apart are the others?"},
    {"fathom robot --joints shoulder=1/2,elbow=-2.5 arm.urdf", "where the joints stand so"},
    {"fathom robot --json --exact-decimals arm.urdf", "one JSON object; 0.1 means 1/10"},
    {"fathom depth --joints elbow=-2.5 arm.urdf#left arm.urdf#base",
     "two links, as every command on bodies takes them"},
};

constexpr Example cases_examples[] = {
    {"fathom cases --list", "the families, with a line on each"},
    {"fathom cases --family near_ties --count 100 --seed 7",
     "one case per line, schema fathom/case/1; the same on every machine"},
    {"fathom cases --family random_sphere --count 10 --size 50 | fathom depth -", "generated and answered"},
    {"fathom cases --catalogue", "all named degenerate pairs"},
    {"fathom cases --small-world 0 --count 100 | fathom depth -", "the first of all pairs of small tetrahedra"},
    {"fathom cases --family all --shapes --count 50 | fathom depth -",
     "round and curved bodies, of every family in turn"},
    {"fathom cases --catalogue --unions | fathom depth -", "named pairs of bodies that are not convex"},
    {"fathom cases --from a.obj b.obj --pose-b '0 -1 0 1/2; 1 0 0 0; 0 0 1 0'",
     "two meshes as one case; B turned and moved"},
    {"fathom cases --from-fcl error.log | fathom depth -", "the pairs that FCL printed when it threw"},
};

constexpr Example certify_examples[] = {
    {"fathom certify --list-adapters", "the libraries for which a subject is built"},
    {"fathom certify --adapter libccd-epa cases.jsonl", "every case through libccd's EPA; a table of verdicts"},
    {"fathom certify --adapter libccd-epa --worst", "one small case for each class of error, in a second"},
    {"fathom certify --subject ./mine --report verdicts.jsonl cases.jsonl",
     "your own program, by the protocol of verify/PROTOCOL.md"},
    {"fathom certify --subject ./mine --report verdicts.jsonl --resume cases.jsonl",
     "goes on where a run was cut short"},
    {"fathom certify --replay replies.jsonl cases.jsonl", "answers that were recorded elsewhere"},
    {"fathom cases --family near_ties --count 50 | fathom certify --adapter bullet-epa --metamorphic -",
     "each case also swapped, moved, reordered and scaled"},
    {"fathom certify --method exact --adapter bullet-epa --shrink small cases.jsonl",
     "each truth found twice, by methods that share nothing; any difference is kept"},
    {"fathom certify --subject ./mine --expect-fail known.txt --junit junit.xml cases.jsonl",
     "in continuous integration: strict about known failures"},
    {"fathom certify --adapter libccd-epa --shrink small --html page.html cases.jsonl",
     "the smallest case of each verdict, and a page to look at"},
};

constexpr Example check_examples[] = {
    {"fathom check proof.cert", "s VERIFIED, or the reason why it is no proof"},
    {"fathom check --case case.json proof.cert", "is it about these bodies?"},
    {"fathom depth --json --embed-certificate cases.jsonl | fathom check --results -",
     "every answer with its proof, checked"},
    {"cat proof.cert | fathom check --echo -", "with the bodies and the claim as they were read"},
};

constexpr Example help_examples[] = {
    {"fathom help", "what fathom --help prints"},
    {"fathom help depth", "what fathom depth --help prints"},
    {"fathom help golden verify", "help for a task of a command"},
};

constexpr Example man_examples[] = {
    {"fathom man depth | man -l -", "the page of a command, to be read"},
    {"fathom man > fathom.1", "the page of fathom itself, as roff"},
    {"fathom man --all man1", "every page, as a file of the folder man1: what packages install"},
};

constexpr Example completion_examples[] = {
    {"eval \"$(fathom completion bash)\"", "in this shell, or in ~/.bashrc"},
    {"fathom completion zsh > _fathom", "for a folder of zsh's fpath"},
    {"fathom completion fish > fathom.fish", "for ~/.config/fish/completions"},
};

constexpr ExitMeaning fine_exit = {0, "fine"};
constexpr ExitMeaning usage_exit = {2, "usage or bad input (in a stream the other cases are still answered)"};
constexpr ExitMeaning fault_exit = {3, "internal error, out of memory, or output that cannot be written"};
constexpr ExitMeaning interrupted_exit = {130, "interrupted"};

constexpr ExitMeaning usual_exits[] = {fine_exit, usage_exit, fault_exit, interrupted_exit};
constexpr ExitMeaning all_exits[] = {fine_exit,         {1, "a verdict failed, a certificate was refused"},
                                     usage_exit,        fault_exit,
                                     {4, "incomplete"}, interrupted_exit};
constexpr ExitMeaning certify_exits[] = {
    fine_exit,
    {1, "a verdict failed, or the run differs from the list of known failures"},
    usage_exit,
    fault_exit,
    {4, "incomplete: the subject could not be started, declined all cases, or cases have no reply"},
    interrupted_exit};
constexpr ExitMeaning solid_exits[] = {
    fine_exit, {1, "with --judge: the pieces do not tile the solid"}, usage_exit, fault_exit, interrupted_exit};
constexpr ExitMeaning check_exits[] = {
    {0, "all were accepted, and there was one"},
    {1, "some were refused"},
    {2, "some were malformed, cut off or unreadable, or the input was empty, or usage"},
    {3, "internal error, or output that cannot be written; the largest counts"},
};

constexpr std::string_view usual_notes[] = {
    "Meshes: OFF, OBJ, PLY, STL, glTF, COLLADA, 3MF, or plain lines \"x y z\"; convex hulls are taken. FILE#NAME is "
    "one "
    "mesh of several. Streams: JSON Lines, schema fathom/case/1.",
    "Results go to standard output, everything else to standard error.",
};
constexpr std::string_view solid_notes[] = {
    "Meshes: OFF, OBJ, PLY, STL, glTF, COLLADA, 3MF. The solid of a mesh is where its winding number is positive. A "
    "mesh that is not "
    "closed, or has a part inside out, is refused; nothing is mended.",
};
constexpr std::string_view robot_notes[] = {
    "Reads the collision elements of URDF: box, sphere, cylinder, capsule, and mesh, of which the hull is taken. Links "
    "with at most one joint between them that moves are adjacent, and left out. A signed depth is above 0 where links "
    "overlap; the least comes first.",
};
constexpr std::string_view check_notes[] = {
    "Checks certificates of how deep two convex bodies lie in each other, exactly; - is standard input. FORMAT.md says "
    "what they look like "
    "and what acceptance proves. One line per certificate: s VERIFIED, s REFUSED or s MALFORMED.",
};

constexpr CommandHelp commands[] = {
    {"depth", "Exact penetration depth of two bodies.", "fathom depth [OPTIONS] A B | CASES.jsonl | -", depth_examples,
     usual_exits, usual_notes},
    {"width", "Exact width of one body.", "fathom width [OPTIONS] A | CASES.jsonl | -", width_examples, usual_exits,
     usual_notes},
    {"approx", "Depth of two bodies within a factor.", "fathom approx [--delta DELTA] [OPTIONS] A B | CASES.jsonl | -",
     approx_examples, usual_exits, usual_notes},
    {"ray", "Exact depth of two bodies in one direction, or their growth distance.",
     "fathom ray --direction X,Y,Z | --growth [OPTIONS] A B | CASES.jsonl | -", ray_examples, usual_exits, usual_notes},
    {"impact", "When two bodies that turn and move meet first.",
     "fathom impact --from POSE --to POSE [--b-from POSE --b-to POSE] [OPTIONS] A B | CASES.jsonl | -", impact_examples,
     usual_exits, usual_notes},
    {"metric", "Exact depth in a polyhedral norm or gauge.", "fathom metric --ball Q [OPTIONS] A B | CASES.jsonl | -",
     metric_examples, usual_exits, usual_notes},
    {"study", "What is degenerate about two bodies.", "fathom study [OPTIONS] A B | CASES.jsonl | - | --sweep FAMILY",
     study_examples, usual_exits, usual_notes},
    {"stages", "What the exact method makes of two bodies on its way to the depth.",
     "fathom stages [OPTIONS] A B | CASES.jsonl | -", stages_examples, usual_exits, usual_notes},
    {"explain", "Why the depth is what it is, as a page with pictures.",
     "fathom explain [OPTIONS] A B -o PAGE.html | CASES.jsonl --case ID -o PAGE.html", explain_examples, usual_exits,
     usual_notes},
    {"solid", "Convex pieces of the solid that a closed mesh bounds, exactly.", "fathom solid [OPTIONS] MESH",
     solid_examples, solid_exits, solid_notes},
    {"robot", "Signed depths of all pairs of links of a robot that may touch, exactly.",
     "fathom robot [OPTIONS] FILE.urdf", robot_examples, usual_exits, robot_notes},
    {"cases", "Test cases by name, or from two meshes.",
     "fathom cases --family NAME [OPTIONS] | --catalogue | --small-world N | --list | --from [OPTIONS] A B | "
     "--from-fcl FILE",
     cases_examples, usual_exits, usual_notes},
    {"certify", "Where another implementation is wrong, case by case.",
     "fathom certify --subject COMMAND | --adapter NAME | --replay REPLIES [OPTIONS] CASES.jsonl | - | --worst | diff "
     "OLD NEW",
     certify_examples, certify_exits, usual_notes},
    {"certify diff", "What changed between two reports.", "fathom certify diff [OPTIONS] OLD NEW", diff_examples,
     diff_exits, diff_notes},
    {"check", "Check certificates, independently.", "fathom check [OPTIONS] FILE...", check_examples, check_exits,
     check_notes},
    {"golden", "Golden test data: make a release, prove one, or export some of it.",
     "fathom golden generate|verify|export [OPTIONS]", golden_examples, golden_exits, golden_notes},
    {"golden generate", "Make a release, or go on with one.",
     "fathom golden generate --level LEVEL --out DIR [OPTIONS]", generate_examples, golden_exits, golden_notes},
    {"golden verify", "Prove a release, or refuse it.", "fathom golden verify DIR [OPTIONS]", verify_examples,
     golden_exits, golden_notes},
    {"golden export", "Write some of a release, or cases of one's own, as one file for other tests.",
     "fathom golden export --format FORMAT DIR|CASES [OPTIONS]", export_examples, golden_exits, golden_notes},
    {"help", "Help for a command.", "fathom help [COMMAND]", help_examples, usual_exits},
    {"man", "The manual page of a command, for man.", "fathom man [COMMAND] | --all DIR", man_examples, usual_exits},
    {"completion", "Completion of commands and options for a shell.", "fathom completion bash|zsh|fish",
     completion_examples, usual_exits},
};

// ---- pages ----

constexpr std::size_t margin = 2;
constexpr std::size_t wide = 100;           // at this width and above, meanings stand beside options and commands
constexpr std::size_t beside_example = 43;  // the column of their meaning at that width
constexpr std::size_t beside_option = 28, below_option = 6;
constexpr std::size_t enough_for_options = 60;

using Lines = std::vector<std::string>;

/// Returns a shell command broken by backslashes outside quotations, so that it still runs.
std::string broken_line(std::string_view line, std::size_t width) {
  std::string result;
  std::size_t column = 0, last_space = line.npos, begin = 0;
  char quotation = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quotation != 0) quotation = c == quotation ? '\0' : quotation;
    else if (c == '\'' || c == '"') quotation = c;
    else if (c == ' ') last_space = i;
    const std::size_t behind = i + 1 < line.size() ? 2 : 0;  // columns for " \"
    if (++column + behind > width && last_space != line.npos && last_space > begin) {
      result += fmt::format("{} \\\n{:{}}", line.substr(begin, last_space - begin), "", 2 * margin + 2);
      begin = last_space + 1;
      column = i + 1 - begin + margin + 2;
    }
  }
  return result + std::string(line.substr(begin));
}

/// Returns the text as one line.
std::string joined(std::string_view text) {
  std::string result(text);
  std::ranges::replace(result, '\n', ' ');
  return result;
}

/// Adds the title and its meaning: beside the title from `column` on if there is room, else below
/// it.
void add_explained(Lines& lines, std::string_view title, std::string_view meaning, std::size_t column,
                   std::size_t columns) {
  std::string text = fmt::format("{:{}}{}", "", margin, title);
  if (text.size() + margin > column || text.find('\n') != text.npos) {
    lines.push_back(text);
    text.clear();
  }
  if (!meaning.empty())
    lines.push_back(folded(fmt::format("{:<{}}{}", text, column, joined(meaning)), columns, column));
  else if (!text.empty()) lines.push_back(text);
}

void add_examples(Lines& lines, std::span<const Example> examples, std::size_t columns) {
  lines.emplace_back("Examples");
  for (const Example& example : examples)
    add_explained(lines, broken_line(example.line, columns - margin), example.meaning,
                  columns >= wide ? beside_example : below_option, columns);
}

/// Returns "-m, --method NAME" or "--metamorphic[=LIST]".
std::string option_title(const OptionHelp& option) {
  return fmt::format("{}{}{}", fmt::join(option.names, ", "),
                     option.value.empty() || option.value.front() == '[' ? "" : " ", option.value);
}

void add_options(Lines& lines, const HelpPage& page, std::size_t columns) {
  const std::size_t column = columns >= enough_for_options ? beside_option : below_option;
  lines.emplace_back();
  lines.emplace_back("Options");
  for (const OptionHelp& option : page.options)
    add_explained(lines, option_title(option), option.meaning, column, columns);
  if (page.commands.empty()) return;
  std::size_t longest = 0;
  for (const CommandHelp& command : page.commands) longest = std::max(longest, last_word(command).size());
  lines.emplace_back();
  lines.emplace_back("Commands");
  for (const CommandHelp& command : page.commands)
    add_explained(lines, last_word(command), command.summary, margin + longest + margin, columns);
}

OptionHelp help_of(const Option& option) {
  OptionHelp help{words_of(option.names), option.value, option.meaning, option.values.words};
  for (std::string& name : help.names) name = name.substr(0, name.find('{'));
  if (option.required) help.meaning += "; required";
  return help;
}

std::string exits_text(std::span<const ExitMeaning> exits) {
  Lines parts;
  for (const ExitMeaning& exit : exits) parts.push_back(fmt::format("{} {}", exit.code, exit.meaning));
  return fmt::format("Exit codes: {}.", fmt::join(parts, "; "));
}

}  // namespace

const CommandHelp general_help = {"",
                                  "Exact penetration depth of two convex polytopes.",
                                  "fathom COMMAND [OPTIONS] INPUT...",
                                  general_examples,
                                  all_exits,
                                  usual_notes};
constinit const std::span<const CommandHelp> command_table = commands;

std::string full_name(const CommandHelp& command) {
  return command.name.empty() ? "fathom" : "fathom " + std::string(command.name);
}

HelpPage page_of(std::string_view command, std::span<const Option> table) {
  const auto found = std::ranges::find(command_table, command, &CommandHelp::name);
  HelpPage page{found == command_table.end() ? general_help : *found, {}};
  if (command == "check") {  // the checker has a parser and a page of its own
    for (const auto& [name, value, meaning] : fathom_check::option_texts) {
      page.options.push_back({{std::string(name)}, std::string(value), std::string(meaning)});
      if (name == "--help") page.options.back().names.insert(page.options.back().names.begin(), "-h");
    }
  } else {
    page.options.push_back({{"-h", "--help"}, "", "print help"});
  }
  if (command.empty())
    page.options.push_back(
        {{"-V", "--version"}, "", "the version, with the commit, that of the golden data, and the licence"});
  for (const Option& option : table)
    if (option.belongs_to(command) && !option.is_input()) page.options.push_back(help_of(option));
  for (const CommandHelp& other : command_table)
    if (parent(other) == command) page.commands.push_back(other);
  page.takes_input = command == "certify";
  return page;
}

std::string help_text(const HelpPage& page, std::size_t columns) {
  Lines lines;
  add_examples(lines, page.command.examples, columns);
  lines.emplace_back();
  lines.push_back(folded(page.command.summary, columns));
  lines.push_back(folded(fmt::format("Usage: {}", page.command.synopsis), columns, below_option));
  add_options(lines, page, columns);
  lines.emplace_back();
  for (const std::string_view note : page.command.notes) lines.push_back(folded(note, columns));
  lines.push_back(folded(exits_text(page.command.exits), columns));
  return fmt::format("{}", fmt::join(lines, "\n"));
}

}  // namespace fathom::cli
