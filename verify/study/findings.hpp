// SPDX-License-Identifier: GPL-3.0-or-later
// What the searches of a study share: the bodies with their diagrams, and the list of coincidences.
#pragma once

#include <cstdint>
#include <span>

#include "kernels/context.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"
#include "verify/study/study.hpp"

namespace fathom::studies {

/// For maps with directions as keys.
struct LexicographicOrder {
  bool operator()(const Vector& u, const Vector& v) const { return lexicographically_less(u, v); }
};

/// A body and its Gaussian diagram, that of its reflection for A.
struct Subject {
  const polytope::Polytope& body;
  const gaussian::GaussianDiagram& diagram;

  [[nodiscard]] Feature edge(std::uint32_t i) const;
  [[nodiscard]] Feature facet(std::uint32_t i) const;
};

/// Counts every coincidence and lists the first few of each kind.
class Findings {
 public:
  using Ids = std::span<const std::uint32_t>;

  Findings(Study& study, std::size_t most) : study_(study), most_(most) {}

  void add(Coincidence kind, Involved involved) {
    Coincidences& all = at(kind);
    ++all.count;
    if (all.listed.size() < most_) all.listed.push_back(std::move(involved));
  }

  /// Adds every x of one group with every y of another; involved(x, y) describes a pair.
  template <class F>
  void add_pairs(Coincidence kind, Ids xs, Ids ys, F involved) {
    Coincidences& all = at(kind);
    all.count += std::uint64_t{xs.size()} * ys.size();
    for (const std::uint32_t x : xs) {
      for (const std::uint32_t y : ys) {
        if (all.listed.size() >= most_) return;
        all.listed.push_back(involved(x, y));
      }
    }
  }

  /// Adds every two of one group.
  template <class F>
  void add_pairs(Coincidence kind, Ids xs, F involved) {
    Coincidences& all = at(kind);
    if (xs.size() > 1) all.count += std::uint64_t{xs.size()} * (xs.size() - 1) / 2;
    for (std::size_t i = 0; i < xs.size(); ++i) {
      for (std::size_t j = i + 1; j < xs.size(); ++j) {
        if (all.listed.size() >= most_) return;
        all.listed.push_back(involved(xs[i], xs[j]));
      }
    }
  }

 private:
  Coincidences& at(Coincidence kind) { return study_.coincidences[static_cast<std::size_t>(kind)]; }

  Study& study_;
  std::size_t most_;
};

/// Finds the kinds that are seen in space.
void find_parallel_edges(const Subject& a, const Subject& b, Findings& findings);
void find_common_normals(const Subject& a, const Subject& b, Findings& findings);
/// Finds the kinds that are seen on the sphere. The first reports its progress.
void find_normals_on_arcs(kernels::Context& context, const Subject& a, const Subject& b, Findings& findings);
void find_equator_hits(const Subject& a, const Subject& b, Findings& findings);
void find_verticals(const Subject& a, const Subject& b, Findings& findings);

}  // namespace fathom::studies
