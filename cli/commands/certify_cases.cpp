// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/certify_cases.hpp"

#include <utility>

#include "cli/io/case_stream.hpp"
#include "cli/io/cases_in.hpp"
#include "kernels/printable.hpp"

namespace fathom::cli {
CertifyCases::CertifyCases(const std::string& input, std::function<void(const std::string&)> tell)
    : input_(input), tell_(std::move(tell)), items_(CaseStream::open(input, stdin_)), expected_(cases_in(input)) {
  stdin_.exceptions(std::ios::badbit);
}

std::string CertifyCases::place() const { return (input_ == "-" ? "<stdin>" : input_) + ":" + std::to_string(items_.case_line()); }

std::optional<Case> CertifyCases::next() {
  while (std::optional<CaseItem> item = items_.next()) {
    std::string fault;
    const std::string name = input_ == "-" ? "<stdin>" : input_;
    if (!item->ok()) fault = item->error().what();
    else if (const std::string wrong = wrong_bodies(item->value(), false, "", false); !wrong.empty())
      fault = InputError(name, item->line, wrong).what();
    else if (!ids_.insert(item->id).second)
      fault = InputError(name, item->line, "the id " + kernels::shown(item->id) + " was there before").what();
    if (fault.empty()) return std::get<Case>(std::move(item->outcome));
    ++bad_;
    tell_(fault);
  }
  return std::nullopt;
}

}  // namespace fathom::cli
