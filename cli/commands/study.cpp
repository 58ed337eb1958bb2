// SPDX-License-Identifier: GPL-3.0-or-later
// fathom study A B | CASES.jsonl | -
// fathom study --sweep FAMILY --sizes LOW..HIGH
// Prints the degeneracies of pairs; or how the work of the exact method grows with the size of the
// bodies: as a table, as CSV, and as a chart.

#include "verify/study/study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/args/arguments.hpp"
#include "cli/args/values.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/explain.hpp"
#include "cli/commands/names.hpp"
#include "cli/commands/replies.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "cli/output/study_output.hpp"
#include "fathom/depth.hpp"
#include "fathom/files.hpp"
#include "fathom/signed_depth.hpp"
#include "kernels/messages.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/shapes/body_notes.hpp"
#include "verify/families/families.hpp"
#include "view/picture/markup.hpp"
#include "view/plot/plot.hpp"

namespace fathom::cli {
namespace {

// ---- --sweep ----

/// The counts of the exact method on one pair.
struct SweepRow {
  unsigned size;  ///< the size asked for
  Status status;
  Counters counters;
  std::vector<std::uint64_t> evaluated = {};  ///< pairs of lines evaluated by each engine of the sweep
  std::optional<double> seconds = {};

  [[nodiscard]] std::uint64_t edges() const { return counters.edges_a + counters.edges_b; }
  [[nodiscard]] std::uint64_t sum() const { return counters.sum_a + counters.sum_b; }
  [[nodiscard]] std::uint64_t cleared() const {
    return counters.vertex_clears + counters.frame_clears + counters.wide_clears;
  }
};

/// The options of --sweep.
struct Sweep {
  explicit Sweep(const Given& given)
      : family(given.text("--sweep")),
        sizes(typed_sizes(given.value("--sizes").value_or("10..1000")).value()),
        seed(given.integer<std::uint64_t>("--seed").value_or(1)),
        timed(given.flag("--times")),
        csv(given.flag("--csv")),
        svg(given.text("--svg")) {
    for (const std::string& name : given.words("--closest-lines")) engines.push_back(typed_engine(name).value());
  }

  std::string family;
  std::vector<unsigned> sizes;  ///< ascending
  std::uint64_t seed;
  bool timed, csv;
  std::string svg;                    ///< the file for the chart, or ""
  std::vector<ClosestLines> engines;  ///< the engines to compare; empty: only the default one
};

/// A count whose growth is shown.
struct Column {
  std::string key, words;  ///< its name in CSV; and in tables and charts
  std::function<std::uint64_t(const SweepRow&)> of;
};

/// Returns the columns. With several engines, one count is replaced by the pairs that each of them
/// evaluates.
std::vector<Column> columns_of(const Sweep& sweep) {
  std::vector<Column> columns{
      {"crossings", "crossings", [](const SweepRow& row) { return row.counters.crossings; }},
      {"canonical_pairs", "canonical pairs", [](const SweepRow& row) { return row.counters.canonical_pairs; }},
      {"sum", "sum |A_i|+|B_i|", [](const SweepRow& row) { return row.sum(); }}};
  for (std::size_t i = 0; i < sweep.engines.size(); ++i) {
    const std::string engine(engine_names[static_cast<std::size_t>(sweep.engines[i])]);
    columns.push_back(
        {"pairs_evaluated_" + engine, "pairs, " + engine, [i](const SweepRow& row) { return row.evaluated.at(i); }});
  }
  if (sweep.engines.empty())
    columns.push_back(
        {"pairs_evaluated", "pairs evaluated", [](const SweepRow& row) { return row.counters.pairs_evaluated; }});
  columns.push_back({"blocks_tested", "blocks tested", [](const SweepRow& row) { return row.counters.block_tests; }});
  columns.push_back({"blocks_cleared", "blocks cleared", [](const SweepRow& row) { return row.cleared(); }});
  return columns;
}

constexpr std::size_t size_width = 7, status_width = 11, edges_width = 8, least_width = 9;

std::size_t width(const Column& column) { return std::max(column.words.size(), least_width); }

std::string seconds_text(double seconds) { return fmt::format("{:.3g}", seconds); }

template <class Value>
std::vector<plot::Datum> places(const std::vector<SweepRow>& rows, Value value) {
  std::vector<plot::Datum> result;
  for (const SweepRow& row : rows) {
    const double y = static_cast<double>(value(row));
    result.push_back(
        {static_cast<double>(row.edges()), y, fmt::format("size {}, {} edges: {}", row.size, row.edges(), value(row))});
  }
  return result;
}

/// Returns "1.07", or "-" if there are too few sizes.
std::string exponent_text(const std::vector<plot::Datum>& places) {
  const std::optional<double> exponent = plot::growth_exponent(places);
  if (!exponent) return "-";
  const std::string text = fmt::format("{:.2f}", *exponent);
  return text == "-0.00" ? "0.00" : text;
}

std::string legend(std::string_view words, const std::vector<plot::Datum>& places) {
  const std::string exponent = exponent_text(places);
  return exponent == "-" ? std::string(words) : fmt::format("{}: (m + n)^{}", words, exponent);
}

plot::CurvePanel panel_of(const std::string& title, const std::string& what) {
  return {title, {"m + n: edges of A and of B", plot::Scale::logarithmic}, {what, plot::Scale::logarithmic}, {}};
}

std::string sweep_text_header(const Sweep& sweep) {
  std::string result = fmt::format("{}, seed {}, by the exact method\n{:>{}}  {:<{}}  {:>{}}", sweep.family, sweep.seed,
                                   "size", size_width, "status", status_width, "edges", edges_width);
  for (const Column& column : columns_of(sweep)) result += fmt::format("  {:>{}}", column.words, width(column));
  return sweep.timed ? result + fmt::format("  {:>{}}", "seconds", least_width) : result;
}

std::string sweep_text_row(const Sweep& sweep, const SweepRow& row) {
  std::string result = fmt::format("{:>{}}  {:<{}}  {:>{}}", row.size, size_width, name(row.status), status_width,
                                   row.edges(), edges_width);
  for (const Column& column : columns_of(sweep)) result += fmt::format("  {:>{}}", column.of(row), width(column));
  return row.seconds ? result + fmt::format("  {:>{}}", seconds_text(*row.seconds), least_width) : result;
}

/// Returns "growth", and the exponent of each column.
std::string sweep_text_growth(const Sweep& sweep, const std::vector<SweepRow>& rows) {
  std::string result =
      fmt::format("growth: edges to the power {:>{}}", "", size_width + status_width + edges_width + 4 - 27);
  for (const Column& column : columns_of(sweep))
    result += fmt::format("  {:>{}}", exponent_text(places(rows, column.of)), width(column));
  if (!sweep.timed) return result;
  return result + fmt::format("  {:>{}}", exponent_text(places(rows, [](const SweepRow& row) { return *row.seconds; })),
                              least_width);
}

std::string sweep_csv_header(const Sweep& sweep) {
  std::string result = "size,status,edges_a,edges_b,edges";
  for (const Column& column : columns_of(sweep)) result += fmt::format(",{}", column.key);
  return sweep.timed ? result + ",seconds" : result;
}

std::string sweep_csv_row(const Sweep& sweep, const SweepRow& row) {
  std::string result = fmt::format("{},{},{},{},{}", row.size, name(row.status), row.counters.edges_a,
                                   row.counters.edges_b, row.edges());
  for (const Column& column : columns_of(sweep)) result += fmt::format(",{}", column.of(row));
  return row.seconds ? result + "," + seconds_text(*row.seconds) : result;
}

/// Returns the chart as an SVG file.
std::string sweep_svg(const Sweep& sweep, const std::vector<SweepRow>& rows) {
  plot::CurvePanel work = panel_of("Counts of the exact method", "count");
  for (const Column& column : columns_of(sweep)) {
    std::vector<plot::Datum> counts = places(rows, column.of);
    const std::string name = legend(column.words, counts);
    work.series.push_back({name, std::move(counts)});
  }
  plot::Figure figure{
      fmt::format("How the work grows: {}", sweep.family),
      fmt::format(
          "Pairs of the family {}, seed {}, of {} sizes, by the exact method. Both axes are logarithmic. The exponents "
          "are those of the powers of the number of edges that fit best.",
          sweep.family, sweep.seed, rows.size()),
      "sweep",
      {std::move(work)}};
  if (sweep.timed) {
    plot::CurvePanel time = panel_of("Time", "seconds");
    std::vector<plot::Datum> seconds = places(rows, [](const SweepRow& row) { return *row.seconds; });
    const std::string name = legend("seconds", seconds);
    time.series.push_back({name, std::move(seconds)});
    figure.panels.push_back(std::move(time));
  }
  return plot::figure_file(figure);
}

using Clock = std::chrono::steady_clock;

constexpr double long_enough = 0.2;  // seconds: shorter runs are repeated, and the shortest time counts
constexpr int most_runs = 3;
constexpr std::size_t behind_size = 9;  // spaces before continued lines of a row, on a narrow terminal

const families::Family& family_named(const std::string& name) {
  if (const families::Family* family = families::find_family(name)) {
    if (family->kind() == families::Kind::polytopes) return *family;
    throw InputError("--sweep", 0,
                     fmt::format("expected a family of polytopes, found {}, whose {} are not", kernels::shown(name),
                                 family->kind() == families::Kind::shapes   ? "shapes"
                                 : family->kind() == families::Kind::unions ? "unions"
                                                                            : "bodies of the plane"));
  }
  std::vector<std::string_view> of_polytopes;
  for (const families::Family& family : families::families()) of_polytopes.push_back(family.name);
  throw InputError("--sweep", 0,
                   fmt::format("{} is unknown (nearest: {}; `fathom cases --list` lists all)", kernels::shown(name),
                               fmt::join(nearest_families(name, std::move(of_polytopes)), ", ")));
}

SweepRow row_of(const families::Family& family, unsigned size, const Sweep& sweep, Monitor& monitor) {
  const Case pair = family.make(sweep.seed, size);
  Options options;
  options.method = Method::exact;
  options.optima = 1;
  options.monitor = &monitor;
  SweepRow row{size, Status::disjoint, {}};
  for (const ClosestLines engine : sweep.engines) {
    options.closest_lines = engine;
    row.evaluated.push_back(penetration_depth(pair.a, pair.b, options).counters.pairs_evaluated);
  }
  if (!sweep.engines.empty())
    options.closest_lines = sweep.engines.front();  // the other counts and the times are those of this engine
  for (int run = 0; run < most_runs; ++run) {
    const Clock::time_point begin = Clock::now();
    const Depth depth = penetration_depth(pair.a, pair.b, options);
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    row.status = depth.status();
    row.counters = depth.counters;
    if (!sweep.timed) break;
    row.seconds = std::min(seconds, row.seconds.value_or(seconds));
    if (seconds >= long_enough) break;
  }
  return row;
}

/// Prints each row as soon as it is known, and appends it to `rows`. Throws Interrupted.
void run_sizes(const Sweep& sweep, std::vector<SweepRow>& rows) {
  const families::Family& family = family_named(sweep.family);
  const std::size_t all = std::accumulate(sweep.sizes.begin(), sweep.sizes.end(), std::size_t{0});
  Progress progress("points of a body");  // which determine the time that is left
  print(sweep.csv ? sweep_csv_header(sweep) : fitted(sweep_text_header(sweep), behind_size));
  std::size_t done = 0;
  for (const unsigned size : sweep.sizes) {
    progress.about(fmt::format("size {}", size));
    progress.count({done, all});
    rows.push_back(row_of(family, size, sweep, progress));
    progress.answered();
    print(sweep.csv ? sweep_csv_row(sweep, rows.back()) : fitted(sweep_text_row(sweep, rows.back()), behind_size));
    done += size;
  }
}

// ---- the study of a case ----

struct StudyRequest : BodiesRequest {
  explicit StudyRequest(const Given& given)
      : BodiesRequest(given),
        csv(given.flag("--csv")),
        all(given.flag("--all")),
        html(given.text("--html")),
        command_line(given.command_line) {}

  bool csv, all;                   ///< rows of counts; all coincidences, not the first few of each kind
  std::string html, command_line;  ///< the file for the page, or ""; the command line, which the page quotes
};

StudyOptions options_of(const StudyRequest& request, Monitor* monitor) {
  StudyOptions options;
  if (request.all) options.listed = std::numeric_limits<std::size_t>::max();
  options.monitor = monitor;
  return options;
}

ShapeStudy shape_study_of(const Case& pair, const StudyRequest& request, Monitor& monitor) {
  if (request.csv)
    throw InputError(pair.id, 0,
                     "the rows of --csv are about polytopes, found a shape that is none: --json takes both");
  const Shape a = files::shape_of(pair.a), b = files::shape_of(pair.b);
  require_depth(pair.id, a, b);
  return study(a, b, options_of(request, &monitor));
}

std::string text_of(const std::string& id, const ShapeStudy& study, const StudyRequest& request) {
  if (request.json) return study_json(id, study);
  return is_stream(request) ? study_line(id, study) : study_block(study, request.all);
}

std::string text_of(const std::string& id, const Study& study, const StudyRequest& request) {
  if (request.csv) return study_csv_row(id, study);
  if (request.json) return study_json(id, study);
  return is_stream(request) ? study_line(id, study) : study_block(study, request.all);
}

/// The file of --html: for two bodies the page of `explain`, for a stream the table of its cases.
class PageFile {
 public:
  PageFile(const Given& given, const StudyRequest& request) : request_(request), explained_(given) {
    if (!request.html.empty()) file_.emplace(request.html, "page");
    explained_.opens = "coincided";
    explained_.options.listed = options_of(request, nullptr).listed;
    explained_.options.most_pairs = std::numeric_limits<std::uint64_t>::max();
  }

  /// Returns the reply to a case. Its `keep` adds the case to the page.
  template <class AnyStudy>
  CaseReply reply(const AskedCase& pair, const AnyStudy& found, Monitor& monitor) {
    CaseReply result{text_of(pair.input.id, found, request_)};
    if (!file_) return result;
    if (is_stream(request_)) result.keep = [this, row = table_row(pair.input.id, found)] { table_.add(row); };
    else page_ = explained_page(pair, explained_, monitor);
    return result;
  }
  void lose(const std::string& sentence) { table_.add_fault(picture::without_folders(sentence)); }
  void write(const std::string& cut_short) {
    if (!file_) return;
    if (is_stream(request_)) file_->write(table_.html(request_.command_line, cut_short));
    else if (cut_short.empty()) file_->write(page_);
  }

 private:
  const StudyRequest& request_;
  ExplainRequest explained_;
  StudyTable table_;
  std::string page_;
  std::optional<CertificateFile> file_;
};

}  // namespace

ExitCode run_sweep(const Given& given) {
  const Sweep sweep(given);
  const auto picture = wanted_file(sweep.svg, "picture");  // fails early for an unwritable path
  const InterruptGuard interrupt_guard;
  std::vector<SweepRow> rows;
  ExitCode code = fine;
  try {
    run_sizes(sweep, rows);
  } catch (const Interrupted&) {  // rows that are finished are kept
    take_time_to_write();
    code = interrupted;
  }
  if (!sweep.csv && rows.size() > 1) print(fitted(sweep_text_growth(sweep, rows), behind_size));
  if (picture && !rows.empty()) picture->write(sweep_svg(sweep, rows));
  if (code == interrupted) talk(fmt::format("interrupted after {} of {} sizes", rows.size(), sweep.sizes.size()));
  return code;
}

ExitCode run_study(const Given& given) {
  if (given.has("--sweep")) return run_sweep(given);
  const StudyRequest request(given);
  PageFile page(given, request);
  Replies replies;
  replies.refuses_unions = shapes::study_of_union;
  replies.refuses_plane = "what it names are coincidences in space, as the exact method meets them; depth lists ties";
  replies.reply = [&](const AskedCase& pair, Monitor& monitor, Workspace&) {
    if (has_shape(pair)) return page.reply(pair, shape_study_of(pair, request, monitor), monitor);
    return page.reply(pair, study(pair.input.a.points, pair.input.b.points, options_of(request, &monitor)), monitor);
  };
  replies.lost = [&](const std::string& sentence) { page.lose(sentence); };
  if (request.csv) {
    replies.header = study_csv_header();
    replies.error_line = [](const CaseItem& item, const std::string& fault) { return study_csv_error(item.id, fault); };
  } else if (request.json) {
    replies.error_line = [](const CaseItem& item, const std::string& fault) {
      return study_json_error(item.id, item.line, fault);
    };
  }
  try {
    const ExitCode code = reply_to_inputs(request, replies);
    page.write("");
    return code;
  } catch (const Interrupted&) {
    page.write("interrupted");
    throw;
  }
}

}  // namespace fathom::cli
