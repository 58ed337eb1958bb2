// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <optional>
#include <stdexcept>

#include "fathom/certificate.hpp"
#include "fathom/numbers.hpp"
#include "reference/files/shape_names.hpp"
#include "verify/check/check.hpp"
#include "verify/check/unreadable.hpp"
#include "verify/harness/two_ways.hpp"

namespace fathom::harness {
namespace {

/// As the checker writes it.
std::string surd_text(const Surd& value) {
  return fmt::format("{}sqrt({})+{}", value.root < 0 ? "-" : "", exact_text(abs(value.root)), exact_text(value.rational));
}

/// What the checker finds. Throws fathom_check::Unreadable if none would read the text, std::logic_error if it refuses the proof.
fathom_check::Verdict acceptance(const std::string& id, const std::string& text) {
  fathom_check::require_readable(text);
  fathom_check::Verdict verdict = fathom_check::verify(text);
  if (!verdict.accepted()) throw std::logic_error(fmt::format("the certificate of {} is refused: {}", id, verdict.reason));
  return verdict;
}

}  // namespace

std::string accepted_certificate(const Case& pair, const Depth& answer, Monitor* monitor) {
  std::string text = certificate_text(pair.a.points, pair.b.points, answer, pair.id, monitor);
  const fathom_check::Verdict verdict = acceptance(pair.id, text);
  const Distance* const apart = answer.distance();
  const bool same = apart ? verdict.signed_depth == surd_text({0, -apart->squared}) : verdict.depth_squared == exact_text(answer.squared());
  if (!same || verdict.status != name(answer.status()) || verdict.optima != answer.optima().size())
    throw std::logic_error(fmt::format("the certificate of {} proves another answer", pair.id));
  return text;
}

std::string accepted_certificate(const std::string& id, const ShapeTruth& truth, Monitor* monitor) {
  std::string text = certificate_text(truth.a, truth.b, truth.depth, id, ShapeFormat::richest, monitor);
  const fathom_check::Verdict verdict = acceptance(id, text);
  const Bounds* const bounds = truth.depth.bounds();
  const bool same = bounds ? verdict.at_least == exact_text(bounds->low) && verdict.at_most == exact_text(bounds->high)
                           : verdict.signed_depth == surd_text(*truth.depth.exact());
  const std::optional<Status> status = truth.depth.status();
  if (!same || verdict.status != (status ? name(*status) : "undecided"))
    throw std::logic_error(fmt::format("the certificate of {} proves another answer", id));
  return text;
}

std::string accepted_certificate(const std::string& id, const UnionTruth& truth, Monitor* monitor) {
  const UnionDepth& depth = truth.depth;
  std::string text = certificate_text(truth.a, truth.b, depth, id, monitor);
  const fathom_check::Verdict verdict = acceptance(id, text);
  const bool same = depth.apart ? verdict.distance_squared == exact_text(depth.apart->distance.squared)
                                : verdict.depth_squared == exact_text(depth.squared());
  const std::size_t optima = depth.status == Status::penetrating ? depth.optima.size() : 0;
  if (!same || verdict.status != name(depth.status) || verdict.optima != optima)
    throw std::logic_error(fmt::format("the certificate of {} proves another answer", id));
  return text;
}

std::string accepted_certificate(const Case& pair, Monitor* monitor) {
  if (pair.a.pieces || pair.b.pieces) {
    UnionOptions options;
    options.monitor = monitor;
    return accepted_certificate(pair.id, truth_about(pieces_of(pair.a), pieces_of(pair.b), options), monitor);
  }
  if (pair.a.shape || pair.b.shape) {
    SignedDepthOptions options;
    options.cores.monitor = monitor;
    return accepted_certificate(pair.id, truth_about(files::shape_of(pair.a), files::shape_of(pair.b), options), monitor);
  }
  Options options;
  options.monitor = monitor;
  return accepted_certificate(pair, penetration_depth(pair.a.points, pair.b.points, options), monitor);
}

}  // namespace fathom::harness
