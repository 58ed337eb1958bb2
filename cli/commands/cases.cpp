// SPDX-License-Identifier: GPL-3.0-or-later
// fathom cases --family NAME|all | --catalogue | --small-world N | --list | --from A B |
// --from-fcl FILE

#include "reference/files/cases.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands/command.hpp"
#include "cli/commands/names.hpp"
#include "cli/commands/replies.hpp"
#include "cli/io/output.hpp"
#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "kernels/messages.hpp"
#include "reference/files/file_io.hpp"
#include "verify/families/families.hpp"
#include "verify/families/polytope_pairs.hpp"

namespace fathom::cli {
namespace {

/// Prints the case of each failure in a text of FCL's exceptions; "-" is the standard input. Throws
/// InputError if there is none, or a bad one.
ExitCode print_fcl_cases(const std::string& path) {
  const bool standard = path == "-";
  const std::string name = standard ? "<stdin>" : path;
  const std::string text =
      standard ? std::string(std::istreambuf_iterator<char>(std::cin), {}) : files::read_file(path);
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

/// The cases to print.
struct FamiliesRequest {
  explicit FamiliesRequest(const Given& given)
      : names(given.words("--family")),
        count(given.integer<std::uint64_t>("--count").value_or(1)),
        seed(given.integer<std::uint64_t>("--seed").value_or(1)),
        size(given.integer<unsigned>("--size")) {}

  std::vector<std::string> names;  ///< as typed: names, patterns, or "all"
  std::uint64_t count, seed;       ///< the seeds are seed, seed + 1, ...
  std::optional<unsigned> size;    ///< if not set, the family's usual size
};

constexpr std::string_view every_family = "all";

/// Returns "1/4", "5 - sqrt(25)".
std::string known_text(const Surd& value) {
  const std::string rational = exact_text(value.rational);
  if (value.root == 0) return rational;
  return fmt::format("{} {} sqrt({})", rational, value.root > 0 ? '+' : '-', exact_text(abs(value.root)));
}

/// Returns the name of the square that a catalogue of unions holds.
std::string known_square(Status status) { return status == Status::disjoint ? "distance_squared" : "depth_squared"; }

using Source = std::vector<std::pair<std::string, std::string>>;

void print_case(const Case& pair, Source source, const std::string& comment) {
  print(files::case_json({pair.id,
                          files::body_json(pair.a),
                          files::body_json(pair.b),
                          std::move(source),
                          comment,
                          false,
                          {},
                          pair.a.dimension == 2}));
}

void print_case(const families::ShapeCase& shapes, Source source, const std::string& comment) {
  const families::NamedPair& pair = shapes.pair;
  if (pair.known) source.emplace_back("signed_depth", known_text(pair.known->signed_depth));
  print(files::case_json({shapes.id, files::body_json(pair.a), files::body_json(pair.b), std::move(source), comment}));
}

void print_case_of(const families::Family& family, std::uint64_t seed, const FamiliesRequest& request) {
  const unsigned size = request.size.value_or(family.usual_size);
  Source source{
      {"family", std::string(family.name)}, {"size", fmt::format("{}", size)}, {"seed", fmt::format("{}", seed)}};
  if (family.kind() == families::Kind::shapes) print_case(family.make_shapes(seed, size), std::move(source), "");
  else print_case(family.make(seed, size), std::move(source), "");
}

/// Returns the kind of families that the options choose: shapes, unions, bodies of the plane, or
/// else polytopes.
families::Kind asked_kind(const Given& given) {
  if (given.flag("--plane")) return families::Kind::plane;
  if (given.flag("--shapes")) return families::Kind::shapes;
  return given.flag("--unions") ? families::Kind::unions : families::Kind::polytopes;
}

using FamilyList = std::vector<const families::Family*>;

/// Returns the families whose names match a pattern.
FamilyList families_like(const std::string& pattern) {
  FamilyList result;
  for (const families::Family& family : families::all_families())
    if (::fnmatch(pattern.c_str(), std::string(family.name).c_str(), 0) == 0) result.push_back(&family);
  if (result.empty())
    throw InputError("--family", 0,
                     fmt::format("{} is unknown (nearest: {}; --list lists all of polytopes, with --shapes those of "
                                 "shapes, with --unions those of unions, with --plane those of the plane)",
                                 kernels::shown(pattern), fmt::join(nearest_families(pattern), ", ")));
  return result;
}

/// Returns the families of these names and patterns, each once.
FamilyList asked_families(const std::vector<std::string>& names, families::Kind kind) {
  FamilyList result;
  if (names == std::vector<std::string>{std::string(every_family)}) {
    for (const families::Family& family : families::families(kind)) result.push_back(&family);
    return result;
  }
  for (const std::string& pattern : names)
    for (const families::Family* family : families_like(pattern))
      if (std::ranges::find(result, family) == result.end()) result.push_back(family);
  return result;
}

/// Prints one case of each family with the first seed, then with the second, and so on up to the
/// count.
ExitCode print_families(const FamiliesRequest& request, families::Kind kind) {
  const FamilyList asked = asked_families(request.names, kind);
  for (std::uint64_t i = 0; i < request.count; ++i)
    print_case_of(*asked[i % asked.size()], request.seed + i / asked.size(), request);
  return fine;
}

ExitCode print_catalogue(families::Kind kind) {
  if (kind == families::Kind::shapes) {
    for (const families::ShapeCatalogueEntry& entry : families::shape_catalogue())
      print_case(entry.shapes, {{"catalogue", entry.shapes.id}}, std::string(entry.description));
  } else if (kind == families::Kind::unions) {
    for (const families::UnionCatalogueEntry& entry : families::union_catalogue())
      print_case(entry.pair, {{"catalogue", entry.pair.id}, {known_square(entry.status), exact_text(entry.squared)}},
                 std::string(entry.description));
  } else {
    for (const families::CatalogueEntry& entry : families::catalogue())
      print_case(entry.pair, {{"catalogue", std::string(entry.name)}},
                 fmt::format("{}; not so: {}", entry.description, entry.breaks));
  }
  return fine;
}

/// Prints so many pairs of the small world from `first` on, as far as there are.
ExitCode print_small_world(std::uint64_t first, std::uint64_t count) {
  const std::uint64_t size = families::small_world_size();
  if (first >= size)
    throw InputError("--small-world", 0, fmt::format("expected a number from 0 to {}, found {}", size - 1, first));
  for (std::uint64_t number = first; number < size && number - first < count; ++number)
    print_case(families::small_case(number),
               {{"small_world", fmt::format("{}", number)},
                {"kinds", fmt::format("{}", fmt::join(families::small_kinds(families::small_pair(number)), " "))}},
               "");
  return fine;
}

ExitCode print_list(std::span<const families::Family> all) {
  std::size_t column = 0;
  for (const families::Family& family : all) column = std::max(column, family.name.size());
  for (const families::Family& family : all)
    print(fitted(fmt::format("{:<{}}  {}", family.name, column, family.description), column + 2));
  return fine;
}

ExitCode print_meshes(const BodiesRequest& request) try {
  const auto pose = [&](const std::optional<std::string>& text, const char* option) {
    return text ? std::optional(asked_pose(*text, option, request.decimals, false)) : std::nullopt;
  };
  const auto posed = [](Body body, const std::optional<files::GivenPose>& given) {
    // A pose of its own, none that could be written, or one that is refused.
    if (given && (body.words || body.dimension == 2 || given->plane)) {
      files::place(body, *given);
      return files::body_json(body);
    }
    return given ? files::body_json(body, *given) : files::body_json(body);
  };
  const std::optional<files::GivenPose> pose_a = pose(request.pose_a, "--pose-a"),
                                        pose_b = pose(request.pose_b, "--pose-b");
  const std::string &path_a = request.inputs[0], &path_b = request.inputs[1];
  const std::vector<Body> bodies = bodies_of_inputs(request);
  const Body &a = bodies[0], &b = bodies[1];
  if (a.dimension != b.dimension)
    throw InputError(path_a + " " + path_b, 0, wrong_bodies({"", a, b}, false, "", "", ""));
  files::CaseText text{path_a + " " + path_b, posed(a, pose_a), posed(b, pose_b), {{"a", path_a}, {"b", path_b}}, ""};
  text.plane = a.dimension == 2;
  print(files::case_json(text));
  return fine;
} catch (const std::invalid_argument& error) {
  throw InputError("--pose-a, --pose-b", 0, error.what());
}

}  // namespace

ExitCode run_cases(const Given& given) {
  if (given.has("--from-fcl")) return print_fcl_cases(given.text("--from-fcl"));
  if (given.has("--from")) return print_meshes(BodiesRequest(given));
  if (given.has("--list")) return print_list(families::families(asked_kind(given)));
  if (given.has("--catalogue")) return print_catalogue(asked_kind(given));
  if (given.has("--small-world"))
    return print_small_world(*given.integer<std::uint64_t>("--small-world"),
                             given.integer<std::uint64_t>("--count").value_or(1));
  return print_families(FamiliesRequest(given), asked_kind(given));
}

}  // namespace fathom::cli
