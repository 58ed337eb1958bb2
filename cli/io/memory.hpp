// SPDX-License-Identifier: GPL-3.0-or-later
// When memory runs out, std::bad_alloc is thrown: a stream loses one case, anything else ends with a message and exit code 3.
//
// Left alone, mimalloc's operator new and GMP abort. Here operator new throws. Nothing may be thrown through GMP's frames: its requests
// are served from a reserve then, and the thread's next operator new throws in its place. Where the reserve ends too, or no
// exception can leave (a destructor, a thread that has no handler), the process ends at once; what it has printed is complete.
#pragma once

namespace fathom::cli {

/// Call it before anything else.
void guard_memory();

}  // namespace fathom::cli
