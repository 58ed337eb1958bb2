// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/release/agreement.hpp"

#include <nlohmann/json.hpp>

#include "reference/solve/disagreement.hpp"

namespace fathom::golden {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string agreement_text(const Agreement& agreement) {
  Json methods = Json::array();
  for (const Method method : agreement.methods) methods.push_back(name(method));
  const Json json = {{"schema", "fathom/golden-agreement/2"},
                     {"content_sha256", agreement.content_sha256},
                     {"records", agreement.records},
                     {"methods", methods}};
  return json.dump(2) + '\n';
}

std::optional<Agreement> parse_agreement(std::string_view text) {
  try {
    const Json json = Json::parse(text);
    Agreement agreement{json.at("content_sha256").get<std::string>(), json.at("records").get<std::size_t>(), {}};
    for (const Json& method : json.at("methods")) agreement.methods.push_back(solve::second_method(method.get<std::string>()).value());
    if (!agreement.methods.empty() && agreement_text(agreement) == text) return agreement;
  } catch (const std::exception&) {  // no JSON, or other fields than ours
  }
  return std::nullopt;
}

}  // namespace fathom::golden
