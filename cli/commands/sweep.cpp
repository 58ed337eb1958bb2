// SPDX-License-Identifier: GPL-3.0-or-later
// fathom study --sweep FAMILY --sizes LOW..HIGH How the work of the exact method grows: for people
// (a table), for spreadsheets (CSV), and as a chart.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/args/request.hpp"
#include "cli/args/values.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/family_names.hpp"
#include "cli/io/certificate_file.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "cli/io/terminal.hpp"
#include "fathom/depth.hpp"
#include "fathom/files.hpp"
#include "kernels/messages.hpp"
#include "verify/families/families.hpp"
#include "view/plot/plot.hpp"

namespace fathom::cli {
namespace {

/// The exact method on one pair.
struct SweepRow {
  unsigned size;  ///< as it was asked for
  Status status;
  Counters counters;
  std::vector<std::uint64_t> evaluated = {};  ///< pairs of lines, by each engine of the sweep
  std::optional<double> seconds = {};

  [[nodiscard]] std::uint64_t edges() const { return counters.edges_a + counters.edges_b; }
  [[nodiscard]] std::uint64_t sum() const { return counters.sum_a + counters.sum_b; }
  [[nodiscard]] std::uint64_t cleared() const {
    return counters.vertex_clears + counters.frame_clears + counters.wide_clears;
  }
};

struct Sweep {
  std::string family;
  std::uint64_t seed;
  bool timed;
  std::vector<ClosestLines> engines = {};  ///< that are compared; empty: the usual one alone
};

/// A count that grows.
struct Column {
  std::string key, words;  ///< in CSV; in tables and charts
  std::function<std::uint64_t(const SweepRow&)> of;
};

/// With several engines, what each of them evaluates stands in the place of one count.
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

/// "1.07", or "-" where there is too little to tell.
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

/// "growth", and the exponent of each column.
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

/// A file of SVG.
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

constexpr double long_enough = 0.2;  // seconds: what is shorter is measured again, and the shortest time counts
constexpr int most_runs = 3;
constexpr std::size_t behind_size = 9;  // spaces before the further lines of a row, on a narrow terminal

const families::Family& family_named(const std::string& name) {
  if (const families::Family* family = families::find_family(name)) {
    if (family->kind() == families::Kind::polytopes) return *family;
    throw InputError("--sweep", 0,
                     fmt::format("expected a family of polytopes, found {}, whose {} are not", kernels::shown(name),
                                 family->kind() == families::Kind::shapes ? "shapes" : "unions"));
  }
  std::vector<std::string_view> of_polytopes;
  for (const families::Family& family : families::families()) of_polytopes.push_back(family.name);
  throw InputError("--sweep", 0,
                   fmt::format("{} is unknown (nearest: {}; `fathom cases --list` lists all)", kernels::shown(name),
                               fmt::join(nearest_families(name, std::move(of_polytopes)), ", ")));
}

SweepRow row_of(const families::Family& family, unsigned size, const Request& request, Monitor& monitor) {
  const Case pair = family.make(request.seed, size);
  Options options;
  options.method = Method::exact;
  options.optima = 1;
  options.monitor = &monitor;
  SweepRow row{size, Status::disjoint, {}};
  for (const ClosestLines engine : request.sweep.engines) {
    options.closest_lines = engine;
    row.evaluated.push_back(penetration_depth(pair.a, pair.b, options).counters.pairs_evaluated);
  }
  if (!request.sweep.engines.empty())
    options.closest_lines = request.sweep.engines.front();  // which the other counts and the times are of
  for (int run = 0; run < most_runs; ++run) {
    const Clock::time_point begin = Clock::now();
    const Depth depth = penetration_depth(pair.a, pair.b, options);
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    row.status = depth.status();
    row.counters = depth.counters;
    if (!request.times) break;
    row.seconds = std::min(seconds, row.seconds.value_or(seconds));
    if (seconds >= long_enough) break;
  }
  return row;
}

/// Prints each row as soon as it is known, and keeps it. Throws Interrupted.
void run_sizes(const Sweep& sweep, const Request& request, std::vector<SweepRow>& rows) {
  const families::Family& family = family_named(sweep.family);
  const std::vector<unsigned>& sizes = request.sweep.sizes;
  const std::size_t all = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
  Progress progress("points of a body");  // time goes with them: it tells how long the rest will take
  print(request.csv ? sweep_csv_header(sweep) : fitted(sweep_text_header(sweep), behind_size));
  std::size_t done = 0;
  for (const unsigned size : sizes) {
    progress.about(fmt::format("size {}", size));
    progress.count({done, all});
    rows.push_back(row_of(family, size, request, progress));
    progress.answered();
    print(request.csv ? sweep_csv_row(sweep, rows.back()) : fitted(sweep_text_row(sweep, rows.back()), behind_size));
    done += size;
  }
}

}  // namespace

ExitCode run_sweep(const Request& request) {
  const Sweep sweep{request.sweep.family, request.seed, request.times, request.sweep.engines};
  std::unique_ptr<CertificateFile> picture;
  if (!request.svg.empty())
    picture = std::make_unique<CertificateFile>(request.svg, "picture");  // an unwritable path fails early
  const Working working;
  std::vector<SweepRow> rows;
  ExitCode code = fine;
  try {
    run_sizes(sweep, request, rows);
  } catch (const Interrupted&) {  // what is done is kept
    take_time_to_write();
    code = interrupted;
  }
  if (!request.csv && rows.size() > 1) print(fitted(sweep_text_growth(sweep, rows), behind_size));
  if (picture && !rows.empty()) picture->write(sweep_svg(sweep, rows));
  if (code == interrupted)
    talk(fmt::format("interrupted after {} of {} sizes", rows.size(), request.sweep.sizes.size()));
  return code;
}

}  // namespace fathom::cli
