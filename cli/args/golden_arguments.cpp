// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/args/golden_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <tuple>

#include "cli/args/examples_first.hpp"
#include "cli/args/export_arguments.hpp"
#include "cli/args/golden_help.hpp"
#include "cli/args/second_method.hpp"
#include "cli/args/threads.hpp"
#include "kernels/printable.hpp"

namespace fathom::cli {
namespace {

constexpr std::uint64_t most_parts = 1'000'000;

/// An integer in plain digits.
std::optional<std::uint64_t> integer(std::string_view text, std::uint64_t low, std::uint64_t high) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool good = error == std::errc() && end == text.data() + text.size() && value >= low && value <= high;
  return good ? std::optional(value) : std::nullopt;
}

CLI::Validator integer_from(std::uint64_t low, std::uint64_t high) {
  const auto check = [low, high](const std::string& text) -> std::string {
    const std::string highest = high == UINT64_MAX ? "2^64 - 1" : std::to_string(high);
    return integer(text, low, high) ? "" : fmt::format("expected an integer from {} to {}, found {}", low, highest, kernels::shown(text));
  };
  return CLI::Validator(check, "", "");
}

std::string check_level(const std::string& text) {
  return golden::find_level(text) ? "" : fmt::format("expected L0, L1, L2, L3, P0 or P1, found {}", kernels::shown(text));
}

/// "i/n".
std::optional<std::pair<std::size_t, std::size_t>> part_of(std::string_view text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto parts = integer(text.substr(std::min(slash + 1, text.size())), 1, most_parts);
  const auto part = parts ? integer(text.substr(0, slash), 1, *parts) : std::nullopt;
  return part ? std::optional(std::pair<std::size_t, std::size_t>(*part, *parts)) : std::nullopt;
}

std::string check_part(const std::string& text) {
  return part_of(text) ? "" : fmt::format("expected i/n with 1 <= i <= n, found {}", kernels::shown(text));
}

void add_jobs(CLI::App& app, GoldenRequest& request) {
  app.add_option_function<std::string>(
         "--jobs", [&request](const std::string& text) { request.jobs = *threads_of(text); },
         "threads; as many as there are cores unless given")
      ->check(check_threads)
      ->type_name("N");
}

void add_generate_options(CLI::App& app, GoldenRequest& request) {
  app.add_option_function<std::string>(
         "--level", [&request](const std::string& text) { request.level = *golden::find_level(text); },
         "L0, L1, L2 or L3, of polytopes: hundreds of records, about ten thousand,\nover a hundred thousand, about ten million; P0 or P1, "
         "of shapes: about a\nthousand, about ten thousand; each holds the shards of those below it")
      ->check(check_level)
      ->type_name("LEVEL")
      ->required();
  app.add_option_function<std::string>(
         "--seed", [&request](const std::string& text) { request.seed = *integer(text, 0, UINT64_MAX); }, "of the families; 1 unless given")
      ->check(integer_from(0, UINT64_MAX))
      ->type_name("N");
  app.add_option_function<std::string>(
         "--out", [&request](const std::string& text) { request.folder = text; }, "the folder, made if need be")
      ->type_name("DIR")
      ->required();
  app.add_option_function<std::string>(
         "--shard",
         [&request](const std::string& text) {
           std::tie(request.part, request.parts) = *part_of(text);
           request.is_part = true;
         },
         "make every n-th shard only, from the i-th on, and leave it to a last run\nwithout --shard to complete the release")
      ->check(check_part)
      ->type_name("I/N");
  add_jobs(app, request);
}

void add_folder(CLI::App& app, GoldenRequest& request) {
  app.add_option_function<std::string>("folder", [&request](const std::string& path) { request.folder = path; });
}

void add_verify_options(CLI::App& app, GoldenRequest& request) {
  add_folder(app, request);
  add_second_method(app, request.methods,
                    "compute every record again by exact (AGHRS's pipeline) or naive (the hull\nof all vertex differences) too, and "
                    "compare every field; may be repeated");
  app.add_flag("--state", request.state, "once all agree, write agreement.json into the folder, which says so");
  add_jobs(app, request);
}

CLI::App& add_command(CLI::App& app, std::string name, std::string description, std::string_view examples, std::string_view synopsis) {
  CLI::App& command = *app.add_subcommand(std::move(name), std::move(description));
  command.formatter(std::make_shared<ExamplesFirst>(examples, synopsis));
  command.footer(std::string(golden_footer));
  command.get_help_ptr()->description("this text");
  return command;
}

GoldenArguments refusal(const std::string& sentence, const std::string& command = "") {
  return {std::nullopt, fmt::format("{}\nTry: fathom golden {}--help", sentence, command.empty() ? "" : command + " "), bad_input};
}

}  // namespace

GoldenArguments parse_golden(const std::vector<std::string>& words) {
  GoldenRequest request;
  CLI::App app("Golden test data: make a release, prove one, or export some of it.", "fathom golden");
  app.formatter(std::make_shared<ExamplesFirst>(golden_examples, "fathom golden generate|verify|export [OPTIONS]"));
  app.get_help_ptr()->description("this text");
  app.footer(std::string(golden_footer));
  app.require_subcommand(0, 1);
  CLI::App& generate = add_command(app, "generate", "Make a release, or go on with one.", generate_examples,
                                   "fathom golden generate --level LEVEL --out DIR [OPTIONS]");
  CLI::App& verify = add_command(app, "verify", "Prove a release, or refuse it.", verify_examples, "fathom golden verify DIR [OPTIONS]");
  CLI::App& exporting = add_command(app, "export", "Write some of a release as one file for other tests.", export_examples,
                                    "fathom golden export --format FORMAT DIR [OPTIONS]");
  add_generate_options(generate, request);
  add_verify_options(verify, request);
  add_folder(exporting, request);
  add_export_options(exporting, request.exported);

  const auto asked = [&]() -> CLI::App* {
    return generate.parsed() ? &generate : verify.parsed() ? &verify : exporting.parsed() ? &exporting : nullptr;
  };
  if (!words.empty() && words[0] != "generate" && words[0] != "verify" && words[0] != "export" && !words[0].starts_with('-'))
    return refusal(fmt::format("unknown task {} of golden (expected generate, verify, export)", kernels::shown(words[0])));
  if (const std::string fault = missing_value(words); !fault.empty()) return refusal(fault);
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::CallForHelp&) {
    return {std::nullopt, (asked() ? asked() : &app)->help(), fine};
  } catch (const CLI::ParseError& error) {
    return refusal(sentence(error), asked() ? asked()->get_name() : "");
  }
  if (!asked()) return refusal("golden expects a task: generate, verify, export");
  if (request.folder.empty())
    return refusal(generate.parsed() ? "--out expects a folder" : asked()->get_name() + " expects a folder", asked()->get_name());
  if (request.state && request.methods.empty()) return refusal("--state says which methods agreed, and needs --method", "verify");
  request.what = generate.parsed() ? GoldenRequest::What::generate
                 : verify.parsed() ? GoldenRequest::What::verify
                                   : GoldenRequest::What::exporting;
  return {request, "", fine};
}

}  // namespace fathom::cli
