// SPDX-License-Identifier: GPL-3.0-or-later
// Which monomials of the perturbation resolve a coincidence: the question that it makes zero is asked of the perturbed kernel.
//                                                                                                              [proofs/perturbation.md]
#pragma once

#include <map>
#include <string>
#include <vector>

#include "kernels/predicates/perturbed_kernel.hpp"
#include "verify/study/study.hpp"

namespace fathom::stages {

class Decisions {
 public:
  /// The subjects must outlive it.
  Decisions(const studies::Subjects& subjects, const kernels::Perturbation& perturbation);

  /// The monomials that decide about these features, by name, each once; empty if the method asks no question that they make zero, as of
  /// bodies that only tie.
  [[nodiscard]] std::vector<std::string> about(Coincidence kind, const Involved& involved) const;

 private:
  /// Edges and facets by their points.
  struct Features {
    std::map<Feature, gaussian::ArcId> arcs;
    std::map<Feature, gaussian::NodeId> nodes;
  };
  /// A feature with its colour.
  struct Member {
    gaussian::Colour colour;
    const Feature* feature;
  };

  static Features features_of(const studies::Subject& subject);
  static std::vector<Member> members(const Involved& involved);
  [[nodiscard]] const gaussian::Arc* arc(const Member& member) const;
  [[nodiscard]] const kernels::Direction* node(const Member& member) const;
  [[nodiscard]] const kernels::Direction& end(const Member& member, gaussian::NodeId i) const;
  void ask(const kernels::PerturbedKernel& kernel, Coincidence kind, const std::vector<Member>& all) const;
  void ask_of_edges(const kernels::PerturbedKernel& kernel, Coincidence kind, const std::vector<Member>& all) const;

  const studies::Subjects& subjects_;
  kernels::Perturbation perturbation_;
  gaussian::PerColour<Features> features_;
};

}  // namespace fathom::stages
