// SPDX-License-Identifier: GPL-3.0-or-later
// When memory runs out, std::bad_alloc is thrown: a stream loses one case, anything else ends with
// a message and exit code 3.
//
// By default, mimalloc's operator new and GMP abort. Here operator new throws. Because nothing may
// be thrown through GMP's frames, GMP's requests are served from a reserve then, and the thread's
// next operator new throws in its place. If the reserve is exhausted too, or the exception cannot
// be caught (in a destructor, or in a thread without a handler), the process ends at once; its
// output so far is complete.
#pragma once

#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <charconv>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/io/process.hpp"

namespace fathom::cli {

/// Call it before anything else.
void guard_memory();

// Threads.

/// Returns the default number of threads for a stream: one for each core that this process may use.
/// One if the address space is limited, because every thread takes some of it.
unsigned usual_threads();

/// Returns how many of `asked` threads to start: fewer if the address space is limited, as more
/// would leave too little for the items.
unsigned possible_threads(unsigned asked);

// Runs programs that are built beside this one, in its place or as children.

/// Replaces this process by `program`, found beside this one or else on PATH, with these arguments.
/// Returns only if it is not found.
void become(const std::string& program, std::vector<std::string> words);

/// Puts this program's folder first on PATH, for children.
void look_here_first();

// Texts for other processes.

/// Appends a text of any bytes: its length, a space, the text.
inline void pack(std::string& all, const std::string& text) { ((all += std::to_string(text.size())) += ' ') += text; }

inline std::string packed(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) pack(all, text);
  return all;
}

/// Returns the texts that were packed. Throws std::invalid_argument for other text.
inline std::vector<std::string> unpacked(const std::string& all) {
  std::vector<std::string> texts;
  for (std::size_t at = 0; at < all.size();) {
    std::size_t length = 0;
    const auto [end, error] = std::from_chars(all.data() + at, all.data() + all.size(), length);
    const std::size_t begin = static_cast<std::size_t>(end - all.data()) + 1;  // after the space
    if (error != std::errc() || begin > all.size() || *end != ' ' || length > all.size() - begin)
      throw std::invalid_argument("expected packed texts, found another text");
    texts.push_back(all.substr(begin, length));
    at = begin + length;
  }
  return texts;
}

// Processing of a stream's items by many threads, with delivery in order.

/// Read-ahead per thread: how many items may be in flight behind a slow one.
inline constexpr std::size_t items_in_flight = 16;

/// Calls `next` until it returns null, `work` for each item and then `deliver`. Calls `next` and
/// `deliver` for one item at a time, in order; `work` for several at once, on as many threads.
/// While `next` waits, other threads continue, and every item before the awaited one is delivered.
/// With one thread, each item is delivered before `next` is called again. The first exception of
/// any of the three ends the run, after running calls return, and is rethrown.
template <class Item, class Next, class Work, class Deliver>
void in_order(unsigned threads, Next next, Work work, Deliver deliver) {
  using Shared = std::shared_ptr<Item>;
  threads = possible_threads(threads);
  if (threads == 1) {
    while (const Shared item = next()) {
      work(*item);
      deliver(*item);
    }
    return;
  }
  const auto first = [&](tbb::flow_control& control) {
    Shared item = next();
    if (!item) control.stop();
    return item;
  };
  const auto second = [&](const Shared& item) {
    work(*item);
    return item;
  };
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(static_cast<int>(threads));
  arena.execute([&] {
    tbb::parallel_pipeline(threads * items_in_flight,
                           tbb::make_filter<void, Shared>(tbb::filter_mode::serial_in_order, first) &
                               tbb::make_filter<Shared, Shared>(tbb::filter_mode::parallel, second) &
                               tbb::make_filter<Shared, void>(tbb::filter_mode::serial_in_order,
                                                              [&](const Shared& item) { deliver(*item); }));
  });
}

}  // namespace fathom::cli
