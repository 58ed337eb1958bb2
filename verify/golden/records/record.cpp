// SPDX-License-Identifier: GPL-3.0-or-later
// The expanding polytope finds answer and proof in one run; if it gives up, the exact method answers and the proof is found afterwards. In
// both cases the checker, which shares nothing with them, must accept.
#include "verify/golden/records/record.hpp"

#include <stdexcept>
#include <utility>

#include "fathom/certificate.hpp"
#include "fathom/numbers.hpp"
#include "kernels/context.hpp"
#include "verify/check/check.hpp"
#include "verify/digest/sha256.hpp"
#include "verify/golden/records/names.hpp"
#include "verify/golden/records/record_facts.hpp"
#include "verify/golden/records/record_line.hpp"

namespace fathom::golden {
namespace {

void insist_on(const std::string& id, const std::string& text, const Depth& answer) {
  const fathom_check::Verdict verdict = fathom_check::verify(text);
  const auto refuse = [&id](const std::string& why) { throw std::logic_error(id + ": " + why); };
  if (!verdict.accepted()) refuse("the certificate is not accepted: line " + std::to_string(verdict.line) + ": " + verdict.reason);
  if (verdict.id != id || verdict.status != name(answer.status()) || verdict.depth_squared != exact_text(answer.squared()) ||
      verdict.optima != answer.optima().size())
    refuse("the certificate proves something else: " + fathom_check::verdict_line(verdict, id));
}

}  // namespace

Record record_of(const Recipe& recipe, Form form, const Case& points, Monitor* monitor, Workspace* workspace) {
  Options options;
  options.monitor = monitor;
  options.workspace = workspace;
  Depth answer = penetration_depth(points.a, points.b, options);
  Record record;
  record.id = points.id;
  record.certificate = certificate_text(points.a, points.b, answer, points.id, monitor);
  insist_on(record.id, record.certificate, answer);
  Facts facts = facts_of_answer(recipe, form, points, std::move(answer), monitor, workspace);
  facts.certificate_sha256 = digest::digest_of(record.certificate).sha256;
  record.line = line_of(facts);
  record.exports = exports_of(facts);
  record.in_binary64 = facts.in_binary64;
  record.in_binary32 = facts.in_binary32;
  return record;
}

std::vector<Record> records_of(const Recipe& recipe, Monitor* monitor, Workspace* workspace) {
  kernels::Context context(monitor);
  std::vector<Record> records;
  for (const auto& [form, points] : cases_of(recipe)) {
    context.check();
    records.push_back(record_of(recipe, form, points, monitor, workspace));
  }
  return records;
}

}  // namespace fathom::golden
