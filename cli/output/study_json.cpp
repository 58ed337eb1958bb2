// SPDX-License-Identifier: GPL-3.0-or-later
// Studies as JSON, schema fathom/study/1.
#include "cli/output/study_output.hpp"
#include "fathom/numbers.hpp"
#include "kernels/number/infinitesimal.hpp"
#include "reference/output/json_values.hpp"

namespace fathom::cli {
namespace {

constexpr const char* schema = "fathom/study/1";

Json size_object(const BodySize& size) {
  return {{"rank", size.rank}, {"vertices", size.vertices}, {"edges", size.edges}, {"facets", size.facets}};
}

Json points_of(const std::vector<Feature>& features) {
  Json result = Json::array();
  for (const Feature& points : features) result.push_back(points);
  return result;
}

Json predicates_object(const PredicateCounts& counts) {
  Json result;
  for (std::size_t i = 0; i < predicate_names.size(); ++i) {
    Json decided = Json::array();
    for (const auto& [packed, count] : counts[i].decided) {
      decided.push_back({{"monomial", kernels::Monomial::unpacked(packed).text()}, {"name", monomial_name(packed)}, {"count", count}});
    }
    result[predicate_names[i]] = {
        {"calls", counts[i].calls}, {"exact", counts[i].exact}, {"zero", counts[i].zero}, {"decided_by", decided}};
  }
  return result;
}

Json coincidences_object(const Study& study) {
  Json result;
  for (std::size_t i = 0; i < coincidence_names.size(); ++i) {
    Json listed = Json::array();
    for (const Involved& involved : study.coincidences[i].listed)
      listed.push_back({{"a", points_of(involved.a)}, {"b", points_of(involved.b)}});
    result[coincidence_names[i]] = {{"count", study.coincidences[i].count}, {"listed", listed}};
  }
  return result;
}

}  // namespace

Json study_head(const std::string& id) { return {{"schema", schema}, {"id", id}}; }

void add_study(Json& object, const Study& study) {
  object["status"] = name(study.depth.status());
  object["squared"] = exact_text(study.depth.squared());
  object["optima"] = study.depth.optima().size();
  object["bodies"] = {{"a", size_object(study.a)}, {"b", size_object(study.b)}};
  object["predicates"] = predicates_object(study.predicates);
  object["coincidences"] = coincidences_object(study);
}

std::string study_json(const std::string& id, const Study& study) {
  Json result = study_head(id);
  add_study(result, study);
  return result.text();
}

std::string study_json_error(const std::string& id, std::size_t line, const std::string& error) {
  return output::error_object(schema, id, line, error);
}

}  // namespace fathom::cli
