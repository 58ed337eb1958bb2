// SPDX-License-Identifier: Apache-2.0
#include "reader.hpp"

#include <exception>
#include <new>

#include "budget.hpp"
#include "checks.hpp"
#include "text.hpp"

namespace fathom_check {
namespace {

Verdict fault(Outcome outcome, std::size_t line, const std::string& reason) {
  Verdict verdict;
  verdict.outcome = outcome;
  verdict.line = line;
  verdict.reason = reason;
  return verdict;
}

std::string text(const Rational& r) { return ratio_text(r.num.value(), r.den.value()); }

/// For a certificate that has passed every check.
Verdict verified(const Certificate& c) {
  Verdict verdict;
  verdict.status = c.claim == Claim::touching ? "touching" : c.claim == Claim::disjoint ? "disjoint" : "penetrating";
  if (c.claim == Claim::bounds) {
    verdict.at_least = text(c.low);
    verdict.at_most = text(c.high);
  } else {
    verdict.depth_squared = c.claim == Claim::depth ? text(c.low) : "0";
  }
  if (c.all) verdict.optima = c.directions.items.size();
  verdict.outcome = Outcome::verified;
  return verdict;
}

}  // namespace

Verdict caught(const std::function<Verdict()>& action, std::size_t line) {
  try {
    return action();
  } catch (const Fault& error) {
    return fault(error.malformed ? Outcome::malformed : Outcome::refused, error.line, error.what());
  } catch (const std::bad_alloc&) {
    return fault(Outcome::malformed, line, "larger than the memory at hand");
  } catch (const std::exception& error) {
    return fault(Outcome::malformed, line, error.what());
  }
}

std::optional<Verdict> Reader::next(const Inspect& inspect) {
  bool found = false;
  Verdict verdict = caught(
      [&] {
        found = parser_.find_next() || !any_;
        return Verdict();
      },
      0);
  if (!found) return std::nullopt;
  any_ = true;
  Certificate certificate;
  verdict = caught(
      [&] {
        parser_.read(certificate);
        if (inspect) inspect(certificate);
        check_claim(certificate);
        return verified(certificate);
      },
      0);
  if (!verdict.accepted() && verdict.line == 0) verdict.line = lines_->number();
  if (verdict.outcome == Outcome::malformed) {
    caught([&] { return parser_.skip_to_next() ? Verdict() : Verdict(); }, 0);
  }
  verdict.id = certificate.id;
  return verdict;
}

}  // namespace fathom_check
