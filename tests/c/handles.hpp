// SPDX-License-Identifier: GPL-3.0-or-later
// Handles of C that end by themselves, for tests.
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "fathom/fathom.h"
#include "fathom/numbers.hpp"
#include "fathom/point.hpp"

namespace fathom::testing {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Free {
  void operator()(fathom_body* body) const { fathom_body_free(body); }
  void operator()(fathom_answer* answer) const { fathom_answer_free(answer); }
};
using BodyHandle = std::unique_ptr<fathom_body, Free>;
using AnswerHandle = std::unique_ptr<fathom_answer, Free>;

inline BodyHandle body_of(const std::vector<double>& xyz) {
  fathom_body* body = nullptr;
  EXPECT_EQ(fathom_body_from_points(xyz.data(), xyz.size() / 3, &body), FATHOM_OK) << fathom_last_error();
  return BodyHandle(body);
}

/// The same of exact points.
inline BodyHandle exact_body_of(const std::vector<Point>& points) {
  std::vector<std::string> texts;
  for (const Point& p : points)
    for (const mpq_class& x : {p.x, p.y, p.z}) texts.push_back(exact_text(x));
  std::vector<const char*> numbers;
  for (const std::string& text : texts) numbers.push_back(text.c_str());
  fathom_body* body = nullptr;
  EXPECT_EQ(fathom_body_from_numbers(numbers.data(), points.size(), &body), FATHOM_OK) << fathom_last_error();
  return BodyHandle(body);
}

inline BodyHandle shape_of(const char* text) {
  fathom_body* body = nullptr;
  EXPECT_EQ(fathom_body_from_shape(text, FATHOM_EXACT_DECIMALS, &body), FATHOM_OK) << fathom_last_error();
  return BodyHandle(body);
}

inline AnswerHandle answer_about(const BodyHandle& a, const BodyHandle& b, const fathom_options* options = nullptr) {
  fathom_answer* answer = nullptr;
  EXPECT_EQ(fathom_depth(a.get(), b.get(), options, &answer), FATHOM_OK) << fathom_last_error();
  return AnswerHandle(answer);
}

/// The text that a function made, freed; "" for NULL.
inline std::string taken(char* text) {
  const std::string result = text ? text : "";
  fathom_text_free(text);
  return result;
}

inline std::string exactly(const AnswerHandle& answer, int quantity) {
  char* text = nullptr;
  EXPECT_EQ(fathom_answer_exact(answer.get(), quantity, &text), FATHOM_OK) << fathom_last_error();
  return taken(text);
}

/// The unit cube, moved along x.
inline std::vector<double> cube_at(double x) {
  std::vector<double> points;
  for (unsigned i = 0; i < 8; ++i) points.insert(points.end(), {(i & 1) + x, i & 2 ? 1.0 : 0.0, i & 4 ? 1.0 : 0.0});
  return points;
}

}  // namespace fathom::testing
