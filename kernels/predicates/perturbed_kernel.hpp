// SPDX-License-Identifier: GPL-3.0-or-later
// The traits classes of the topology: what diagrams, charts and canonical subsets ask, and nothing
// else do they ask of numbers. One set of predicates, two models of it.
//                                                       [docs/kernel_concept.md; proofs/kernels.md]
#pragma once

#include <cstdint>

#include "fathom/counters.hpp"
#include "kernels/predicates/direction.hpp"
#include "kernels/vector.hpp"

namespace fathom::kernels {

/// The signs of the operands as they are. Zero means "on". Refers to the counts; not to be shared
/// between threads.
class UnperturbedKernel {
 public:
  explicit UnperturbedKernel(PredicateCounts& counts) : counts_(&counts) {}

  /// Positive: n lies in the hemisphere of z.
  [[nodiscard]] Sign side_of_equator(const Direction& n, const Direction& z) const;
  /// Positive: n1 lies to the left of n2 in a chart whose vertical is v.
  [[nodiscard]] Sign x_order(const Direction& n1, const Direction& n2, const Direction& v) const;
  /// Positive: n lies on the side of the great circle d to which d points.
  [[nodiscard]] Sign side_of_arc(const Direction& n, const Direction& d) const;
  /// Positive: arc d1 lies above arc d2 on the vertical through n, if both point upward.
  [[nodiscard]] Sign order_on_vertical(const Direction& d1, const Direction& d2, const Direction& n,
                                       const Direction& v) const;
  /// Positive: arc d1 lies above arc d2 far to the left, if both point upward.
  [[nodiscard]] Sign order_at_infinity(const Direction& d1, const Direction& d2, const Direction& z) const;

 private:
  friend class PerturbedKernel;
  template <template <class> class P, class... Directions>
  Sign decide(const Directions&... directions) const;

  PredicateCounts* counts_;
};

/// The signs of the perturbed operands: never zero. Where the sign of the operands as they are is
/// not zero, it is the answer. Throws std::logic_error when the operands are related in a way that
/// no perturbation resolves (a node on a circle of its own body, parallel circles of one body):
/// such questions are answered combinatorially and must not be asked.      [proofs/perturbation.md]
/// Refers to the perturbation and the counts; not to be shared between threads.
class PerturbedKernel {
 public:
  PerturbedKernel(const Perturbation& perturbation, PredicateCounts& counts)
      : perturbation_(&perturbation), unperturbed_(counts) {}

  // As those of UnperturbedKernel.
  [[nodiscard]] Sign side_of_equator(const Direction& n, const Direction& z) const;
  [[nodiscard]] Sign x_order(const Direction& n1, const Direction& n2, const Direction& v) const;
  [[nodiscard]] Sign side_of_arc(const Direction& n, const Direction& d) const;
  [[nodiscard]] Sign order_on_vertical(const Direction& d1, const Direction& d2, const Direction& n,
                                       const Direction& v) const;
  [[nodiscard]] Sign order_at_infinity(const Direction& d1, const Direction& d2, const Direction& z) const;

  [[nodiscard]] const UnperturbedKernel& unperturbed() const { return unperturbed_; }
  /// Counts calls that a filter in front of the kernel has settled.
  void count_calls(Predicate id, std::uint64_t calls) const {
    (*unperturbed_.counts_)[static_cast<std::size_t>(id)].calls += calls;
  }

 private:
  template <template <class> class P, class... Directions>
  Sign decide(const Directions&... directions) const;

  const Perturbation* perturbation_;
  UnperturbedKernel unperturbed_;
};

}  // namespace fathom::kernels
