// SPDX-License-Identifier: Apache-2.0
#include "command_line.hpp"

#include <gmp.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <string_view>

#include "run.hpp"
#include "text.hpp"

namespace fathom_check {
namespace {

constexpr int usage_error = 2;

// In lines of 80 columns.
constexpr std::string_view about =
    " [OPTIONS] FILE...\n"
    "Checks certificates of how deep two bodies lie in each other, and of convex\n"
    "pieces that tile a mesh, exactly; - is standard input. The format and what\n"
    "acceptance proves: FORMAT.md.\n"
    "\n";
constexpr std::string_view answers =
    "\n"
    "One line per certificate: s VERIFIED, s REFUSED or s MALFORMED.\n"
    "Exit codes: 0 all were accepted, and there was one; 1 some were refused; 2 some\n"
    "were malformed, cut off or unreadable, or the input was empty, or usage. The\n"
    "largest counts.\n";

std::string help() {
  constexpr std::size_t column = 20;
  std::string text(about);
  for (const OptionText& option : option_texts) {
    std::string line = "  " + std::string(option.name) + (option.value.empty() ? "" : " ") + std::string(option.value);
    line.resize(column, ' ');
    for (const char c : option.meaning) line += c == '\n' ? "\n" + std::string(column, ' ') : std::string(1, c);
    text += line + '\n';
  }
  return text += answers;
}

// GMP would abort where memory ends; the answer "not accepted" is due instead.
[[noreturn]] void out_of_memory() {
  constexpr std::string_view text = "out of memory\n";
  if (write(STDERR_FILENO, text.data(), text.size()) < 0) _exit(usage_error);
  _exit(usage_error);
}
void* allocate(std::size_t size) {
  void* const memory = std::malloc(size);
  if (!memory) out_of_memory();
  return memory;
}
void* reallocate(void* old, std::size_t, std::size_t size) {
  void* const memory = std::realloc(old, size);
  if (!memory) out_of_memory();
  return memory;
}
void release(void* memory, std::size_t) { std::free(memory); }

/// What the words ask for; or a sentence on what is wrong with them, empty if help is wanted.
struct Request {
  Options options;
  bool understood = false;
  std::string sentence;
};

Request understand(const std::vector<std::string>& words) {
  Request request;
  bool only_files = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (only_files || word == "-" || word.empty() || word[0] != '-') {
      request.options.inputs.push_back({word, false});
    } else if (word == "--") {
      only_files = true;
    } else if (word == "--help" || word == "-h") {
      request.sentence.clear();
      return request;
    } else if (word == "--echo") {
      request.options.echo = true;
    } else if (word == "--width") {
      request.options.width = true;
    } else if (word != "--case" && word != "--results") {
      request.sentence = "unknown option " + shown(word);
      return request;
    } else if (++i == words.size()) {
      request.sentence = word + " expects a file";
      return request;
    } else if (word == "--results") {
      request.options.inputs.push_back({words[i], true});
    } else if (request.options.cases) {
      request.sentence = "--case is given twice";
      return request;
    } else {
      request.options.cases = words[i];
    }
  }
  request.understood = !request.options.inputs.empty();
  if (!request.understood) request.sentence = "expected certificates: files, or - for standard input";
  return request;
}

int run_words(const std::vector<std::string>& words, const std::string& program, SecondChecker* second,
              Workers* workers) {
  Request request = understand(words);
  request.options.second = second;
  request.options.workers = workers;
  if (request.understood) return run(request.options, std::cin, std::cout, std::cerr);
  if (request.sentence.empty()) {
    std::cout << "Usage: " << program << help() << std::flush;
    return std::cout ? 0 : usage_error;
  }
  std::cerr << program << ": " << request.sentence << "\nTry: " << program << " --help\n";
  return usage_error;
}

}  // namespace

int command_line(const std::vector<std::string>& words, const std::string& program, SecondChecker* second,
                 Workers* workers) noexcept {
  mp_set_memory_functions(allocate, reallocate, release);
  std::ios::sync_with_stdio(false);
  try {
    return run_words(words, program, second, workers);
  } catch (const std::exception& error) {
    std::cerr << program << ": " << error.what() << '\n';
  } catch (...) {
    std::cerr << program << ": failed\n";
  }
  return usage_error;
}

}  // namespace fathom_check
