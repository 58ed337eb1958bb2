// SPDX-License-Identifier: GPL-3.0-or-later
// The words of `fathom golden --help` and of its tasks, like those of the other commands.
#pragma once

#include <string_view>

#include "cli/args/help_page.hpp"

namespace fathom::cli {

inline constexpr Example golden_examples[] = {
    {"fathom golden generate --level L0 --out data", "cases with their exact answers, rounded answers and proofs, in the folder data"},
    {"fathom golden verify data", "proves every value in it, or says what is wrong"},
    {"fathom golden export --format c --count 50 data > golden_cases.h", "fifty of its cases, for the tests of another project"},
};

inline constexpr Example generate_examples[] = {
    {"fathom golden generate --level L0 --seed 1 --out data",
     "the same bytes on every machine; after an interrupt or a kill, the same line goes on"},
    {"fathom golden generate --level L0 --out part --shard 3/8",
     "the third of eight machines; when all are done, the line without --shard completes it"},
    {"mpirun -np 4 fathom golden generate --level L0 --out together",
     "four processes, which take shard after shard; Open MPI wants --oversubscribe for more processes than cores, and "
     "--allow-run-as-root of root"},
    {"fathom golden generate --level P0 --out shapes", "spheres, capsules, cylinders and their like; U0: unions of convex pieces"},
    {"zstd -dc data/golden-L0-*.jsonl.zst | fathom depth --json -", "the records are cases for every other command"},
};

inline constexpr Example verify_examples[] = {
    {"fathom golden verify data", "sums, schemas, counts, every certificate, every value"},
    {"fathom golden verify --method exact data", "the same, and every value computed again by AGHRS's pipeline"},
    {"fathom golden verify --method exact --method naive --state data", "by two methods; agreement.json in data then says so"},
    {"zstd -dc data/*.cert.zst | fathom check -", "the certificates alone, by the independent checker"},
};

inline constexpr Example export_examples[] = {
    {"fathom golden export --format c --exclude flat,huge --max-points 8 --count 50 data > golden_cases.h",
     "C89 arrays, and a function that accepts answers or not"},
    {"fathom golden export --format json --exclude disjoint,touching data > golden_cases.json",
     "all bodies that overlap, for whoever reads JSON"},
    {"fathom golden export --format c --contact edge-edge --only thin_penetration --exact-in binary32 data > nearly_touching.h",
     "edges across each other that hardly overlap, for a program in float"},
    {"fathom golden export --format json --certificates own.cert cases.jsonl > own.json",
     "one's own cases with their exact answers; fathom check --case own.json own.cert proves them"},
};

inline constexpr ExitMeaning golden_exits[] = {
    {0, "fine, or verified"},
    {1, "refused"},
    {2, "usage, or a folder that holds something else or cannot be read"},
    {3, "internal error, or files cannot be written"},
    {130, "interrupted"},
};

inline constexpr std::string_view golden_notes[] = {
    "A release is a folder of zstd files, shard by shard: records as JSON Lines, certificates; of polytopes CSV too. "
    "Its NOTES.md explains every field. The data is in the public domain (CC0-1.0).",
};

/// The command, then its tasks.
inline constexpr CommandHelp golden_table[] = {
    {"golden", "Golden test data: make a release, prove one, or export some of it.", "fathom golden generate|verify|export [OPTIONS]",
     golden_examples, golden_exits, golden_notes},
    {"golden generate", "Make a release, or go on with one.", "fathom golden generate --level LEVEL --out DIR [OPTIONS]", generate_examples,
     golden_exits, golden_notes},
    {"golden verify", "Prove a release, or refuse it.", "fathom golden verify DIR [OPTIONS]", verify_examples, golden_exits, golden_notes},
    {"golden export", "Write some of a release, or cases of one's own, as one file for other tests.",
     "fathom golden export --format FORMAT DIR|CASES [OPTIONS]", export_examples, golden_exits, golden_notes},
};

}  // namespace fathom::cli
