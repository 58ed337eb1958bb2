// SPDX-License-Identifier: GPL-3.0-or-later
// Reads files and lines; writes files that appear with all of their content or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <istream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace fathom::files {

/// The longest line of a stream, and the longest case, which may span many lines, in bytes: endless
/// input must not use up the memory.
inline constexpr std::size_t longest_line = std::size_t{256} << 20;

enum class LineRead { whole, too_long, no_memory, none };

/// Replaces `line` by the next line of `input`, without its line feed. Returns `none` at the end of
/// the input. Skips a line that is longer than the limit, or than the memory allows, and leaves
/// `line` empty; after sixteen times the limit it takes `input` for endless and sets its badbit.
LineRead read_line(std::istream& input, std::string& line);

/// Returns the bytes of the whole file; reads pipes to their end. Throws InputError if it is
/// missing, a directory, unreadable, or a pipe or device with more than `most_of_a_pipe` bytes,
/// which may have no end.
std::string read_file(const std::string& path, std::size_t most_of_a_pipe = std::size_t{1} << 30);

/// Throws InputError if `path` is missing, a directory or unreadable. Does not open it.
void require_readable(const std::string& path);

/// Whether `path` is a folder that is there.
bool is_folder(const std::string& path);

/// Returns the extension of the file's name in lower case and without the dot; empty if there is
/// none.
std::string extension(std::string_view path);

/// The operating system reported an error: full disk, no permission, a file that cannot be read.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
  /// "cannot `action` `path`: " and the system's words for the error `number` (an errno).
  FileError(const std::string& action, const std::filesystem::path& path, int number);

  std::error_code code;  ///< none if the system said nothing
};

/// A file that is being written: under a hidden name in the same folder, and then renamed, so that
/// a file of the name that was there is replaced at once. A device or a pipe is written to as it
/// is; a symbolic link stays one.
class WholeFile {
 public:
  /// Throws FileError, here and below, if nothing can be written there.
  explicit WholeFile(const std::string& path);
  /// The same with a hidden name that others know: throws also if another living process is writing
  /// the file. Replaces links, devices and pipes.
  WholeFile(const std::filesystem::path& path, const std::string& hidden);
  /// Leaves all as it was, unless the file was put into its place.
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  /// Appends.
  void write(std::string_view bytes);
  /// Waits until all bytes are on the disk.
  void sync();
  /// Gives the file its name: once, in the end.
  void put_in_place();

  /// Where it is, behind links.
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  [[noreturn]] void fail(int number) const { throw FileError("write", path_, number); }

  std::string path_, hidden_;  // no hidden_ of devices and pipes
  int descriptor_ = -1;
};

/// Writes all bytes, however many calls that takes. Returns the system's error code, or 0.
int write_all(int descriptor, std::string_view bytes);

}  // namespace fathom::files
