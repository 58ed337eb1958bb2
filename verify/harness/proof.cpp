// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/proof.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "fathom/certificate.hpp"
#include "fathom/numbers.hpp"
#include "verify/check/check.hpp"

namespace fathom::harness {

std::string accepted_certificate(const Case& pair, const Depth& answer, Monitor* monitor) {
  Certificate certificate = make_certificate(pair.a.points, pair.b.points, answer, monitor);
  certificate.id = pair.id;
  std::string text = certificate_text(certificate);
  const fathom_check::Verdict verdict = fathom_check::verify(text);
  if (!verdict.accepted()) throw std::logic_error(fmt::format("the certificate of {} is refused: {}", pair.id, verdict.reason));
  if (verdict.status != name(answer.status()) || verdict.depth_squared != exact_text(answer.squared()) ||
      verdict.optima != answer.optima().size())
    throw std::logic_error(fmt::format("the certificate of {} proves another answer", pair.id));
  return text;
}

}  // namespace fathom::harness
