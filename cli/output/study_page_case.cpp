// SPDX-License-Identifier: GPL-3.0-or-later
// One case of the page of studies.
#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

#include "cli/output/coordinates.hpp"
#include "cli/output/decimal.hpp"
#include "cli/output/study_output.hpp"
#include "cli/output/study_page.hpp"
#include "cli/output/study_page_parts.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/numbers.hpp"
#include "kernels/number/irrational.hpp"
#include "reference/files/case_json.hpp"
#include "reference/output/json_values.hpp"
#include "view/picture/markup.hpp"

namespace fathom::cli {
namespace {

using picture::FactList;
using Rows = std::vector<CoincidenceRow>;
using Counts = std::vector<std::pair<std::string, std::uint64_t>>;

constexpr std::size_t longest_case = 200'000;  // characters of a case as JSON
constexpr std::size_t most_indices = 12;       // of one feature

std::string indices_text(const Feature& feature) {
  std::string result;
  for (std::size_t i = 0; i < std::min(feature.size(), most_indices); ++i) result += fmt::format("{}{}", i > 0 ? " " : "", feature[i]);
  return feature.size() <= most_indices ? result : fmt::format("{} ... ({} in all)", result, feature.size());
}

/// The features of one body in a coincidence, as links to their marks.
std::string features_text(CoincidenceRow& row, Marks* marks, bool of_a, const std::vector<Feature>& features) {
  std::string result;
  for (const Feature& feature : features) {
    if (!result.empty()) result += ", ";
    const std::string id = marks ? marks->of(of_a, feature) : "";
    if (!id.empty()) row.lights.push_back(id);
    result += id.empty() ? indices_text(feature) : fmt::format("<a href=\"#{}\">{}</a>", id, indices_text(feature));
  }
  return result;
}

Rows rows_of(const Study& study, Marks* marks) {
  Rows rows;
  for (std::size_t i = 0; i < coincidence_names.size(); ++i) {
    const auto& listed = study.coincidences[i].listed;
    for (std::size_t k = 0; k < listed.size(); ++k) {
      CoincidenceRow row{spoken(coincidence_names[i]), k + 1, "", "", {}};
      row.a = features_text(row, marks, true, listed[k].a);
      row.b = features_text(row, marks, false, listed[k].b);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

Rows rows_of(const ShapeStudy& study) {
  Rows rows;
  for (std::size_t i = 0; i < shape_coincidence_names.size(); ++i) {
    const auto& listed = study.coincidences[i].listed;
    for (std::size_t k = 0; k < listed.size(); ++k)
      rows.push_back({spoken(shape_coincidence_names[i]),
                      k + 1,
                      picture::markup(feature_text(listed[k].a)),
                      picture::markup(feature_text(listed[k].b)),
                      {}});
  }
  return rows;
}

template <class AnyStudy, class Names>
Counts counts_of(const AnyStudy& study, const Names& names) {
  Counts counts;
  for (std::size_t i = 0; i < names.size(); ++i) counts.emplace_back(spoken(names[i]), study.coincidences[i].count);
  return counts;
}

void add_depth(FactList& facts, const Depth& depth) {
  facts.add_text("status", name(depth.status()));
  if (const Penetration* found = depth.penetration()) {
    facts.add_text("depth", root_text(found->squared()));
    facts.add_text("depth^2", exact_text(found->squared()));
    facts.add_text("optima", fmt::format("{}", depth.optima_count()));
    facts.add_text("translation of A", place_text(depth.translation(), false));
  }
  if (const Distance* apart = depth.distance()) {
    facts.add_text("distance", root_text(apart->squared));
    facts.add_text("distance^2", exact_text(apart->squared));
  }
  if (const Contact* contact = depth.contact()) facts.add_text("contact", contact_text(*contact));
}

FactList facts_of(const Study& study) {
  FactList facts;
  add_depth(facts, study.depth);
  facts.add_text("A", size_text(study.a));
  facts.add_text("B", size_text(study.b));
  return facts;
}

/// The case, to be copied; a sentence if it is too long for a page; nothing for shapes without words.
std::string case_part(const Case& pair, const std::string& anchor) {
  try {
    const std::string line = files::case_json(pair);
    if (line.size() < longest_case) return picture::copied_text(anchor + "case", "copy this case", "The case as a line of JSON", line);
    return fmt::format("<p class=\"soft\">The case has {} points and is not on this page.</p>\n",
                       pair.a.points.size() + pair.b.points.size());
  } catch (const std::invalid_argument&) {
    return "";
  }
}

std::string coincidences_heading(const std::string& tables) { return "<h3>What coincides</h3>\n" + tables; }
std::string predicates_heading(const Study& study) {
  return "<h3>What the perturbation decided</h3>\n" + predicates_part(study.predicates);
}

}  // namespace

std::string study_section(const Case& pair, const Study& study, const std::string& anchor) {
  Marks marks(anchor);
  const std::string table = coincidences_part(anchor, rows_of(study, &marks), counts_of(study, coincidence_names));
  const std::string said = facts_of(study).list() + coincidences_heading(table) + predicates_heading(study) + case_part(pair, anchor);
  return picture::beside(study_figure(pair, study.depth, marks, anchor), said);
}

std::string study_section(const Case& pair, const ShapeStudy& study, const std::string& anchor) {
  FactList facts;
  facts.add_text("status", status_name(study.depth));
  if (study.depth.exact()) {
    facts.add_text("signed depth", surd_text(*study.depth.exact()));
    facts.add_text("exactly", kernels::exact_surd_text(*study.depth.exact()));
  } else {
    facts.add_text("signed depth", fmt::format("from {} to {}", study.depth.low_binary64(), study.depth.high_binary64()));
  }
  facts.add_text("A", size_text(study.a));
  facts.add_text("B", size_text(study.b));
  if (study.contact) facts.add_text("contact", involved_text(*study.contact));
  std::string said =
      facts.list() + coincidences_heading(coincidences_part(anchor, rows_of(study), counts_of(study, shape_coincidence_names)));
  if (study.cores) {
    const Study& cores = *study.cores;
    const std::string table = coincidences_part(anchor + "k", rows_of(cores, nullptr), counts_of(cores, coincidence_names));
    said += "<details class=\"part\"><summary>The cores, without their radii: " + picture::markup(status_text(cores.depth)) +
            "</summary>\n" + facts_of(cores).list() + coincidences_heading(table) + predicates_heading(cores) + "</details>\n";
  }
  return picture::beside(study_figure(pair, study.depth, anchor), said + case_part(pair, anchor));
}

}  // namespace fathom::cli
