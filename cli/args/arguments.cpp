// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/args/arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

#include "cli/args/given.hpp"
#include "cli/args/help.hpp"
#include "cli/args/help_page.hpp"
#include "cli/args/values.hpp"
#include "cli/args/words.hpp"
#include "cli/io/terminal.hpp"
#include "kernels/messages.hpp"
#include "reference/files/file_io.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/solve/disagreement.hpp"
#include "verify/golden/shards/plan.hpp"
#include "verify/harness/variants.hpp"
#include "verify/judge/words.hpp"

namespace fathom::cli {

extern const char* const built_commit;  ///< "" if the sources are at none: CMake writes it into a file of its own

namespace {

// ---- words that name no command ----

/// Returns whether the name is that of a mesh. Other names may be streams of cases.
bool is_mesh_name(const std::string& path) {
  constexpr std::string_view meshes[] = {"off", "obj", "ply", "stl", "xyz", "pts"};
  return std::find(std::begin(meshes), std::end(meshes), files::extension(path)) != std::end(meshes);
}

/// Returns whether the word names bodies or cases.
bool is_input(const std::string& word) {
  const std::string kind = files::extension(word);
  std::error_code fault;
  return word == "-" || is_mesh_name(word) || kind == "jsonl" || kind == "ndjson" || kind == "json" ||
         files::is_shape_text(word) || std::filesystem::is_regular_file(word, fault);
}

/// Returns the line that is probably meant if there are inputs and no command, as "; did you mean
/// 'fathom depth a.obj b.obj'?", or "".
std::string line_with_command(const std::vector<std::string>& words) {
  std::vector<std::string> inputs;
  std::copy_if(words.begin(), words.end(), std::back_inserter(inputs), is_input);
  if (inputs.empty()) return "";
  const bool one_body = inputs.size() == 1 && (is_mesh_name(inputs[0]) || files::is_shape_text(inputs[0]));
  return fmt::format("; did you mean: fathom {} {}", one_body ? "width" : "depth", shell_line(words));
}

/// Returns a sentence if the first word is no command, or "".
std::string wrong_command(const std::vector<std::string>& words) {
  const std::string& command = words[0];
  const std::vector<std::string> names = command_names();
  if (command.starts_with('-') || std::ranges::find(names, command) != names.end()) return "";
  if (const std::string line = is_input(command) ? line_with_command(words) : ""; !line.empty())
    return fmt::format("expected a command, found the input {}{}", kernels::shown(command), line);
  return fmt::format("unknown command {} (expected {}){}", kernels::shown(command), fmt::join(names, ", "),
                     did_you_mean(command, names));
}

Arguments refusal(const std::string& sentence, const std::string& command = "") {
  return {std::nullopt, fmt::format("{}\nTry: fathom {}--help", sentence, command.empty() ? "" : command + " "),
          bad_input};
}

Arguments no_command() {
  return refusal(fmt::format("expected a command: {}\nFor example: {}", fmt::join(command_names(), ", "),
                             general_examples[0].line));
}

std::string version_text() {
  const std::string commit = *built_commit ? fmt::format("commit {}\n", built_commit) : "";
  return fmt::format("fathom {}\n{}golden data {}\nlicence GPL-3.0-or-later", FATHOM_VERSION, commit,
                     golden::data_version);
}

// ---- the requests ----

/// The engine of this name.
ClosestLines engine_of(const std::string& name) {
  return static_cast<ClosestLines>(std::ranges::find(engine_names, name) - engine_names.begin());
}

template <class Count>
std::optional<Count> count_of(const Given& given, std::string_view option) {
  const std::optional<std::string> text = given.value(option);
  return text ? std::optional(static_cast<Count>(typed_integer(*text).value())) : std::nullopt;
}

/// A number as certify takes it.
std::optional<mpq_class> number_of(const Given& given, std::string_view option) {
  const std::optional<std::string> text = given.value(option);
  return text ? parse_number(*text, Decimals::exact).value : std::nullopt;
}

CasesRequest cases_of(const Given& given) {
  using What = CasesRequest::What;
  CasesRequest cases;
  for (const auto& [option, what] : {std::pair("--family", What::family),
                                     {"--catalogue", What::catalogue},
                                     {"--list", What::list},
                                     {"--from", What::from},
                                     {"--from-fcl", What::from_fcl}})
    if (given.has(option)) cases.what = what;
  cases.families = given.words("--family");
  cases.shapes = given.flag("--shapes");
  cases.unions = given.flag("--unions");
  cases.count = count_of<std::uint64_t>(given, "--count").value_or(cases.count);
  cases.seed = count_of<std::uint64_t>(given, "--seed").value_or(cases.seed);
  cases.size = count_of<unsigned>(given, "--size");
  cases.fcl = given.text("--from-fcl");
  return cases;
}

CertifyRequest certify_of(const Given& given) {
  CertifyRequest certify;
  certify.subject = given.text("--subject");
  certify.adapter = given.text("--adapter");
  certify.replay = given.text("--replay");
  certify.claims = given.text("--claims");
  certify.list_adapters = given.flag("--list-adapters");
  if (const auto jobs = given.value("--jobs")) certify.jobs = typed_threads(*jobs);
  if (const auto time = number_of(given, "--time-out")) certify.time_out = round_binary64(*time, Rounding::ru);
  certify.tolerance.relative = number_of(given, "--tol-rel").value_or(certify.tolerance.relative);
  certify.tolerance.absolute = number_of(given, "--tol-abs").value_or(certify.tolerance.absolute);
  if (const auto ulps = count_of<std::size_t>(given, "--tol-ulps")) certify.tolerance.ulps = *ulps;
  certify.fit = number_of(given, "--fit");
  if (const auto policy = given.value("--policy")) certify.tolerance.policy = judging::policy_of(*policy).value();
  certify.methods = second_methods(given);
  certify.report = given.text("--report");
  certify.resume = given.flag("--resume");
  certify.overwrite = given.flag("--overwrite");
  certify.all_rows = given.flag("--all-rows");
  certify.metamorphic = given.text("--metamorphic");
  if (certify.metamorphic == "all")
    certify.variants.assign(std::begin(harness::variant_names), std::end(harness::variant_names));
  else if (!certify.metamorphic.empty()) certify.variants = words_of(certify.metamorphic);
  certify.expect_fail = given.text("--expect-fail");
  certify.write_expect_fail = given.text("--write-expect-fail");
  certify.max_errors = count_of<std::size_t>(given, "--max-errors");
  certify.junit = given.text("--junit");
  certify.html = given.text("--html");
  certify.certificates = given.text("--certificates");
  certify.shrink = given.text("--shrink");
  certify.harness = given.text("--harness");
  certify.print_input = given.text("--print-input");
  return certify;
}

constexpr const char *usual_sizes = "10..1000", *usual_delta = "1/100";

Request request_of(const Given& given) {
  Request request;
  const std::vector<std::string> names = command_names();
  request.command = static_cast<Command>(std::ranges::find(names, given.command) - names.begin());
  request.inputs = given.inputs();
  const std::string method = given.text("--method"), engine = given.text("--closest-lines");
  if (request.command == Command::certify) request.certify = certify_of(given);
  if (request.command == Command::cases) request.cases = cases_of(given);
  if (method == "exact") request.method = Method::exact;
  if (method == "naive") request.method = Method::naive;
  request.shallow = method == "shallow";
  request.sweep.family = given.text("--sweep");
  if (request.command == Command::study)
    for (const std::string& name : given.words("--closest-lines")) request.sweep.engines.push_back(engine_of(name));
  else if (!engine.empty()) request.closest_lines = engine_of(engine);
  if (!request.sweep.family.empty())
    request.sweep.sizes = typed_sizes(given.value("--sizes").value_or(usual_sizes)).value();
  request.seed = count_of<std::uint64_t>(given, "--seed").value_or(request.seed);
  request.optima = count_of<std::size_t>(given, "--optima");
  request.digits = count_of<unsigned>(given, "--digits");
  request.bits = count_of<unsigned>(given, "--bits");
  request.exact = given.flag("--exact");
  request.json = given.flag("--json");
  request.csv = given.flag("--csv");
  request.html = request.command == Command::study ? given.text("--html") : "";
  request.all = given.flag("--all");
  request.times = given.flag("--times");
  request.counters = given.flag("--counters");
  if (const auto threads = given.value("--threads")) request.threads = typed_threads(*threads);
  request.certificate = given.text("--certificate");
  request.embed_certificate = given.flag("--embed-certificate");
  request.svg = given.text("--svg");
  if (const auto delta = given.value("--delta")) request.delta = typed_number(*delta);
  else if (request.command == Command::approx) request.delta = typed_number(usual_delta);
  if (const auto direction = given.value("--direction")) request.direction = typed_vector(*direction);
  request.ball = given.text("--ball");
  request.pose_a = given.value("--pose-a");
  request.pose_b = given.value("--pose-b");
  request.require_convex = given.flag("--require-convex");
  request.case_id = given.value("--case");
  request.page = given.text("--output");
  if (const auto path = given.value("--along")) request.along.translation = typed_vector(*path);
  request.along.steps = count_of<std::uint32_t>(given, "--steps").value_or(request.along.steps);
  request.pieces = given.flag("--pieces");
  request.decimals = given.flag("--exact-decimals") ? Decimals::exact : Decimals::binary64;
  return request;
}

// ---- what does not go together: sentences, or "" ----

std::string wrong_cases(const Given& given, const CasesRequest& cases, std::size_t inputs) {
  using What = CasesRequest::What;
  const auto wanted = std::ranges::count_if(std::array{"--family", "--catalogue", "--list", "--from", "--from-fcl"},
                                            [&](const char* option) { return given.has(option); });
  if (wanted != 1)
    return fmt::format("cases expects one of --family, --catalogue, --list, --from and --from-fcl, found {}",
                       wanted == 0 ? "none" : "several");
  for (const char* option : {"--count", "--seed", "--size"})
    if (cases.what != What::family && given.has(option)) return fmt::format("{} goes with --family", option);
  const bool of_many = cases.what == What::catalogue || cases.what == What::list ||
                       (cases.what == What::family && cases.families == std::vector<std::string>{"all"});
  for (const auto& [option, asked] : {std::pair("--shapes", cases.shapes), std::pair("--unions", cases.unions)})
    if (asked && !of_many) return fmt::format("{} goes with --list, --catalogue and --family all", option);
  if (cases.shapes && cases.unions) return "--shapes and --unions are two kinds of bodies: ask for one after the other";
  for (const char* option : {"--pose-a", "--pose-b", "--exact-decimals"})
    if (cases.what != What::from && given.has(option)) return fmt::format("{} goes with --from", option);
  if (inputs == (cases.what == What::from ? 2 : 0)) return "";
  return fmt::format("cases expects two meshes after --from and no input otherwise, found {} argument{}", inputs,
                     inputs == 1 ? "" : "s");
}

std::string wrong_variants(const CertifyRequest& certify) {
  for (const std::string& word : certify.variants)
    if (std::ranges::find(harness::variant_names, word) == std::end(harness::variant_names))
      return fmt::format("--metamorphic: {} is unknown (expected {}, with commas between them)", kernels::shown(word),
                         fmt::join(harness::variant_names, ", "));
  return "";
}

std::string wrong_certify(const CertifyRequest& certify, const std::vector<std::string>& inputs) {
  const auto given = [](const std::string& text) { return text.empty() ? 0U : 1U; };
  const std::size_t subjects = given(certify.subject) + given(certify.adapter) + given(certify.replay);
  if (certify.list_adapters)
    return subjects + inputs.size() == 0 ? "" : "--list-adapters only prints a list, and takes no subject and no cases";
  if (!certify.claims.empty())
    return subjects + inputs.size() == 0 ? "" : "--claims judges a file, and takes no subject and no cases";
  if (subjects != 1)
    return fmt::format("certify expects one of --subject, --adapter and --replay, found {} of them", subjects);
  if (inputs.size() != 1)
    return fmt::format(
        "certify expects one stream of cases (a JSON Lines file, or - for standard input), found {} argument{}",
        inputs.size(), inputs.size() == 1 ? "" : "s");
  if (certify.resume && certify.report.empty()) return "--resume goes on with a report, and needs --report";
  if (certify.overwrite && certify.report.empty()) return "--overwrite replaces a report, and needs --report";
  if (certify.overwrite && certify.resume)
    return "--resume goes on with the report that --overwrite replaces: one of them";
  if (!certify.harness.empty() && certify.shrink.empty())
    return "--harness is filled with what --shrink finds, and needs --shrink";
  if (!certify.print_input.empty() && !certify.replay.empty())
    return "--print-input shows what a subject reads, and a replay reads nothing";
  if (certify.replay == "-" && inputs[0] == "-") return "--replay - and the cases cannot both come from standard input";
  if (certify.report == "-") return "--report writes a file; --json writes to standard output";
  if (!certify.replay.empty() && !certify.metamorphic.empty())
    return "--metamorphic puts new cases to a subject, and a replay answers none";
  if (!certify.replay.empty() && !certify.shrink.empty())
    return "--shrink puts new cases to a subject, and a replay answers none";
  return wrong_variants(certify);
}

std::string wrong_inputs(const Given& given, const Request& request) {
  const std::vector<std::string>& inputs = request.inputs;
  if (request.command == Command::cases) return wrong_cases(given, request.cases, inputs.size());
  if (!request.sweep.family.empty()) return "";
  if (request.command == Command::certify) return wrong_certify(request.certify, inputs);
  const std::string found = fmt::format("found {} argument{}", inputs.size(), inputs.size() == 1 ? "" : "s");
  if (request.command == Command::width)
    return inputs.size() == 1
               ? ""
               : "width expects one mesh, or one stream of cases (a .jsonl file, or - for standard input), " + found;
  const std::string expected =
      given.command + " expects two meshes, or one stream of cases (a JSON Lines file, or - for standard input), ";
  if (inputs.empty()) return expected + found;
  if (inputs.size() == 1 && is_mesh_name(inputs[0]))
    return expected + "found the single mesh " + kernels::shown(inputs[0]);
  if (inputs.size() == 1 && files::is_shape_text(inputs[0]))
    return expected + "found the single shape " + kernels::shown(inputs[0]);
  if (inputs.size() == 2 && (inputs[0] == "-" || inputs[1] == "-")) return expected + "found - beside another input";
  return "";
}

std::string wrong_pieces(const Given& given, const Request& request) {
  for (const char* option : {"--method", "--closest-lines", "--seed", "--bits", "--optima", "--along", "--steps",
                             "--times", "--csv", "--case", "--threads"})
    if (given.has(option)) return fmt::format("--pieces is about unions, and cannot be combined with {}", option);
  if (request.inputs.size() != 2)
    return "--pieces expects two bodies: OBJ files, folders of meshes, meshes or shapes, found one input";
  return "";
}

std::string wrong_along(const Given& given, const Request& request) {
  if (!request.along.translation) {
    for (const char* option : {"--steps", "--csv"})
      if (given.has(option)) return fmt::format("{} goes with --along X,Y,Z", option);
    return "";
  }
  for (const char* option :
       {"--optima", "--digits", "--certificate", "--embed-certificate", "--exact", "--counters", "--threads"})
    if (given.has(option))
      return fmt::format("--along answers with a curve of signed depths, and cannot be combined with {}", option);
  if (request.shallow)
    return "--along answers for bodies that are apart too, and cannot be combined with --method shallow";
  return "";
}

std::string wrong_sweep(const Given& given, const Request& request) {
  if (!given.has("--sweep")) {
    for (const char* option : {"--sizes", "--closest-lines", "--times", "--svg", "--seed"})
      if (given.has(option)) return fmt::format("{} goes with --sweep FAMILY", option);
    return "";
  }
  if (!request.inputs.empty()) return "--sweep makes its bodies itself, found " + kernels::shown(request.inputs[0]);
  for (const char* option : {"--json", "--html", "--case", "--all", "--pose-a", "--pose-b", "--require-convex",
                             "--exact-decimals", "--threads"})
    if (given.has(option))
      return fmt::format("--sweep answers as a table, with --csv and --svg, and cannot be combined with {}", option);
  return "";
}

/// Of a request for a curve or a chart.
std::string wrong_picture(const Given& given, const Request& request) {
  if (request.svg == "-") return "--svg writes a file, found - for standard output";
  if (request.pieces) return wrong_pieces(given, request);
  if (request.command == Command::depth) return wrong_along(given, request);
  return request.command == Command::study ? wrong_sweep(given, request) : "";
}

std::string wrong_page(const Request& request) {
  if (request.command != Command::explain) return "";
  if (request.page.empty()) return "explain writes a page: expected -o FILE, with the name of an HTML file";
  if (request.page == "-") return "-o writes a file, found - for standard output";
  return "";
}

std::string wrong_approximation(const Request& request, bool asks_exact) {
  if (request.command == Command::ray && !request.direction) return "ray expects --direction X,Y,Z: where A is to move";
  if (request.command == Command::metric && request.ball.empty())
    return "metric expects --ball Q: a mesh, the unit ball";
  if (request.command != Command::width || !request.delta) return "";
  if (asks_exact)
    return "--delta asks for an approximation, and cannot be combined with --method, --closest-lines or a certificate";
  if (request.counters)
    return "--delta asks for an approximation, which has no counters: it cannot be combined with --counters";
  if (request.bits)
    return "--delta asks for an approximation by rays, and cannot be combined with --bits, which is about bounds";
  return "";
}

/// The first thing that is wrong with the request, or "".
std::string wrong_request(const Given& given, const Request& request) {
  const bool stream = request.inputs.size() == 1 && !request.case_id;  // of width both are possible: it has one output
  if (std::string fault = wrong_inputs(given, request); !fault.empty()) return fault;
  if (std::string fault = wrong_picture(given, request); !fault.empty()) return fault;
  if (std::string fault = wrong_files(given, stream); !fault.empty()) return fault;
  if (request.case_id && request.inputs.size() == 2) return "--case chooses a case of a stream, found two bodies";
  const std::string method = given.command == "certify" ? "auto" : given.value("--method").value_or("auto");
  if (request.closest_lines && method != "auto" && method != "exact")
    return "--closest-lines chooses the engine of --method exact, and cannot be combined with --method " + method;
  if (request.embed_certificate && !request.json)
    return "--embed-certificate adds a field to JSON results, and needs --json";
  if (request.certificate == "-")
    return "--certificate writes files; --json --embed-certificate writes to standard output";
  if (request.html == "-") return "--html writes a file; standard output has the answers";
  if (std::string fault = wrong_page(request); !fault.empty()) return fault;
  const bool asks_exact =
      method != "auto" || request.closest_lines || !request.certificate.empty() || request.embed_certificate;
  if (std::string fault = wrong_approximation(request, asks_exact); !fault.empty()) return fault;
  if (request.exact && request.json)
    return "--exact is about text: JSON has every number exactly, and rounded beside it";
  if (request.csv && request.json) return "--csv and --json are two forms of one answer: choose one";
  if (request.csv && request.all)
    return "--all lists coincidences, and cannot be combined with --csv, which counts them";
  return "";
}

}  // namespace

std::vector<Method> second_methods(const Given& given) {
  std::vector<Method> methods;
  for (const std::string& word : given.words("--method")) {
    const Method method = solve::second_method(word).value();
    if (std::ranges::find(methods, method) == methods.end()) methods.push_back(method);
  }
  return methods;
}

Arguments parse_arguments(int argc, const char* const* argv) {
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (words.empty()) return no_command();
  if (const std::string fault = wrong_command(words); !fault.empty()) return refusal(fault);
  if (const std::string fault = missing_value(words); !fault.empty()) return refusal(fault);
  const Given given = read_words("", common_options(), words);
  switch (given.kind) {
    case Given::Kind::help:
      return {std::nullopt, help_text(page_of(given.command, common_options()), help_columns(STDOUT_FILENO)), fine};
    case Given::Kind::version: return {std::nullopt, version_text(), fine};
    case Given::Kind::refused:
      return refusal(given.fault + (given.command.empty() ? line_with_command(words) : ""), given.command);
    case Given::Kind::request: break;
  }
  if (given.command.empty()) return no_command();
  if (const std::string fault = empty_value(given); !fault.empty()) return refusal(fault, given.command);
  Request request = request_of(given);
  if (request.command == Command::certify) request.certify.command_line = command_line(argc, argv);
  if (!request.html.empty()) request.command_line = command_line(argc, argv);
  if (const std::string fault = wrong_request(given, request); !fault.empty()) return refusal(fault, given.command);
  return {std::move(request), "", fine};
}

}  // namespace fathom::cli
