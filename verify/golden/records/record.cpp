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
#include "verify/golden/records/prove.hpp"
#include "verify/golden/records/record_facts.hpp"
#include "verify/golden/records/record_line.hpp"
#include "verify/golden/shapes/shape_facts.hpp"
#include "verify/golden/unions/union_facts.hpp"

namespace fathom::golden {
namespace {

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
  record.csv_row = csv_row(facts);
  record.in_binary64 = facts.in_binary64;
  record.in_binary32 = facts.in_binary32;
  return record;
}

Record record_of(const Recipe& recipe, const FormedShapes& bodies, Monitor* monitor) {
  const auto& [id, pair] = bodies.shapes;
  const Shape a = families::shape_of(pair.a), b = families::shape_of(pair.b);
  Options options;
  options.monitor = monitor;
  const SignedDepth answer = answer_about(a, b, options);
  Record record;
  record.id = id;
  record.certificate = certificate_text(a, b, answer, id, ShapeFormat::richest, monitor);
  record.line = line_of(ShapeFacts{recipe, bodies, truth_of(answer), digest::digest_of(record.certificate).sha256});
  if (const auto fault = faults_of(record.line, record.certificate)) throw std::logic_error(id + ": " + *fault);
  record.in_binary64 = in_format(pair, Form::binary64);
  record.in_binary32 = in_format(pair, Form::binary32);
  return record;
}

Record record_of(const Recipe& recipe, const FormedUnions& bodies, Monitor* monitor) {
  const Pieces &a = *bodies.unions.a.pieces, &b = *bodies.unions.b.pieces;
  const std::string& id = bodies.unions.id;
  const UnionDepth answer = answer_about(bodies.unions, monitor);
  Record record;
  record.id = id;
  record.certificate = certificate_text(a, b, answer, id, monitor);
  record.line = line_of(UnionFacts{recipe, bodies, truth_of(answer), digest::digest_of(record.certificate).sha256});
  if (const auto fault = faults_of(record.line, record.certificate)) throw std::logic_error(id + ": " + *fault);
  record.in_binary64 = unions_in_format(bodies.unions, Form::binary64);
  record.in_binary32 = unions_in_format(bodies.unions, Form::binary32);
  return record;
}

namespace {

/// Of each of the cases, which are all of one recipe.
template <class Formed>
std::vector<Record> records_of_all(const Recipe& recipe, const std::vector<Formed>& cases, kernels::Context& context, Monitor* monitor) {
  std::vector<Record> records;
  for (const Formed& bodies : cases) {
    context.check();
    records.push_back(record_of(recipe, bodies, monitor));
  }
  return records;
}

}  // namespace

std::vector<Record> records_of(const Recipe& recipe, Monitor* monitor, Workspace* workspace) {
  kernels::Context context(monitor);
  if (kind_of(recipe.source) == Kind::shapes) return records_of_all(recipe, shape_cases_of(recipe), context, monitor);
  if (kind_of(recipe.source) == Kind::unions) return records_of_all(recipe, union_cases_of(recipe), context, monitor);
  std::vector<Record> records;
  for (const auto& [form, points] : cases_of(recipe)) {
    context.check();
    records.push_back(record_of(recipe, form, points, monitor, workspace));
  }
  return records;
}

}  // namespace fathom::golden
