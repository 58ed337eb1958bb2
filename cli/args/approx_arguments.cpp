// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/args/approx_arguments.hpp"

#include <fmt/format.h>

#include "cli/args/named_files.hpp"
#include "fathom/numbers.hpp"
#include "kernels/messages.hpp"
#include "reference/approximate/directions.hpp"

namespace fathom::cli {
namespace {

constexpr const char* usual_delta = "1/100";

/// Numbers on the command line are meant as typed: decimals are exact.
std::optional<mpq_class> typed_number(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(' '), end = text.find_last_not_of(' ');
  if (begin == text.npos) return std::nullopt;
  return parse_number(text.substr(begin, end - begin + 1), Decimals::exact).value;
}

}  // namespace

std::optional<Point> typed_vector(std::string_view text) {
  const std::size_t first = text.find(','), second = first == text.npos ? first : text.find(',', first + 1);
  if (second == text.npos) return std::nullopt;
  const auto x = typed_number(text.substr(0, first)), y = typed_number(text.substr(first + 1, second - first - 1)),
             z = typed_number(text.substr(second + 1));
  if (!x || !y || !z || (*x == 0 && *y == 0 && *z == 0)) return std::nullopt;
  return Point{*x, *y, *z};
}

namespace {

std::string check_delta(const std::string& text) {
  const auto value = typed_number(text);
  return value && *value >= approximate::least_delta
             ? ""
             : fmt::format("expected a positive number such as 1/100, 1e-9 or more, found {}", kernels::shown(text));
}

void add_json(CLI::App& app, Request& request, const std::string& schema) {
  app.add_flag("--json", request.json, "one JSON object per line, schema " + schema);
}

}  // namespace

std::string check_vector(const std::string& text) {
  return typed_vector(text) ? "" : fmt::format("expected three numbers such as 1,0,-1/2, not all zero, found {}", kernels::shown(text));
}

void add_delta(CLI::App& app, Request& request, const std::string& meaning) {
  app.add_option_function<std::string>(
         "--delta", [&request](const std::string& text) { request.delta = typed_number(text); }, meaning)
      ->check(CLI::Validator(check_delta, "", ""))
      ->type_name("DELTA");
}

void add_approx_options(CLI::App& app, Request& request) {
  add_delta(app, request,
            fmt::format("the translation may be longer than the depth by a factor of 1 + DELTA; {} unless given. "
                        "About 4 / DELTA rays are shot",
                        usual_delta));
  add_json(app, request, "fathom/result/2");
}

void add_ray_options(CLI::App& app, Request& request) {
  app.add_option_function<std::string>(
         "--direction", [&request](const std::string& text) { request.direction = typed_vector(text); }, "where A is to move")
      ->check(CLI::Validator(check_vector, "", ""))
      ->type_name("X,Y,Z");
  add_json(app, request, "fathom/ray/1");
}

void add_metric_options(CLI::App& app, Request& request) {
  names_file(app.add_option("--ball", request.ball,
                            "the unit ball: a mesh with O inside its hull. Symmetric about O it makes a norm, else a gauge"),
             FileUse::read)
      ->type_name("Q");
  add_json(app, request, "fathom/metric/1");
}

std::string wrong_approximation(Request& request, bool exact_options) {
  if (request.command == Command::approx && !request.delta) request.delta = typed_number(usual_delta);
  if (request.command == Command::ray && !request.direction) return "ray expects --direction X,Y,Z: where A is to move";
  if (request.command == Command::metric && request.ball.empty()) return "metric expects --ball Q: a mesh, the unit ball";
  if (request.command != Command::width || !request.delta) return "";
  if (exact_options) return "--delta asks for an approximation, and cannot be combined with --method, --closest-lines or a certificate";
  if (request.counters) return "--delta asks for an approximation, which has no counters: it cannot be combined with --counters";
  if (request.bits) return "--delta asks for an approximation by rays, and cannot be combined with --bits, which is about bounds";
  return "";
}

}  // namespace fathom::cli
