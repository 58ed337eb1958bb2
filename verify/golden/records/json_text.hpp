// SPDX-License-Identifier: GPL-3.0-or-later
// Writes JSON by appending: building an object first would take longer than finding the answer.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/vector.hpp"

namespace fathom::golden {

/// Appends values to a text, with commas where needed. Keys and texts must not need escapes.
class JsonText {
 public:
  JsonText& open(char bracket);
  JsonText& close(char bracket);
  JsonText& key(std::string_view name);
  JsonText& text(std::string_view plain);
  JsonText& number(std::int64_t n);
  JsonText& null();
  /// Exact numbers, as texts.
  JsonText& exact(const mpz_class& n);
  JsonText& exact(const mpq_class& q);
  JsonText& exact(const Vector& v) { return three(v.x, v.y, v.z); }
  JsonText& exact(const Point& p) { return three(p.x, p.y, p.z); }
  /// A hexadecimal float, as text.
  JsonText& hex(double value);
  JsonText& hex(const std::array<double, 3>& p) { return open('[').hex(p[0]).hex(p[1]).hex(p[2]).close(']'); }

  std::string take() { return std::move(text_); }

 private:
  template <class Number>
  JsonText& three(const Number& x, const Number& y, const Number& z) {
    return open('[').exact(x).exact(y).exact(z).close(']');
  }
  void separate();
  void digits(mpz_srcptr n);

  std::string text_;
  bool first_ = true;  ///< the next value is the first of its object or array
};

}  // namespace fathom::golden
