// SPDX-License-Identifier: GPL-3.0-or-later
// Files for certificates, pictures and reports, and folders of them; and the limits of the checkers
// on certificates.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "reference/files/file_io.hpp"
#include "verify/check/limits.hpp"

namespace fathom::cli {

/// A file for a certificate, a picture or a report, which appears with all of its content or not at
/// all. Opened before solving, so that an unwritable path fails early.
class CertificateFile {
 public:
  /// `what` is for messages. Throws InputError if nothing can be written there.
  explicit CertificateFile(const std::string& path, const std::string& what = "certificate");

  /// Writes the content, once. Throws OutputError.
  void write(std::string_view text);

 private:
  std::string what_;
  files::WholeFile file_;
};

/// Returns the file at `path`, opened; null if the path is empty.
std::unique_ptr<CertificateFile> wanted_file(const std::string& path, const std::string& what);

/// A folder for the certificates, or the pictures, of a stream; made if it is missing.
class CertificateFolder {
 public:
  /// `what` names the files in messages, `ending` is that of their names. Throws InputError if the
  /// path is not a folder and cannot be made.
  explicit CertificateFolder(std::string path, std::string what = "certificate", std::string ending = ".cert");

  /// Returns the path for the file of a case. Throws InputError if the id occurred before.
  std::string file(const std::string& id);

 private:
  std::string path_, what_, ending_;
  std::set<std::string> names_;
};

// Refuses to write a certificate that exceeds the checkers' limits: an error, and no file.
// [verify/check/FORMAT.md, section 8]

/// Throws OutputError, which names the limit and what helps, if the certificate of this case passes
/// a limit of all checkers.
void require_readable(const std::string& id, std::string_view certificate, const fathom_check::Limits& limits = {});

}  // namespace fathom::cli
