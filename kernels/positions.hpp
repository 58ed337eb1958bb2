// SPDX-License-Identifier: GPL-3.0-or-later
// The points of a body where they stand, so that nobody copies them to compute with them.
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>

#include "fathom/point.hpp"
#include "fathom/shape.hpp"

namespace fathom::kernels {

/// A view of an array of points, or of the centers of an array of atoms. What it is made from must
/// outlive it.
class Positions {
 public:
  Positions(const Point* points, std::size_t size) : points_(points), size_(size) {}
  template <class Range>
  requires std::is_convertible_v<const Range&, std::span<const Point>> Positions(
      const Range& points)  // NOLINT(google-explicit-constructor): it stands for them
      : Positions(std::span<const Point>(points).data(), std::span<const Point>(points).size()) {}
  explicit Positions(std::span<const Atom> atoms) : atoms_(atoms.data()), size_(atoms.size()) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  const Point& operator[](std::size_t i) const { return atoms_ != nullptr ? atoms_[i].center : points_[i]; }
  [[nodiscard]] const Point& front() const { return (*this)[0]; }

  class Iterator {
   public:
    Iterator(const Positions& all, std::size_t i) : all_(all), i_(i) {}
    const Point& operator*() const { return all_[i_]; }
    Iterator& operator++() {
      ++i_;
      return *this;
    }
    friend bool operator==(const Iterator& p, const Iterator& q) { return p.i_ == q.i_; }

   private:
    const Positions& all_;
    std::size_t i_;
  };
  [[nodiscard]] Iterator begin() const { return {*this, 0}; }
  [[nodiscard]] Iterator end() const { return {*this, size_}; }

 private:
  const Point* points_ = nullptr;
  const Atom* atoms_ = nullptr;  // else
  std::size_t size_ = 0;
};

}  // namespace fathom::kernels
