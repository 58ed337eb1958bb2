// SPDX-License-Identifier: GPL-3.0-or-later
// Writes files that appear with all of their content or not at all: under a hidden name in the same folder, and then renamed, so that a
// file of the name that was there is replaced at once.
#pragma once

#include <string>
#include <string_view>

namespace fathom::files {

/// A file that is being written. A device or a pipe is written to as it is; a symbolic link stays one.
class WholeFile {
 public:
  /// Throws std::system_error if nothing can be written there.
  explicit WholeFile(const std::string& path);
  /// Leaves all as it was, unless the file was put into its place.
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  /// Appends. Throws std::system_error.
  void write(std::string_view bytes);
  /// Gives the file its name: once, in the end. Throws std::system_error.
  void put_in_place();

  /// Where it is, behind links.
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_, hidden_;  // no hidden_ of devices and pipes
  int descriptor_ = -1;
};

/// Writes all bytes, however many calls that takes. Returns the system's error code, or 0.
int write_all(int descriptor, std::string_view bytes);

}  // namespace fathom::files
