// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/certify_cases.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "kernels/printable.hpp"

namespace fathom::cli {
namespace {

std::optional<std::size_t> lines_of(const std::string& path) {
  std::error_code fault;
  if (path == "-" || !std::filesystem::is_regular_file(path, fault)) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  std::array<char, 1 << 16> piece;
  std::size_t lines = 0;
  char last = '\n';
  while (file.read(piece.data(), piece.size()) || file.gcount() > 0) {
    const auto size = static_cast<std::size_t>(file.gcount());
    lines += static_cast<std::size_t>(std::count(piece.data(), piece.data() + size, '\n'));
    last = piece[size - 1];
  }
  return lines + (last == '\n' ? 0 : 1);
}

}  // namespace

CertifyCases::CertifyCases(const std::string& input, std::function<void(const std::string&)> tell)
    : input_(input), tell_(std::move(tell)), items_(CaseStream::open(input, stdin_)), expected_(lines_of(input)) {
  stdin_.exceptions(std::ios::badbit);
}

std::string CertifyCases::place() const { return (input_ == "-" ? "<stdin>" : input_) + ":" + std::to_string(items_.case_line()); }

std::optional<Case> CertifyCases::next() {
  while (std::optional<CaseItem> item = items_.next()) {
    std::string fault;
    if (!item->ok()) fault = item->error().what();
    else if (!ids_.insert(item->id).second)
      fault = InputError(input_ == "-" ? "<stdin>" : input_, item->line, "the id " + kernels::shown(item->id) + " was there before").what();
    if (fault.empty()) return std::get<Case>(std::move(item->outcome));
    ++bad_;
    tell_(fault);
  }
  return std::nullopt;
}

}  // namespace fathom::cli
