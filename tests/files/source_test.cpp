// SPDX-License-Identifier: GPL-3.0-or-later
// Files are read whole; what may have no end, a pipe or a device, up to a limit.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "fathom/files.hpp"
#include "reference/files/file_io.hpp"

namespace fathom::files {
namespace {

constexpr std::size_t limit = 1000;

std::string complaint_of(const std::string& path) {
  try {
    read_file(path, limit);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// A pipe that holds so many bytes and ends; its name.
class Pipe {
 public:
  explicit Pipe(std::size_t size) {
    if (::pipe(ends_.data()) != 0) throw std::runtime_error("no pipe");
    const std::string bytes(size, 'x');
    const bool written = ::write(ends_[1], bytes.data(), size) == static_cast<ssize_t>(size);
    ::close(ends_[1]);
    if (!written) throw std::runtime_error("a pipe that takes nothing");
  }
  ~Pipe() { ::close(ends_[0]); }
  [[nodiscard]] std::string name() const { return "/proc/self/fd/" + std::to_string(ends_[0]); }

 private:
  std::array<int, 2> ends_{};
};

TEST(ReadFile, PipesAndDevicesHaveALimit) {
  EXPECT_EQ(complaint_of("/dev/zero"),
            "/dev/zero: expected a readable file, found a pipe or device of more than 1000 bytes");
  EXPECT_EQ(complaint_of("/dev/null"), "");
  EXPECT_EQ(complaint_of(Pipe(limit).name()), "");
  const Pipe longer(limit + 1);
  EXPECT_EQ(complaint_of(longer.name()),
            longer.name() + ": expected a readable file, found a pipe or device of more than 1000 bytes");
}

TEST(ReadFile, FilesHaveNone) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("fathom-source-" + std::to_string(::getpid()));
  std::ofstream(path) << std::string(2 * limit, 'x');
  EXPECT_EQ(read_file(path, limit), std::string(2 * limit, 'x'));
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace fathom::files
