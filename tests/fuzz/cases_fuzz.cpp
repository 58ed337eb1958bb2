// SPDX-License-Identifier: GPL-3.0-or-later
// The reader of cases on arbitrary bytes. The first byte picks the layout. Corpus:
// tests/data/*.json, *.jsonl with any byte in front.
#include <cstdint>
#include <cstdlib>
#include <sstream>

#include "fathom/files.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  std::istringstream input(std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
  fathom::CaseStream stream(input, "c", data[0] % 2 == 0 ? fathom::CaseLayout::lines : fathom::CaseLayout::document);
  std::size_t items = 0;
  const auto is_nothing = [](const fathom::Body& body) { return body.points.empty() && !body.shape && !body.pieces; };
  for (; const std::optional<fathom::CaseItem> item = stream.next(); ++items)
    if (item->ok() && (is_nothing(item->value().a) || is_nothing(item->value().b))) std::abort();
  if (items == 0) std::abort();  // never silent on empty input
  return 0;
}
