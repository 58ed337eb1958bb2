// SPDX-License-Identifier: GPL-3.0-or-later
// Where certificates go: a file, or for a stream a folder with one file per case.                                [docs/certificates.md]
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace fathom::cli {

/// A file, of a certificate or a report, that appears with all of its content or not at all. Made before the content is known, so that a hopeless path is found out early.
class CertificateFile {
 public:
  /// `what` is for messages. Throws InputError when nothing can be written there.
  explicit CertificateFile(std::string path, std::string what = "certificate");
  ~CertificateFile();
  CertificateFile(const CertificateFile&) = delete;
  CertificateFile& operator=(const CertificateFile&) = delete;

  /// Throws OutputError.
  void write(std::string_view text);

 private:
  [[noreturn]] void fail();

  std::string what_, path_, temporary_;  // no temporary: what exists is no regular file, and is written to as it is
  int descriptor_ = -1;
};

/// A folder for the certificates of a stream; made if it is missing.
class CertificateFolder {
 public:
  /// Throws InputError when it is no folder and cannot become one.
  explicit CertificateFolder(std::string path);

  /// The path for the certificate of a case. Throws InputError when the id was asked for before.
  std::string file(const std::string& id);

 private:
  std::string path_;
  std::set<std::string> names_;
};

/// The id with ".cert". Whatever is not a letter, a digit or one of . _ - becomes %XX, and so does a leading dot; of a
/// name longer than a file's may be, the beginning, '~' and the SHA-256 of the id. Different ids make different names.
std::string certificate_file_name(const std::string& id);

}  // namespace fathom::cli
