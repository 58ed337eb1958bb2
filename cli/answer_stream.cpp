// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "cli/answer.hpp"
#include "cli/command.hpp"
#include "cli/interrupt.hpp"
#include "cli/json_result.hpp"
#include "cli/output.hpp"
#include "cli/text_result.hpp"
#include "reference/files/cases.hpp"

namespace fathom::cli {
namespace {

class Stream {
 public:
  Stream(const Request& request, const Solve& solve) : request_(request), solve_(solve) {}

  void take(const CaseItem& item) {
    const Working working;
    ++cases_;
    progress_.about(fmt::format("line {}", item.line));
    if (!item.ok()) return report(item, item.error().what(), bad_input);
    try {
      show(answer_to(item.value(), request_, solve_, progress_));
    } catch (const Interrupted&) {
      throw;
    } catch (const OutputError&) {
      throw;
    } catch (const std::exception& error) {
      report(item, fault_text(error), internal_error);
    }
  }

  ExitCode finish() {
    if (failed_ > 0 && request_.json) talk(fmt::format("errors: {} of {} lines", failed_, cases_));
    if (hulls_ > 0) talk(fmt::format("{} of {} cases had points that are not extreme; convex hulls were taken", hulls_, cases_));
    return code_;
  }

 private:
  void show(const Answer& answer) {
    if (hull_note(answer, request_)) ++hulls_;
    print(request_.json ? json_result(answer, request_) : text_line(answer, request_));
  }

  void report(const CaseItem& item, const std::string& sentence, ExitCode code) {
    ++failed_;
    code_ = std::max(code_, code);
    progress_.clear();
    request_.json ? print(json_error(item.id, item.line, sentence)) : talk(sentence);
  }

  const Request& request_;
  const Solve& solve_;
  Progress progress_;
  std::size_t cases_ = 0, failed_ = 0, hulls_ = 0;
  ExitCode code_ = fine;
};

}  // namespace

ExitCode answer_stream(const Request& request, const Solve& solve) {
  std::ios::sync_with_stdio(false);  // whole blocks at a time; a pipe still yields each line as it comes
  CaseStream cases = CaseStream::open(request.inputs[0], std::cin);
  Stream stream(request, solve);
  while (const std::optional<CaseItem> item = cases.next()) {
    stream.take(*item);
    if (interrupt_requested()) throw Interrupted();
  }
  return stream.finish();
}

}  // namespace fathom::cli
