// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates of unions for which the differences of the pieces are boxes: A is one cube, and B
// has a piece for each box.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace fathom_check {

using Triple = std::array<int, 3>;

/// Its sides are longer than 1.
struct DifferenceBox {
  Triple low, high;
};

inline const DifferenceBox cube{{-1, -1, -1}, {1, 1, 1}};
/// Its optima.
inline const std::vector<Triple> six{{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}};

/// The text, part by part: so that a test may change one.
struct UnionText {
  std::string id = "boxes", pieces, claim, end;
  std::vector<std::string> optima, polytopes, tree;

  [[nodiscard]] std::string text() const {
    std::string result = "fathom-certificate 3\nid " + id + "\n" + pieces + claim;
    const auto part = [&result](const std::string& word, const std::vector<std::string>& items) {
      result += word + " " + std::to_string(items.size()) + "\n";
      for (const std::string& item : items) result += item;
    };
    part("optima", optima);
    part("polytopes", polytopes);
    part("tree", tree);
    return result + "end " + counted() + "\n";
  }

 private:
  /// The numbers that were announced, from the text itself.
  [[nodiscard]] std::string counted() const {
    std::string result;
    const auto take = [&result](const std::string& lines) {
      for (std::size_t begin = 0; begin < lines.size(); begin = lines.find('\n', begin) + 1) {
        const std::string line = lines.substr(begin, lines.find('\n', begin) - begin);
        for (const char* word : {"pieces_a ", "pieces_b ", "a ", "b ", "separations ", "vertices ", "facets "})
          if (line.rfind(word, 0) == 0) result += (result.empty() ? "" : " ") + line.substr(std::string(word).size());
      }
    };
    const auto take_all = [&](const std::vector<std::string>& items) {
      result += " " + std::to_string(items.size());
      for (const std::string& item : items) take(item);
    };
    take(pieces);
    take_all(optima);
    take_all(polytopes);
    return result + " " + std::to_string(tree.size());
  }
};

inline std::string row(const Triple& p) {
  return std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
}

/// Corner s has its coordinates in the bits of s, x lowest.
inline std::string corners(const char* word, const Triple& low, const Triple& high) {
  std::string result = std::string(word) + " 8\n";
  for (unsigned s = 0; s < 8; ++s)
    result +=
        row({(s & 1U) != 0 ? high[0] : low[0], (s & 2U) != 0 ? high[1] : low[1], (s & 4U) != 0 ? high[2] : low[2]});
  return result;
}

inline constexpr const char* all_facets = "4 0 4 6 2\n4 1 3 7 5\n4 0 1 5 4\n4 2 6 7 3\n4 0 2 3 1\n4 4 5 7 6\n";

/// Facet 2 k of the polytope in a box is where coordinate k is low, facet 2 k + 1 where it is high.
inline UnionText boxes(const std::string& q, const std::vector<DifferenceBox>& boxes, const std::vector<Triple>& optima,
                       const std::vector<std::string>& tree) {
  UnionText result;
  result.pieces =
      "pieces_a 1\n" + corners("a", {0, 0, 0}, {1, 1, 1}) + "pieces_b " + std::to_string(boxes.size()) + "\n";
  for (std::size_t j = 0; j < boxes.size(); ++j) {
    const Triple& low = boxes[j].low;
    result.pieces += corners("b", {low[0] + 1, low[1] + 1, low[2] + 1}, boxes[j].high);
    std::string polytope = "polytope 0 " + std::to_string(j) + "\nvertices 8\n";
    for (unsigned s = 0; s < 8; ++s) polytope += std::to_string(s) + " " + std::to_string(7 - s) + "\n";
    result.polytopes.push_back(polytope + "facets 6\n" + all_facets);
  }
  for (const Triple& t : optima) {
    std::string optimum = "optimum " + row(t) + "separations " + std::to_string(boxes.size()) + "\n";
    for (const DifferenceBox& box : boxes) {
      Triple u{1, 0, 0};
      for (std::size_t k = 0; k < 3; ++k)
        if (t[k] <= box.low[k] || t[k] >= box.high[k]) {
          u = {};
          u[k] = t[k] <= box.low[k] ? -1 : 1;
        }
      optimum += row(u);
    }
    result.optima.push_back(optimum);
  }
  result.claim = "claim depth " + q + "\n";
  for (const std::string& node : tree) result.tree.push_back(node + "\n");
  return result;
}

}  // namespace fathom_check
