// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/messages.hpp"
#include "reference/files/cases.hpp"
#include "reference/files/mesh_formats.hpp"

namespace fathom::files {
namespace {

constexpr std::string_view separators = " \t\r\v\f,;";

/// The lines of a log. Behind the start of a failure, the words that a logger puts before each line
/// are cut off.
class Log {
 public:
  Log(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  /// False at the end; the line is empty then.
  bool next() {
    line_ = {};
    if (begin_ >= text_.size()) return false;
    ++number_;
    const std::size_t end = std::min(text_.find('\n', begin_), text_.size());
    line_ = text_.substr(begin_, end - begin_);
    begin_ = end + 1;
    if (line_.starts_with(prefix_)) line_.remove_prefix(prefix_.size());
    line_ = trimmed(line_);
    return true;
  }
  bool next_with_text() {
    while (next())
      if (!line_.empty()) return true;
    return false;
  }
  void set_prefix(std::string_view prefix) { prefix_ = trimmed(prefix); }

  [[nodiscard]] std::string_view line() const { return line_; }
  [[nodiscard]] std::size_t number() const { return number_; }
  [[noreturn]] void fail(const std::string& expected, std::string_view found) const {
    throw InputError(
        name_, number_,
        "expected " + expected + ", found " + (found.empty() ? "the end of the text" : kernels::shown(found)));
  }

 private:
  std::string_view text_, line_, prefix_;
  std::string name_;
  std::size_t begin_ = 0, number_ = 0;
};

/// What stands before the first separator; cuts it off.
std::string_view take_token(std::string_view& rest) {
  const std::size_t begin = std::min(rest.find_first_not_of(separators), rest.size());
  rest.remove_prefix(begin);
  const std::string_view token = rest.substr(0, rest.find_first_of(separators));
  rest.remove_prefix(token.size());
  return token;
}

/// The nearest binary64, integers too: FCL printed a double.
mpq_class number(const Log& log, std::string_view token, const std::string& what) {
  const ParsedNumber parsed = parse_number(token, Decimals::binary64);
  if (!parsed.value) log.fail(what, token);
  const double nearest = round_binary64(*parsed.value, Rounding::rn);
  if (nearest - nearest != 0) log.fail(what + " within binary64", token);
  return exact_value(nearest);
}

/// Exactly three numbers and nothing else.
Point three_numbers(const Log& log, std::string_view text, const std::string& what) {
  std::string_view rest = text;
  Point point;
  for (mpq_class* value : {&point.x, &point.y, &point.z}) {
    const std::string_view token = take_token(rest);
    if (token.empty()) log.fail(what, trimmed(text));
    *value = number(log, token, what);
  }
  if (!take_token(rest).empty()) log.fail(what, trimmed(text));
  return point;
}

/// Cuts "<double>" and the like off the front.
std::string_view without_scalar(std::string_view text) {
  text = trimmed(text);
  return text.starts_with('<') ? text.substr(std::min(text.find('>'), text.size() - 1) + 1) : text;
}

/// What stands in brackets at the front of `text`, or all of it if there are none.
std::string_view in_brackets(std::string_view text) {
  text = trimmed(text);
  if (!text.starts_with('(')) return text;
  return text.substr(1, text.find(')') == std::string_view::npos ? std::string_view::npos : text.find(')') - 1);
}

/// "0.5 0.5 0.5" of FCL 0.7, "<double>(0.5, 0.5, 0.5);" of later ones: the lengths of the sides.
Body box(const Log& log, std::string_view text) {
  const std::string what = "the three sides of a Box";
  const Point sides = three_numbers(log, in_brackets(without_scalar(text)), what);
  Body body;
  for (int corner = 0; corner < 8; ++corner)
    body.points.push_back({(corner & 1 ? 1 : -1) * sides.x / 2, (corner & 2 ? 1 : -1) * sides.y / 2,
                           (corner & 4 ? 1 : -1) * sides.z / 2});
  if (sides.x < 0 || sides.y < 0 || sides.z < 0) log.fail(what + ", none negative", text);
  return body;
}

/// Adds the points on this line: "Vector3<double>(x, y, z)".
void read_points(const Log& log, Body& body) {
  constexpr std::string_view word = "Vector3";
  for (std::size_t at = 0; (at = log.line().find(word, at)) != std::string_view::npos;) {
    at += word.size();
    const std::string_view rest = without_scalar(log.line().substr(at));
    if (rest.starts_with('('))
      body.points.push_back(three_numbers(log, in_brackets(rest), "the three coordinates of a point"));
  }
}

/// The log stands at the shape's first line; leaves it at the line with `end`.
Body convex(Log& log, std::string_view end) {
  if (log.line().find("v count") != std::string_view::npos)
    log.fail("a Convex with its points, which FCL 0.7 and older do not print", log.line());
  Body body;
  while (!log.line().starts_with(end)) {
    read_points(log, body);
    if (!log.next_with_text()) log.fail(std::string(end), {});
  }
  if (body.points.empty()) log.fail("the points of a Convex before it", end);
  return body;
}

/// The shape whose text begins with `text`, which is the rest of its line or empty; leaves the log
/// at the line with `end`.
Body shape(Log& log, std::string_view text, std::string_view end) {
  if (text.empty()) {
    if (!log.next_with_text()) log.fail("a shape", {});
    text = log.line();
  }
  if (text.starts_with("Convex")) return convex(log, end);
  if (!text.starts_with("Box")) log.fail("a Box or a Convex (other shapes are not polytopes)", text);
  Body body = box(log, text.substr(3));
  if (!log.next_with_text() || !log.line().starts_with(end)) log.fail(std::string(end), log.line());
  return body;
}

/// Sixteen numbers, row by row, on the lines that follow.
Pose pose(Log& log) {
  Pose pose;
  std::string_view rest;
  for (std::size_t i = 0; i < 16; ++i) {
    const std::string what = "number " + std::to_string(i + 1) + " of a 4 x 4 matrix";
    std::string_view token = take_token(rest);
    if (token.empty()) {
      if (!log.next_with_text()) log.fail(what, {});
      rest = log.line();
      token = take_token(rest);
    }
    const mpq_class value = number(log, token, what);
    if (i < 12) pose[i / 4][i % 4] = value;
    else if (value != (i == 15 ? 1 : 0)) log.fail("a last row of 0 0 0 1", log.line());
  }
  if (const std::string_view more = take_token(rest); !more.empty()) log.fail("the end of a 4 x 4 matrix", more);
  return pose;
}

FclFailure failure(Log& log, std::size_t at, std::string message) {
  constexpr std::string_view first = "Shape 1:", second = "Shape 2:";
  FclFailure result{log.number(), {}, {}, std::move(message)};
  const std::string_view line = log.line();
  log.set_prefix(line.substr(0, at));
  result.first.body = shape(log, trimmed(line.substr(at + first.size())), "X_FS1");
  result.first.pose = pose(log);
  if (!log.next_with_text() || !log.line().starts_with(second)) log.fail("'Shape 2:'", log.line());
  result.second.body = shape(log, trimmed(log.line().substr(second.size())), "X_FS2");
  result.second.pose = pose(log);
  log.set_prefix({});
  return result;
}

}  // namespace

std::vector<FclFailure> read_fcl_text(std::string_view text, const std::string& name) {
  constexpr std::string_view heading = "Original error message:";
  Log log(text, name);
  std::vector<FclFailure> failures;
  std::string message;
  while (log.next()) {
    if (const std::size_t at = log.line().find(heading); at != std::string_view::npos)
      message = trimmed(log.line().substr(at + heading.size()));
    if (const std::size_t at = log.line().find("Shape 1:"); at != std::string_view::npos)
      failures.push_back(failure(log, at, std::exchange(message, {})));
  }
  if (failures.empty())
    throw InputError(name, 0, "expected the text of an exception of FCL, with 'Shape 1:', found none");
  return failures;
}

}  // namespace fathom::files
