// SPDX-License-Identifier: GPL-3.0-or-later
// The page of studies: its pieces, each a whole element or a few, in which texts of others are
// escaped; the section of a case; the page.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/output/study_output.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "fathom/study.hpp"
#include "kernels/messages.hpp"
#include "kernels/number/irrational.hpp"
#include "reference/files/case_json.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/output/json_values.hpp"
#include "view/picture/markup.hpp"
#include "view/picture/scene.hpp"

namespace fathom::cli {
namespace {

/// The features that a picture shows when they are asked for, each with an id of its own.
class Marks {
 public:
  /// `anchor` begins the ids; at most `most` features have one.
  explicit Marks(std::string anchor, std::size_t most = 2000) : anchor_(std::move(anchor)), most_(most) {}

  /// The id of a feature; empty if there are too many.
  std::string of(bool of_a, const Feature& feature) {
    const auto found = ids_.find({of_a, feature});
    if (found != ids_.end()) return found->second;
    if (ids_.size() == most_) return "";
    return ids_[{of_a, feature}] = fmt::format("{}{}{}", anchor_, of_a ? "a" : "b", ids_.size() + 1);
  }
  /// By body and feature.
  [[nodiscard]] const std::map<std::pair<bool, Feature>, std::string>& all() const { return ids_; }

 private:
  std::string anchor_;
  std::size_t most_;
  std::map<std::pair<bool, Feature>, std::string> ids_;
};

/// A row of the table of coincidences.
struct CoincidenceRow {
  std::string kind;                 ///< its name, as spoken
  std::uint64_t number;             ///< among those of its kind, from 1 on
  std::string a, b;                 ///< markup: the features
  std::vector<std::string> lights;  ///< the ids that the row lights
};

using kernels::counted;
using picture::FactList;

using Rows = std::vector<CoincidenceRow>;
using Counts = std::vector<std::pair<std::string, std::uint64_t>>;  // by name, as spoken

std::string row_element(const CoincidenceRow& row) {
  const std::string lights = row.lights.empty() ? "" : fmt::format(" data-lights=\"{}\"", fmt::join(row.lights, " "));
  return fmt::format(
      "<tr data-kind=\"{0}\"{1}><th scope=\"row\">{0}</th><td>{2}</td><td class=\"name\">{3}</td><td "
      "class=\"name\">{4}</td></tr>\n",
      row.kind, lights, row.number, row.a, row.b);
}

std::string unlisted_text(const Rows& rows, const Counts& counts) {
  std::vector<std::string> parts;
  for (const auto& [kind, count] : counts) {
    const auto listed = static_cast<std::uint64_t>(std::ranges::count(rows, kind, &CoincidenceRow::kind));
    if (listed < count) parts.push_back(fmt::format("{} of {}", count - listed, kind));
  }
  return parts.empty()
             ? ""
             : fmt::format("<p class=\"soft\">Not listed: {}; --all lists every one.</p>\n", fmt::join(parts, ", "));
}

std::string counts_list(const std::string& anchor, const Counts& counts) {
  std::string items;
  std::vector<std::string> none;
  for (const auto& [kind, count] : counts) {
    if (count == 0) none.push_back(kind);
    else
      items += fmt::format(
          "<li><b>{0}</b> <a href=\"#{1}rows\" data-of=\"{1}rows\" data-find=\"\" data-choice=\"{2}\">{2}</a></li>",
          count, anchor, kind);
  }
  std::string result = items.empty() ? "" : fmt::format("<ul class=\"legend\">{}</ul>\n", items);
  if (!none.empty()) result += fmt::format("<p class=\"soft\">none: {}</p>\n", fmt::join(none, ", "));
  return result;
}

/// A table that can be filtered, with what is not listed and the names of what there is none of.
std::string coincidences_part(const std::string& anchor, const Rows& rows, const Counts& counts) {
  std::string result = counts_list(anchor, counts);
  if (rows.empty()) return result;
  std::string body;
  for (const CoincidenceRow& row : rows) body += row_element(row);
  std::vector<picture::Choice> kinds;
  for (const auto& [kind, count] : counts)
    if (count > 0) kinds.push_back({kind, kind});
  const std::string table = fmt::format(
      "<thead><tr><th scope=\"col\" class=\"text\">coincidence</th><th scope=\"col\">no.</th><th scope=\"col\" "
      "class=\"text\">of A</th>"
      "<th scope=\"col\" class=\"text\">of B</th></tr></thead>\n<tbody id=\"{}rows\">\n{}</tbody>",
      anchor, body);
  return result + picture::filter_bar(anchor + "rows", "coincidence", kinds) +
         picture::table_box("Coincidences", table, true) + unlisted_text(rows, counts);
}

/// The zeros of the predicates, and which monomials decided.
std::string predicates_part(const PredicateCounts& counts) {
  std::string rows;
  for (std::size_t i = 0; i < predicate_names.size(); ++i) {
    std::vector<std::string> decided;
    for (const auto& [packed, count] : counts[i].decided)
      decided.push_back(fmt::format("{}: {}", monomial_name(packed), count));
    rows +=
        fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td><td class=\"text\">{}</td></tr>\n",
                    spoken(predicate_names[i]), counts[i].calls, counts[i].exact, counts[i].zero,
                    picture::markup(fmt::format("{}", fmt::join(decided, ", "))));
  }
  const std::string table =
      "<thead><tr><th scope=\"col\" class=\"text\">predicate</th><th scope=\"col\">calls</th><th "
      "scope=\"col\">exact</th>"
      "<th scope=\"col\">zero</th><th scope=\"col\" class=\"text\">decided by</th></tr></thead>\n<tbody>\n" +
      rows + "</tbody>";
  return picture::table_box("What the perturbation decided", table, false) +
         "<p class=\"soft\">exact: calls that floating point could not decide; zero: those that are 0, which the "
         "perturbation then "
         "decided. Eij "
         "are the infinitesimals that move -A; a, b, c tilt the chart's frame.</p>\n";
}

// The picture of a case in the page of studies.

std::string figure(const picture::PairScene& scene, const std::string& svg) {
  std::string caption = "<span class=\"key body-a\">A</span> toned, <span class=\"key body-b\">B</span> hatched";
  if (scene.has_edges()) caption += ", hidden edges dashed";
  if (!scene.moves()) caption += "; <span class=\"key true\">dot</span>: where they touch";
  else if (scene.status == Status::disjoint)
    caption += "; <span class=\"key true\">arrow</span>: the way of A until it touches B, and A there, dashed";
  else
    caption +=
        "; <span class=\"key true\">arrow</span>: the shortest way of A out of B, and A there, dashed; thick: the "
        "faces in contact";
  return fmt::format("<figure><div class=\"pairs\">{}</div><figcaption>{}.</figcaption></figure>\n", svg, caption);
}

/// The picture of the bodies, with its legend; empty if there is none. The features of `marks` are
/// in it.
std::string study_figure(const Case& pair, const Depth& depth, const Marks& marks, const std::string& anchor) {
  std::vector<picture::Mark> shown;
  for (const auto& [feature, id] : marks.all()) {
    const GivenPoints& points = feature.first ? pair.a.points : pair.b.points;
    picture::Mark mark{feature.first, {}, id};
    for (const std::uint32_t i : feature.second) mark.points.push_back(points[i]);
    shown.push_back(std::move(mark));
  }
  const picture::PairScene scene = picture::scene_of({pair.a.points, pair.b.points, depth});
  return figure(scene, picture::scene_panels(scene, anchor, "Hulls of " + picture::markup(pair.id), shown));
}

std::string study_figure(const Case& pair, const SignedDepth& depth, const std::string& anchor) {
  const picture::PairScene scene = picture::scene_of(files::shape_of(pair.a), files::shape_of(pair.b), depth);
  return figure(scene, picture::scene_panels(scene, anchor, "Shapes of " + picture::markup(pair.id)));
}

// One case of the page of studies.

constexpr std::size_t longest_case = 200'000;  // characters of a case as JSON

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

/// The case, to be copied; a sentence if it is too long for a page; nothing for shapes without
/// words.
std::string case_part(const Case& pair, const std::string& anchor) {
  try {
    const std::string line = files::case_json(pair);
    if (line.size() < longest_case)
      return picture::copied_text(anchor + "case", "copy this case", "The case as a line of JSON", line);
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

/// What the page says of one case, without its name. `anchor` begins the ids of its elements.
std::string study_section(const Case& pair, const Study& study, const std::string& anchor) {
  Marks marks(anchor);
  const std::string table = coincidences_part(anchor, rows_of(study, &marks), counts_of(study, coincidence_names));
  const std::string said =
      facts_of(study).list() + coincidences_heading(table) + predicates_heading(study) + case_part(pair, anchor);
  return picture::beside(study_figure(pair, study.depth, marks, anchor), said);
}

std::string study_section(const Case& pair, const ShapeStudy& study, const std::string& anchor) {
  FactList facts;
  facts.add_text("status", status_name(study.depth));
  if (study.depth.exact()) {
    facts.add_text("signed depth", surd_text(*study.depth.exact()));
    facts.add_text("exactly", kernels::exact_surd_text(*study.depth.exact()));
  } else {
    facts.add_text("signed depth",
                   fmt::format("from {} to {}", study.depth.low_binary64(), study.depth.high_binary64()));
  }
  facts.add_text("A", size_text(study.a));
  facts.add_text("B", size_text(study.b));
  if (study.contact) facts.add_text("contact", involved_text(*study.contact));
  std::string said = facts.list() + coincidences_heading(coincidences_part(anchor, rows_of(study),
                                                                           counts_of(study, shape_coincidence_names)));
  if (study.cores) {
    const Study& cores = *study.cores;
    const std::string table =
        coincidences_part(anchor + "k", rows_of(cores, nullptr), counts_of(cores, coincidence_names));
    said += "<details class=\"part\"><summary>The cores, without their radii: " +
            picture::markup(status_text(cores.depth)) + "</summary>\n" + facts_of(cores).list() +
            coincidences_heading(table) + predicates_heading(cores) + "</details>\n";
  }
  return picture::beside(study_figure(pair, study.depth, anchor), said + case_part(pair, anchor));
}

constexpr std::size_t most_shown = 500;   // cases in full
constexpr std::size_t most_faults = 100;  // sentences

constexpr std::array<std::pair<const char*, const char*>, 4> status_styles{
    {{"penetrating", "good"}, {"touching", "fair"}, {"disjoint", "left"}, {"undecided", "lost"}}};

}  // namespace

template <class AnyStudy, class Names>
void StudyPage::take(const Case& pair, const AnyStudy& study, std::string_view status, const std::string& headline,
                     const Names& names) {
  ++cases_;
  ++statuses_[std::string(status)];
  std::string present;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::uint64_t count = study.coincidences[i].count;
    if (count == 0) continue;
    Total& total = coincidences_[spoken(names[i])];
    ++total.cases;
    total.count += count;
    present += fmt::format("; {}: {}", spoken(names[i]), count);
  }
  title_ = picture::markup(pair.id);
  headline_ = picture::markup(headline);
  if (shown_ == most_shown) return;
  const std::string anchor = fmt::format("c{}-", ++shown_);
  if (!stream_) {
    sections_ += study_section(pair, study, anchor);
    return;
  }
  sections_ += fmt::format(
      "<details class=\"part\" id=\"{}\" data-kind=\"{}\"><summary>{} <span "
      "class=\"soft\">{}{}</span></summary>\n{}</details>\n",
      anchor, status, title_, headline_, present, study_section(pair, study, anchor));
}

void StudyPage::add(const Case& pair, const Study& study) {
  take(pair, study, name(study.depth.status()), status_text(study.depth), coincidence_names);
}

void StudyPage::add(const Case& pair, const ShapeStudy& study) {
  take(pair, study, status_name(study.depth), status_text(study.depth), shape_coincidence_names);
}

void StudyPage::add_fault(const std::string& sentence) { faults_.push_back(sentence); }

std::string StudyPage::head() const {
  if (!stream_) return fmt::format("<h1>{}</h1>\n<p class=\"answer\">{}</p>\n", title_, headline_);
  std::vector<picture::Share> shares;
  for (const auto& [status, style] : status_styles) {
    const auto found = statuses_.find(status);
    shares.push_back({status, found == statuses_.end() ? 0 : found->second, style, ""});
  }
  std::string result =
      fmt::format("<h1>What coincides</h1>\n<p class=\"answer\">{}{}</p>\n", counted(cases_, "case", "cases"),
                  faults_.empty() ? "" : fmt::format(", {}", counted(faults_.size(), "error", "errors")));
  return result + picture::share_bar(shares, "shares", "Cases by status");
}

std::string StudyPage::totals() const {
  std::string rows;
  const auto add = [&](const std::string& kind) {
    const auto found = coincidences_.find(kind);
    if (found == coincidences_.end()) return;
    rows += fmt::format(
        "<tr><th scope=\"row\"><a href=\"#list\" data-of=\"list\" data-find=\"; "
        "{0}:\">{0}</a></th><td>{1}</td><td>{2}</td></tr>\n",
        kind, found->second.cases, found->second.count);
  };
  for (const std::string_view kind : coincidence_names) add(spoken(kind));
  for (const std::string_view kind : shape_coincidence_names)
    if (std::ranges::find(coincidence_names, kind) == coincidence_names.end()) add(spoken(kind));
  if (rows.empty()) return "<p>Nothing coincides.</p>\n";
  const std::string table =
      "<thead><tr><th scope=\"col\" class=\"text\">coincidence</th><th scope=\"col\">cases with any</th><th "
      "scope=\"col\">in all</th></tr>"
      "</thead>\n<tbody>\n" +
      rows + "</tbody>";
  return picture::table_box("Coincidences of all cases", table, false);
}

std::string StudyPage::case_by_case() const {
  std::vector<picture::Choice> kinds;
  for (const auto& [status, style] : status_styles)
    if (statuses_.contains(status)) kinds.push_back({status, status});
  std::string result = "<section><h2>All cases</h2>\n" + totals() + "</section>\n<section><h2>Case by case</h2>\n";
  result += picture::filter_bar("list", "status", kinds) + "<div id=\"list\">\n" + sections_ + "</div>\n";
  if (shown_ < cases_)
    result += fmt::format("<p>{} further cases are counted above and not shown.</p>\n", cases_ - shown_);
  return result + "</section>\n";
}

std::string StudyPage::without_study() const {
  if (faults_.empty()) return "";
  std::string items;
  for (std::size_t i = 0; i < std::min(faults_.size(), most_faults); ++i)
    items += fmt::format("<li>{}</li>\n", picture::markup(faults_[i]));
  const std::string more =
      faults_.size() > most_faults ? fmt::format("<p>{} more are not listed.</p>\n", faults_.size() - most_faults) : "";
  return "<section><h2>Cases without a study</h2>\n<ul>\n" + items + "</ul>\n" + more + "</section>\n";
}

std::string StudyPage::html(const std::string& command, const std::string& cut_short) const {
  const std::string warning =
      cut_short.empty() ? ""
                        : fmt::format("<p class=\"warning\" role=\"note\">{}; this is what was studied.</p>\n",
                                      picture::markup(cut_short));
  const std::string body = fmt::format(
      "<header>{}{}</header>\n<main>\n{}{}</main>\n<footer><p class=\"soft\">Made by fathom {}. Counts are exact; "
      "features are 0-based "
      "indices of points.</p>\n<p class=\"soft\"><code>{}</code></p></footer>\n",
      head(), warning, stream_ ? case_by_case() : sections_, without_study(), FATHOM_VERSION,
      picture::markup(picture::without_folders(command)));
  return picture::page(stream_ ? "What coincides" : title_ + ": what coincides", body);
}

}  // namespace fathom::cli
