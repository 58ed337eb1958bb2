// SPDX-License-Identifier: GPL-3.0-or-later
// Files beside the replies: one of a single case, one for each case of a stream.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "cli/commands/replies.hpp"
#include "cli/io/certificate_file.hpp"

namespace fathom::cli {

/// Where the certificates of a run go, or its pictures: a file, or for a stream a folder.
class FilePlaces {
 public:
  FilePlaces(const Request& request, std::string path, std::string what, const std::string& ending)
      : path_(std::move(path)), what_(std::move(what)) {
    if (!path_.empty() && is_stream(request)) folder_.emplace(path_, what_, ending);
  }

  [[nodiscard]] bool wanted() const { return !path_.empty(); }
  /// Returns the file of a single case; null for a stream, or if nothing is to be written.
  [[nodiscard]] std::unique_ptr<CertificateFile> single() const {
    return path_.empty() || folder_ ? nullptr : std::make_unique<CertificateFile>(path_, what_);
  }
  /// Writes the file of a case of a stream, if it is to be written. Call it in the order of the cases: of two with one id, the first gets
  /// the file.
  void write_to_folder(const std::string& id, const std::string& text) {
    if (folder_) CertificateFile(folder_->file(id), what_).write(text);
  }

 private:
  std::string path_, what_;
  std::optional<CertificateFolder> folder_;
};

}  // namespace fathom::cli
