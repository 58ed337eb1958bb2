// SPDX-License-Identifier: GPL-3.0-or-later
// The sentence of an InputError.
#include <utility>

#include "fathom/files.hpp"

namespace fathom {
namespace {

std::string sentence(const std::string& file, std::size_t line, const std::string& message) {
  return file + ":" + (line ? std::to_string(line) + ":" : "") + " " + message;
}

}  // namespace

InputError::InputError(std::string file, std::size_t line, const std::string& message)
    : std::runtime_error(sentence(file, line, message)), file_(std::move(file)), line_(line) {}

}  // namespace fathom
