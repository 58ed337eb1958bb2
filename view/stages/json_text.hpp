// SPDX-License-Identifier: GPL-3.0-or-later
// JSON that is written straight into one text, commas and all: there may be hundreds of thousands of numbers.
#pragma once

#include <gmpxx.h>

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom::stages {

class StagesText {
 public:
  [[nodiscard]] std::string take() && { return std::move(text_); }

  /// `fill` writes the fields, or the elements.
  template <class Fill>
  void object(Fill fill) {
    enclosed('{', '}', fill);
  }
  template <class Fill>
  void array(Fill fill) {
    enclosed('[', ']', fill);
  }
  /// An array of what `write` writes for each element.
  template <class Range, class Write>
  void array_of(const Range& range, Write write) {
    array([&] {
      for (const auto& element : range) write(element);
    });
  }
  void array_of(const std::vector<std::uint32_t>& numbers) {
    array_of(numbers, [this](std::uint32_t n) { integer(n); });
  }

  /// Before a value in an object. The key needs no escapes.
  void key(std::string_view name);

  void null() { plain("null"); }
  void boolean(bool value) { plain(value ? "true" : "false"); }
  template <std::integral Integer>
  void integer(Integer value) {
    plain(std::to_string(value));
  }
  void integer_or_null(const std::optional<std::uint32_t>& value) {
    if (value) integer(*value);
    else null();
  }
  /// With so many significant digits; 0 stands for the shortest text that reads back as the number. It is finite.
  void number(double value, int digits);
  void numbers(const std::array<double, 3>& values, int digits);
  /// An exact number, as a string.
  void exact(const mpq_class& value);
  /// Any bytes: what is not UTF-8 is replaced.
  void string(std::string_view value);

 private:
  template <class Fill>
  void enclosed(char open, char close, Fill fill) {
    separate();
    text_ += open;
    first_ = true;
    fill();
    text_ += close;
    first_ = false;
  }
  void separate() {
    if (!first_) text_ += ',';
    first_ = false;
  }
  void plain(std::string_view value) {
    separate();
    text_ += value;
  }

  std::string text_;
  bool first_ = true;  // no comma is due
};

}  // namespace fathom::stages
