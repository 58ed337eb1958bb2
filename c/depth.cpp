// SPDX-License-Identifier: GPL-3.0-or-later
// The question: how deep, or how far apart, two bodies are.
#include <string>
#include <string_view>

#include "c/boundary.hpp"
#include "reference/files/shape_names.hpp"

namespace fathom::c {
namespace {

Options options_of(const fathom_options& given, Monitor& monitor) {
  thread_local Workspace workspace;
  Options options;
  if (given.optima != 0) options.optima = given.optima;
  options.monitor = &monitor;
  options.workspace = &workspace;
  return options;
}

fathom_answer answer_about(const fathom_body& a, const fathom_body& b, const fathom_options& given) {
  CallersMonitor monitor(given);
  const Options options = options_of(given, monitor);
  if (a.body->pieces || b.body->pieces)
    return {a.body, b.body, union_depth(pieces_of(*a.body), pieces_of(*b.body), {&monitor}), options.optima};
  if (!a.body->shape && !b.body->shape) return {a.body, b.body, penetration_depth(*a.body, *b.body, options), options.optima};
  return {a.body, b.body, signed_depth(files::shape_of(*a.body), files::shape_of(*b.body), {.cores = options, .bits = given.bits}),
          options.optima};
}

}  // namespace

fathom_options options_from(const fathom_options* options) {
  fathom_options result;
  fathom_options_init(&result);
  if (options == nullptr) return result;
  require_struct(options, "options");
  if (options->bits > most_bound_bits)
    throw std::invalid_argument("options: expected at most " + std::to_string(most_bound_bits) + " bits, found " +
                                std::to_string(options->bits));
  return *options;
}

}  // namespace fathom::c

using namespace fathom::c;

void fathom_options_init(fathom_options* options) {
  if (options) *options = {sizeof(fathom_options), 0, fathom::SignedDepthOptions{}.bits, nullptr, nullptr};
}

int fathom_depth(const fathom_body* a, const fathom_body* b, const fathom_options* options, fathom_answer** answer) {
  return make_handle(answer, [&] {
    require(a, "a");
    require(b, "b");
    return answer_about(*a, *b, options_from(options));
  });
}

void fathom_answer_free(fathom_answer* answer) { delete answer; }
