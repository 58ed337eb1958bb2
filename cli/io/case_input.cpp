// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/io/case_input.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include "fathom/files.hpp"

namespace fathom::cli {
namespace {

constexpr int between_looks = 100;  // milliseconds

int open_pipe(const std::string& path) {
  struct stat status {};
  const bool is_pipe =
      path != "-" && ::stat(path.c_str(), &status) == 0 && S_ISFIFO(status.st_mode) && files::extension(path) != "json";
  return is_pipe ? ::open(path.c_str(), O_RDONLY | O_CLOEXEC) : -1;
}

}  // namespace

InterruptibleInput::int_type InterruptibleInput::underflow() {
  while (true) {
    if (stopped_()) throw Interrupted();
    pollfd input{descriptor_, POLLIN, 0};
    if (const int ready = ::poll(&input, 1, between_looks); ready == 0 || (ready < 0 && errno == EINTR)) continue;
    const ssize_t got = ::read(descriptor_, buffer_.data(), buffer_.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw InputError("<stdin>", 0, std::string("cannot be read: ") + std::strerror(errno));
    if (got == 0) return traits_type::eof();
    setg(buffer_.data(), buffer_.data(), buffer_.data() + got);
    return traits_type::to_int_type(buffer_[0]);
  }
}

CaseInput::CaseInput(const std::string& path, std::function<bool()> stopped)
    : path_(path),
      descriptor_(open_pipe(path)),
      buffer_(std::move(stopped), descriptor_ < 0 ? STDIN_FILENO : descriptor_) {}

CaseInput::~CaseInput() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

files::UnreadCases CaseInput::texts() {
  if (descriptor_ >= 0) return {stream_, path_};
  return files::UnreadCases::open(path_, stream_);
}

std::optional<std::size_t> cases_in(const std::string& path) {
  std::error_code fault;
  if (path == "-" || !std::filesystem::is_regular_file(path, fault)) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  std::array<char, 1 << 16> piece;
  std::size_t cases = 0;
  char before = '\n';
  while (file.read(piece.data(), piece.size()) || file.gcount() > 0) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(file.gcount()); ++i) {
      if (before == '\n' && piece[i] == '{') ++cases;
      before = piece[i];
    }
  }
  return cases > 0 ? std::optional(cases) : std::nullopt;
}

}  // namespace fathom::cli
