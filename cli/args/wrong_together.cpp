// SPDX-License-Identifier: GPL-3.0-or-later
// Checks whether options, inputs and files of a command go together. Each function returns a
// sentence, or "".

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/args/arguments.hpp"
#include "cli/args/values.hpp"
#include "fathom/files.hpp"
#include "kernels/messages.hpp"
#include "reference/files/file_io.hpp"
#include "reference/files/piece_files.hpp"
#include "reference/files/robot.hpp"
#include "reference/files/shape_names.hpp"
#include "verify/harness/variants.hpp"

namespace fathom::cli {
namespace {

std::string wrong_cases(const Given& given) {
  const auto wanted =
      std::ranges::count_if(std::array{"--family", "--catalogue", "--small-world", "--list", "--from", "--from-fcl"},
                            [&](const char* option) { return given.has(option); });
  if (wanted != 1)
    return fmt::format(
        "cases expects one of --family, --catalogue, --small-world, --list, --from and --from-fcl, found {}",
        wanted == 0 ? "none" : "several");
  for (const char* option : {"--seed", "--size"})
    if (!given.has("--family") && given.has(option)) return fmt::format("{} goes with --family", option);
  if (given.has("--count") && !given.has("--family") && !given.has("--small-world"))
    return "--count goes with --family and --small-world";
  const bool of_many =
      given.has("--catalogue") || given.has("--list") || given.words("--family") == std::vector<std::string>{"all"};
  if (given.flag("--plane") && (given.has("--catalogue") || given.flag("--shapes") || given.flag("--unions")))
    return "--plane goes with --list and --family all, and with no other kind of bodies";
  for (const char* option : {"--shapes", "--unions", "--plane"})
    if (given.flag(option) && !of_many)
      return fmt::format("{} goes with --list{} and --family all", option,
                         std::string_view(option) == "--plane" ? "" : ", --catalogue");
  if (given.flag("--shapes") && given.flag("--unions"))
    return "--shapes and --unions are two kinds of bodies: ask for one after the other";
  for (const char* option : {"--pose-a", "--pose-b", "--exact-decimals"})
    if (!given.has("--from") && given.has(option)) return fmt::format("{} goes with --from", option);
  const std::size_t inputs = given.inputs().size();
  if (inputs == (given.has("--from") ? 2 : 0)) return "";
  return fmt::format("cases expects two meshes after --from and no input otherwise, found {} argument{}", inputs,
                     inputs == 1 ? "" : "s");
}

std::string wrong_variants(const std::string& list) {
  if (list.empty() || list == "all") return "";
  for (const std::string& word : words_of(list))
    if (std::ranges::find(harness::variant_names, word) == std::end(harness::variant_names))
      return fmt::format("--metamorphic: {} is unknown (expected {}, with commas between them)", kernels::shown(word),
                         fmt::join(harness::variant_names, ", "));
  return "";
}

std::string wrong_certify(const Given& given) {
  const std::vector<std::string> inputs = given.inputs();
  const auto subjects = std::ranges::count_if(std::array{"--subject", "--adapter", "--replay"},
                                              [&](const char* option) { return given.has(option); });
  const bool worst = given.flag("--worst"), replays = given.has("--replay");
  const bool alone = subjects == 0 && inputs.empty() && !worst;
  if (given.flag("--list-adapters"))
    return alone ? "" : "--list-adapters only prints a list, and takes no subject and no cases";
  if (given.has("--claims")) return alone ? "" : "--claims judges a file, and takes no subject and no cases";
  if (subjects != 1)
    return fmt::format("certify expects one of --subject, --adapter and --replay, found {} of them", subjects);
  if (worst && !inputs.empty()) return "--worst has cases of its own, and takes no stream of others";
  if (!worst && inputs.size() != 1)
    return fmt::format(
        "certify expects one stream of cases (a JSON Lines file, or - for standard input), found {} argument{}",
        inputs.size(), inputs.size() == 1 ? "" : "s");
  const bool resumes = given.flag("--resume"), overwrites = given.flag("--overwrite");
  if (resumes && !given.has("--report")) return "--resume goes on with a report, and needs --report";
  if (overwrites && !given.has("--report")) return "--overwrite replaces a report, and needs --report";
  if (overwrites && resumes) return "--resume goes on with the report that --overwrite replaces: one of them";
  if (given.has("--harness") && !given.has("--shrink"))
    return "--harness is filled with what --shrink finds, and needs --shrink";
  for (const char* option : {"--print-input", "--write-requests"})
    if (replays && given.has(option))
      return fmt::format("{} shows what a subject reads, and a replay reads nothing", option);
  if (given.text("--replay") == "-" && !worst && inputs[0] == "-")
    return "--replay - and the cases cannot both come from standard input";
  if (given.text("--report") == "-") return "--report writes a file; --json writes to standard output";
  for (const char* option : {"--metamorphic", "--shrink"})
    if (replays && given.has(option))
      return fmt::format("{} puts new cases to a subject, and a replay answers none", option);
  return wrong_variants(given.text("--metamorphic"));
}

std::string wrong_robots(const Given& given) {
  const std::vector<std::string> inputs = given.inputs();
  if (given.command == "robot") {
    if (given.flag("--pieces") && given.flag("--solid"))
      return "--solid cuts meshes, and --pieces takes groups as they are: choose one";
    return inputs.size() == 1 ? ""
                              : fmt::format("robot expects one URDF file, found {} argument{}", inputs.size(),
                                            inputs.size() == 1 ? "" : "s");
  }
  for (const char* option : {"--joints", "--package-path"})
    if (given.has(option) && std::ranges::none_of(inputs, files::is_robot_text))
      return fmt::format("{} is about links of robots, FILE.urdf#LINK, found none", option);
  return "";
}

std::string wrong_inputs(const Given& given) {
  if (const std::string fault = wrong_robots(given); !fault.empty()) return fault;
  if (given.command == "cases") return wrong_cases(given);
  if (given.has("--sweep")) return "";
  if (given.command == "certify") return wrong_certify(given);
  const std::vector<std::string> inputs = given.inputs();
  const std::string found = fmt::format("found {} argument{}", inputs.size(), inputs.size() == 1 ? "" : "s");
  if (given.command == "certify diff")
    return inputs.size() == 2 ? "" : "certify diff expects two reports, the old and the new one, " + found;
  if (given.command == "width")
    return inputs.size() == 1
               ? ""
               : "width expects one mesh, or one stream of cases (a .jsonl file, or - for standard input), " + found;
  if (given.command == "robot") return "";
  if (given.command == "solid") return inputs.size() == 1 ? "" : "solid expects one mesh, " + found;
  const std::string expected =
      given.command + " expects two meshes, or one stream of cases (a JSON Lines file, or - for standard input), ";
  if (inputs.empty()) return expected + found;
  if (inputs.size() == 1 && is_mesh_name(inputs[0]))
    return expected + "found the single mesh " + kernels::shown(inputs[0]);
  if (inputs.size() == 1 && files::is_shape_text(inputs[0]))
    return expected + "found the single shape " + kernels::shown(inputs[0]);
  if (inputs.size() == 1 && files::is_robot_text(inputs[0]))
    return expected + "found the single link " + kernels::shown(inputs[0]);
  if (inputs.size() == 2 && (inputs[0] == "-" || inputs[1] == "-")) return expected + "found - beside another input";
  return "";
}

/// Returns the first of the options that was given, or "".
std::string first_of(const Given& given, std::initializer_list<const char*> options) {
  const auto found = std::ranges::find_if(options, [&](const char* option) { return given.has(option); });
  return found == options.end() ? "" : *found;
}

std::string wrong_unions(const Given& given) {
  if (given.command == "robot") return "";
  const std::string asked = given.flag("--solid") ? "--solid" : "--pieces";
  const std::string other = first_of(given, {"--method", "--closest-lines", "--seed", "--bits", "--optima", "--along",
                                             "--steps", "--times", "--csv", "--case", "--threads"});
  if (!other.empty()) return asked + " is about unions, and cannot be combined with " + other;
  if (asked == "--solid" && given.flag("--pieces"))
    return "--solid cuts meshes, and --pieces takes groups as they are: choose one";
  if (given.inputs().size() == 2) return "";
  return asked == "--solid" ? "--solid expects two closed meshes, or shapes, found one input"
                            : "--pieces expects two bodies: OBJ files, folders of meshes, meshes or shapes, found one "
                              "input";
}

std::string wrong_along(const Given& given) {
  if (!given.has("--along")) {
    const std::string other = first_of(given, {"--steps", "--csv"});
    return other.empty() ? "" : other + " goes with --along X,Y,Z";
  }
  const std::string other =
      first_of(given, {"--optima", "--digits", "--certificate", "--embed-certificate", "--exact", "--counters",
                       "--threads", "--patch", "--patch-slack", "--twist", "--twist-b"});
  if (!other.empty()) return "--along answers with a curve of signed depths, and cannot be combined with " + other;
  if (given.text("--method") == "shallow")
    return "--along answers for bodies that are apart too, and cannot be combined with --method shallow";
  return "";
}

std::string wrong_sweep(const Given& given) {
  if (!given.has("--sweep")) {
    const std::string other = first_of(given, {"--sizes", "--closest-lines", "--times", "--svg", "--seed"});
    return other.empty() ? "" : other + " goes with --sweep FAMILY";
  }
  if (const std::vector<std::string> inputs = given.inputs(); !inputs.empty())
    return "--sweep makes its bodies itself, found " + kernels::shown(inputs[0]);
  const std::string other = first_of(given, {"--json", "--html", "--case", "--all", "--pose-a", "--pose-b",
                                             "--require-convex", "--exact-decimals", "--threads"});
  return other.empty() ? "" : "--sweep answers as a table, with --csv and --svg, and cannot be combined with " + other;
}

/// Checks the options of curves and charts.
std::string wrong_picture(const Given& given) {
  if (given.text("--svg") == "-") return "--svg writes a file, found - for standard output";
  if (given.command == "depth" && !given.has("--along") && given.has("--patch-slack") && !given.flag("--patch"))
    return "--patch-slack goes with --patch";
  if (given.command == "solid" && given.has("--skip-flat") && !given.has("--judge"))
    return "--skip-flat goes with --judge";
  if (given.command != "solid" && given.has("--skip-flat") && !given.flag("--pieces"))
    return "--skip-flat goes with --pieces";
  if (given.flag("--pieces") || given.flag("--solid")) return wrong_unions(given);
  if (given.command == "depth") return wrong_along(given);
  return given.command == "study" ? wrong_sweep(given) : "";
}

std::string wrong_page(const Given& given) {
  const bool writes_page = given.command == "study" || given.command == "certify diff";
  if (writes_page && given.text("--html") == "-")
    return given.command == "study" ? "--html writes a file; standard output has the answers"
                                    : "--html writes a file, found - for standard output";
  if (given.command == "solid" && given.text("--output") == "-")
    return "-o writes a file; standard output has the answer";
  if (given.command != "explain") return "";
  if (!given.has("--output")) return "explain writes a page: expected -o FILE, with the name of an HTML file";
  return given.text("--output") == "-" ? "-o writes a file, found - for standard output" : "";
}

std::string wrong_ray(const Given& given) {
  if (given.flag("--growth")) {
    const std::string other = first_of(given, {"--direction", "--digits"});
    return other.empty() ? "" : "--growth answers with a factor, and cannot be combined with " + other;
  }
  const std::string other = first_of(given, {"--center-a", "--center-b"});
  if (!other.empty()) return other + " goes with --growth";
  return given.has("--direction") ? "" : "ray expects --direction X,Y,Z: where A is to move; or --growth";
}

std::string wrong_impact(const Given& given) {
  const std::string pose = first_of(given, {"--from", "--to", "--b-from", "--b-to"});
  if (given.inputs().size() == 1)
    return pose.empty() ? "" : pose + " moves bodies, found a stream of cases, which have motions of their own";
  if (pose.empty()) return "impact expects --from POSE and --to POSE: how A moves; or --b-from and --b-to";
  for (const auto& [from, to] : {std::pair("--from", "--to"), std::pair("--b-from", "--b-to")})
    if (given.has(to) && !given.has(from)) return fmt::format("{} expects {} POSE: where the motion begins", to, from);
  return "";
}

/// Checks approx, ray, metric, and width with --delta. `asks_exact`: an option for exact answers
/// was given.
std::string wrong_approximation(const Given& given, bool asks_exact) {
  if (given.command == "ray") return wrong_ray(given);
  if (given.command == "impact") return wrong_impact(given);
  if (given.command == "metric" && !given.has("--ball")) return "metric expects --ball Q: a mesh, the unit ball";
  if (given.command != "width" || !given.has("--delta")) return "";
  if (asks_exact)
    return "--delta asks for an approximation, and cannot be combined with --method, --closest-lines or a certificate";
  if (given.flag("--counters"))
    return "--delta asks for an approximation, which has no counters: it cannot be combined with --counters";
  if (given.has("--bits"))
    return "--delta asks for an approximation by rays, and cannot be combined with --bits, which is about bounds";
  return "";
}

/// Checks the forms of an answer.
std::string wrong_forms(const Given& given) {
  if (given.flag("--exact") && given.flag("--json"))
    return "--exact is about text: JSON has every number exactly, and rounded beside it";
  if (given.flag("--csv") && given.flag("--json")) return "--csv and --json are two forms of one answer: choose one";
  if (given.flag("--csv") && given.flag("--all"))
    return "--all lists coincidences, and cannot be combined with --csv, which counts them";
  return "";
}

/// Checks the methods of depth and width, and their certificates.
std::string wrong_proof(const Given& given, const std::string& method) {
  if (given.command != "depth" && given.command != "width") return "";
  if (given.has("--closest-lines") && method != "auto" && method != "exact")
    return "--closest-lines chooses the engine of --method exact, and cannot be combined with --method " + method;
  if (given.flag("--embed-certificate") && !given.flag("--json"))
    return "--embed-certificate adds a field to JSON results, and needs --json";
  if (given.text("--certificate") == "-")
    return "--certificate writes files; --json --embed-certificate writes to standard output";
  return "";
}

// ---- files that would destroy each other, found before any is opened ----

namespace fs = std::filesystem;

/// An existing file, identified by its device and inode; or the path of a file to be made.
class FilePlace {
 public:
  explicit FilePlace(const std::string& path) {
    struct stat found {};
    const bool there = ::stat(path.c_str(), &found) == 0;
    if (there) take(found);
    std::error_code fault;
    path_ = fs::weakly_canonical(path, fault);
    if (fault) path_ = fs::absolute(path, fault).lexically_normal();
    if (!path_.has_filename()) path_ = path_.parent_path();  // "folder/"
  }
  /// The file of an open stream.
  explicit FilePlace(int descriptor) {
    struct stat found {};
    if (::fstat(descriptor, &found) == 0) take(found);
    else special_ = true;
  }

  /// Returns whether both are the same file. Devices and pipes never are: output to them destroys
  /// nothing.
  [[nodiscard]] bool is(const FilePlace& other) const {
    if (special_ || other.special_) return false;
    return id_ || other.id_ ? id_ == other.id_ : path_ == other.path_;
  }
  /// Returns whether it exists and is a regular file.
  [[nodiscard]] bool is_file() const { return regular_; }
  /// Returns whether it lies in that folder itself.
  [[nodiscard]] bool is_in(const FilePlace& folder) const {
    return !path_.empty() && path_.parent_path() == folder.path_;
  }
  /// Returns whether its name is like those that commands choose for files in folders.
  [[nodiscard]] bool has_chosen_name() const {
    const std::string ending = path_.extension().string();
    return ending == ".cert" || ending == ".svg" || ending == ".cpp" ||
           path_.filename().string().ends_with(".case.json");
  }

 private:
  void take(const struct stat& found) {
    special_ = !S_ISREG(found.st_mode) && !S_ISDIR(found.st_mode);
    regular_ = S_ISREG(found.st_mode);
    id_.emplace(found.st_dev, found.st_ino);
  }

  std::optional<std::pair<dev_t, ino_t>> id_;
  fs::path path_;
  bool special_ = false, regular_ = false;
};

/// A file named by an option or by a positional word.
struct NamedFile {
  std::string option, value;  // option is empty for a positional word
  FilePlace place;
  FileUse use;

  [[nodiscard]] bool is_read() const { return use == FileUse::read || use == FileUse::read_list; }
};

/// Returns the files of a folder of pieces, which are inputs too.
std::vector<std::string> files_in(const std::string& folder) {
  try {
    return files::is_folder(folder) ? files::piece_files(folder) : std::vector<std::string>();
  } catch (const InputError&) {  // the command that reads the folder reports it
    return {};
  }
}

bool is_motion(const std::string& name) {
  return name == "--from" || name == "--to" || name == "--b-from" || name == "--b-to";
}

std::vector<NamedFile> files_of(const Given& given) {
  std::vector<NamedFile> found;
  for (const GivenOption& option : given.options) {
    const bool is_input = option.option->is_input();
    if (!is_input && option.option->use == FileUse::none) continue;
    const FileUse use = is_input ? FileUse::read : option.option->use;
    const std::string name = is_input ? "" : option.name;
    for (std::string value : option.values) {
      if (is_input) value = files::is_robot_text(value) ? files::file_of_robot(value) : value;
      if (name.starts_with("--pose") || is_motion(name)) {
        if (!value.starts_with('@')) continue;
        value.erase(0, 1);
      }
      if (value == "-" && use == FileUse::read) found.push_back({name, "standard input", FilePlace(STDIN_FILENO), use});
      else found.push_back({name, value, FilePlace(is_input ? files::mesh_path(value).file : value), use});
      if (use != FileUse::read) continue;
      for (const std::string& file : files_in(value)) found.push_back({name, file, FilePlace(file), use});
    }
  }
  found.push_back({"standard output", "standard output", FilePlace(STDOUT_FILENO), FileUse::written});
  return found;
}

/// Returns whether writing `writes` would destroy `other`.
bool destroys(const NamedFile& writes, const NamedFile& other, bool stream) {
  if (writes.use == FileUse::written_list && other.use == FileUse::read_list) return false;
  const bool folder =
      writes.use == FileUse::folder || (writes.use == FileUse::placed && stream && !writes.place.is_file());
  if (folder && other.is_read() && other.place.is_in(writes.place) && other.place.has_chosen_name()) return true;
  return writes.place.is(other.place) && !(folder && other.use == FileUse::placed);
}

/// Returns whether it would replace a file whose name is that of an input.
bool replaces_a_body(const NamedFile& writes) {
  const bool replaces = writes.use == FileUse::written || writes.use == FileUse::placed;
  return replaces && writes.place.is_file() && (is_mesh_name(writes.value) || is_cases_name(writes.value));
}

}  // namespace

std::string wrong_together(const Given& given) {
  const std::size_t inputs = given.inputs().size();
  const bool stream = inputs == 1 && !given.has("--case");  // width has one input in both cases
  const std::string method = given.command == "certify" ? "auto" : given.value("--method").value_or("auto");
  const bool asks_exact = method != "auto" || given.has("--closest-lines") || given.has("--certificate") ||
                          given.flag("--embed-certificate");
  if (std::string fault = wrong_inputs(given); !fault.empty()) return fault;
  if (std::string fault = wrong_picture(given); !fault.empty()) return fault;
  if (std::string fault = wrong_files(given, stream); !fault.empty()) return fault;
  if (given.has("--case") && inputs == 2) return "--case chooses a case of a stream, found two bodies";
  if (std::string fault = wrong_proof(given, method); !fault.empty()) return fault;
  if (std::string fault = wrong_page(given); !fault.empty()) return fault;
  if (std::string fault = wrong_approximation(given, asks_exact); !fault.empty()) return fault;
  return wrong_forms(given);
}

std::string wrong_files(const Given& given, bool stream) {
  const std::vector<NamedFile> files = files_of(given);
  for (std::size_t i = 0; i < files.size(); ++i) {
    const NamedFile& writes = files[i];
    if (writes.is_read()) continue;
    if (replaces_a_body(writes))
      return fmt::format(
          "{} would write over {}, which is named like a mesh or like cases: name another file, or remove it first",
          writes.option, kernels::shown(writes.value));
    for (std::size_t k = 0; k < files.size(); ++k) {
      const NamedFile& other = files[k];
      if (k == i || (!other.is_read() && k < i) || !destroys(writes, other, stream)) continue;
      if (!other.is_read())
        return fmt::format("{} and {} write to one place, {}: each needs its own", writes.option, other.option,
                           kernels::shown(writes.value));
      return fmt::format("{} would write over {}, which is read", writes.option, kernels::shown(other.value));
    }
  }
  return "";
}

}  // namespace fathom::cli
