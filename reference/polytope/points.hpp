// SPDX-License-Identifier: GPL-3.0-or-later
// The points of a body in the form in which they were given: binary64, rationals, the centers of
// atoms, or points that a pose moves. From any of these forms a lattice is made.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <variant>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/depth.hpp"
#include "fathom/point.hpp"
#include "fathom/shape.hpp"
#include "kernels/number/word_integer.hpp"

namespace fathom::polytope {

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

/// Returns the points of all pieces, whose hull holds the union: piece after piece, each in its
/// order. Does not check the laws of pieces.
inline std::vector<Point> joined(const Pieces& pieces) {
  std::vector<Point> all;
  for (const std::vector<Point>& piece : pieces) all.insert(all.end(), piece.begin(), piece.end());
  return all;
}

/// Numbers in binary64 as integers times one power of two.
struct AlignedNumbers {
  std::vector<std::int64_t> integers;
  long exponent = 0;
  long bits = 0;  ///< |n| < 2^bits for each integer
};

/// An integer fits a word if |n| < 2^most_word_bits, and then a difference of two does too.
inline constexpr long most_word_bits = 62;

/// Returns nullopt if an integer would have more bits than that. Throws std::invalid_argument if
/// a number is not finite.
std::optional<AlignedNumbers> aligned(std::span<const double> numbers);

/// Points of a body that a pose moves. What they are made from must outlive them.
struct PosedPoints {
  static constexpr long most_bits = 124;

  const GivenPoints* given = nullptr;        ///< all points of the body, before they are moved
  const AlignedNumbers* integers = nullptr;  ///< their coordinates, if these are in binary64 and can be aligned
  std::span<const std::uint32_t> chosen;     ///< which of them these are; empty: all
  const std::variant<PoseBinary64, Pose>* pose = nullptr;  ///< numbers finite, or in lowest terms
  /// The moved points over 2^-exponent, if all is in binary64 and each |n| < 2^most_bits; or none.
  std::vector<Vec3<kernels::Int128>> numerators;
  long exponent = 0;

  /// Makes the numerators, if 128 bits suffice, of what is set above. Throws std::invalid_argument
  /// if a number of the pose is not finite, or not in lowest terms.
  void move();

  [[nodiscard]] std::size_t size() const { return chosen.empty() ? given->size() : chosen.size(); }
  /// Which point of the body the i-th of these is.
  [[nodiscard]] std::size_t index(std::size_t i) const { return chosen.empty() ? i : chosen[i]; }
  [[nodiscard]] GivenPoint point(std::size_t i) const;
};

/// A view of the points of a body in the form in which they were given: coordinates in binary64,
/// exact points, the centers of atoms, or moved points. What it is made from must outlive it.
class Points {
 public:
  using Doubles = std::span<const std::array<double, 3>>;

  template <class Range>
  requires std::is_convertible_v<const Range&, Doubles> Points(
      const Range& points)  // NOLINT(google-explicit-constructor)
      : doubles_(points), exact_(nullptr, 0) {}
  template <class Range>
  requires std::is_convertible_v<const Range&, Positions> Points(
      const Range& points)  // NOLINT(google-explicit-constructor)
      : exact_(points) {}
  Points(const GivenPoints& points)  // NOLINT(google-explicit-constructor)
      : doubles_(points.binary64()), exact_(points.in_binary64() ? Positions(nullptr, 0) : Positions(points.exact())) {}
  Points(const PosedPoints& points)  // NOLINT(google-explicit-constructor)
      : exact_(nullptr, 0), posed_(&points) {}

  [[nodiscard]] std::size_t size() const {
    return posed_ != nullptr ? posed_->size() : doubles_.size() + exact_.size();
  }
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] GivenPoint operator[](std::size_t i) const {
    if (posed_ != nullptr) return posed_->point(i);
    if (doubles_.empty()) return {exact_[i]};
    return {doubles_[i]};
  }
  /// The points that a pose moves, if they are the form; else null.
  [[nodiscard]] const PosedPoints* posed() const { return posed_; }
  /// The exact points, where they stand or else in `room`, which must outlive them.
  [[nodiscard]] Positions exact(std::vector<Point>& room) const;

  /// Calls f(coordinate), with numbers of binary64 or with rationals, until it returns false.
  /// Returns whether it never did.
  template <class F>
  bool all_coordinates(F f) const {
    for (const std::array<double, 3>& p : doubles_)
      if (!f(p[0]) || !f(p[1]) || !f(p[2])) return false;
    for (const Point& p : exact_)
      if (!f(p.x) || !f(p.y) || !f(p.z)) return false;
    for (std::size_t i = 0; posed_ != nullptr && i < size(); ++i)
      if (const Point p = (*this)[i].exact(); !f(p.x) || !f(p.y) || !f(p.z)) return false;
    return true;
  }

 private:
  Doubles doubles_;
  Positions exact_;  // if they are not in binary64
  const PosedPoints* posed_ = nullptr;
};

/// The exact positions. Throws std::invalid_argument if a coordinate is no finite number.
std::vector<Point> exact_points(std::span<const std::array<double, 3>> body);

}  // namespace fathom::polytope
