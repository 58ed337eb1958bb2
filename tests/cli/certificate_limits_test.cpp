// SPDX-License-Identifier: GPL-3.0-or-later
// That a proof which no checker would read is told of, by small limits in the place of those that
// checkers have.
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "cli/io/output.hpp"
#include "fathom/certificate.hpp"
#include "verify/check/limits.hpp"

namespace fathom::cli {
namespace {

using fathom_check::Limits;

std::vector<Point> box(const Point& low, const Point& high) {
  std::vector<Point> corners;
  for (const mpq_class& x : {low.x, high.x})
    for (const mpq_class& y : {low.y, high.y})
      for (const mpq_class& z : {low.z, high.z}) corners.push_back({x, y, z});
  return corners;
}

const std::vector<Point> cube = box({0, 0, 0}, {2, 2, 2}), beside = box({1, 0, 0}, {3, 2, 2});

std::string of_convex() { return certificate_text(cube, beside, penetration_depth(cube, beside), "convex"); }
std::string of_shapes() {
  Shape a = hull(cube), b = hull(beside);
  a.radius = 1;
  b.radius = 2;
  return certificate_text(a, b, signed_depth(a, b), "rounded");
}
std::string of_unions() {
  const Pieces a{box({0, 0, 0}, {1, 2, 2}), box({1, 0, 0}, {2, 2, 2})}, b{beside};
  return certificate_text(a, b, union_depth(a, b), "union");
}

/// What is said of the certificate; empty if it may be written.
std::string said(const std::string& text, const Limits& limits = {}) {
  try {
    require_readable("the case", text, limits);
    return "";
  } catch (const OutputError& error) {
    return error.what();
  }
}

/// Whether the sentence is about this limit, and says what helps.
void expect_told(const std::string& sentence, const std::string& limit) {
  const std::string begin =
      "the case: no certificate is written, since all checkers would refuse to read it: a certificate ";
  EXPECT_EQ(sentence.substr(0, begin.size() + limit.size()), begin + limit);
  EXPECT_NE(sentence.find("--exact-decimals"), std::string::npos) << sentence;
}

TEST(CertificateLimits, EachIsNamed) {
  for (const std::string& text : {of_convex(), of_shapes(), of_unions()}) {
    EXPECT_EQ(said(text), "");
    expect_told(said(text, {.bytes = 100}), "of more bytes than the limit, 100.");
    expect_told(said(text, {.numbers = 20}), "of more numbers than the limit, 20.");
    expect_told(said(text, {.size = 30}), "larger than the limit, 30 in its size.");
    expect_told(said(text, {.work = 4'000}), "of more work than the limit, 4000.");
  }
}

TEST(CertificateLimits, WhatReachesALimitIsWritten) {
  for (const std::string& text : {of_convex(), of_shapes(), of_unions()}) {
    std::size_t bytes = 0;
    for (const char c : text) bytes += c != '\n';
    EXPECT_EQ(said(text, {.bytes = bytes}), "");
    expect_told(said(text, {.bytes = bytes - 1}), "of more bytes than the limit, ");
  }
}

TEST(CertificateLimits, NumbersAndLinesToo) {
  const std::vector<Point> wide = box({0, 0, 0}, {mpq_class(std::string(100'001, '7')), 1, 1});
  const std::string sentence = said(certificate_text(wide, cube, penetration_depth(wide, cube), "wide"));
  EXPECT_NE(sentence.find(": a number of more digits than the limit, 100000. "), std::string::npos)
      << sentence.substr(0, 200);
  const std::string id(std::size_t{1} << 24, 'x');
  EXPECT_NE(said(certificate_text(cube, beside, penetration_depth(cube, beside), id)), "") << "a line that is too long";
}

}  // namespace
}  // namespace fathom::cli
