// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <utility>

#include "kernels/messages.hpp"
#include "reference/files/file_io.hpp"
#include "verify/harness/coordinates.hpp"
#include "verify/harness/examiner.hpp"
#include "verify/harness/seen_case.hpp"

namespace fathom::harness {

Replay Replay::read(const std::string& given) {
  const bool standard = given == "-";
  const std::string path = standard ? "<stdin>" : given;
  const std::string text = standard ? std::string(std::istreambuf_iterator<char>(std::cin), {}) : files::read_file(path);
  Replay replay;
  replay.info_.name = "replay";
  std::size_t number = 0;
  bool any = false;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t newline = std::min(text.find('\n', begin), text.size());
    const std::string_view line = std::string_view(text).substr(begin, newline - begin);
    begin = newline + 1;
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    try {
      if (!any && is_hello(line)) replay.info_ = read_hello(line);
      else replay.take(line, path, number);
    } catch (const ProtocolError& error) {
      throw InputError(path, number, error.what());
    }
    any = true;
  }
  if (replay.answers_.empty() && replay.faults_.empty()) throw InputError(path, 0, "expected replies, found none");
  return replay;
}

void Replay::take(std::string_view line, const std::string& path, std::size_t number) {
  try {
    SubjectAnswer answer = read_reply(line, info_.format);
    std::string id = answer.ticket;
    answers_[std::move(id)].push_back(std::move(answer));
  } catch (const ProtocolError& error) {
    faults_.emplace_back(path, number, error.what());
  }
}

Outcome Replay::ask(const Case& seen, long exponent, std::optional<SubjectAnswer>& answer) const {
  const auto found = answers_.find(seen.id);
  if (found == answers_.end()) throw NoReply("no reply to case " + kernels::shown(seen.id));
  Outcome outcome = outcome_for(seen, exponent);
  outcome.detail = fmt::format("{} replies to one case", found->second.size());  // the verdict stays garbage
  if (found->second.size() > 1) return outcome;
  try {
    demand_sent_as_vertices(seen, found->second[0]);
  } catch (const ProtocolError& error) {
    outcome.detail = error.what();
    return outcome;
  }
  outcome.detail.clear();
  answer = found->second[0];
  return outcome;
}

Outcome Replay::examine(const Case& pair, long exponent, const Judging& judging) const {
  std::string why;
  const std::optional<Case> seen = as_seen(pair, in_unit(info_.format, exponent), info_.shapes, &why);
  if (!seen) return declined(pair, why);
  if (const std::string obstacle = obstacle_to(*seen, info_, exponent); !obstacle.empty()) return declined(*seen, obstacle);
  const auto ask_pair = [&](const Case& one, std::optional<SubjectAnswer>& answer) { return ask(one, exponent, answer); };
  if (is_asked_in_pairs(*seen, info_) && !answers_.contains(seen->id)) return examine_pairs(*seen, exponent, info_, judging, ask_pair);
  std::optional<SubjectAnswer> answer;
  Outcome outcome = ask(*seen, exponent, answer);
  if (answer) judge_answer(outcome, *seen, *answer, info_, judging);
  return outcome;
}

std::vector<std::string> Replay::unasked(const std::function<bool(const std::string&)>& is_asked) const {
  std::vector<std::string> result;
  for (const auto& [id, answers] : answers_)
    if (!is_asked(id)) result.push_back(id);
  return result;
}

}  // namespace fathom::harness
