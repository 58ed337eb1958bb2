// SPDX-License-Identifier: GPL-3.0-or-later
// Indices that cannot be confused: an index of one kind does not compile where one of another kind
// is expected.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace fathom::kernels {

/// The index of one kind of thing, which the tag names. As cheap as the number.
template <class Tag>
struct Id {
  std::uint32_t value = 0;

  constexpr Id() = default;
  explicit constexpr Id(std::uint32_t index) : value(index) {}
  explicit constexpr operator std::uint32_t() const { return value; }

  /// The id of nothing. It is greater than all others.
  static constexpr Id none() { return Id(UINT32_MAX); }
  [[nodiscard]] constexpr bool is_none() const { return value == UINT32_MAX; }

  [[nodiscard]] constexpr Id next() const { return Id(value + 1); }

  friend constexpr auto operator<=>(Id, Id) = default;
};

/// The ids 0, 1, ..., count - 1.
template <class I>
class IdsBelow {
 public:
  explicit constexpr IdsBelow(std::size_t count) : end_{I(static_cast<std::uint32_t>(count))} {}

  struct Iterator {
    using value_type = I;
    using difference_type = std::ptrdiff_t;

    I id{};

    constexpr I operator*() const { return id; }
    constexpr Iterator& operator++() {
      id = id.next();
      return *this;
    }
    constexpr Iterator operator++(int) { return std::exchange(*this, Iterator{id.next()}); }
    bool operator==(const Iterator&) const = default;
  };
  [[nodiscard]] constexpr Iterator begin() const { return {I(0)}; }
  [[nodiscard]] constexpr Iterator end() const { return end_; }

 private:
  Iterator end_;
};

/// The ids with these numbers.
template <class I>
std::vector<I> to_ids(const std::vector<std::uint32_t>& numbers) {
  return std::vector<I>(numbers.begin(), numbers.end());
}

/// A vector that is indexed by ids of type I alone.
template <class I, class T>
struct IdVector : std::vector<T> {
  using std::vector<T>::vector;

  decltype(auto) operator[](I id) { return std::vector<T>::operator[](id.value); }
  decltype(auto) operator[](I id) const { return std::vector<T>::operator[](id.value); }

  /// The ids of all elements, ascending.
  [[nodiscard]] IdsBelow<I> ids() const { return IdsBelow<I>(this->size()); }
};

}  // namespace fathom::kernels
