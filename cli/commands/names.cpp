// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "cli/args/values.hpp"
#include "fathom/files.hpp"
#include "kernels/messages.hpp"
#include "verify/families/families.hpp"

namespace fathom::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t suggestions = 3, longest_name = 60;

bool is_script(const Adapter& adapter) { return adapter.program.ends_with(".mjs"); }

// A script can run if npm has installed its packages beside it.
bool is_ready(const Adapter& adapter, const fs::path& file) {
  std::error_code fault;
  if (is_script(adapter))
    return fs::is_regular_file(file, fault) && fs::is_directory(file.parent_path() / "node_modules", fault);
  return ::access(file.c_str(), X_OK) == 0;
}

}  // namespace

std::vector<std::string_view> nearest_families(std::string_view name, std::vector<std::string_view> names) {
  const std::string_view typed = name.substr(0, longest_name);
  const auto distance = [typed](std::string_view other) {
    return !typed.empty() && other.find(typed) != std::string_view::npos ? 0 : kernels::slips(typed, other);
  };
  std::ranges::stable_sort(names, {}, distance);
  names.resize(std::min(names.size(), suggestions));
  return names;
}

const std::vector<Adapter>& adapters() {
  static const std::vector<Adapter> all = {
      {"libccd-epa", "fathom-subject-libccd", "epa", "libccd: ccdGJKPenetration (GJK, then EPA)"},
      {"libccd-mpr", "fathom-subject-libccd", "mpr", "libccd: ccdMPRPenetration"},
      {"fcl-signed", "fathom-subject-fcl", "signed", "FCL: distance with enable_signed_distance (its own EPA)"},
      {"fcl-collide", "fathom-subject-fcl", "collide", "FCL: collide, solver GST_LIBCCD"},
      {"fcl-indep", "fathom-subject-fcl", "indep", "FCL: collide, solver GST_INDEP"},
      {"bullet-epa", "fathom-subject-bullet", "epa", "Bullet, binary32: btGjkEpaSolver2, margin 0"},
      {"bullet-pair", "fathom-subject-bullet", "pair", "Bullet, binary32: btGjkPairDetector with the shapes' margin"},
      {"bullet-world", "fathom-subject-bullet", "world", "Bullet, binary32: the deepest point of a world's manifold"},
      {"bullet64-epa", "fathom-subject-bullet64", "epa", "Bullet, binary64: btGjkEpaSolver2, margin 0"},
      {"bullet64-pair", "fathom-subject-bullet64", "pair",
       "Bullet, binary64: btGjkPairDetector with the shapes' margin"},
      {"bullet64-world", "fathom-subject-bullet64", "world",
       "Bullet, binary64: the deepest point of a world's manifold"},
      {"ode-collide", "fathom-subject-ode", "collide", "ODE: dCollide"},
      {"jolt", "web-subjects/jolt.mjs", "radius0", "Jolt, binary32: CollideShape, convex radius 0"},
      {"jolt-radius", "web-subjects/jolt.mjs", "radius",
       "Jolt, binary32: the same, convex radius 0.05 as in C++ by default"},
      {"jolt-world", "web-subjects/jolt.mjs", "world", "Jolt, binary32: the deepest point of a step's manifold"},
      {"rapier-contact", "web-subjects/rapier.mjs", "contact",
       "Rapier, binary32: contactCollider, which is parry's query"},
      {"rapier-world", "web-subjects/rapier.mjs", "world", "Rapier, binary32: the deepest point of a step's manifold"},
      {"physx-gjk", "web-subjects/physx.mjs", "gjk", "PhysX, binary32: PxGjkQuery (GJK, then EPA)"},
      {"physx-sweep", "web-subjects/physx.mjs", "sweep", "PhysX, binary32: a sweep that asks for the MTD"},
      {"physx-scene", "web-subjects/physx.mjs", "scene",
       "PhysX, binary32: the deepest point of a step's contact report"},
      {"havok", "web-subjects/havok.mjs", "proximity", "Havok, binary32: the proximity of two shapes"},
      {"mujoco-native", "web-subjects/mujoco.mjs", "native", "MuJoCo: mj_collision as by default"},
      {"mujoco-single", "web-subjects/mujoco.mjs", "single", "MuJoCo: mj_collision, multiccd disabled"},
      {"mujoco-libccd", "web-subjects/mujoco.mjs", "libccd", "MuJoCo: mj_collision, nativeccd disabled"},
      {"mujoco-distance", "web-subjects/mujoco.mjs", "distance", "MuJoCo: mj_geomDistance"},
      {"cannon-sat", "web-subjects/cannon.mjs", "sat", "cannon-es, binary64: findSeparatingAxis, testSepAxis"},
      {"cannon-contact", "web-subjects/cannon.mjs", "contact",
       "cannon-es, binary64: findSeparatingAxis, clipAgainstHull"},
      {"planck", "web-subjects/planck.mjs", "manifold",
       "planck, binary64, in the plane: the deepest point of a manifold"},
      {"matter", "web-subjects/matter.mjs", "sat", "matter-js, binary64, in the plane: Collision.collides"},
      {"box2d", "web-subjects/box2d.mjs", "world",
       "Box2D 3, binary32, in the plane: the deepest point of a step's manifold"},
      {"rapier2d-contact", "web-subjects/rapier2d.mjs", "contact",
       "Rapier, binary32, in the plane: contactCollider, which is parry's query"},
      {"rapier2d-world", "web-subjects/rapier2d.mjs", "world",
       "Rapier, binary32, in the plane: the deepest point of a step's manifold"},
  };
  return all;
}

const Adapter* adapter_named(std::string_view words) {
  const auto adapter = std::ranges::find(adapters(), words.substr(0, words.find(',')), &Adapter::name);
  return adapter == adapters().end() ? nullptr : &*adapter;
}

std::string program_of(const Adapter& adapter) {
  std::error_code fault;
  const fs::path folder = fs::read_symlink("/proc/self/exe", fault).parent_path();
  for (const fs::path& place : {folder, folder / ".." / "libexec" / "fathom"}) {
    const fs::path file = place / adapter.program;
    if (!fault && is_ready(adapter, file)) return file.string();
  }
  return "";
}

std::string how_adapters_come() {
  return "what is not built comes with its first use, ./fathom certify --adapter NAME in the source tree: the adapters "
         "of C and C++ "
         "libraries "
         "are compiled with Debian's packages, the others' engines are installed by npm";
}

std::string adapter_command(const std::string& words) {
  const std::string name = words.substr(0, words.find(','));
  const Adapter* const adapter = adapter_named(words);
  if (!adapter) {
    std::vector<std::string> names;
    for (const Adapter& a : adapters()) names.push_back(a.name);
    throw InputError("--adapter", 0,
                     fmt::format("{} is unknown (expected {})", kernels::shown(name), fmt::join(names, ", ")));
  }
  const std::string program = program_of(*adapter);
  if (program.empty())
    throw InputError(
        "--adapter", 0,
        fmt::format("{} is not beside this program: it is {}", adapter->program,
                    is_script(*adapter)
                        ? "installed with its packages by node 18 or later and npm, as verify/subjects/web says"
                        : "built where the library's Debian package is there"));
  std::string command =
      fmt::format("exec {}{} {}", is_script(*adapter) ? "node " : "", quoted(program), adapter->argument);
  for (std::size_t comma = name.size(); comma < words.size();) {
    const std::size_t next = std::min(words.find(',', comma + 1), words.size());
    command += ' ' + quoted(words.substr(comma + 1, next - comma - 1));
    comma = next;
  }
  return command;
}

}  // namespace fathom::cli
