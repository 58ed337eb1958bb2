// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "fathom/study.hpp"
#include "kernels/context.hpp"
#include "reference/gaussian/gaussian_diagram.hpp"

namespace fathom::studies {

/// Implements the public function with a context, which counts the predicates of the search for
/// coincidences.
Study study(kernels::Context& context, std::span<const Point> a, std::span<const Point> b,
            const StudyOptions& options = {});

// ---- the searches ----

// The common data of the searches: the bodies with their diagrams, and the list of coincidences.

/// A body and its Gaussian diagram, that of its reflection for A.
struct StudiedBody {
  gaussian::Colour colour;
  const polytope::Polytope& body;
  const gaussian::GaussianDiagram& diagram;

  /// Return the edge of an arc, and the facet of a node.
  [[nodiscard]] Feature feature(gaussian::ArcId i) const;
  [[nodiscard]] Feature feature(gaussian::NodeId i) const;
  /// Returns a coincidence of features of this body with those of the other one.
  [[nodiscard]] Involved involved(std::vector<Feature> own, std::vector<Feature> others = {}) const;
};
using StudiedBodies = gaussian::PerColour<StudiedBody>;

/// Counts every coincidence and lists the first few of each kind.
class Findings {
 public:
  Findings(Study& study, std::size_t most) : study_(study), most_(most) {}

  void add(Coincidence kind, Involved involved) {
    Coincidences& all = at(kind);
    ++all.count;
    if (all.listed.size() < most_) all.listed.push_back(std::move(involved));
  }

  /// Adds each pair of a feature of A and one of B.
  template <class I>
  void add_pairs(Coincidence kind, const StudiedBodies& bodies, const gaussian::PerColour<std::vector<I>>& ids) {
    Coincidences& all = at(kind);
    all.count += std::uint64_t{ids.a.size()} * ids.b.size();
    for (const I i : ids.a) {
      for (const I j : ids.b) {
        if (all.listed.size() >= most_) return;
        all.listed.push_back({{bodies.a.feature(i)}, {bodies.b.feature(j)}});
      }
    }
  }

  /// Adds each pair of features of one body.
  template <class I>
  void add_pairs(Coincidence kind, const StudiedBody& studied, const std::vector<I>& ids) {
    Coincidences& all = at(kind);
    if (ids.size() > 1) all.count += std::uint64_t{ids.size()} * (ids.size() - 1) / 2;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      for (std::size_t j = i + 1; j < ids.size(); ++j) {
        if (all.listed.size() >= most_) return;
        all.listed.push_back(studied.involved({studied.feature(ids[i]), studied.feature(ids[j])}));
      }
    }
  }

 private:
  Coincidences& at(Coincidence kind) { return study_.coincidences[static_cast<std::size_t>(kind)]; }

  Study& study_;
  std::size_t most_;
};

/// Returns the number of pairs of a node and an arc that the search for normals on arcs tests.
std::uint64_t pairs_to_test(const StudiedBodies& bodies);

/// Finds the coincidences of two bodies of this depth, whose axes have `units`, of all kinds;
/// normals on arcs only if there are at most `most_pairs` pairs to test. Reports its progress.
void find_coincidences(kernels::Context& context, const StudiedBodies& bodies, const Vector& units, const Depth& depth,
                       Findings& findings, std::uint64_t most_pairs = std::numeric_limits<std::uint64_t>::max());

}  // namespace fathom::studies
