// SPDX-License-Identifier: GPL-3.0-or-later
// The independent checker for C.
#include "verify/check/check.hpp"

#include <optional>
#include <string>
#include <string_view>

#include "bindings/c/boundary.hpp"
#include "reference/files/case_json.hpp"
#include "verify/check/cases.hpp"
#include "verify/check/limits.hpp"
#include "verify/check/reader.hpp"

namespace fathom::c {
namespace {

using fathom_check::Verdict;

text::Json points_json(const fathom_body& body, const char* name) {
  if (body.body->shape)
    throw std::invalid_argument(std::string(name) + ": expected points, or pieces, to compare the certificate with, found a shape");
  Body bare;
  if (body.body->pieces) bare.pieces = body.body->pieces;
  else bare.points = body.body->points;
  return files::body_json(bare);
}

/// Refuses a certificate that is not about these bodies.
Verdict verify_about(std::string_view text, const fathom_body& a, const fathom_body& b) {
  const fathom_check::CaseFile bodies(text::Json{{"a", points_json(a, "a")}, {"b", points_json(b, "b")}}.text() + '\n');
  const Verdict alone = fathom_check::verify(text);
  if (!alone.accepted()) return alone;
  fathom_check::Lines lines(text, fathom_check::longest_line);
  const auto compare = [&](const fathom_check::Certificate& certificate) { bodies.compare(certificate); };
  return fathom_check::Reader(lines).next(compare).value_or(Verdict());
}

}  // namespace
}  // namespace fathom::c

using namespace fathom::c;

int fathom_check_certificate(const char* certificate, size_t length, const fathom_body* a, const fathom_body* b, int* outcome,
                             char** line) {
  if (line) *line = nullptr;
  return guarded([&] {
    require(certificate, "certificate");
    require(outcome, "outcome");
    require_at_most(length, "bytes of a certificate");
    if ((a == nullptr) != (b == nullptr)) throw std::invalid_argument("expected both bodies or none, found one");
    const std::string_view text(certificate, length);
    const fathom_check::Verdict verdict = a ? verify_about(text, *a, *b) : fathom_check::verify(text);
    if (line) *line = text_for_caller(fathom_check::verdict_line(verdict, "certificate"));
    *outcome = static_cast<int>(verdict.outcome);
  });
}
