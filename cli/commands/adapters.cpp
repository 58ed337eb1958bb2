// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/adapters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "cli/args/shell_words.hpp"
#include "fathom/files.hpp"
#include "kernels/printable.hpp"

namespace fathom::cli {

namespace fs = std::filesystem;

const std::vector<Adapter>& adapters() {
  static const std::vector<Adapter> all = {
      {"libccd-epa", "fathom-subject-libccd", "epa", "libccd: ccdGJKPenetration (GJK, then EPA)"},
      {"libccd-mpr", "fathom-subject-libccd", "mpr", "libccd: ccdMPRPenetration"},
      {"fcl-signed", "fathom-subject-fcl", "signed", "FCL: distance with enable_signed_distance (its own EPA)"},
      {"fcl-collide", "fathom-subject-fcl", "collide", "FCL: collide, solver GST_LIBCCD"},
      {"fcl-indep", "fathom-subject-fcl", "indep", "FCL: collide, solver GST_INDEP"},
      {"bullet-epa", "fathom-subject-bullet", "epa", "Bullet, binary32: btGjkEpaSolver2, margin 0"},
      {"bullet-pair", "fathom-subject-bullet", "pair", "Bullet, binary32: btGjkPairDetector with the shapes' margin"},
      {"bullet64-epa", "fathom-subject-bullet64", "epa", "Bullet, binary64: btGjkEpaSolver2, margin 0"},
      {"bullet64-pair", "fathom-subject-bullet64", "pair", "Bullet, binary64: btGjkPairDetector with the shapes' margin"},
      {"ode-collide", "fathom-subject-ode", "collide", "ODE: dCollide"},
  };
  return all;
}

std::string program_of(const Adapter& adapter) {
  std::error_code fault;
  const fs::path folder = fs::read_symlink("/proc/self/exe", fault).parent_path();
  for (const fs::path& place : {folder, folder / ".." / "libexec" / "fathom"}) {
    const std::string file = (place / adapter.program).string();
    if (!fault && ::access(file.c_str(), X_OK) == 0) return file;
  }
  return "";
}

std::string adapter_command(const std::string& words) {
  const std::string name = words.substr(0, words.find(','));
  const auto adapter = std::ranges::find(adapters(), name, &Adapter::name);
  if (adapter == adapters().end()) {
    std::vector<std::string> names;
    for (const Adapter& a : adapters()) names.push_back(a.name);
    throw InputError("--adapter", 0, fmt::format("{} is unknown (expected {})", kernels::shown(name), fmt::join(names, ", ")));
  }
  const std::string program = program_of(*adapter);
  if (program.empty())
    throw InputError(
        "--adapter", 0,
        fmt::format("{} is not beside this program: it is built where the library's Debian package is there", adapter->program));
  std::string command = "exec " + quoted(program) + ' ' + adapter->argument;
  for (std::size_t comma = name.size(); comma < words.size();) {
    const std::size_t next = std::min(words.find(',', comma + 1), words.size());
    command += ' ' + quoted(words.substr(comma + 1, next - comma - 1));
    comma = next;
  }
  return command;
}

}  // namespace fathom::cli
