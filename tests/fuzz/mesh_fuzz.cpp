// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh readers on arbitrary bytes. The first byte picks the format and the meaning of decimals.
// Corpus: tests/data/wedge* and examples/data/plate.svg, each with any byte in front.
#include <cstdint>
#include <cstdlib>

#include "fathom/files.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  const fathom::Decimals decimals = data[0] % 2 == 0 ? fathom::Decimals::binary64 : fathom::Decimals::exact;
  const int format = data[0] / 2 % 7;  // scenes are read in a process of their own: tests/cli/scene_mutants_test.py
  try {
    const fathom::Body body = format < 6
                                  ? fathom::parse_mesh(bytes, "m", decimals, static_cast<fathom::MeshFormat>(format))
                                  : fathom::parse_mesh(bytes, "m", decimals);
    if (body.points.empty() && !body.shape) std::abort();
  } catch (const fathom::InputError&) {
    // A refusal is a fine answer; any other exception is a finding.
  }
  return 0;
}
