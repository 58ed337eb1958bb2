// SPDX-License-Identifier: GPL-3.0-or-later
// Properties under RapidCheck, with the same random numbers in every run.
#pragma once

#include <rapidcheck.h>

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <utility>

namespace fathom {

struct Runs {
  std::uint64_t seed;
  int runs;
  int max_size = 100;
};

/// Whether the property held in so many runs. Where the environment has RC_PARAMS, that decides on
/// the runs instead, as RapidCheck documents.
template <class Property>
bool holds(const Runs& asked, Property&& property) {
  if (std::getenv("RC_PARAMS") != nullptr) return rc::check(std::forward<Property>(property));
  rc::detail::TestParams params;
  params.seed = asked.seed;
  params.maxSuccess = asked.runs;
  params.maxSize = asked.max_size;
  const auto result = rc::detail::checkTestable(std::forward<Property>(property), rc::detail::TestMetadata{}, params);
  rc::detail::printResultMessage(result, std::cerr);
  std::cerr << '\n';
  return result.template is<rc::detail::SuccessResult>();
}

}  // namespace fathom
