// SPDX-License-Identifier: GPL-3.0-or-later
// Subjects as the shipped adapters describe themselves, and pairs that they get wrong.
#pragma once

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "fathom/files.hpp"
#include "verify/harness/outcome.hpp"

namespace fathom::testing {

inline harness::SubjectInfo subject(const std::string& library, const std::string& name, bool faces = false,
                                    Precision precision = Precision::binary64) {
  harness::SubjectInfo info;
  info.library = library;
  info.name = name;
  info.version = "1.0";
  info.wants_faces = faces;
  info.format = precision;
  return info;
}

inline std::vector<harness::SubjectInfo> subjects() {
  return {subject("libccd", "libccd-epa"),
          subject("libccd", "libccd-mpr"),
          subject("fcl", "fcl-signed", true),
          subject("fcl", "fcl-collide", true),
          subject("fcl", "fcl-indep", true),
          subject("bullet", "bullet-epa", false, Precision::binary32),
          subject("bullet", "bullet-pair", false, Precision::binary32),
          subject("bullet", "bullet64-epa"),
          subject("bullet", "bullet64-pair"),
          subject("ode", "ode-collide", true),
          subject("", "home-made")};
}

/// A pair of tests/data/real_cases.jsonl.
inline Case real_case(const std::string& id) {
  std::ifstream in(FATHOM_TEST_DATA "/real_cases.jsonl");
  CaseStream stream(in, "real_cases.jsonl");
  while (const auto item = stream.next())
    if (item->ok() && item->id == id) return item->value();
  throw std::invalid_argument("no real case " + id);
}

/// What the subject is said to have claimed of the pair.
inline harness::Outcome claimed(const Case& pair, double depth) {
  harness::Outcome outcome;
  outcome.id = pair.id;
  Reply& reply = outcome.reply.emplace();
  reply.overlap = true;
  reply.depth = depth;
  reply.direction = Triple{0, 0, 1};
  outcome.judgement = judge(truth_about(pair.a.points, pair.b.points), reply);
  outcome.verdict = outcome.judgement->verdict;
  return outcome;
}

}  // namespace fathom::testing
