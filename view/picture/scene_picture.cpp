// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "view/picture/markup.hpp"
#include "view/picture/paint.hpp"
#include "view/picture/strokes.hpp"
#include "view/picture/style.hpp"

namespace fathom::picture {
namespace {

constexpr PixelSize alone{720, 420}, of_two{356, 340};  // in a file: one panel, or each of two
constexpr double gap = 8, head = 34, line = 19, inset = 12;
constexpr std::size_t widest = 92;  // characters of a line of text

/// The text in lines that fit, broken at spaces.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> result;
  std::string rest = text;
  while (rest.size() > widest) {
    std::size_t at = rest.rfind(' ', widest);
    if (at == std::string::npos || at == 0) at = widest;
    result.push_back(rest.substr(0, at));
    rest = rest.substr(rest[at] == ' ' ? at + 1 : at);
  }
  result.push_back(rest);
  return result;
}

std::string panel_element(const PairScene& scene, const Panel& panel, const Dot& at, const std::string& name) {
  return svg_opening(fmt::format(" x=\"{}\" y=\"{}\"", at.x, at.y), panel.window.size(), "pair") + ">" + painted(scene, panel, name) +
         "</svg>\n";
}

std::string text_element(const std::string& style, double y, const std::string& text) {
  return fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", style, inset, y, markup(text));
}

}  // namespace

std::string description_of(const PairScene& scene) {
  std::string result = "Orthographic view of A, toned, and B, hatched, across a shortest way of A out of B, which points to the right.";
  if (!scene.moves()) result = "Orthographic view of A, toned, and B, hatched, along a plane between them; they touch at the dot.";
  if (scene.status == Status::disjoint)
    result = "Orthographic view of A, toned, and B, hatched; the arrow is the shortest way of A that makes them touch.";
  if (scene.moves()) result += " The outline of A moved by it is dashed.";
  if (scene.of_unions()) result += " Both are unions of convex pieces; the deeper ones are those in contact.";
  if (scene.enclosed) result += " The way is known to within its bounds.";
  if (scene.claimed) result += scene.cut ? " The claimed translation is far longer than drawn." : " The claimed translation is dashed.";
  return result;
}

std::string scene_panels(const PairScene& scene, const std::string& name, const std::string& label, const std::vector<Mark>& marks) {
  std::string result;
  for (const Panel& panel : panels_of(scene, on_pages)) {
    const std::string own = name + (panel.close ? "c" : "w");
    result += svg_opening("", on_pages, "pair") +
              svg_told(own, panel.close ? label + ", close to the translations" : label, description_of(scene)) +
              painted(scene, panel, own, marks) + "</svg>\n";
  }
  return result;
}

std::string scene_document(const PairScene& scene, const std::string& title, std::span<const std::string> caption) {
  std::vector<Panel> panels = panels_of(scene, alone);
  if (panels.size() > 1) panels = panels_of(scene, of_two);
  std::string body, spoken = description_of(scene);
  const std::string name = without_folders(title);
  for (const Panel& panel : panels)
    body += panel_element(scene, panel, {panel.close ? of_two.width + gap : 0, head}, panel.close ? "close" : "whole");
  double y = head + panels.front().window.size().height + line;
  for (const std::string& text : caption) {
    for (const std::string& part : lines_of(text)) {
      body += text_element(&text == caption.data() ? "answer" : "caption", y, part);
      y += line;
    }
    spoken += " " + text + (text.ends_with('.') ? "" : ".");
  }
  const PixelSize size{alone.width, y};
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + svg_opening(" xmlns=\"http://www.w3.org/2000/svg\"", size, "pair document") +
         svg_told("picture", markup(name), markup(spoken)) + "\n<style>" + document_style() + "</style>\n" +
         fmt::format("<rect class=\"paper\" width=\"{}\" height=\"{}\"/>\n", size.width, size.height) +
         text_element("heading", head - 12, lines_of(name).front()) + body + "</svg>\n";
}

}  // namespace fathom::picture
