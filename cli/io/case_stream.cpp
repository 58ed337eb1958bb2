// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/io/case_stream.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <new>
#include <string>

#include "cli/io/interrupt.hpp"
#include "cli/io/output.hpp"
#include "cli/output/hull_note.hpp"

namespace fathom::cli {
namespace {

class Stream {
 public:
  Stream(const std::string& input, const StreamWork& work) : name_(input == "-" ? "<stdin>" : input), work_(work) {}

  /// Reads a case and answers it. Returns false at the end.
  bool take_next(CaseStream& items) {
    std::optional<CaseItem> item;
    try {
      item = items.next();
    } catch (const std::bad_alloc& error) {  // the case does not fit; the next may
      ++cases_;
      const std::size_t line = items.case_line();
      report({line, std::to_string(line), InputError(name_, line, fault_text(error))}, internal_error);
      return true;
    }
    if (item) take(*item);
    return item.has_value();
  }

  ExitCode finish() {
    progress_.clear();
    if (failed_ > 0 && work_.error_line) talk(fmt::format("errors: {} of {} lines", failed_, cases_));
    if (perhaps_inner_ > 0) talk(fmt::format("later cases that may have points which are not extreme: {}", perhaps_inner_));
    return code_;
  }

 private:
  void take(const CaseItem& item) {
    const Working working;
    ++cases_;
    progress_.about(fmt::format("line {}", item.line));
    progress_.report("", -1);
    if (!item.ok()) return report(item, bad_input);
    try {
      tell_of_hull(item);
      work_.answer(item.value(), progress_);
    } catch (const Interrupted&) {
      throw;
    } catch (const OutputError&) {
      throw;
    } catch (const InputError& error) {
      report({item.line, item.id, error}, bad_input);
    } catch (const std::exception& error) {
      report({item.line, item.id, InputError(name_, item.line, fault_text(error))}, internal_error);
    }
  }

  // To count such cases exactly would take a hull each: after the first they are counted by what is seen without one.
  void tell_of_hull(const CaseItem& item) {
    if (hull_told_) {
      if (may_have_inner_points(item.value(), work_.one_body)) ++perhaps_inner_;
      return;
    }
    const std::optional<std::string> note = hull_note(item.value(), work_.one_body);
    if (!note) return;
    hull_told_ = true;
    progress_.clear();
    talk(fmt::format("{}:{}: {}; later cases are counted", name_, item.line, *note));
  }

  void report(const CaseItem& bad, ExitCode code) {
    const std::string sentence = bad.error().what();
    ++failed_;
    code_ = std::max(code_, code);
    progress_.clear();
    work_.error_line ? print(work_.error_line(bad, sentence)) : talk(sentence);
  }

  std::string name_;  // of the input, for messages
  const StreamWork& work_;
  Progress progress_;
  std::size_t cases_ = 0, failed_ = 0, perhaps_inner_ = 0;
  bool hull_told_ = false;
  ExitCode code_ = fine;
};

}  // namespace

ExitCode for_each_case(const std::string& input, const StreamWork& work) {
  std::ios::sync_with_stdio(false);  // whole blocks at a time; a pipe still yields each line as it comes
  CaseStream items = CaseStream::open(input, std::cin);
  if (!work.header.empty()) print(work.header);
  Stream stream(input, work);
  while (stream.take_next(items))
    if (interrupt_requested()) throw Interrupted();
  return stream.finish();
}

}  // namespace fathom::cli
