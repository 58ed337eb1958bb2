// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/sweep_output.hpp"

#include <fmt/format.h>

#include <functional>
#include <string_view>

#include "cli/args/request.hpp"
#include "view/plot/plot.hpp"

namespace fathom::cli {
namespace {

/// A count that grows.
struct Column {
  std::string key, words;  ///< in CSV; in tables and charts
  std::function<std::uint64_t(const SweepRow&)> of;
};

/// With several engines, what each of them evaluates stands in the place of one count.
std::vector<Column> columns_of(const Sweep& sweep) {
  std::vector<Column> columns{{"crossings", "crossings", [](const SweepRow& row) { return row.counters.crossings; }},
                              {"canonical_pairs", "canonical pairs", [](const SweepRow& row) { return row.counters.canonical_pairs; }},
                              {"sum", "sum |A_i|+|B_i|", [](const SweepRow& row) { return row.sum(); }}};
  for (std::size_t i = 0; i < sweep.engines.size(); ++i) {
    const std::string engine(engine_names[static_cast<std::size_t>(sweep.engines[i])]);
    columns.push_back({"pairs_evaluated_" + engine, "pairs, " + engine, [i](const SweepRow& row) { return row.evaluated.at(i); }});
  }
  if (sweep.engines.empty())
    columns.push_back({"pairs_evaluated", "pairs evaluated", [](const SweepRow& row) { return row.counters.pairs_evaluated; }});
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
    result.push_back({static_cast<double>(row.edges()), y, fmt::format("size {}, {} edges: {}", row.size, row.edges(), value(row))});
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

}  // namespace

std::string sweep_text_header(const Sweep& sweep) {
  std::string result = fmt::format("{}, seed {}, by the exact method\n{:>{}}  {:<{}}  {:>{}}", sweep.family, sweep.seed, "size", size_width,
                                   "status", status_width, "edges", edges_width);
  for (const Column& column : columns_of(sweep)) result += fmt::format("  {:>{}}", column.words, width(column));
  return sweep.timed ? result + fmt::format("  {:>{}}", "seconds", least_width) : result;
}

std::string sweep_text_row(const Sweep& sweep, const SweepRow& row) {
  std::string result =
      fmt::format("{:>{}}  {:<{}}  {:>{}}", row.size, size_width, name(row.status), status_width, row.edges(), edges_width);
  for (const Column& column : columns_of(sweep)) result += fmt::format("  {:>{}}", column.of(row), width(column));
  return row.seconds ? result + fmt::format("  {:>{}}", seconds_text(*row.seconds), least_width) : result;
}

std::string sweep_text_growth(const Sweep& sweep, const std::vector<SweepRow>& rows) {
  std::string result = fmt::format("growth: edges to the power {:>{}}", "", size_width + status_width + edges_width + 4 - 27);
  for (const Column& column : columns_of(sweep)) result += fmt::format("  {:>{}}", exponent_text(places(rows, column.of)), width(column));
  if (!sweep.timed) return result;
  return result + fmt::format("  {:>{}}", exponent_text(places(rows, [](const SweepRow& row) { return *row.seconds; })), least_width);
}

std::string sweep_csv_header(const Sweep& sweep) {
  std::string result = "size,status,edges_a,edges_b,edges";
  for (const Column& column : columns_of(sweep)) result += fmt::format(",{}", column.key);
  return sweep.timed ? result + ",seconds" : result;
}

std::string sweep_csv_row(const Sweep& sweep, const SweepRow& row) {
  std::string result = fmt::format("{},{},{},{},{}", row.size, name(row.status), row.counters.edges_a, row.counters.edges_b, row.edges());
  for (const Column& column : columns_of(sweep)) result += fmt::format(",{}", column.of(row));
  return row.seconds ? result + "," + seconds_text(*row.seconds) : result;
}

std::string sweep_svg(const Sweep& sweep, const std::vector<SweepRow>& rows) {
  plot::CurvePanel work = panel_of("Counts of the exact method", "count");
  for (const Column& column : columns_of(sweep)) {
    std::vector<plot::Datum> counts = places(rows, column.of);
    const std::string name = legend(column.words, counts);
    work.series.push_back({name, std::move(counts)});
  }
  plot::Figure figure{
      fmt::format("How the work grows: {}", sweep.family),
      fmt::format("Pairs of the family {}, seed {}, of {} sizes, by the exact method. Both axes are logarithmic. The exponents "
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

}  // namespace fathom::cli
