// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "fathom/study.hpp"
#include "kernels/context.hpp"
#include "kernels/nearest.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"

namespace fathom::studies {

/// The public function with a context, which counts the predicates of the search for coincidences.
Study study(kernels::Context& context, std::span<const Point> a, std::span<const Point> b,
            const StudyOptions& options = {});

// ---- the searches ----

// What the searches of a study share: the bodies with their diagrams, and the list of coincidences.

/// What belongs to each of some directions.
template <class T>
using ByDirection = std::map<Vector, T, kernels::NearestPlanes::LexicographicOrder>;

/// A body and its Gaussian diagram, that of its reflection for A.
struct Subject {
  gaussian::Colour colour;
  const polytope::Polytope& body;
  const gaussian::GaussianDiagram& diagram;

  /// The edge of an arc, and the facet of a node.
  [[nodiscard]] Feature feature(gaussian::ArcId i) const;
  [[nodiscard]] Feature feature(gaussian::NodeId i) const;
  /// A coincidence of features of this body with those of the other one.
  [[nodiscard]] Involved involved(std::vector<Feature> own, std::vector<Feature> others = {}) const;
};
using Subjects = gaussian::PerColour<Subject>;

/// Counts every coincidence and lists the first few of each kind.
class Findings {
 public:
  Findings(Study& study, std::size_t most) : study_(study), most_(most) {}

  void add(Coincidence kind, Involved involved) {
    Coincidences& all = at(kind);
    ++all.count;
    if (all.listed.size() < most_) all.listed.push_back(std::move(involved));
  }

  /// Adds every one of A's with every one of B's.
  template <class I>
  void add_pairs(Coincidence kind, const Subjects& subjects, const gaussian::PerColour<std::vector<I>>& ids) {
    Coincidences& all = at(kind);
    all.count += std::uint64_t{ids.a.size()} * ids.b.size();
    for (const I i : ids.a) {
      for (const I j : ids.b) {
        if (all.listed.size() >= most_) return;
        all.listed.push_back({{subjects.a.feature(i)}, {subjects.b.feature(j)}});
      }
    }
  }

  /// Adds every two of one body's.
  template <class I>
  void add_pairs(Coincidence kind, const Subject& subject, const std::vector<I>& ids) {
    Coincidences& all = at(kind);
    if (ids.size() > 1) all.count += std::uint64_t{ids.size()} * (ids.size() - 1) / 2;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      for (std::size_t j = i + 1; j < ids.size(); ++j) {
        if (all.listed.size() >= most_) return;
        all.listed.push_back(subject.involved({subject.feature(ids[i]), subject.feature(ids[j])}));
      }
    }
  }

 private:
  Coincidences& at(Coincidence kind) { return study_.coincidences[static_cast<std::size_t>(kind)]; }

  Study& study_;
  std::size_t most_;
};

/// Finds the kinds that are seen in space.
void find_parallel_edges(const Subjects& subjects, Findings& findings);
void find_common_normals(const Subjects& subjects, Findings& findings);
/// Finds the kinds that are seen on the sphere. The first reports its progress.
void find_normals_on_arcs(kernels::Context& context, const Subjects& subjects, Findings& findings);
void find_equator_hits(const Subjects& subjects, Findings& findings);
void find_verticals(const Subjects& subjects, Findings& findings);

}  // namespace fathom::studies
