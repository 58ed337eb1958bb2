// SPDX-License-Identifier: GPL-3.0-or-later
// The words of `fathom golden --help`. Examples come first.
#pragma once

#include <string_view>

namespace fathom::cli {

inline constexpr std::string_view golden_examples =
    "Examples\n"
    "  fathom golden generate --level L0 --out data\n"
    "                                           cases with their exact answers, rounded answers and proofs, in the folder data\n"
    "  fathom golden verify data                proves every value in it, or says what is wrong\n"
    "  fathom golden export --format c --count 50 data > golden_cases.h\n"
    "                                           fifty of its cases, for the tests of another project\n";

inline constexpr std::string_view generate_examples =
    "Examples\n"
    "  fathom golden generate --level L1 --seed 1 --out data\n"
    "                                           the same bytes on every machine; after an interrupt or a kill, the same line goes on\n"
    "  fathom golden generate --level L2 --out data --shard 3/8\n"
    "                                           the third of eight machines; when all are done, the line without --shard completes it\n"
    "  mpirun -np 4 fathom golden generate --level L2 --out data\n"
    "                                           four processes, which take shard after shard; Open MPI wants --oversubscribe\n"
    "                                           for more processes than cores, and --allow-run-as-root of root\n"
    "  fathom golden generate --level P0 --out shapes\n"
    "                                           spheres, capsules, cylinders and their like\n"
    "  zstd -dc data/golden-L0-*.jsonl.zst | fathom depth --json -\n"
    "                                           the records are cases for every other command\n";

inline constexpr std::string_view verify_examples =
    "Examples\n"
    "  fathom golden verify data                sums, schemas, counts, every certificate, every value\n"
    "  fathom golden verify --method exact data the same, and every value computed again by AGHRS's pipeline\n"
    "  fathom golden verify --method exact --method naive --state data\n"
    "                                           by two methods; agreement.json in data then says so\n"
    "  zstd -dc data/*.cert.zst | fathom check -\n"
    "                                           the certificates alone, by the independent checker\n";

inline constexpr std::string_view export_examples =
    "Examples\n"
    "  fathom golden export --format c --exclude flat,huge --max-points 8 --count 50 data > golden_cases.h\n"
    "                                           C89 arrays, and a function that accepts answers or not\n"
    "  fathom golden export --format json --exclude disjoint,touching data > golden_cases.json\n"
    "                                           all bodies that overlap, for whoever reads JSON\n";

inline constexpr std::string_view golden_footer =
    "A release is a folder of zstd files, shard by shard: records as JSON Lines, certificates; of polytopes CSV too.\n"
    "Its NOTES.md explains every field. The data is in the public domain (CC0-1.0).\n"
    "Exit codes: 0 fine, or verified; 1 refused; 2 usage, or a folder that holds something else or cannot be read; 3 internal error,\n"
    "or files cannot be written; 130 interrupted.\n";

}  // namespace fathom::cli
