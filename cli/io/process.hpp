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

#include <string>
#include <vector>

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

}  // namespace fathom::cli
