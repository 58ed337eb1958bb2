// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/io/case_stream.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "cli/io/output.hpp"
#include "cli/io/process.hpp"
#include "cli/io/progress.hpp"
#include "fathom/files.hpp"
#include "kernels/context.hpp"
#include "kernels/filters/support.hpp"
#include "reference/files/cases.hpp"
#include "reference/polytope/convexity.hpp"

namespace fathom::cli {
namespace {

constexpr int between_looks = 100;  // milliseconds between two checks of `stopped`

int open_pipe(const std::string& path) {
  struct stat status {};
  const bool is_pipe =
      path != "-" && ::stat(path.c_str(), &status) == 0 && S_ISFIFO(status.st_mode) && files::extension(path) != "json";
  return is_pipe ? ::open(path.c_str(), O_RDONLY | O_CLOEXEC) : -1;
}

constexpr std::size_t worth_a_thread = 2048;  // points

/// Returns a note on the points of a body; empty if all are extreme.
std::string note_on(char body, const std::vector<Point>& points) {
  const std::optional<std::size_t> inner = polytope::count_inner_points(points);
  if (!inner)
    return fmt::format("{}: it was not tried whether all points are extreme, as their denominators share little", body);
  return *inner > 0 ? fmt::format("{}: {} of {} points are not extreme", body, *inner, points.size()) : "";
}

bool may_have_inner_points(const Case& input, bool one_body) {
  const auto all_extreme = [](const GivenPoints& points) {
    return points.in_binary64() ? kernels::all_seen_extreme(points.binary64())
                                : kernels::all_seen_extreme(points.exact());
  };
  return !all_extreme(input.a.points) || (!one_body && !all_extreme(input.b.points));
}

std::optional<std::string> hull_note(const Case& input, bool one_body) {
  const std::vector<Point>&a = input.a.points, &b = input.b.points;
  std::vector<std::string> notes(2);
  kernels::Context context;
  kernels::run_both(
      !one_body && a.size() + b.size() >= worth_a_thread, context,
      [&](kernels::Context&) { notes[0] = note_on('A', a); },
      [&](kernels::Context&) { notes[1] = one_body ? "" : note_on('B', b); });
  std::erase(notes, "");
  if (notes.empty()) return std::nullopt;
  return fmt::format("{}; the convex hull is taken", fmt::join(notes, "; "));
}

// A case of a stream on its way from its text to its answer, and between processes.

/// Notes on a case that are printed beside its answer. Of each kind, the first note is printed and
/// later ones are counted.
enum class NoteKind { field, pose, sizes, dents };
inline constexpr std::array<std::string_view, 4> later_notes = {
    "fields that look misspelt", "poses that are no rotations", "bodies of very different sizes",
    "meshes that are not their hulls"};
struct StreamNote {
  NoteKind kind;
  std::string text;
};

/// A case of the stream, from its text to its reply.
struct StreamedCase {
  std::size_t number = 0;  ///< the number of cases before it
  files::UnreadCase text;
  std::optional<InterruptGuard> interrupt_guard;
  bool answered = false;

  std::string id;
  CaseReply reply;
  std::optional<InputError> fault;  ///< set if there is no reply
  ExitCode code = fine;
  std::optional<std::string> hull_note;  ///< set if no note on a hull was printed before
  std::vector<StreamNote> notes;
  bool perhaps_inner = false;
};

/// Returns the message of an error without its file and line.
std::string message_of(const InputError& error) {
  const std::string sentence = error.what(), place = InputError(error.file(), error.line(), "").what();
  return sentence.substr(std::min(place.size(), sentence.size()));
}

std::string notes_text(const std::vector<StreamNote>& notes) {
  std::string all;
  for (const StreamNote& note : notes) {
    pack(all, std::to_string(static_cast<unsigned>(note.kind)));
    pack(all, note.text);
  }
  return all;
}

std::vector<StreamNote> notes_of(const std::string& text) {
  const std::vector<std::string> texts = unpacked(text);
  std::vector<StreamNote> notes;
  for (std::size_t i = 0; i + 1 < texts.size(); i += 2)
    notes.push_back({static_cast<NoteKind>(std::stoul(texts[i])), texts[i + 1]});
  return notes;
}

/// Appends the results for the case, packed, to other packed texts.
void pack_answer(std::string& all, const StreamedCase& streamed) {
  const auto optional = [](const std::optional<std::string>& text) { return text ? "+" + *text : ""; };
  std::vector<std::string> texts = {streamed.id, std::to_string(streamed.code), streamed.perhaps_inner ? "+" : "",
                                    optional(streamed.hull_note), notes_text(streamed.notes)};
  if (streamed.fault)
    texts.insert(texts.end(),
                 {streamed.fault->file(), std::to_string(streamed.fault->line()), message_of(*streamed.fault)});
  else texts.push_back(streamed.reply.text);
  pack(all, packed(texts));
}

/// Reads the results that pack_answer wrote.
void take_answer(const std::string& text, StreamedCase& streamed) {
  const std::vector<std::string> texts = unpacked(text);
  streamed.id = texts.at(0);
  streamed.code = static_cast<ExitCode>(std::stoi(texts.at(1)));
  streamed.perhaps_inner = !texts.at(2).empty();
  if (!texts.at(3).empty()) streamed.hull_note = texts[3].substr(1);
  streamed.notes = notes_of(texts.at(4));
  if (texts.size() > 6) streamed.fault = InputError(texts[5], std::stoull(texts.at(6)), texts.at(7));
  else streamed.reply.text = texts.at(5);
  streamed.answered = true;
}

// Longer texts are answered before more cases are read: many of them at once would take much
// memory, and two threads share the work on large bodies.
constexpr std::size_t long_text = std::size_t{1} << 20;

using Block = std::vector<std::shared_ptr<StreamedCase>>;

// A block that is answered by another process ends with this many cases, or with this many bytes.
constexpr std::size_t cases_in_a_block = 64, bytes_of_a_block = std::size_t{1} << 18;

/// Memory for as many answers as there are threads. It is allocated at the beginning, so that a
/// case that does not fit takes none away from others.
class Workspaces {
 public:
  explicit Workspaces(unsigned count) : idle_(count) {}

  /// Calls `use` with memory that no other thread uses meanwhile.
  template <class Use>
  void with_one(Use use) {
    Workspace workspace = take();
    use(workspace);
    const std::lock_guard lock(idle_lock_);
    idle_.push_back(std::move(workspace));  // cannot allocate: there is room for all
  }

 private:
  Workspace take() {
    const std::lock_guard lock(idle_lock_);
    if (idle_.empty()) return {};
    Workspace workspace = std::move(idle_.back());
    idle_.pop_back();
    return workspace;
  }

  std::mutex idle_lock_;
  std::vector<Workspace> idle_;
};

/// Reads the text and answers the case; an error of either becomes the case's fault. Throws
/// Interrupted. Looks for a note on a hull only if none was printed before.
void answer_case(StreamedCase& streamed, const std::string& name, const StreamWork& work, Monitor& monitor,
                 Workspace& workspace, bool hull_told) {
  const std::size_t line = streamed.text.line;
  const auto lose = [&](InputError why, ExitCode code) {
    streamed.fault = std::move(why);
    streamed.code = std::max(streamed.code, code);
  };
  streamed.id = std::to_string(line);
  try {
    const CaseItem item = files::read_case(streamed.text, name);
    if (!work.reads_text) std::string().swap(streamed.text.text);
    streamed.id = item.id;
    if (!item.ok()) return lose(item.error(), bad_input);
    if (const std::string fault =
            wrong_bodies(item.value(), work.one_body, work.refuses_shapes, work.refuses_unions, work.refuses_plane);
        !fault.empty())
      return lose({name, line, fault}, bad_input);
    for (const CaseNote& note : item.notes)
      streamed.notes.push_back({note.kind == CaseNote::field ? NoteKind::field : NoteKind::pose, note.text});
    AskedCase asked(item.value(), work.one_body);
    asked.text = streamed.text.text;
    if (const std::string fault = wrong_meshes(asked.bodies.hull, work.require_convex); !fault.empty())
      return lose({name, line, fault}, bad_input);
    if (std::string dents = shapes::dents_text(asked.bodies.hull); !dents.empty())
      streamed.notes.push_back({NoteKind::dents, std::move(dents)});
    if (std::optional<std::string> note = shapes::sizes_note(asked.bodies.sizes))
      streamed.notes.push_back({NoteKind::sizes, *std::move(note)});
    streamed.perhaps_inner = !has_shape(item.value()) && !files::has_union(item.value()) &&
                             may_have_inner_points(item.value(), work.one_body);
    if (streamed.perhaps_inner && !hull_told) streamed.hull_note = hull_note(item.value(), work.one_body);
    streamed.reply = work.answer(asked, monitor, workspace);
    std::string().swap(streamed.text.text);
  } catch (const Interrupted&) {
    throw;
  } catch (const InputError& error) {
    lose(error, bad_input);
  } catch (const OutputError& error) {
    lose({name, line, error.what()}, internal_error);
  } catch (const std::exception& error) {
    lose({name, line, fault_text(error)}, internal_error);
  }
}

class Stream {
 public:
  Stream(const std::string& input, const StreamWork& work)
      : work_(work), input_(input, [this] { return failed_ || interrupt_requested(); }), texts_(input_.texts()) {
    if (progress_.is_seen()) all_ = cases_in(input);
  }

  /// Returns the next case; null at the end.
  std::shared_ptr<StreamedCase> next();
  /// Does the same for several cases at once.
  std::shared_ptr<Block> next_block();
  void answer_elsewhere(Block& block);
  void answer(StreamedCase& streamed);
  void deliver(StreamedCase& streamed);
  ExitCode finish();

 private:
  /// Shows the progress of one case at a time: of the one to be delivered next, for which the
  /// others wait.
  class CaseMonitor;

  void tell_of_hull(const StreamedCase& streamed);
  void tell_notes(const StreamedCase& streamed);
  void report(const StreamedCase& bad);

  const StreamWork& work_;
  Workspaces workspaces_{work_.threads};
  std::atomic<bool> failed_ = false, hull_told_ = false;
  CaseInput input_;
  files::UnreadCases texts_;
  Progress progress_;
  std::size_t read_ = 0, failures_ = 0, perhaps_inner_ = 0;
  std::optional<std::size_t> all_;  // approximate number of cases
  std::atomic<std::size_t> delivered_ = 0;
  std::array<std::size_t, later_notes.size()> cases_with_{};  // cases with a note of each kind
  ExitCode code_ = fine;
};

class Stream::CaseMonitor : public StopOnInterrupt {
 public:
  CaseMonitor(Stream& stream, const StreamedCase& streamed)
      : stream_(stream), number_(streamed.number), line_(streamed.text.line) {}

  void report(std::string_view stage, double share) override {
    if (has_the_bar()) stream_.progress_.report(stage, share);
  }
  [[nodiscard]] bool stopped() override {
    has_the_bar();
    return stream_.failed_ || StopOnInterrupt::stopped();
  }
  bool has_the_bar() {
    if (has_it_ || stream_.delivered_ != number_) return has_it_;
    stream_.progress_.about(fmt::format("line {}", line_));
    stream_.progress_.count({number_, stream_.all_});
    return has_it_ = true;
  }

 private:
  Stream& stream_;
  std::size_t number_, line_;
  bool has_it_ = false;
};

std::shared_ptr<StreamedCase> Stream::next() {
  auto streamed = std::make_shared<StreamedCase>();
  try {
    std::optional<files::UnreadCase> text = texts_.next();
    if (interrupt_requested()) throw Interrupted();
    if (failed_ || !text) return nullptr;
    streamed->text = std::move(*text);
  } catch (const std::bad_alloc& error) {  // the case does not fit into memory; the next one may
    const std::size_t line = texts_.case_line();
    streamed->text = {line, "", InputError(texts_.name(), line, fault_text(error))};
    streamed->code = internal_error;
  }
  streamed->number = read_++;
  streamed->interrupt_guard.emplace();
  if (streamed->text.text.size() >= long_text) answer(*streamed);
  return streamed;
}

// After the first, cases with inner points are only estimated: an exact count needs a convex hull
// for each case.
void Stream::answer(StreamedCase& streamed) {
  if (std::exchange(streamed.answered, true)) return;
  CaseMonitor monitor(*this, streamed);
  monitor.has_the_bar();
  try {
    workspaces_.with_one(
        [&](Workspace& workspace) { answer_case(streamed, texts_.name(), work_, monitor, workspace, hull_told_); });
  } catch (const Interrupted&) {
    if (!failed_) throw;  // otherwise the run ends with the first failure
  }
}

std::shared_ptr<Block> Stream::next_block() {
  auto block = std::make_shared<Block>();
  for (std::size_t bytes = 0; block->size() < cases_in_a_block && bytes < bytes_of_a_block;) {
    std::shared_ptr<StreamedCase> streamed = next();
    if (!streamed) break;
    bytes += streamed->text.text.size();
    block->push_back(std::move(streamed));
  }
  return block->empty() ? nullptr : block;
}

void Stream::answer_elsewhere(Block& block) {
  std::string texts = packed({hull_told_ ? "+" : ""});
  Block sent;
  for (const std::shared_ptr<StreamedCase>& streamed : block) {
    if (streamed->answered) continue;
    if (streamed->text.error) {
      answer(*streamed);
      continue;
    }
    pack(texts, std::to_string(streamed->text.line));
    pack(texts, streamed->text.text);
    sent.push_back(streamed);
  }
  if (sent.empty()) return;
  const std::string name =
      fmt::format("lines {} to {} of {}", sent.front()->text.line, sent.back()->text.line, texts_.name());
  const std::vector<std::string> answers = unpacked(work_.elsewhere(texts, name));
  for (std::size_t i = 0; i < sent.size(); ++i) take_answer(answers.at(i), *sent[i]);
}

void Stream::deliver(StreamedCase& streamed) try {
  tell_of_hull(streamed);
  tell_notes(streamed);
  if (!streamed.fault && streamed.reply.keep) {
    try {
      streamed.reply.keep();
    } catch (const InputError& error) {
      streamed.fault = error;
      streamed.code = bad_input;
    }
  }
  if (streamed.fault) {
    report(streamed);
  } else {
    progress_.answered();
    print(streamed.reply.text);
  }
  progress_.count({++delivered_, all_});
  streamed.interrupt_guard.reset();
  if (interrupt_requested()) throw Interrupted();
} catch (...) {
  failed_ = true;  // stops threads that wait for input or compute
  throw;
}

void Stream::tell_of_hull(const StreamedCase& streamed) {
  if (hull_told_) perhaps_inner_ += streamed.perhaps_inner;
  if (hull_told_ || !streamed.hull_note) return;
  hull_told_ = true;
  progress_.clear();
  talk(fmt::format("{}:{}: {}; later cases are counted", texts_.name(), streamed.text.line, *streamed.hull_note));
}

void Stream::tell_notes(const StreamedCase& streamed) {
  for (const StreamNote& note : streamed.notes) {
    if (cases_with_[static_cast<std::size_t>(note.kind)]++ > 0) continue;
    progress_.clear();
    talk(fmt::format("{}:{}: {}", texts_.name(), streamed.text.line, note.text));
  }
}

void Stream::report(const StreamedCase& bad) {
  const std::string sentence = bad.fault->what();
  ++failures_;
  code_ = std::max(code_, bad.code);
  progress_.clear();
  if (work_.lost) work_.lost(sentence);
  work_.error_line ? print(work_.error_line({bad.text.line, bad.id, *bad.fault}, sentence)) : talk(sentence);
}

ExitCode Stream::finish() {
  progress_.clear();
  if (failures_ > 0 && work_.error_line) talk(fmt::format("errors: {} of {} lines", failures_, read_));
  if (perhaps_inner_ > 0)
    talk(fmt::format("later cases that may have points which are not extreme: {}", perhaps_inner_));
  for (std::size_t i = 0; i < later_notes.size(); ++i)
    if (cases_with_[i] > 1) talk(fmt::format("later {}: {}", later_notes[i], cases_with_[i] - 1));
  return code_;
}

}  // namespace

InterruptibleInput::int_type InterruptibleInput::underflow() {
  while (true) {
    if (stopped_()) throw Interrupted();
    pollfd input{descriptor_, POLLIN, 0};
    if (const int ready = ::poll(&input, 1, between_looks); ready == 0 || (ready < 0 && errno == EINTR)) continue;
    const ssize_t got = ::read(descriptor_, buffer_.data(), buffer_.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw InputError("<stdin>", 0, std::string("cannot be read: ") + std::strerror(errno));
    if (got == 0) return traits_type::eof();
    setg(buffer_.data(), buffer_.data(), buffer_.data() + got);
    return traits_type::to_int_type(buffer_[0]);
  }
}

CaseInput::CaseInput(const std::string& path, std::function<bool()> stopped)
    : path_(path),
      descriptor_(open_pipe(path)),
      buffer_(std::move(stopped), descriptor_ < 0 ? STDIN_FILENO : descriptor_) {}

CaseInput::~CaseInput() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

files::UnreadCases CaseInput::texts() {
  if (descriptor_ >= 0) return {stream_, path_};
  return files::UnreadCases::open(path_, stream_);
}

std::optional<std::size_t> cases_in(const std::string& path) {
  std::error_code fault;
  if (path == "-" || !std::filesystem::is_regular_file(path, fault)) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  std::array<char, 1 << 16> piece;
  std::size_t cases = 0;
  char before = '\n';
  while (file.read(piece.data(), piece.size()) || file.gcount() > 0) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(file.gcount()); ++i) {
      if (before == '\n' && piece[i] == '{') ++cases;
      before = piece[i];
    }
  }
  return cases > 0 ? std::optional(cases) : std::nullopt;
}

void tell_of_hulls(const Case& input, bool one_body, Progress& progress) {
  progress.report("looking for dents", -1);
  const std::optional<std::string> note = hull_note(input, one_body);
  progress.clear();
  if (note) talk(*note);
}

std::string wrong_bodies(const Case& single, bool one_body, const std::string& refuses_shapes,
                         const std::string& refuses_unions, const std::string& refuses_plane) {
  const auto which = [&](bool a, bool b) { return a ? "a" : b && !one_body ? "b" : ""; };
  const std::string of_pieces = which(single.a.pieces != nullptr, single.b.pieces != nullptr);
  const std::string of_shape = which(single.a.shape.has_value(), single.b.shape.has_value());
  const std::string of_plane = which(single.a.dimension == 2, single.b.dimension == 2);
  if (!of_plane.empty() && !refuses_plane.empty())
    return of_plane + ": expected a body of space, found one of the plane: " + refuses_plane;
  if (single.a.dimension != single.b.dimension && !one_body)
    return of_plane + ": expected two bodies of the plane or two of space, found one of each";
  if (!of_pieces.empty() && !refuses_unions.empty())
    return of_pieces + ": expected a convex body, found a union of pieces: " + refuses_unions;
  if (!of_pieces.empty() && !of_shape.empty())
    return of_shape +
           ": expected pieces or a polytope, found a shape that is none: unions with radii have another depth than "
           "their cores";
  if (!of_shape.empty() && !refuses_shapes.empty())
    return of_shape + ": expected a polytope, found a shape that is none: " + refuses_shapes;
  return "";
}

std::string wrong_meshes(const shapes::HullFacts& facts, bool require_convex) {
  const std::string dents = require_convex ? shapes::dents_text(facts, false) : "";
  return dents.empty() ? "" : "expected convex meshes, as --require-convex says: " + dents;
}

ExitCode for_each_case(const std::string& input, const StreamWork& work) {
  Stream stream(input, work);
  if (!work.header.empty()) print(work.header);
  if (work.elsewhere) {
    in_order<Block>(
        work.threads, [&] { return stream.next_block(); }, [&](Block& block) { stream.answer_elsewhere(block); },
        [&](Block& block) {
          for (const std::shared_ptr<StreamedCase>& streamed : block) stream.deliver(*streamed);
        });
    return stream.finish();
  }
  in_order<StreamedCase>(
      work.threads, [&] { return stream.next(); }, [&](StreamedCase& streamed) { stream.answer(streamed); },
      [&](StreamedCase& streamed) { stream.deliver(streamed); });
  return stream.finish();
}

std::string answer_block(const std::string& block, const std::string& input, const StreamWork& work) {
  const std::vector<std::string> texts = unpacked(block);
  const bool hull_told = !texts.at(0).empty();
  StopOnInterrupt monitor;
  Workspace workspace;
  std::string answers;
  for (std::size_t i = 1; i + 1 < texts.size(); i += 2) {
    StreamedCase streamed;
    streamed.text = {std::stoull(texts[i]), texts[i + 1], {}};
    answer_case(streamed, input == "-" ? "<stdin>" : input, work, monitor, workspace, hull_told);
    pack_answer(answers, streamed);
  }
  return answers;
}

}  // namespace fathom::cli
