// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "reference/files/case_json.hpp"
#include "reference/files/file_io.hpp"
#include "verify/harness/shrink/reproducer.hpp"

namespace fathom::harness {
namespace {

void write_whole(const std::string& path, const std::string& text) try {
  files::WholeFile file(path);
  file.write(text);
  file.put_in_place();
} catch (const std::system_error& error) {
  throw InputError(path, 0, "cannot be written: " + error.code().message());
}

void make_folder(const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw InputError(directory, 0, "cannot be made a directory: " + error.message());
}

}  // namespace

std::string write_case(const std::string& directory, const std::string& stem, const Case& pair, const std::string& comment) {
  make_folder(directory);
  const std::string path = (std::filesystem::path(directory) / (stem + ".case.json")).string();
  write_whole(path, files::case_json(pair, comment) + '\n');
  return path;
}

HarnessTemplate read_harness(const std::string& path) {
  HarnessTemplate own{files::read_file(path), std::filesystem::path(path).extension().string()};
  for (const std::string body : {"A", "B"})
    if (own.text.find("@" + body + "@") == own.text.npos && own.text.find("@" + body + "_JSON@") == own.text.npos)
      throw InputError(path, 0, "expected @" + body + "@ or @" + body + "_JSON@ where the body goes, found neither");
  return own;
}

std::vector<std::string> write_shrunk(const std::string& directory, const Shrunk& shrunk, const SubjectInfo& info,
                                      const std::optional<HarnessTemplate>& own) {
  make_folder(directory);
  const Outcome& outcome = shrunk.outcome;
  std::string stem(name(outcome.verdict));
  if (!outcome.variant.empty()) stem += '~' + outcome.variant;
  const std::string comment = fmt::format("{} of {} {}", stem, info.name, info.version);
  const std::filesystem::path base = std::filesystem::path(directory) / stem;
  const std::pair<std::string, std::string> files[] = {{".cert", shrunk.certificate},
                                                       own ? std::pair(own->ending, filled_harness(own->text, info, shrunk.pair, outcome))
                                                           : std::pair(".cpp", snippet(info, shrunk.pair, outcome))};
  std::vector<std::string> paths = {write_case(directory, stem, shrunk.pair, comment)};
  for (const auto& [ending, text] : files) {
    paths.push_back(base.string() + ending);
    write_whole(paths.back(), text);
  }
  return paths;
}

}  // namespace fathom::harness
