// SPDX-License-Identifier: GPL-3.0-or-later
// fathom study --sweep FAMILY --sizes LOW..HIGH
#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <numeric>

#include "cli/commands/command.hpp"
#include "cli/commands/family_names.hpp"
#include "cli/io/certificate_file.hpp"
#include "cli/io/output.hpp"
#include "cli/io/progress.hpp"
#include "cli/io/terminal.hpp"
#include "cli/output/sweep_output.hpp"
#include "fathom/files.hpp"
#include "kernels/messages.hpp"
#include "verify/families/families.hpp"

namespace fathom::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double long_enough = 0.2;  // seconds: what is shorter is measured again, and the shortest time counts
constexpr int most_runs = 3;
constexpr std::size_t behind_size = 9;  // spaces before the further lines of a row, on a narrow terminal

const families::Family& family_named(const std::string& name) {
  if (const families::Family* family = families::find_family(name)) return *family;
  if (families::find_shape_family(name) != nullptr)
    throw InputError("--sweep", 0, fmt::format("expected a family of polytopes, found {}, whose shapes are not", kernels::shown(name)));
  if (families::find_union_family(name) != nullptr)
    throw InputError("--sweep", 0, fmt::format("expected a family of polytopes, found {}, whose unions are not", kernels::shown(name)));
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
  if (!request.sweep.engines.empty()) options.closest_lines = request.sweep.engines.front();  // which the other counts and the times are of
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
  if (!request.svg.empty()) picture = std::make_unique<CertificateFile>(request.svg, "picture");  // an unwritable path fails early
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
  if (code == interrupted) talk(fmt::format("interrupted after {} of {} sizes", rows.size(), request.sweep.sizes.size()));
  return code;
}

}  // namespace fathom::cli
