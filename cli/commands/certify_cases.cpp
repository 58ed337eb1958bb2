// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/certify_cases.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "cli/io/case_input.hpp"
#include "cli/io/case_stream.hpp"
#include "fathom/union.hpp"
#include "kernels/messages.hpp"
#include "verify/harness/piece_pairs.hpp"

namespace fathom::cli {
namespace {

/// What is wrong with the bodies, or "".
std::string wrong_certified(const Case& single) {
  if (std::string wrong = wrong_bodies(single, false, "", true); !wrong.empty()) return wrong;
  for (const auto& [body, name] : {std::pair(&single.a, 'a'), {&single.b, 'b'}}) {
    if (!has_union(single)) break;
    const Pieces pieces = pieces_of(*body);
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (is_flat(hull(pieces[i]))) return fmt::format("{}: piece {} is flat: the pieces of a union need interiors", name, i);
  }
  return "";
}

}  // namespace

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
    else if (const std::string wrong = wrong_certified(item->value()); !wrong.empty()) fault = InputError(name, item->line, wrong).what();
    else if (!ids_.insert(item->id).second)
      fault = InputError(name, item->line, "the id " + kernels::shown(item->id) + " was there before").what();
    if (fault.empty()) {
      Case good = std::get<Case>(std::move(item->outcome));
      if (has_union(good)) unions_.push_back(good);
      return good;
    }
    ++bad_;
    tell_(fault);
  }
  return std::nullopt;
}

bool CertifyCases::asked(const std::string& id) const {
  return ids_.contains(id) || std::ranges::any_of(unions_, [&](const Case& pair) { return harness::is_pair_of(id, pair); });
}

}  // namespace fathom::cli
