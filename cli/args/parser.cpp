// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/args/parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "cli/args/along_arguments.hpp"
#include "cli/args/approx_arguments.hpp"
#include "cli/args/cases_arguments.hpp"
#include "cli/args/certify_arguments.hpp"
#include "cli/args/help.hpp"
#include "cli/args/named_files.hpp"
#include "cli/args/parser_words.hpp"
#include "cli/args/pieces_arguments.hpp"
#include "cli/args/sweep_arguments.hpp"
#include "cli/args/threads.hpp"
#include "fathom/numbers.hpp"
#include "fathom/signed_depth.hpp"
#include "kernels/messages.hpp"

namespace fathom::cli {
namespace {

std::string check_digits(const std::string& value) {
  const bool number = !value.empty() && value.size() < 8 && value.find_first_not_of("0123456789") == std::string::npos;
  if (number && value != std::string(value.size(), '0') && std::stoul(value) <= most_root_digits) return "";
  return fmt::format("expected an integer from 1 to {}, found {}", most_root_digits, kernels::shown(value));
}

std::optional<std::uint64_t> seed_of(const std::string& value) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), seed);
  return error == std::errc() && end == value.data() + value.size() ? std::optional(seed) : std::nullopt;
}

std::string check_bits(const std::string& value) {
  const std::optional<std::uint64_t> bits = seed_of(value);
  return bits && *bits > 0 && *bits <= most_bound_bits
             ? ""
             : fmt::format("expected an integer from 1 to {}, found {}", most_bound_bits, kernels::shown(value));
}

std::string check_optima(const std::string& value) {
  const std::optional<std::uint64_t> number = seed_of(value);
  return number && *number > 0 ? "" : fmt::format("expected an integer from 1 on, found {}", kernels::shown(value));
}

std::string check_seed(const std::string& value) {
  if (seed_of(value)) return "";
  return fmt::format("expected an integer from 0 to 2^64 - 1, found {}", kernels::shown(value));
}

void add_input(CLI::App& app, Request& request, const char* place) {
  app.add_option_function<std::string>(place, [&request](const std::string& path) { request.inputs.push_back(path); });
}

void add_inputs(CLI::App& app, Request& request, Texts& texts) {
  // One by one: into a vector, CLI11 would take a file called "[x]" for a list.
  for (const char* place : {"first", "second"}) add_input(app, request, place);
  app.add_flag("--exact-decimals", texts.exact_decimals, "decimals in text meshes are exact, instead of the nearest binary64");
}

void add_poses(CLI::App& app, Request& request, bool of_one) {
  CLI::Option* const of_a = app.add_option(
      of_one ? "--pose-a,--pose" : "--pose-a", request.pose_a,
      "how A is placed, exactly: \"r11 r12 r13 t1; r21 ...; r31 ...\", 4 x 4 numbers, \"xyz=X,Y,Z quat=W,X,Y,Z\" (or xyzw=X,Y,Z,W, or "
      "rpy=ROLL,PITCH,YAWdeg or rad), or @FILE with one of these");
  names_file(of_a, FileUse::read)->type_name("POSE");
  if (!of_one) names_file(app.add_option("--pose-b", request.pose_b, "the same for B"), FileUse::read)->type_name("POSE");
}

void add_exact(CLI::App& app, Request& request) {
  app.add_flag("--exact", request.exact,
               "text: the exact numbers, as fractions in full and directions as integers, where else the nearest decimals stand");
}

void add_require_convex(CLI::App& app, Request& request) {
  app.add_flag("--require-convex", request.require_convex,
               "a mesh with faces that is not convex is an error, exit code 2; else its hull is taken, and the result says so");
}

/// The inputs of a command that answers two meshes, or a stream.
void add_questions(CLI::App& app, Request& request, Texts& texts, bool of_one = false) {
  add_inputs(app, request, texts);
  add_poses(app, request, of_one);
  add_require_convex(app, request);
  app.add_option_function<std::string>(
         "--threads", [&request](const std::string& text) { request.threads = threads_of(text); },
         "cases of a stream that are answered at once; as many as there are cores unless given. The output is the same with any number")
      ->check(check_threads)
      ->type_name("N");
}

void add_seed(CLI::App& app, Request& request, const std::string& meaning) {
  app.add_option_function<std::string>(
         "--seed", [&request](const std::string& text) { request.seed = *seed_of(text); }, meaning)
      ->check(check_seed)
      ->type_name("N");
}

void add_svg(CLI::App& app, Request& request, const std::string& meaning) {
  names_file(app.add_option("--svg", request.svg, meaning), FileUse::placed)->type_name("FILE");
}

void add_case(CLI::App& app, Request& request) {
  app.add_option("--case", request.case_id, "one case of a stream alone: the first with this id")->type_name("ID");
}

void add_study_options(CLI::App& app, Request& request, Texts& texts) {
  add_questions(app, request, texts);
  add_case(app, request);
  app.add_flag("--all", request.all, "list every coincidence, not the first 20 of a kind (in tables: the first)");
  app.add_flag("--json", request.json, "one JSON object per line, schema fathom/study/1");
  app.add_flag("--csv", request.csv, "a header, then one row of counts per case, or per size");
  names_file(app.add_option("--html", request.html, "write one page, with pictures, tables to filter, and of a stream every case folded"),
             FileUse::written)
      ->type_name("FILE");
  add_sweep_options(app, request);
  add_seed(app, request, "with --sweep: of the family's pairs; 1 unless given");
  add_svg(app, request, "with --sweep: write a chart of the counts to FILE, on logarithmic axes, with the exponents of growth");
}

void add_explain_options(CLI::App& app, Request& request, Texts& texts) {
  add_inputs(app, request, texts);
  add_poses(app, request, false);
  add_require_convex(app, request);
  add_pieces_option(app, request);
  add_case(app, request);
  names_file(app.add_option("-o,--output", request.page, "the page: one HTML file, which needs no network"), FileUse::written)
      ->type_name("FILE");
  app.add_flag("--times", request.times, "add how long each stage took: then the page differs from run to run");
}

void add_stages_options(CLI::App& app, Request& request, Texts& texts) {
  add_questions(app, request, texts);
  add_case(app, request);
  app.add_flag("--times", request.times, "add the seconds that each stage took, which differ from run to run");
  app.add_flag("--json", request.json, "one JSON object per line, schema fathom/stages/1: every stage, for pictures");
  add_svg(app, request, "draw both charts as SVG to FILE, in longitude and latitude; for a stream: a directory, one file for each case");
}

void add_options(CLI::App& app, Request& request, Texts& texts, bool of_one) {
  app.add_option("--method", texts.method,
                 "how: auto, exact, certificate (an expanding polytope; exact where that takes too many points), shallow (the part of B - "
                 "A near O: for "
                 "bodies that overlap a little), or naive (the hull of all vertex differences). auto is certificate; the result names the "
                 "one that ran")
      ->check(one_of({"auto", "exact", "certificate", "shallow", "naive"}))
      ->type_name("NAME");
  app.add_option("--closest-lines", texts.closest_lines,
                 "engine inside the exact method: cutting (the default), sampled, or naive (all pairs of lines)")
      ->check(one_of({engine_names.begin(), engine_names.end()}))
      ->type_name("NAME");
  add_seed(app, request, "of the closest lines' random order, which changes the work and not the answer; 1 unless given");
  app.add_option(
         "--digits", request.digits,
         "add an enclosure of the depth to N significant digits. Of curved bodies, bounds so near are looked for, unless --bits says "
         "how near")
      ->check(check_digits)
      ->type_name("N");
  app.add_option("--bits", request.bits,
                 "how near the bounds of curved bodies are to be: within 2^-K of the value, or of the bodies' extent; 40 unless given, at "
                 "most 1000")
      ->check(check_bits)
      ->type_name("K");
  add_questions(app, request, texts, of_one);
  names_file(app.add_option("--certificate", request.certificate,
                            "write the proof of the answer to FILE; for a stream: a directory, one file for each case"),
             FileUse::placed)
      ->type_name("FILE");
  app.add_flag("--embed-certificate", request.embed_certificate, "with --json: add the proof to each result");
  if (!of_one)
    add_svg(app, request,
            "draw the bodies and the way out as SVG to FILE; for a stream: a directory, one file for each case; with --along: the curve");
  app.add_flag("--counters", request.counters, "add what the run did, in counts");
  add_exact(app, request);
  app.add_flag("--json", request.json, "one JSON object per line, schema fathom/result/2");
}

void add_optima(CLI::App& app, Request& request) {
  app.add_option_function<std::string>(
         "--optima", [&request](const std::string& text) { request.optima = *seed_of(text); },
         "count all ties, and list the first N; without it all are listed")
      ->check(check_optima)
      ->type_name("N");
}

/// The command of this name in the table.
CLI::App& add_command(CLI::App& app, std::string_view name) {
  const auto help =
      std::find_if(std::begin(command_table), std::end(command_table), [name](const CommandHelp& c) { return c.name == name; });
  CLI::App& command = *app.add_subcommand(std::string(name), std::string(help->summary));
  command.get_help_ptr()->description(help_meaning);
  return command;
}

/// The commands that answer by rays: approx, ray, metric.
std::array<CLI::App*, 3> add_ray_commands(CLI::App& app, Request& request, Texts& texts) {
  CLI::App& approx = add_command(app, "approx");
  CLI::App& ray = add_command(app, "ray");
  CLI::App& metric = add_command(app, "metric");
  add_approx_options(approx, request);
  add_ray_options(ray, request);
  add_metric_options(metric, request);
  for (CLI::App* command : {&approx, &ray, &metric}) {
    add_questions(*command, request, texts);
    add_exact(*command, request);
  }
  for (CLI::App* command : {&approx, &ray}) {
    command->add_option("--digits", request.digits, "add an enclosure of the length to N significant digits")
        ->check(check_digits)
        ->type_name("N");
  }
  return {&approx, &ray, &metric};
}

}  // namespace

Parser::Parser() {
  app.get_help_ptr()->description(help_meaning);
  app.set_version_flag("-V,--version", "", "the version, with the commit, that of the golden data, and the licence");
  app.require_subcommand(0, 1);  // so that a file may be called "width"
  CLI::App &depth = add_command(app, "depth"), &width = add_command(app, "width");
  add_options(depth, request, texts, false);
  add_optima(depth, request);
  add_along_options(depth, request);
  add_pieces_option(depth, request, ". With --json one object, schema fathom/union/1");
  add_case(depth, request);
  add_options(width, request, texts, true);
  add_delta(width, request, "approximate within a factor of 1 + DELTA, by rays");
  const auto [approx, ray, metric] = add_ray_commands(app, request, texts);
  CLI::App &study = add_command(app, "study"), &stages = add_command(app, "stages");
  add_study_options(study, request, texts);
  add_stages_options(stages, request, texts);
  CLI::App& explain = add_command(app, "explain");
  add_explain_options(explain, request, texts);
  CLI::App &cases = add_command(app, "cases"), &certify = add_command(app, "certify");
  add_certify_options(certify, request);
  add_input(certify, request, "first");
  add_cases_options(cases, request.cases);
  add_inputs(cases, request, texts);
  add_poses(cases, request, false);
  commands = {&depth, &width, approx, ray, metric, &study, &stages, &explain, &cases, &certify};
}

CLI::App* Parser::asked() const {
  const auto found = std::ranges::find_if(commands, [](const CLI::App* command) { return command->parsed(); });
  return found == commands.end() ? nullptr : *found;
}

}  // namespace fathom::cli
