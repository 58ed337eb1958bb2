// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/args/arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <memory>

#include "cli/args/approx_arguments.hpp"
#include "cli/args/cases_arguments.hpp"
#include "cli/args/certify_arguments.hpp"
#include "cli/args/examples_first.hpp"
#include "cli/args/help.hpp"
#include "cli/args/shell_words.hpp"
#include "cli/args/threads.hpp"
#include "fathom/numbers.hpp"
#include "fathom/signed_depth.hpp"
#include "kernels/printable.hpp"
#include "reference/files/shape_text.hpp"
#include "reference/files/source.hpp"

namespace fathom::cli {
namespace {

/// A value that must be one of `here`; those in `absent` are known but not part of this version.
CLI::Validator one_of(std::vector<std::string> here, std::vector<std::string> absent) {
  const auto check = [here, absent](const std::string& value) -> std::string {
    if (std::find(here.begin(), here.end(), value) != here.end()) return "";
    const bool known = std::find(absent.begin(), absent.end(), value) != absent.end();
    return fmt::format("{} is {} (expected {})", kernels::shown(value), known ? "not part of this version" : "unknown",
                       fmt::join(here, ", "));
  };
  return CLI::Validator(check, "", "");
}

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

/// The values of the options, before it is checked whether they go together.
struct Texts {
  std::string method = "auto", closest_lines;
  bool exact_decimals = false;
  std::string schema;       ///< empty unless given
  std::string wrong_cases;  ///< what does not go together in `cases`
};

void add_input(CLI::App& app, Request& request, const char* place) {
  app.add_option_function<std::string>(place, [&request](const std::string& path) { request.inputs.push_back(path); });
}

void add_inputs(CLI::App& app, Request& request, Texts& texts) {
  // One by one: into a vector, CLI11 would take a file called "[x]" for a list.
  for (const char* place : {"first", "second"}) add_input(app, request, place);
  app.add_flag("--exact-decimals", texts.exact_decimals, "decimals in text meshes are exact, instead of the nearest binary64");
}

void add_poses(CLI::App& app, Request& request, bool of_one) {
  app.add_option(
         of_one ? "--pose-a,--pose" : "--pose-a", request.pose_a,
         "how A is placed, exactly: \"r11 r12 r13 t1; r21 ...; r31 ...\", 4 x 4\nnumbers, \"xyz=X,Y,Z quat=W,X,Y,Z\" (or xyzw=X,Y,Z,W, or\n"
         "rpy=ROLL,PITCH,YAWdeg or rad), or @FILE with one of these")
      ->type_name("POSE");
  if (!of_one) app.add_option("--pose-b", request.pose_b, "the same for B")->type_name("POSE");
}

void add_exact(CLI::App& app, Request& request) {
  app.add_flag("--exact", request.exact,
               "text: the exact numbers, as fractions in full and directions as\nintegers, where else the nearest decimals stand");
}

/// The inputs of a command that answers two meshes, or a stream.
void add_questions(CLI::App& app, Request& request, Texts& texts, bool of_one = false) {
  add_inputs(app, request, texts);
  add_poses(app, request, of_one);
  app.add_flag("--require-convex", request.require_convex,
               "a mesh with faces that is not convex is an error, exit code 2;\nelse its hull is taken, and the result says so");
  app.add_option_function<std::string>(
         "--threads", [&request](const std::string& text) { request.threads = threads_of(text); },
         "cases of a stream that are answered at once; as many as there are\ncores unless given. The output is the same with any number")
      ->check(check_threads)
      ->type_name("N");
}

void add_study_options(CLI::App& app, Request& request, Texts& texts) {
  add_questions(app, request, texts);
  app.add_flag("--all", request.all, "list every coincidence, not the first 20 of a kind (in tables: the first)");
  app.add_flag("--json", request.json, "one JSON object per line, schema fathom/study/1");
  app.add_flag("--csv", request.csv, "a header, then one row of counts per case");
}

void add_schema(CLI::App& app, Request& request, Texts& texts) {
  app.add_option_function<std::string>(
         "--schema",
         [&](const std::string& text) {
           texts.schema = text;
           request.schema = text == "1" ? 1 : newest_result_schema;
         },
         "the version of the schema of JSON results: 2, or 1 for programs that\nread that one, without the fields that came later")
      ->check(one_of({"1", "2"}, {}))
      ->type_name("VERSION");
}

void add_options(CLI::App& app, Request& request, Texts& texts, bool of_one) {
  app.add_option("--method", texts.method,
                 "how: auto, exact, certificate (an expanding polytope; exact where\nthat takes too many points), shallow (the part of B - "
                 "A near O: for\n"
                 "bodies that overlap a little), or naive (the hull of all vertex\ndifferences). auto is certificate; the result names the "
                 "one that ran")
      ->check(one_of({"auto", "exact", "certificate", "shallow", "naive"}, {}))
      ->type_name("NAME");
  app.add_option("--closest-lines", texts.closest_lines,
                 "engine inside the exact method: cutting (the default), sampled, or naive (all pairs of lines)")
      ->check(one_of({"cutting", "sampled", "naive"}, {}))
      ->type_name("NAME");
  app.add_option_function<std::string>(
         "--seed", [&request](const std::string& text) { request.seed = *seed_of(text); },
         "of the closest lines' random order, which changes the work and not the answer; 1 unless given")
      ->check(check_seed)
      ->type_name("N");
  app.add_option(
         "--digits", request.digits,
         "add an enclosure of the depth to N significant digits. Of curved\nbodies, bounds so near are looked for, unless --bits says "
         "how near")
      ->check(check_digits)
      ->type_name("N");
  app.add_option("--bits", request.bits,
                 "how near the bounds of curved bodies are to be: within 2^-K of the\nvalue, or of the bodies' extent; 40 unless given, at "
                 "most 1000")
      ->check(check_bits)
      ->type_name("K");
  add_questions(app, request, texts, of_one);
  app.add_option("--certificate", request.certificate,
                 "write the proof of the answer to FILE; for a stream: a directory, one\nfile for each case")
      ->type_name("FILE");
  app.add_flag("--embed-certificate", request.embed_certificate, "with --json: add the proof to each result");
  app.add_flag("--counters", request.counters, "add what the run did, in counts");
  add_exact(app, request);
  app.add_flag("--json", request.json, "one JSON object per line, schema fathom/result/2");
  add_schema(app, request, texts);
}

void add_optima(CLI::App& app, Request& request) {
  app.add_option_function<std::string>(
         "--optima", [&request](const std::string& text) { request.optima = *seed_of(text); },
         "count all ties, and list the first N; without it all are listed")
      ->check(check_optima)
      ->type_name("N");
}

CLI::App& add_command(CLI::App& app, std::string name, std::string description, std::string_view examples, std::string_view synopsis) {
  CLI::App& command = *app.add_subcommand(name, std::move(description));
  command.formatter(std::make_shared<ExamplesFirst>(examples, synopsis));
  command.footer(footer_text);
  command.get_help_ptr()->description("this text");
  return command;
}

/// The commands that answer by rays: approx, ray, metric.
std::array<CLI::App*, 3> add_ray_commands(CLI::App& app, Request& request, Texts& texts) {
  CLI::App& approx = add_command(app, "approx", "Depth of two bodies within a factor.", approx_examples,
                                 "fathom approx [--delta DELTA] [OPTIONS] A B | CASES.jsonl | -");
  CLI::App& ray = add_command(app, "ray", "Exact depth of two bodies in one direction.", ray_examples,
                              "fathom ray --direction X,Y,Z [OPTIONS] A B | CASES.jsonl | -");
  CLI::App& metric = add_command(app, "metric", "Exact depth in a polyhedral norm or gauge.", metric_examples,
                                 "fathom metric --ball Q [OPTIONS] A B | CASES.jsonl | -");
  add_approx_options(approx, request);
  add_schema(approx, request, texts);
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

/// Returns a sentence if the words ask for what this version does not have, which CLI11 would call unknown, or "".
std::string wrong_words(const std::vector<std::string>& words) {
  const std::string_view command = words[0];
  const bool known = command.starts_with('-') || std::find(std::begin(commands), std::end(commands), command) != std::end(commands);
  const bool absent = std::find(std::begin(absent_commands), std::end(absent_commands), command) != std::end(absent_commands);
  if (absent) return fmt::format("the command '{}' is not part of this version (expected {})", command, fmt::join(commands, ", "));
  if (!known) return fmt::format("unknown command {} (expected {})", kernels::shown(command), fmt::join(commands, ", "));
  return missing_value(words);
}

Arguments refusal(const std::string& sentence, const std::string& command = "") {
  return {std::nullopt, fmt::format("{}\nTry: fathom {}--help", sentence, command.empty() ? "" : command + " "), bad_input};
}

/// Returns whether the name is that of a mesh. Other names may be streams of cases.
bool is_mesh_name(const std::string& path) {
  constexpr std::string_view meshes[] = {"off", "obj", "ply", "stl", "xyz", "pts"};
  return std::find(std::begin(meshes), std::end(meshes), files::extension(path)) != std::end(meshes);
}

/// The name as the user typed it.
std::string name(Command command) { return std::string(commands[static_cast<std::size_t>(command)]); }

/// Returns what is wrong with the number of inputs, or "".
std::string wrong_inputs(Request& request, const Texts& texts) {
  if (request.command == Command::cases) return texts.wrong_cases;
  if (request.command == Command::certify) return wrong_certify(request.certify, request.inputs);
  const std::vector<std::string>& inputs = request.inputs;
  const std::string found = fmt::format("found {} argument{}", inputs.size(), inputs.size() == 1 ? "" : "s");
  if (request.command == Command::width)
    return inputs.size() == 1 ? "" : "width expects one mesh, or one stream of cases (a .jsonl file, or - for standard input), " + found;
  const std::string expected =
      name(request.command) + " expects two meshes, or one stream of cases (a JSON Lines file, or - for standard input), ";
  if (inputs.empty()) return expected + found;
  if (inputs.size() == 1 && is_mesh_name(inputs[0])) return expected + "found the single mesh " + kernels::shown(inputs[0]);
  if (inputs.size() == 1 && files::is_shape_text(inputs[0])) return expected + "found the single shape " + kernels::shown(inputs[0]);
  if (inputs.size() == 2 && (inputs[0] == "-" || inputs[1] == "-")) return expected + "found - beside another input";
  return "";
}

/// The request, unless its parts contradict each other.
Arguments completed(Request request, const Texts& texts) {
  const std::string command = name(request.command);
  if (const std::string fault = wrong_inputs(request, texts); !fault.empty()) return refusal(fault, command);
  if (!texts.closest_lines.empty() && texts.method != "auto" && texts.method != "exact")
    return refusal("--closest-lines chooses the engine of --method exact, and cannot be combined with --method " + texts.method, command);
  if (request.embed_certificate && !request.json)
    return refusal("--embed-certificate adds a field to JSON results, and needs --json", command);
  if (!texts.schema.empty() && !request.json) return refusal("--schema chooses the version of JSON results, and needs --json", command);
  if (request.certificate == "-")
    return refusal("--certificate writes files; --json --embed-certificate writes to standard output", command);
  const bool asks_exact =
      texts.method != "auto" || !texts.closest_lines.empty() || !request.certificate.empty() || request.embed_certificate;
  if (const std::string fault = wrong_approximation(request, asks_exact); !fault.empty()) return refusal(fault, command);
  if (request.exact && request.json) return refusal("--exact is about text: JSON has every number exactly, and rounded beside it", command);
  if (request.csv && request.json) return refusal("--csv and --json are two forms of one answer: choose one", command);
  if (request.csv && request.all) return refusal("--all lists coincidences, and cannot be combined with --csv, which counts them", command);
  request.decimals = texts.exact_decimals ? Decimals::exact : Decimals::binary64;
  if (texts.method == "exact") request.method = Method::exact;
  if (texts.method == "naive") request.method = Method::naive;
  request.shallow = texts.method == "shallow";
  if (texts.closest_lines == "cutting") request.closest_lines = ClosestLines::cutting;
  if (texts.closest_lines == "sampled") request.closest_lines = ClosestLines::sampled;
  if (texts.closest_lines == "naive") request.closest_lines = ClosestLines::naive;
  return {std::move(request), "", fine};
}

}  // namespace

Arguments parse_arguments(int argc, const char* const* argv) {
  Request request;
  Texts texts;
  CLI::App app("Exact penetration depth of two convex polytopes.", "fathom");
  app.formatter(std::make_shared<ExamplesFirst>(general_examples, "fathom COMMAND [OPTIONS] INPUT..."));
  app.get_help_ptr()->description("this text");
  app.set_version_flag("--version", "fathom " FATHOM_VERSION, "the version");
  app.require_subcommand(0, 1);  // so that a file may be called "width"
  app.footer(footer_text);
  CLI::App& depth =
      add_command(app, "depth", "Exact penetration depth of two bodies.", depth_examples, "fathom depth [OPTIONS] A B | CASES.jsonl | -");
  CLI::App& width = add_command(app, "width", "Exact width of one body.", width_examples, "fathom width [OPTIONS] A | CASES.jsonl | -");
  add_options(depth, request, texts, false);
  add_optima(depth, request);
  add_options(width, request, texts, true);
  add_delta(width, request, "approximate within a factor of 1 + DELTA, by rays");
  const auto [approx, ray, metric] = add_ray_commands(app, request, texts);
  CLI::App& study =
      add_command(app, "study", "What is degenerate about two bodies.", study_examples, "fathom study [OPTIONS] A B | CASES.jsonl | -");
  add_study_options(study, request, texts);
  CLI::App& cases = add_command(app, "cases", "Test cases by name, or from two meshes.", cases_examples,
                                "fathom cases --family NAME [OPTIONS] | --catalogue | --list | --from [OPTIONS] A B | --from-fcl FILE");
  CLI::App& certify = add_command(app, "certify", "Where another implementation is wrong, case by case.", certify_examples,
                                  "fathom certify --subject COMMAND | --adapter NAME | --replay REPLIES [OPTIONS] CASES.jsonl | -");
  add_certify_options(certify, request);
  add_input(certify, request, "first");
  // For the list alone: these have command lines of their own.
  app.add_subcommand("check", "Check certificates, independently.");
  app.add_subcommand("golden", "Golden test data: make a release, or prove one.");
  add_cases_options(cases, request.cases);
  add_inputs(cases, request, texts);
  add_poses(cases, request, false);
  const CLI::App* const apps[] = {&depth, &width, approx, ray, metric, &study, &cases, &certify};  // in the order of `commands`
  const auto asked = [&] { return std::find_if(std::begin(apps), std::end(apps), [](const CLI::App* a) { return a->parsed(); }); };

  if (argc < 2) return {std::nullopt, "expected a command\n\n" + app.help(), bad_input};
  if (const std::string fault = wrong_words({argv + 1, argv + argc}); !fault.empty()) return refusal(fault);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return {std::nullopt, (asked() == std::end(apps) ? &app : *asked())->help(), fine};
  } catch (const CLI::CallForVersion&) {
    return {std::nullopt, "fathom " FATHOM_VERSION, fine};
  } catch (const CLI::ParseError& error) {
    return refusal(sentence(error), asked() == std::end(apps) ? "" : (*asked())->get_name());
  }
  if (asked() == std::end(apps)) return refusal(fmt::format("expected a command: {}", fmt::join(commands, ", ")));
  request.command = static_cast<Command>(asked() - std::begin(apps));
  if (request.command == Command::certify) request.certify.command_line = command_line(argc, argv);
  if (const std::string fault = empty_value(**asked()); !fault.empty()) return refusal(fault, name(request.command));
  if (request.command == Command::cases) texts.wrong_cases = wrong_cases(cases, request.cases, request.inputs);
  return completed(std::move(request), texts);
}

}  // namespace fathom::cli
