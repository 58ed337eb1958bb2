// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/judgement_difference.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "verify/harness/journal.hpp"

namespace fathom::harness {
namespace {

using Json = nlohmann::ordered_json;

Json fields_of(const Judgement& judgement) {
  Outcome outcome;
  outcome.judgement = judgement;
  return Json::parse(outcome_line(outcome)).at("judgement");
}

}  // namespace

std::optional<std::string> difference(const Judgement& x, const Judgement& y) {
  const Json one = fields_of(x), other = fields_of(y);
  const auto shown = [](const Json& fields, const std::string& key) { return fields.contains(key) ? fields.at(key).dump() : "nothing"; };
  for (const Json* fields : {&one, &other}) {
    for (const auto& [key, value] : fields->items())
      if (shown(one, key) != shown(other, key)) return fmt::format("judgement.{}: {} and {}", key, shown(one, key), shown(other, key));
  }
  return std::nullopt;
}

}  // namespace fathom::harness
