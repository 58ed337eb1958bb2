// SPDX-License-Identifier: GPL-3.0-or-later
// Studies of shapes, for people and as JSON.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/io/terminal.hpp"
#include "cli/output/answer_output.hpp"
#include "cli/output/decimal.hpp"
#include "cli/output/study_output.hpp"
#include "cli/output/text_rows.hpp"
#include "fathom/numbers.hpp"
#include "kernels/number/irrational.hpp"
#include "reference/output/json_values.hpp"

namespace fathom::cli {
namespace {

using Lines = std::vector<std::string>;

// ---- text ----

std::string present_text(const ShapeStudy& study) {
  Lines parts;
  for (std::size_t i = 0; i < shape_coincidence_names.size(); ++i)
    if (const std::uint64_t count = study.coincidences[i].count)
      parts.push_back(fmt::format("{} {}", spoken(shape_coincidence_names[i]), count));
  return fmt::format("{}", fmt::join(parts, "; "));
}

void add_coincidences(Lines& lines, const ShapeStudy& study, bool all) {
  Lines absent;
  constexpr std::size_t column = 32, none_column = 6;
  lines.push_back(fitted(fmt::format("{:<22}{:>8}  {}", "coincidence", "count", all ? "features" : "features of the first"), column));
  for (std::size_t i = 0; i < shape_coincidence_names.size(); ++i) {
    const auto& [count, listed] = study.coincidences[i];
    if (count == 0) {
      absent.push_back(spoken(shape_coincidence_names[i]));
      continue;
    }
    lines.push_back(fitted(
        fmt::format("{:<22}{:>8}{}", spoken(shape_coincidence_names[i]), count, listed.empty() ? "" : "  " + involved_text(listed.front())),
        column));
    for (std::size_t k = 1; all && k < listed.size(); ++k)
      lines.push_back(fitted(fmt::format("{:{}}{}", "", column, involved_text(listed[k])), column));
  }
  if (!absent.empty()) lines.push_back(fitted(fmt::format("none: {}", fmt::join(absent, ", ")), none_column));
}

// ---- JSON ----

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

Json involved_object(const ShapeInvolved& involved) { return {{"a", feature_object(involved.a)}, {"b", feature_object(involved.b)}}; }

Json coincidences_object(const ShapeStudy& study) {
  Json result;
  for (std::size_t i = 0; i < shape_coincidence_names.size(); ++i) {
    Json listed = Json::array();
    for (const ShapeInvolved& involved : study.coincidences[i].listed) listed.push_back(involved_object(involved));
    result[shape_coincidence_names[i]] = {{"count", study.coincidences[i].count}, {"listed", listed}};
  }
  return result;
}

}  // namespace

std::string_view status_name(const SignedDepth& depth) { return depth.status() ? name(*depth.status()) : "undecided"; }

std::string status_text(const SignedDepth& depth) {
  const std::string value = depth.exact() ? "signed depth " + kernels::exact_surd_text(*depth.exact())
                                          : fmt::format("signed depth from {} to {}", depth.low_binary64(), depth.high_binary64());
  return fmt::format("{}; {}", status_name(depth), value);
}

std::string size_text(const ShapeSize& size) {
  Lines parts;
  const auto add = [&](std::uint64_t count, std::string_view one, std::string_view many) {
    if (count > 0) parts.push_back(fmt::format("{} {}", count, count == 1 ? one : many));
  };
  if (size.half_space) parts.emplace_back("a half-space");
  if (size.terms > 1) add(size.terms, "term", "terms");
  add(size.points, "point", "points");
  add(size.discs, "disc", "discs");
  add(size.balls, "ball", "balls");
  if (size.radius > 0) parts.push_back("radius " + exact_text(size.radius));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string feature_text(const ShapeFeature& feature) {
  std::string text(feature.what);
  if (feature.length) text += " " + kernels::exact_surd_text(*feature.length);
  if (!is_zero(feature.direction)) text += " " + direction_text(feature.direction);
  if (feature.point) text += " at " + point_text(*feature.point);
  return text;
}

std::string involved_text(const ShapeInvolved& involved) {
  return fmt::format("A {}, B {}", feature_text(involved.a), feature_text(involved.b));
}

std::string study_block(const ShapeStudy& study, bool all) {
  Lines lines{fitted(status_text(study.depth), body_column), fitted("A  " + size_text(study.a), body_column),
              fitted("B  " + size_text(study.b), body_column)};
  if (study.contact) lines.push_back(fitted("contact  " + involved_text(*study.contact), 9));
  lines.emplace_back();
  add_coincidences(lines, study, all);
  if (study.cores) {
    lines.insert(lines.end(), {"", "cores"});
    lines.push_back(study_block(*study.cores, all));
  }
  return fmt::format("{}", fmt::join(lines, "\n"));
}

std::string study_line(const std::string& id, const ShapeStudy& study) {
  const std::string present = present_text(study);
  std::vector<std::string> parts{status_text(study.depth)};
  if (!present.empty()) parts.push_back(present);
  return case_line(id, parts);
}

std::string study_json(const std::string& id, const ShapeStudy& study) {
  Json result = study_head(id);
  result["status"] = status_name(study.depth);
  result["signed_depth"] = output::signed_depth_object(study.depth);
  result["bodies"] = {{"a", size_object(study.a)}, {"b", size_object(study.b)}};
  result["contact"] = study.contact ? involved_object(*study.contact) : Json();
  result["coincidences"] = coincidences_object(study);
  if (study.cores) {
    Json cores;
    add_study(cores, *study.cores);
    result["cores"] = cores;
  }
  return result.text();
}

}  // namespace fathom::cli
