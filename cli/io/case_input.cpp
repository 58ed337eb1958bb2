// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/io/case_input.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fathom::cli {
namespace {

int open_pipe(const std::string& path) {
  struct stat status {};
  const bool is_pipe = path != "-" && ::stat(path.c_str(), &status) == 0 && S_ISFIFO(status.st_mode) && files::extension(path) != "json";
  return is_pipe ? ::open(path.c_str(), O_RDONLY | O_CLOEXEC) : -1;
}

}  // namespace

CaseInput::CaseInput(const std::string& path, std::function<bool()> stopped)
    : path_(path), descriptor_(open_pipe(path)), buffer_(std::move(stopped), descriptor_ < 0 ? STDIN_FILENO : descriptor_) {}

CaseInput::~CaseInput() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

files::UnreadCases CaseInput::texts() {
  if (descriptor_ >= 0) return {stream_, path_};
  return files::UnreadCases::open(path_, stream_);
}

}  // namespace fathom::cli
