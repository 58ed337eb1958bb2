// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mpi/verbs.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <thread>

namespace fathom::cli {

unsigned usual_jobs() {
  const char* const ours = std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  const unsigned processes = ours ? static_cast<unsigned>(std::max(1, std::atoi(ours))) : 1;
  return std::max(1U, std::thread::hardware_concurrency() / processes);
}

std::string packed(const std::vector<std::string>& texts) {
  std::string result;
  for (const std::string& text : texts) result += std::to_string(text.size()) + ' ' + text;
  return result;
}

std::vector<std::string> unpacked(const std::string& text) {
  std::vector<std::string> result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t blank = text.find(' ', at);
    if (blank == std::string::npos) throw std::invalid_argument("no packed text");
    const std::size_t length = std::stoull(text.substr(at, blank - at));
    if (length > text.size() - blank - 1) throw std::invalid_argument("no packed text");
    result.push_back(text.substr(blank + 1, length));
    at = blank + 1 + length;
  }
  return result;
}

}  // namespace fathom::cli
