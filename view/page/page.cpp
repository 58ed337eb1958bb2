// SPDX-License-Identifier: GPL-3.0-or-later
// Fills the shell: the sentence of the answer, its facts and a still picture of the bodies, which
// need no script; the sections that the script paints, each with an introductory sentence; and the
// data for them.
#include "view/page/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "fathom/numbers.hpp"
#include "view/picture/markup.hpp"
#include "view/plot/plot.hpp"

namespace fathom::page {
namespace {

using Sections = std::vector<std::pair<std::string_view, std::string_view>>;  // ids and names
using Blocks = std::vector<std::pair<std::string_view, std::string>>;         // JSON by ids

// ---- the introductory sentences of the sections ----

std::string lead_why(const stages::Stages& stages) {
  using stages::SumKind;
  const std::size_t facets = stages.sum.facets.size();
  switch (stages.sum.kind) {
    case SumKind::p:
      return fmt::format(
          "P, the set of all differences b - a, has {}. A moved by t is clear of B exactly if t is not inside P: so "
          "the way out is as long "
          "as the nearest facet is far from O, and the ball around O that touches it has nothing of the boundary "
          "inside.",
          counted(facets, "facet", "facets"));
    case SumKind::q:
      return fmt::format(
          "P, the set of all differences b - a, has too many facets to draw. Shown is Q, the polytope inside P that "
          "proves the depth: its "
          "nearest facet lies on the boundary of P, and no one of its {} is nearer to O.",
          counted(facets, "facet", "facets"));
    case SumKind::sampled:
      return "P, the set of all differences b - a, as a mesh near it: the answer comes from the exact body.";
    case SumKind::none: break;
  }
  if (stages.status == Status::disjoint || stages.status == Status::touching)
    return "O is not inside P, the set of all differences b - a: the bodies do not overlap, and the plane across n is "
           "between them.";
  return "P, the set of all differences b - a, is not drawn.";
}

std::string lead_where(const stages::Stages& stages) {
  if (stages.charts.empty()) return "The exact method of AGHRS is about polytopes: there are no diagrams here.";
  std::string winner;
  if (stages.winner) {
    using stages::WinnerKind;
    const WinnerKind kind = stages.winner->kind;
    winner = kind == WinnerKind::edges
                 ? (stages.winner->pair
                        ? fmt::format(" The answer is a crossing of arcs, of canonical pair {}.", *stages.winner->pair)
                        : std::string(" The answer is where two arcs meet."))
             : kind == WinnerKind::facet_of_a ? " The answer is a node of A: a facet of A against a vertex of B."
                                              : " The answer is a node of B: a facet of B against a vertex of A.";
  }
  return fmt::format(
      "The Gaussian diagrams of -A and of B: a node is a facet's normal, an arc is an edge. A facet of P is a node of "
      "one in a face of the "
      "other, or a crossing of two arcs. All {} are in {}, in which every arc of A_i crosses every arc of B_i.{}",
      counted(stages.counters.crossings, "crossing", "crossings"),
      counted(stages.pairs.size(), "canonical pair", "canonical pairs"), winner);
}

std::string lead_coincided(const stages::Stages& stages) {
  const auto counts = [](const auto& found) { return found.count > 0; };
  if (stages.charts.empty()) return "What is in special position about these bodies, by name.";
  const auto size = [](const stages::StagedBody& body) {
    return fmt::format("{}, {}, {}", counted(body.vertices.size(), "vertex", "vertices"),
                       counted(body.edges.size(), "edge", "edges"), counted(body.facets.size(), "facet", "facets"));
  };
  return fmt::format("{} A has {}; B has {}.",
                     std::ranges::any_of(stages.coincidences, counts)
                         ? "What is in special position about these bodies, by name. Topology is decided as if -A "
                           "were moved and the frame tilted by infinitely little, E11 to E33 and a, b, c; values never "
                           "are."
                         : "Nothing: the bodies are in general position.",
                     size(stages.a), size(stages.b));
}

std::string lead_cost(const stages::Stages& stages) {
  if (stages.bounds.empty()) return "The exact method of AGHRS did not run: there is nothing to count.";
  return stages.status == Status::penetrating ? "What the exact method did, in counts."
                                              : "What the exact method makes of these bodies, in counts; the search "
                                                "for closest lines is for bodies that overlap.";
}

std::string lead_of_sums(const stages::UnionStages& stages) {
  if (stages.status != Status::penetrating)
    return "No two pieces have interiors in common: O is in the interior of no set of differences b - a of pieces.";
  return fmt::format(
      "A moved by t overlaps B exactly if t is in the interior of the differences b - a of a piece of A and one of B. "
      "So the depth is the "
      "distance from O to the nearest point that none of the {} x {} sets of differences holds inside: together they "
      "cover the ball around "
      "O, and "
      "at the end of the way out the boundaries meet of those that touch there. {} into the ball.",
      stages.a.size(), stages.b.size(), counted(stages.sums.size(), "of them reaches", "of them reach"));
}

// ---- the parts around the sections ----

/// Returns JSON for a script element. "<" occurs in its strings only, where it is escaped.
std::string block(std::string_view id, const std::string& json) {
  std::string result = fmt::format("<script type=\"application/json\" id=\"{}\">", id);
  result.reserve(result.size() + json.size() + 16);
  for (const char c : json) {
    if (c == '<') result += "\\u003c";
    else result += c;
  }
  return result + "</script>\n";
}

/// Returns the colours and pictures of all pages, and the layout of this one.
const std::string& whole_style() {
  static const std::string text = "\n" + picture::colour_style() + picture::picture_style() + plot::chart_style() +
                                  std::string(picture::scroll_style()) + std::string(style());
  return text;
}

constexpr std::string_view seen_from_above = "seen from +z: x to the right, y up";

/// Returns the still picture with a caption; `seen` describes the view. Empty if there is none.
template <class AnySheet>
std::string figure(const AnySheet& sheet, std::string_view seen) {
  if (sheet.picture.empty()) return "";
  const std::string green =
      sheet.beside.empty() ? ""
                           : fmt::format("; <span class=\"key-patch\">green</span>: {}", picture::markup(sheet.beside));
  return fmt::format(
      "<figure class=\"still\">{}<figcaption><span class=\"key-a\">A</span> and <span class=\"key-b\">B</span>, "
      "{}{}.</figcaption></figure>",
      sheet.picture, seen, green);
}

/// Returns the command that prints the answer of a page.
std::string command_of(const Data& depth, std::string_view options) {
  const text::JsonValue* const derivative = depth.find("derivative");
  return fmt::format("fathom depth{}{}{} --json", options, is_of_plane(depth) ? "" : " --patch",
                     derivative && derivative->is_object() ? " --twist" : "");
}

std::string lead_motion(const Motions& motions) {
  return fmt::format(
      "<p class=\"lead\">{} turned by the quaternion (1, s w/2) and then moved by s v, exactly: so it sets out with "
      "the "
      "velocity v + w x p at its points p, and s = 1 is all of the motion. Each mark is the signed depth then{}; the "
      "slope of the dashed line is the derivative at s = 0, from this side.{}</p>\n",
      motions.of_b ? "A body that moves is" : "A is",
      motions.of_b ? "" : ", as <code>fathom depth --along</code> finds it",
      motions.of_b ? " The picture shows A as it is seen from B." : "");
}

/// Returns the charts, of which the script shows one at a time; or the reason why there are none.
std::string motion_part(const Motions& motions) {
  std::string charts;
  for (const auto& [name, svg, repeated] : motions.charts)
    charts += fmt::format("<div class=\"wide\" role=\"region\" tabindex=\"0\" aria-label=\"{}\">{}{}</div>\n",
                          picture::markup(name), svg,
                          picture::folded("v and w of this motion, for fathom depth", picture::markup(repeated)));
  return charts.empty() ? fmt::format("<p class=\"soft\">{}</p>\n", picture::markup(motions.why_none)) : charts;
}

/// Returns sentences as a section of its own; empty if there are none.
std::string left_out_section(const std::vector<std::string>& sentences) {
  if (sentences.empty()) return "";
  std::string items;
  for (const std::string& sentence : sentences) items += fmt::format("<li>{}</li>\n", picture::markup(sentence));
  return "<section id=\"left-out\" aria-labelledby=\"left-out-h\">\n<h2 id=\"left-out-h\">What is left "
         "out</h2>\n<ul>\n" +
         items + "</ul>\n</section>\n";
}

Data parsed(const std::string& depth) {
  text::JsonRead read = text::read_json(depth);
  if (!read.whole || !read.value.is_object()) throw std::invalid_argument("the answer of a page is no JSON object");
  return std::move(read.value);
}

/// Returns the page with its style, its script and its policy. `main`, the heading and the text
/// below it are markup.
template <class AnySheet>
std::string assembled(const AnySheet& sheet, std::string_view command, const std::string& heading,
                      const std::string& subtitle, const Sections& sections, const std::string& main,
                      const Blocks& blocks, const std::string& opens = "") {
  std::string notes, nav, data;
  for (const std::string& note : sheet.notes)
    notes += fmt::format("<p class=\"warning\" role=\"note\">{}</p>\n", picture::markup(note));
  for (const auto& [id, name] : sections) nav += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", id, name);
  for (const auto& [id, json] : blocks) data += block(id, json);
  const std::array scripts{script()};
  const std::array<std::string_view, 1> styles{whole_style()};
  return filled(shell(), {{"version", picture::markup(sheet.version)},
                          {"command", picture::markup(command)},
                          {"policy", picture::security_policy(scripts, styles)},
                          {"title", heading},
                          {"style", whole_style()},
                          {"opens", opens.empty() ? "" : fmt::format(" data-opens=\"{}\"", opens)},
                          {"answer", heading},
                          {"subtitle", subtitle},
                          {"notes", notes},
                          {"nav", nav},
                          {"main", main},
                          {"left_out", left_out_section(sheet.stages.left_out)},
                          {"data", data},
                          {"script", std::string(script())}});
}

/// Returns an array of exact squares that the JSON of the stages omits: those of canonical pairs
/// with one crossing, in the order of `pairs`.
std::string squares(const stages::Stages& stages) {
  const auto square = [](const stages::StagedPair& pair) {
    return pair.closest && pair.crossings() == 1 ? text::Json(exact_text(pair.closest->squared)) : text::Json();
  };
  return text::Json::array_of(stages.pairs, square).text();
}

}  // namespace

std::string filled(std::string_view text, const std::map<std::string, std::string, std::less<>>& values) {
  std::string result;
  for (std::size_t begin = 0;;) {
    const std::size_t open = text.find("{{", begin);
    result += text.substr(begin, open - begin);
    if (open == std::string_view::npos) return result;
    const std::size_t close = text.find("}}", open);
    const auto value =
        close == std::string_view::npos ? values.end() : values.find(text.substr(open + 2, close - open - 2));
    if (value == values.end()) throw std::logic_error("a gap of the page without a value");
    result += value->second;
    begin = close + 2;
  }
}

std::string html_page(const Sheet& sheet) {
  const Data depth = parsed(sheet.depth);
  const stages::Stages& stages = sheet.stages;
  if (is_of_plane(depth))
    return assembled(
        sheet, command_of(depth, ""), picture::markup(answer_sentence(depth)), subtitle(depth),
        {{"what", "What happens"}},
        filled(
            union_sections(),
            {{"picture_what", figure(sheet, seen_from_above)}, {"facts", facts(depth)}, {"optima", ""}, {"why", ""}}),
        {{"depth", sheet.depth}, {"stages", stages::to_json(stages)}, {"case", sheet.pair}});
  const std::string main =
      filled(pair_sections(), {{"picture_what", figure(sheet, "seen across n")},
                               {"facts", facts(depth)},
                               {"lead_motion", sheet.motions.charts.empty() ? "" : lead_motion(sheet.motions)},
                               {"motions", motion_part(sheet.motions)},
                               {"lead_why", lead_why(stages)},
                               {"lead_where", lead_where(stages)},
                               {"lead_coincided", lead_coincided(stages)},
                               {"lead_cost", lead_cost(stages)}});
  return assembled(sheet, command_of(depth, ""), picture::markup(answer_sentence(depth)), subtitle(depth),
                   {{"what", "What happens"},
                    {"why", "Why no shorter way"},
                    {"where", "Where it comes from"},
                    {"coincided", "What coincided"},
                    {"cost", "Cost"}},
                   main,
                   {{"depth", sheet.depth},
                    {"stages", stages::to_json(stages)},
                    {"squares", squares(stages)},
                    {"motions", sheet.motions.json},
                    {"case", sheet.pair}},
                   sheet.opens);
}

std::string html_page(const UnionSheet& sheet) {
  const Data depth = parsed(sheet.depth);
  const bool plane = is_of_plane(depth);
  const std::string seen =
      fmt::format("{}; deeper: the pieces {}", plane ? seen_from_above : "seen across the translation",
                  sheet.stages.status == Status::disjoint ? "that are nearest" : "in contact");
  const std::string main = filled(
      union_sections(), {{"picture_what", figure(sheet, seen)},
                         {"facts", union_facts(depth, sheet.stages)},
                         {"optima", union_optima(depth)},
                         {"why", plane ? "" : filled(sum_section(), {{"lead_why", lead_of_sums(sheet.stages)}})}});
  Sections sections{{"what", "What happens"}};
  if (!plane) sections.emplace_back("why", "Why no shorter way");
  return assembled(sheet, command_of(depth, " --pieces"), picture::markup(union_sentence(depth)), union_subtitle(depth),
                   sections, main,
                   {{"depth", sheet.depth}, {"stages", stages::to_json(sheet.stages)}, {"case", sheet.pair}});
}

}  // namespace fathom::page
