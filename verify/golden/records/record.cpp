// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/record.hpp"

#include <stdexcept>
#include <utility>

#include "fathom/certificate.hpp"
#include "fathom/numbers.hpp"
#include "kernels/context.hpp"
#include "verify/check/check.hpp"
#include "verify/digest/sha256.hpp"
#include "verify/golden/records/facts.hpp"
#include "verify/golden/records/prove.hpp"

namespace fathom::golden {
namespace {

/// What the engines say of two bodies.
struct Answered {
  RecordStatement truth;
  std::string certificate;
};

/// The checker, which shares nothing with the engines, must accept. Of polytopes, most of the records, the verdict is compared with the
/// answer; to prove the whole record takes as long as to make it.
void insist_on(const std::string& id, const std::string& text, const Depth& answer) {
  const fathom_check::Verdict verdict = fathom_check::verify(text);
  const auto refuse = [&id](const std::string& why) { throw std::logic_error(id + ": " + why); };
  if (!verdict.accepted()) refuse("the certificate is not accepted: line " + std::to_string(verdict.line) + ": " + verdict.reason);
  const Distance* const distance = answer.distance();
  const bool same_length = distance ? verdict.signed_depth == "-sqrt(" + exact_text(distance->squared) + ")+0"
                                    : verdict.depth_squared == exact_text(answer.squared());
  if (verdict.id != id || verdict.status != name(answer.status()) || !same_length || verdict.optima != answer.optima().size())
    refuse("the certificate proves something else: " + fathom_check::verdict_line(verdict, id));
}

/// The expanding polytope finds answer and proof in one run; if it gives up, the exact method answers and the proof is found afterwards.
Answered answered(const HullPair& hulls, const std::string& id, Monitor* monitor, Workspace* workspace) {
  Options options;
  options.monitor = monitor;
  options.workspace = workspace;
  Depth answer = penetration_depth(hulls.a, hulls.b, options);
  std::string certificate = certificate_text(hulls.a, hulls.b, answer, id, monitor);
  insist_on(id, certificate, answer);
  return {truth_of(hulls, std::move(answer), monitor, workspace), std::move(certificate)};
}

Answered answered(const families::NamedPair& shapes, const std::string& id, Monitor* monitor, Workspace*) {
  const Shape a = families::shape_of(shapes.a), b = families::shape_of(shapes.b);
  Options options;
  options.monitor = monitor;
  const SignedDepth answer = answer_about(a, b, options);
  return {truth_of(answer), certificate_text(a, b, answer, id, ShapeFormat::richest, monitor)};
}

Answered answered(const Unions& unions, const std::string& id, Monitor* monitor, Workspace*) {
  const UnionDepth answer = answer_about(unions.a, unions.b, monitor);
  return {truth_of(answer), certificate_text(unions.a, unions.b, answer, id, monitor)};
}

}  // namespace

Record record_of(const Recipe& recipe, FormedCase made, Monitor* monitor, Workspace* workspace) {
  const std::string id = made.id;
  auto [truth, certificate] = std::visit([&](const auto& bodies) { return answered(bodies, id, monitor, workspace); }, made.bodies);
  const Facts facts = facts_of(recipe, std::move(made), std::move(truth), digest::digest_of(certificate).sha256);
  Record record{id, line_of(facts), std::move(certificate), csv_row(facts), facts.in_binary64, facts.in_binary32};
  if (!std::holds_alternative<HullPair>(facts.made.bodies))
    if (const auto fault = faults_of(record.line, record.certificate)) throw std::logic_error(id + ": " + *fault);
  return record;
}

std::vector<Record> records_of(const Recipe& recipe, Monitor* monitor, Workspace* workspace) {
  kernels::Context context(monitor);
  std::vector<Record> records;
  for (FormedCase& made : cases_of(recipe)) {
    context.check();
    records.push_back(record_of(recipe, std::move(made), monitor, workspace));
  }
  return records;
}

}  // namespace fathom::golden
