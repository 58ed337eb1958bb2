// SPDX-License-Identifier: GPL-3.0-or-later
// fathom cases --family NAME|all | --catalogue | --list | --from A B | --from-fcl FILE
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cli/commands/cases_fcl.hpp"
#include "cli/commands/cases_json.hpp"
#include "cli/commands/cases_pose.hpp"
#include "cli/commands/command.hpp"
#include "cli/io/output.hpp"
#include "fathom/files.hpp"
#include "kernels/printable.hpp"
#include "verify/families/catalogue.hpp"
#include "verify/families/families.hpp"
#include "verify/harness/near_miss.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t suggestions = 3, longest_name = 60;
constexpr std::string_view every_family = "all";

/// Names that hold `name` come first, then those by the fewest slips.
std::vector<std::string_view> nearest_names(std::string_view name) {
  std::vector<std::string_view> names;
  for (const families::Family& family : families::families()) names.push_back(family.name);
  const std::string_view typed = name.substr(0, longest_name);
  const auto distance = [typed](std::string_view other) {
    return !typed.empty() && other.find(typed) != std::string_view::npos ? 0 : harness::slips(typed, other);
  };
  std::ranges::stable_sort(names, {}, distance);
  names.resize(std::min(names.size(), suggestions));
  return names;
}

void print_case_of(const families::Family& family, std::uint64_t seed, const CasesRequest& request) {
  const unsigned size = request.size.value_or(family.usual_size);
  const Case pair = family.make(seed, size);
  print(case_json({pair.id,
                   pair.a,
                   pair.b,
                   {},
                   {},
                   {},
                   {{"family", std::string(family.name)}, {"size", fmt::format("{}", size)}, {"seed", fmt::format("{}", seed)}},
                   ""}));
}

/// Each family in turn with the first seed, then each with the second, until there are enough.
ExitCode print_all_families(const CasesRequest& request) {
  const auto all = families::families();
  for (std::uint64_t i = 0; i < request.count; ++i) print_case_of(all[i % all.size()], request.seed + i / all.size(), request);
  return fine;
}

ExitCode print_family(const CasesRequest& request) {
  if (request.family == every_family) return print_all_families(request);
  const families::Family* family = families::find_family(request.family);
  if (!family)
    throw InputError("--family", 0,
                     fmt::format("{} is unknown (nearest: {}; --list lists all)", kernels::shown(request.family),
                                 fmt::join(nearest_names(request.family), ", ")));
  for (std::uint64_t i = 0; i < request.count; ++i) print_case_of(*family, request.seed + i, request);
  return fine;
}

ExitCode print_catalogue() {
  for (const families::CatalogueEntry& entry : families::catalogue())
    print(case_json({entry.pair.id,
                     entry.pair.a,
                     entry.pair.b,
                     {},
                     {},
                     {},
                     {{"catalogue", std::string(entry.name)}},
                     fmt::format("{}; not so: {}", entry.description, entry.breaks)}));
  return fine;
}

ExitCode print_list() {
  std::size_t column = 0;
  for (const families::Family& family : families::families()) column = std::max(column, family.name.size());
  for (const families::Family& family : families::families()) print(fmt::format("{:<{}}  {}", family.name, column, family.description));
  return fine;
}

ExitCode print_meshes(const Request& request) {
  const auto pose = [&](const std::optional<std::string>& text, const char* option) {
    return text ? std::optional<files::Pose>(parse_pose(*text, option, request.decimals)) : std::nullopt;
  };
  const std::optional<files::Pose> pose_a = pose(request.cases.pose_a, "--pose-a"), pose_b = pose(request.cases.pose_b, "--pose-b");
  const std::string &path_a = request.inputs[0], &path_b = request.inputs[1];
  const Body a = read_mesh(path_a, request.decimals), b = read_mesh(path_b, request.decimals);
  print(case_json({path_a + " " + path_b, a, b, pose_a, pose_b, {}, {{"a", path_a}, {"b", path_b}}, ""}));
  return fine;
}

}  // namespace

ExitCode run_cases(const Request& request) {
  switch (request.cases.what) {
    case CasesRequest::What::family: return print_family(request.cases);
    case CasesRequest::What::catalogue: return print_catalogue();
    case CasesRequest::What::list: return print_list();
    case CasesRequest::What::from: return print_meshes(request);
    case CasesRequest::What::from_fcl: return print_fcl_cases(request.cases.fcl);
  }
  return internal_error;
}

}  // namespace fathom::cli
