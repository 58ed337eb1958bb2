// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/io/file_error.hpp"

#include <system_error>

namespace fathom::golden {

FileError::FileError(const std::string& action, const std::filesystem::path& path, int code)
    : std::runtime_error("cannot " + action + " " + path.string() + ": " + std::generic_category().message(code)) {}

}  // namespace fathom::golden
