// SPDX-License-Identifier: GPL-3.0-or-later
// Studies as JSON, schema fathom/study/1.
#include <nlohmann/json.hpp>

#include "cli/output/study_output.hpp"
#include "fathom/numbers.hpp"
#include "kernels/number/infinitesimal.hpp"

namespace fathom::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* schema = "fathom/study/1";

Json size_object(const BodySize& size) {
  return {{"rank", size.rank}, {"vertices", size.vertices}, {"edges", size.edges}, {"facets", size.facets}};
}

Json predicates_object(const PredicateCounts& counts) {
  Json result;
  for (std::size_t i = 0; i < predicate_names.size(); ++i) {
    Json decided = Json::array();
    for (const auto& [packed, count] : counts[i].decided) {
      decided.push_back({{"monomial", kernels::Monomial::unpacked(packed).text()}, {"name", monomial_name(packed)}, {"count", count}});
    }
    result[std::string(predicate_names[i])] = {
        {"calls", counts[i].calls}, {"exact", counts[i].exact}, {"zero", counts[i].zero}, {"decided_by", std::move(decided)}};
  }
  return result;
}

Json coincidences_object(const Study& study) {
  Json result;
  for (std::size_t i = 0; i < coincidence_names.size(); ++i) {
    Json listed = Json::array();
    for (const Involved& involved : study.coincidences[i].listed) listed.push_back({{"a", involved.a}, {"b", involved.b}});
    result[std::string(coincidence_names[i])] = {{"count", study.coincidences[i].count}, {"listed", std::move(listed)}};
  }
  return result;
}

/// Ids and file names may hold any bytes; what is not UTF-8 is replaced, never an error.
std::string one_line(const Json& object) { return object.dump(-1, ' ', true, Json::error_handler_t::replace); }

}  // namespace

std::string study_json(const std::string& id, const Study& study) {
  return one_line({{"schema", schema},
                   {"id", id},
                   {"status", name(study.depth.status())},
                   {"squared", exact_text(study.depth.squared())},
                   {"optima", study.depth.optima().size()},
                   {"bodies", {{"a", size_object(study.a)}, {"b", size_object(study.b)}}},
                   {"predicates", predicates_object(study.predicates)},
                   {"coincidences", coincidences_object(study)}});
}

std::string study_json_error(const std::string& id, std::size_t line, const std::string& error) {
  return one_line({{"schema", schema}, {"id", id}, {"line", line}, {"error", error}});
}

}  // namespace fathom::cli
