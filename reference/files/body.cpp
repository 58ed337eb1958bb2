// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "fathom/files.hpp"

namespace fathom::files {
namespace {

std::string sentence(const std::string& file, std::size_t line, const std::string& message) {
  return file + ":" + (line ? std::to_string(line) + ":" : "") + " " + message;
}

}  // namespace

}  // namespace fathom::files

namespace fathom {

InputError::InputError(std::string file, std::size_t line, const std::string& message)
    : std::runtime_error(files::sentence(file, line, message)), file_(std::move(file)), line_(line) {}

}  // namespace fathom
