// SPDX-License-Identifier: GPL-3.0-or-later
// Studies as text: a block for one case, a line for each case of a stream; as JSON; as CSV; and the
// table of a stream as a page.

#include "cli/output/study_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "cli/io/output.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/numbers.hpp"
#include "kernels/messages.hpp"
#include "kernels/number/infinitesimal.hpp"
#include "kernels/number/irrational.hpp"
#include "reference/output/json_values.hpp"
#include "view/picture/markup.hpp"

namespace fathom::cli {
namespace {

/// The column of continued lines of a body: below the text that follows "A  ".
constexpr std::size_t body_column = 3;

constexpr std::size_t most_monomials = 6;
constexpr std::size_t longest_exact = 40;
constexpr std::size_t decided_column = 52, features_column = 32, none_column = 6;

using kernels::counted;
using Lines = std::vector<std::string>;

/// Returns the text with the gap to the column before it.
std::string decided_text(const TierCounts& tiers) {
  Lines parts;
  for (const auto& [packed, count] : tiers.decided) {
    if (parts.size() == most_monomials) {
      parts.emplace_back("...");
      break;
    }
    parts.push_back(fmt::format("{}: {}", monomial_name(packed), count));
  }
  return parts.empty() ? "" : fmt::format("  {}", fmt::join(parts, ", "));
}

void add_predicates(Lines& lines, const PredicateCounts& counts) {
  bool any = false;
  lines.push_back(
      fitted(fmt::format("{:<18}{:>12}{:>10}{:>10}  {}", "predicate", "calls", "exact", "zero", "decided by"),
             decided_column));
  for (std::size_t i = 0; i < predicate_names.size(); ++i) {
    const TierCounts& tiers = counts[i];
    lines.push_back(fitted(fmt::format("{:<18}{:>12}{:>10}{:>10}{}", spoken(predicate_names[i]), tiers.calls,
                                       tiers.exact, tiers.zero, decided_text(tiers)),
                           decided_column));
    any = any || tiers.zero > 0;
  }
  if (any) lines.push_back(fitted("Eij are the infinitesimals that move -A; a, b, c tilt the chart's frame"));
}

void add_features(Lines& parts, std::string_view body, const std::vector<Feature>& features) {
  for (const Feature& points : features) parts.push_back(fmt::format("{} {}", body, indices_text(points)));
}

/// Returns "A 0 1, B 4 5": the input points of each feature.
std::string points_text(const Involved& involved) {
  Lines parts;
  add_features(parts, "A", involved.a);
  add_features(parts, "B", involved.b);
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// Adds the coincidences that occur with their counts, for a line.
template <class Names, class Coincidences>
void add_present(Lines& parts, const Names& names, const Coincidences& coincidences) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (const std::uint64_t count = coincidences[i].count)
      parts.push_back(fmt::format("{} {}", spoken(names[i]), count));
}

/// Adds a row for each coincidence that occurs, with the features of the first one, or of all that
/// are listed; and one row with the names of those that do not occur. `head` is the heading of the
/// last column.
template <class Names, class Coincidences, class Text>
void add_coincidences(Lines& lines, const Names& names, const Coincidences& coincidences, bool all,
                      std::string_view head, const Text& text) {
  Lines absent;
  lines.push_back(fitted(fmt::format("{:<22}{:>8}  {}", "coincidence", "count", head), features_column));
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto& [count, listed] = coincidences[i];
    if (count == 0) {
      absent.push_back(spoken(names[i]));
      continue;
    }
    lines.push_back(
        fitted(fmt::format("{:<22}{:>8}{}", spoken(names[i]), count, listed.empty() ? "" : "  " + text(listed.front())),
               features_column));
    for (std::size_t k = 1; all && k < listed.size(); ++k)
      lines.push_back(fitted(fmt::format("{:{}}{}", "", features_column, text(listed[k])), features_column));
  }
  if (!absent.empty()) lines.push_back(fitted(fmt::format("none: {}", fmt::join(absent, ", ")), none_column));
}

// Studies as JSON, schema fathom/study/1.

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
      decided.push_back({{"monomial", kernels::Monomial::unpacked(packed).text()},
                         {"name", monomial_name(packed)},
                         {"count", count}});
    }
    result[predicate_names[i]] = {
        {"calls", counts[i].calls}, {"exact", counts[i].exact}, {"zero", counts[i].zero}, {"decided_by", decided}};
  }
  return result;
}

Json involved_object(const Involved& involved) { return {{"a", points_of(involved.a)}, {"b", points_of(involved.b)}}; }

// Studies as lines of CSV.

/// Returns the text of a field: control characters escaped, and quoted if necessary.
std::string field(const std::string& any) {
  const std::string text = safe_id(any);
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string row(const std::vector<std::string>& fields) { return fmt::format("{}", fmt::join(fields, ",")); }

std::vector<std::string> columns() {
  std::vector<std::string> names{"id", "status", "squared", "optima"};
  for (const std::string_view what : coincidence_names) names.emplace_back(what);
  for (const std::string_view what : predicate_names) {
    for (const char* tier : {"calls", "exact", "zero"}) names.push_back(fmt::format("{}_{}", what, tier));
  }
  names.emplace_back("error");
  return names;
}

// Studies of shapes as JSON.

Json size_object(const ShapeSize& size) {
  return {{"half_space", size.half_space ? 1 : 0},
          {"terms", size.terms},
          {"points", size.points},
          {"discs", size.discs},
          {"balls", size.balls},
          {"radius", Json::plain(exact_text(size.radius))}};
}

Json feature_object(const ShapeFeature& feature) {
  Json result = {{"feature", feature.what}};
  if (!is_zero(feature.direction)) result["direction"] = output::exact(feature.direction);
  if (feature.point) result["point"] = output::exact(*feature.point);
  if (feature.length) result["length"] = output::exact_object(*feature.length);
  return result;
}

Json involved_object(const ShapeInvolved& involved) {
  return {{"a", feature_object(involved.a)}, {"b", feature_object(involved.b)}};
}

/// Returns each coincidence by its name, with the listed features.
template <class Names, class Coincidences>
Json coincidences_object(const Names& names, const Coincidences& coincidences) {
  Json result;
  for (std::size_t i = 0; i < names.size(); ++i) {
    Json listed = Json::array();
    for (const auto& involved : coincidences[i].listed) listed.push_back(involved_object(involved));
    result[names[i]] = {{"count", coincidences[i].count}, {"listed", listed}};
  }
  return result;
}

void add_study(Json& object, const Study& study) {
  object["status"] = name(study.depth.status());
  object["squared"] = exact_text(study.depth.squared());
  object["optima"] = study.depth.optima().size();
  object["bodies"] = {{"a", size_object(study.a)}, {"b", size_object(study.b)}};
  object["predicates"] = predicates_object(study.predicates);
  object["coincidences"] = coincidences_object(coincidence_names, study.coincidences);
}

/// Returns "8 vertices, 12 edges, 6 facets"; "1 disc, radius 1/2".
std::string size_text(const BodySize& size) {
  return fmt::format("{}, {}, {}{}", counted(size.vertices, "vertex", "vertices"), counted(size.edges, "edge", "edges"),
                     counted(size.facets, "facet", "facets"), size.rank < 3 ? "; flat" : "");
}

/// Returns "penetrating; depth^2 1/16; 1 optimum"; "penetrating; signed depth 1/2".
std::string status_text(const Depth& depth) {
  std::string result(name(depth.status()));
  if (depth.status() != Status::penetrating) return result;
  const std::string squared = exact_text(depth.squared());
  result += squared.size() <= longest_exact ? "; depth^2 " + squared : "; depth " + root_text(depth.squared());
  return result + "; " + counted(depth.optima().size(), "optimum", "optima");
}

std::string status_text(const SignedDepth& depth) {
  const std::string value =
      depth.exact() ? "signed depth " + kernels::exact_surd_text(*depth.exact())
                    : fmt::format("signed depth from {} to {}", depth.low_binary64(), depth.high_binary64());
  return fmt::format("{}; {}", name(depth.status()), value);
}

std::string size_text(const ShapeSize& size) {
  Lines parts;
  const auto add = [&](std::uint64_t count, std::string_view one, std::string_view many) {
    if (count > 0) parts.push_back(counted(count, one, many));
  };
  if (size.half_space) parts.emplace_back("a half-space");
  if (size.terms > 1) add(size.terms, "term", "terms");
  add(size.points, "point", "points");
  add(size.discs, "disc", "discs");
  add(size.balls, "ball", "balls");
  if (size.radius > 0) parts.push_back("radius " + exact_text(size.radius));
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// Returns "axis (0, 0, 1) at (0, 0, 0)".
std::string feature_text(const ShapeFeature& feature) {
  std::string text(feature.what);
  if (feature.length) text += " " + kernels::exact_surd_text(*feature.length);
  if (!is_zero(feature.direction)) text += " " + direction_text(feature.direction);
  if (feature.point) text += " at " + point_text(*feature.point);
  return text;
}

/// Returns "A axis ..., B axis ...".
std::string involved_text(const ShapeInvolved& involved) {
  return fmt::format("A {}, B {}", feature_text(involved.a), feature_text(involved.b));
}

/// Returns the fields at the beginning of every study.
Json study_head(const std::string& id) { return {{"schema", schema}, {"id", id}}; }

}  // namespace

std::string spoken(std::string_view name) {
  std::string result(name);
  std::ranges::replace(result, '_', ' ');
  if (result.ends_with(" of a")) result.back() = 'A';
  if (result.ends_with(" of b")) result.back() = 'B';
  return result;
}

std::string study_block(const Study& study, bool all) {
  Lines lines{fitted(status_text(study.depth), body_column), fitted("A  " + size_text(study.a), body_column),
              fitted("B  " + size_text(study.b), body_column), ""};
  add_predicates(lines, study.predicates);
  lines.emplace_back();
  add_coincidences(lines, coincidence_names, study.coincidences, all,
                   all ? "points of the features" : "points of the first's features", points_text);
  return fmt::format("{}", fmt::join(lines, "\n"));
}

std::string study_line(const std::string& id, const Study& study) {
  Lines parts{status_text(study.depth)};
  for (std::size_t i = 0; i < predicate_names.size(); ++i) {
    const TierCounts& tiers = study.predicates[i];
    if (tiers.zero > 0)
      parts.push_back(fmt::format("{} {} of {} zero", spoken(predicate_names[i]), tiers.zero, tiers.calls));
  }
  add_present(parts, coincidence_names, study.coincidences);
  return case_line(id, parts);
}

std::string study_json(const std::string& id, const Study& study) {
  Json result = study_head(id);
  add_study(result, study);
  return result.text();
}

std::string study_json_error(const std::string& id, std::size_t line, const std::string& error) {
  return output::error_object(schema, id, line, error);
}

std::string study_csv_header() { return row(columns()); }

std::string study_csv_row(const std::string& id, const Study& study) {
  const Depth& depth = study.depth;
  std::vector<std::string> fields{field(id), std::string(name(depth.status())), exact_text(depth.squared()),
                                  std::to_string(depth.optima().size())};
  for (const Coincidences& all : study.coincidences) fields.push_back(std::to_string(all.count));
  for (const TierCounts& tiers : study.predicates) {
    for (const std::uint64_t count : {tiers.calls, tiers.exact, tiers.zero}) fields.push_back(std::to_string(count));
  }
  fields.emplace_back();  // no error
  return row(fields);
}

std::string study_csv_error(const std::string& id, const std::string& error) {
  std::vector<std::string> fields(columns().size());
  fields.front() = field(id);
  fields.back() = field(error);
  return row(fields);
}

std::string study_block(const ShapeStudy& study, bool all) {
  Lines lines{fitted(status_text(study.depth), body_column), fitted("A  " + size_text(study.a), body_column),
              fitted("B  " + size_text(study.b), body_column)};
  if (study.contact) lines.push_back(fitted("contact  " + involved_text(*study.contact), 9));
  lines.emplace_back();
  add_coincidences(lines, shape_coincidence_names, study.coincidences, all, all ? "features" : "features of the first",
                   involved_text);
  if (study.cores) {
    lines.insert(lines.end(), {"", "cores"});
    lines.push_back(study_block(*study.cores, all));
  }
  return fmt::format("{}", fmt::join(lines, "\n"));
}

std::string study_line(const std::string& id, const ShapeStudy& study) {
  Lines parts{status_text(study.depth)};
  add_present(parts, shape_coincidence_names, study.coincidences);
  return case_line(id, parts);
}

std::string study_json(const std::string& id, const ShapeStudy& study) {
  Json result = study_head(id);
  result["status"] = name(study.depth.status());
  result["signed_depth"] = output::signed_depth_object(study.depth);
  result["bodies"] = {{"a", size_object(study.a)}, {"b", size_object(study.b)}};
  result["contact"] = study.contact ? involved_object(*study.contact) : Json();
  result["coincidences"] = coincidences_object(shape_coincidence_names, study.coincidences);
  if (study.cores) {
    Json cores;
    add_study(cores, *study.cores);
    result["cores"] = cores;
  }
  return result.text();
}

// ---- the table of a stream ----

namespace {

constexpr std::size_t most_rows = 10'000;  // cases
constexpr std::size_t most_faults = 100;   // sentences

constexpr std::array<std::pair<const char*, const char*>, 4> status_styles{
    {{"penetrating", "good"}, {"touching", "fair"}, {"disjoint", "left"}, {"undecided", "lost"}}};

template <class Names, class Coincidences>
StudyTableRow row_of(const std::string& id, std::string_view status, std::string headline, const Names& names,
                     const Coincidences& coincidences) {
  StudyTableRow result{id, std::string(status), std::move(headline), {}};
  for (std::size_t i = 0; i < names.size(); ++i)
    if (coincidences[i].count > 0) result.present.emplace_back(names[i], coincidences[i].count);
  return result;
}

/// Returns a table in a box, of rows that are markup. Columns whose heading begins with ' are
/// aligned left.
std::string boxed(const std::string& name, std::initializer_list<std::string_view> heads, const std::string& body,
                  const std::string& rows) {
  std::string head;
  for (const std::string_view text : heads)
    head += text.starts_with('\'') ? fmt::format("<th scope=\"col\" class=\"text\">{}</th>", text.substr(1))
                                   : fmt::format("<th scope=\"col\">{}</th>", text);
  const std::string table = fmt::format("<thead><tr>{}</tr></thead>\n<tbody{}>\n{}</tbody>", head, body, rows);
  return picture::table_box(name, table, true);
}

}  // namespace

StudyTableRow table_row(const std::string& id, const Study& study) {
  return row_of(id, name(study.depth.status()), status_text(study.depth), coincidence_names, study.coincidences);
}

StudyTableRow table_row(const std::string& id, const ShapeStudy& study) {
  return row_of(id, name(study.depth.status()), status_text(study.depth), shape_coincidence_names, study.coincidences);
}

void StudyTable::add(const StudyTableRow& row) {
  ++statuses_[row.status];
  std::string present;
  for (const auto& [kind, count] : row.present) {
    Total& total = coincidences_[kind];
    ++total.cases;
    total.count += count;
    present += fmt::format("; {}: {}", spoken(kind), count);  // so that a search for "; ties:" finds this kind alone
  }
  if (++cases_ > most_rows) return;
  rows_ += fmt::format("<tr data-kind=\"{}\"><th scope=\"row\" class=\"id\">{}</th><td class=\"text\">{}{}</td></tr>\n",
                       row.status, picture::markup(row.id), picture::markup(row.headline), present);
}

std::string StudyTable::totals() const {
  if (coincidences_.empty()) return "<p>Nothing coincides.</p>\n";
  std::string rows;
  const auto add = [&](std::string_view kind) {
    const auto found = coincidences_.find(kind);
    if (found == coincidences_.end()) return;
    rows += fmt::format(
        "<tr><th scope=\"row\"><a href=\"#list\" data-of=\"list\" data-find=\"; {0}:\">{0}</a></th>"
        "<td>{1}</td><td>{2}</td></tr>\n",
        spoken(kind), found->second.cases, found->second.count);
  };
  std::ranges::for_each(coincidence_names, add);
  for (const std::string_view kind : shape_coincidence_names)
    if (std::ranges::find(coincidence_names, kind) == coincidence_names.end()) add(kind);
  return boxed("Coincidences of all cases", {"'coincidence", "cases with any", "in all"}, "", rows);
}

void StudyTable::add_fault(const std::string& sentence) {
  if (++faults_ <= most_faults) fault_items_ += fmt::format("<li>{}</li>\n", picture::markup(sentence));
}

std::string StudyTable::without_study() const {
  if (faults_ == 0) return "";
  const std::string more =
      faults_ > most_faults ? fmt::format("<p>{} more are not listed.</p>\n", faults_ - most_faults) : "";
  return "<section><h2>Cases without a study</h2>\n<ul>\n" + fault_items_ + "</ul>\n" + more + "</section>\n";
}

std::string StudyTable::html(const std::string& command, const std::string& cut_short) const {
  std::vector<picture::Share> shares;
  std::vector<picture::Choice> kinds;
  for (const auto& [status, style] : status_styles) {
    const auto found = statuses_.find(status);
    shares.push_back({status, found == statuses_.end() ? 0 : found->second, style, ""});
    if (shares.back().count > 0) kinds.push_back({status, status});
  }
  const std::string warning =
      cut_short.empty() ? ""
                        : fmt::format("<p class=\"warning\" role=\"note\">{}; this is what was studied.</p>\n",
                                      picture::markup(cut_short));
  const std::string more =
      cases_ > most_rows ? fmt::format("<p>{} further cases are counted above and not shown.</p>\n", cases_ - most_rows)
                         : "";
  const std::string body = fmt::format(
      "<header><h1>What coincides</h1>\n<p class=\"answer\">{}{}</p>\n{}{}</header>\n<main>\n"
      "<section><h2>All cases</h2>\n{}</section>\n<section><h2>Case by case</h2>\n"
      "<p class=\"soft\">The features, and the picture of a case: <code>fathom study --html PAGE CASES --case "
      "ID</code>.</p>\n{}{}{}</section>\n{}</main>\n"
      "<footer><p class=\"soft\">Made by fathom {}. Counts are exact.</p>\n<p "
      "class=\"soft\"><code>{}</code></p></footer>\n",
      counted(cases_, "case", "cases"), faults_ == 0 ? "" : fmt::format(", {}", counted(faults_, "error", "errors")),
      warning, picture::share_bar(shares, "shares", "Cases by status"), totals(),
      picture::filter_bar("list", "status", kinds), boxed("Cases", {"'case", "'what coincides"}, " id=\"list\"", rows_),
      more, without_study(), FATHOM_VERSION, picture::markup(picture::without_folders(command)));
  return picture::page("What coincides", body);
}

}  // namespace fathom::cli
