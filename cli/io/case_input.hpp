// SPDX-License-Identifier: GPL-3.0-or-later
// The input of a stream of cases. To wait for a pipe can be stopped.
#pragma once

#include <functional>
#include <istream>
#include <string>

#include "reference/files/cases.hpp"

namespace fathom::cli {

class CaseInput {
 public:
  /// Opens the file, or the pipe, called `path`; "-" is standard input. Throws InputError if it cannot be read. Once `stopped` returns
  /// true, nothing more can be read.
  CaseInput(const std::string& path, std::function<bool()> stopped);
  ~CaseInput();
  CaseInput(const CaseInput&) = delete;
  CaseInput& operator=(const CaseInput&) = delete;

  /// The cases of this input, which must outlive them. Call it once.
  [[nodiscard]] files::UnreadCases texts();

 private:
  std::string path_;
  int descriptor_ = -1;  ///< of a pipe with a name
  InterruptibleInput buffer_;
  std::istream stream_{&buffer_};
};

}  // namespace fathom::cli
