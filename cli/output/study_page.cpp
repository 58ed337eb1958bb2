// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/study_page.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/output/study_output.hpp"
#include "view/picture/markup.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t most_shown = 500;   // cases in full
constexpr std::size_t most_faults = 100;  // sentences

std::string count_text(std::size_t count, std::string_view one, std::string_view more) {
  return fmt::format("{} {}", count, count == 1 ? one : more);
}

constexpr std::array<std::pair<const char*, const char*>, 4> status_styles{
    {{"penetrating", "good"}, {"touching", "fair"}, {"disjoint", "left"}, {"undecided", "lost"}}};

}  // namespace

template <class AnyStudy, class Names>
void StudyPage::take(const Case& pair, const AnyStudy& study, std::string_view status, const std::string& headline, const Names& names) {
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
      "<details class=\"part\" id=\"{}\" data-kind=\"{}\"><summary>{} <span class=\"soft\">{}{}</span></summary>\n{}</details>\n", anchor,
      status, title_, headline_, present, study_section(pair, study, anchor));
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
  std::string result = fmt::format("<h1>What coincides</h1>\n<p class=\"answer\">{}{}</p>\n", count_text(cases_, "case", "cases"),
                                   faults_.empty() ? "" : fmt::format(", {}", count_text(faults_.size(), "error", "errors")));
  return result + picture::share_bar(shares, "shares", "Cases by status");
}

std::string StudyPage::totals() const {
  std::string rows;
  const auto add = [&](const std::string& kind) {
    const auto found = coincidences_.find(kind);
    if (found == coincidences_.end()) return;
    rows += fmt::format(
        "<tr><th scope=\"row\"><a href=\"#list\" data-of=\"list\" data-find=\"; {0}:\">{0}</a></th><td>{1}</td><td>{2}</td></tr>\n", kind,
        found->second.cases, found->second.count);
  };
  for (const std::string_view kind : coincidence_names) add(spoken(kind));
  for (const std::string_view kind : shape_coincidence_names)
    if (std::ranges::find(coincidence_names, kind) == coincidence_names.end()) add(spoken(kind));
  if (rows.empty()) return "<p>Nothing coincides.</p>\n";
  const std::string table =
      "<thead><tr><th scope=\"col\" class=\"text\">coincidence</th><th scope=\"col\">cases with any</th><th scope=\"col\">in all</th></tr>"
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
  if (shown_ < cases_) result += fmt::format("<p>{} further cases are counted above and not shown.</p>\n", cases_ - shown_);
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
                        : fmt::format("<p class=\"warning\" role=\"note\">{}; this is what was studied.</p>\n", picture::markup(cut_short));
  const std::string body = fmt::format(
      "<header>{}{}</header>\n<main>\n{}{}</main>\n<footer><p class=\"soft\">Made by fathom {}. Counts are exact; features are 0-based "
      "indices of points.</p>\n<p class=\"soft\"><code>{}</code></p></footer>\n",
      head(), warning, stream_ ? case_by_case() : sections_, without_study(), FATHOM_VERSION,
      picture::markup(picture::without_folders(command)));
  return picture::page(stream_ ? "What coincides" : title_ + ": what coincides", body);
}

}  // namespace fathom::cli
