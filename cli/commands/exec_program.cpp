// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <climits>
#include <cstdlib>

#include "cli/io/process.hpp"

namespace fathom::cli {
namespace {

/// Returns the folder of this program, with a slash, or "" if it is unknown.
std::string own_folder() {
  std::string path(PATH_MAX, '\0');
  const ssize_t length = readlink("/proc/self/exe", path.data(), path.size());
  path.resize(length > 0 ? static_cast<std::size_t>(length) : 0);
  return path.substr(0, path.rfind('/') + 1);
}

}  // namespace

void become(const std::string& program, std::vector<std::string> words) {
  words.insert(words.begin(), program);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const std::string folder = own_folder();
  if (!folder.empty()) execv((folder + program).c_str(), arguments.data());
  execvp(program.c_str(), arguments.data());
}

void look_here_first() {
  const std::string folder = own_folder();
  const char* const path = std::getenv("PATH");
  if (!folder.empty()) setenv("PATH", (folder + (path ? ":" + std::string(path) : "")).c_str(), 1);
}

}  // namespace fathom::cli
