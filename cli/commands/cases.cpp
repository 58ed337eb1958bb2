// SPDX-License-Identifier: GPL-3.0-or-later
// fathom cases --family NAME|all | --catalogue | --list | --from A B | --from-fcl FILE

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cli/commands/command.hpp"
#include "cli/commands/family_names.hpp"
#include "cli/commands/replies.hpp"
#include "cli/io/output.hpp"
#include "cli/io/terminal.hpp"
#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "kernels/messages.hpp"
#include "reference/files/case_json.hpp"
#include "verify/families/catalogue.hpp"
#include "verify/families/families.hpp"
#include "reference/files/fcl_text.hpp"
#include "reference/files/file_io.hpp"

namespace fathom::cli {
namespace {

/// Prints each failure in the text of FCL's exceptions as a case; "-" is the standard input. Throws InputError if there is none, or a bad
/// one.
ExitCode print_fcl_cases(const std::string& path) {
  const bool standard = path == "-";
  const std::string name = standard ? "<stdin>" : path;
  const std::string text = standard ? std::string(std::istreambuf_iterator<char>(std::cin), {}) : files::read_file(path);
  for (const files::FclFailure& failure : files::read_fcl_text(text, name)) {
    files::CaseText line{fmt::format("{}:{}", name, failure.line),
                         files::body_json(failure.first.body, failure.first.pose),
                         files::body_json(failure.second.body, failure.second.pose),
                         {{"fcl", name}},
                         failure.message,
                         true};
    print(files::case_json(line));
  }
  return fine;
}

constexpr std::string_view every_family = "all";

/// "1/4", "5 - sqrt(25)".
std::string known_text(const Surd& value) {
  const std::string rational = exact_text(value.rational);
  if (value.root == 0) return rational;
  return fmt::format("{} {} sqrt({})", rational, value.root > 0 ? '+' : '-', exact_text(abs(value.root)));
}

/// What the square of a catalogue of unions is of.
std::string known_square(Status status) { return status == Status::disjoint ? "distance_squared" : "depth_squared"; }

using Source = std::vector<std::pair<std::string, std::string>>;

void print_case(const Case& pair, Source source, const std::string& comment) {
  print(files::case_json({pair.id, files::body_json(pair.a), files::body_json(pair.b), std::move(source), comment}));
}

void print_case(const families::ShapeCase& shapes, Source source, const std::string& comment) {
  const families::NamedPair& pair = shapes.pair;
  if (pair.known) source.emplace_back("signed_depth", known_text(pair.known->signed_depth));
  print(files::case_json({shapes.id, files::body_json(pair.a), files::body_json(pair.b), std::move(source), comment}));
}

template <class Family>
void print_case_of(const Family& family, std::uint64_t seed, const CasesRequest& request) {
  const unsigned size = request.size.value_or(family.usual_size);
  print_case(family.make(seed, size),
             {{"family", std::string(family.name)}, {"size", fmt::format("{}", size)}, {"seed", fmt::format("{}", seed)}}, "");
}

using AnyFamily = std::variant<const families::Family*, const families::ShapeFamily*, const families::UnionFamily*>;

std::string_view name_of(const AnyFamily& family) {
  return std::visit([](const auto* one) -> std::string_view { return one->name; }, family);
}

template <class Families>
void add_all(std::vector<AnyFamily>& to, const Families& all) {
  for (const auto& family : all) to.push_back(&family);
}

/// The families of a name or a pattern.
std::vector<AnyFamily> families_like(const std::string& pattern, const std::vector<AnyFamily>& all) {
  std::vector<AnyFamily> result;
  for (const AnyFamily& family : all)
    if (::fnmatch(pattern.c_str(), std::string(name_of(family)).c_str(), 0) == 0) result.push_back(family);
  if (result.empty())
    throw InputError(
        "--family", 0,
        fmt::format(
            "{} is unknown (nearest: {}; --list lists all of polytopes, with --shapes those of shapes, with --unions those of unions)",
            kernels::shown(pattern), fmt::join(nearest_families(pattern), ", ")));
  return result;
}

/// Those that were asked for, each once.
std::vector<AnyFamily> asked_families(const CasesRequest& request) {
  std::vector<AnyFamily> all, result;
  if (request.families == std::vector<std::string>{std::string(every_family)}) {
    if (request.shapes) add_all(result, families::shape_families());
    else if (request.unions) add_all(result, families::union_families());
    else add_all(result, families::families());
    return result;
  }
  add_all(all, families::families());
  add_all(all, families::shape_families());
  add_all(all, families::union_families());
  for (const std::string& pattern : request.families)
    for (const AnyFamily& family : families_like(pattern, all))
      if (std::ranges::find(result, family) == result.end()) result.push_back(family);
  return result;
}

/// Each family in turn with the first seed, then each with the second, until there are enough.
ExitCode print_families(const CasesRequest& request) {
  const std::vector<AnyFamily> asked = asked_families(request);
  for (std::uint64_t i = 0; i < request.count; ++i)
    std::visit([&](const auto* family) { print_case_of(*family, request.seed + i / asked.size(), request); }, asked[i % asked.size()]);
  return fine;
}

ExitCode print_catalogue(const CasesRequest& request) {
  if (request.shapes) {
    for (const families::ShapeCatalogueEntry& entry : families::shape_catalogue())
      print_case(entry.shapes, {{"catalogue", entry.shapes.id}}, std::string(entry.description));
  } else if (request.unions) {
    for (const families::UnionCatalogueEntry& entry : families::union_catalogue())
      print_case(entry.pair, {{"catalogue", entry.pair.id}, {known_square(entry.status), exact_text(entry.squared)}},
                 std::string(entry.description));
  } else {
    for (const families::CatalogueEntry& entry : families::catalogue())
      print_case(entry.pair, {{"catalogue", std::string(entry.name)}}, fmt::format("{}; not so: {}", entry.description, entry.breaks));
  }
  return fine;
}

template <class Families>
ExitCode print_list(const Families& all) {
  std::size_t column = 0;
  for (const auto& family : all) column = std::max(column, family.name.size());
  for (const auto& family : all) print(fitted(fmt::format("{:<{}}  {}", family.name, column, family.description), column + 2));
  return fine;
}

ExitCode print_meshes(const Request& request) {
  const auto pose = [&](const std::optional<std::string>& text, const char* option) {
    return text ? std::optional(asked_pose(*text, option, request.decimals, false)) : std::nullopt;
  };
  const auto posed = [](const Body& body, const std::optional<files::GivenPose>& given) {
    return given ? files::body_json(body, *given) : files::body_json(body);
  };
  const std::optional<files::GivenPose> pose_a = pose(request.pose_a, "--pose-a"), pose_b = pose(request.pose_b, "--pose-b");
  const std::string &path_a = request.inputs[0], &path_b = request.inputs[1];
  const Body a = read_mesh(path_a, request.decimals), b = read_mesh(path_b, request.decimals);
  print(files::case_json({path_a + " " + path_b, posed(a, pose_a), posed(b, pose_b), {{"a", path_a}, {"b", path_b}}, ""}));
  return fine;
}

}  // namespace

ExitCode run_cases(const Request& request) {
  switch (request.cases.what) {
    case CasesRequest::What::family: return print_families(request.cases);
    case CasesRequest::What::catalogue: return print_catalogue(request.cases);
    case CasesRequest::What::list:
      if (request.cases.shapes) return print_list(families::shape_families());
      return request.cases.unions ? print_list(families::union_families()) : print_list(families::families());
    case CasesRequest::What::from: return print_meshes(request);
    case CasesRequest::What::from_fcl: return print_fcl_cases(request.cases.fcl);
  }
  return internal_error;
}

}  // namespace fathom::cli
