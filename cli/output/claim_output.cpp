// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/claim_output.hpp"

#include <fmt/format.h>

#include "cli/output/answer_output.hpp"
#include "reference/output/json_values.hpp"

namespace fathom::cli {

std::string claim_text(const claims::PublishedClaim& claim, const claims::JudgedClaim& judged) {
  std::string text = fmt::format("{}: {}", safe_id(claim.bodies.id), claims::verdict_name(judged.finding()));
  for (const claims::Statement& statement : judged.statements)
    text += fmt::format("\n  {}: {}; {}", statement.text, claims::verdict_name(statement.finding), statement.truth);
  return text;
}

std::string claim_json(const claims::PublishedClaim& claim, const claims::JudgedClaim& judged) {
  Json statements = Json::array();
  for (const claims::Statement& statement : judged.statements)
    statements.push_back({{"text", statement.text}, {"finding", claims::verdict_name(statement.finding)}, {"truth", statement.truth}});
  Json result = {{"schema", "fathom/claim/1"}, {"fathom", FATHOM_VERSION}, {"id", claim.bodies.id},
                 {"source", claim.source},     {"kind", claim.kind},       {"note", claim.note}};
  result["verdict"] = claims::verdict_name(judged.finding());
  result["signed_depth"] = output::signed_depth_object(judged.truth);
  if (claim.numeric) result["numeric"] = *claim.numeric;
  result["direction"] = output::exact(judged.truth.direction());
  result["statements"] = statements;
  return result.text();
}

}  // namespace fathom::cli
