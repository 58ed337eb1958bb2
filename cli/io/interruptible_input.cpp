// SPDX-License-Identifier: GPL-3.0-or-later
#include <poll.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "cli/io/case_input.hpp"
#include "fathom/files.hpp"

namespace fathom::cli {
namespace {

constexpr int between_looks = 100;  // milliseconds

}  // namespace

InterruptibleInput::int_type InterruptibleInput::underflow() {
  while (true) {
    if (stopped_()) throw Interrupted();
    pollfd input{descriptor_, POLLIN, 0};
    if (const int ready = ::poll(&input, 1, between_looks); ready == 0 || (ready < 0 && errno == EINTR)) continue;
    const ssize_t got = ::read(descriptor_, buffer_.data(), buffer_.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw InputError("<stdin>", 0, std::string("cannot be read: ") + std::strerror(errno));
    if (got == 0) return traits_type::eof();
    setg(buffer_.data(), buffer_.data(), buffer_.data() + got);
    return traits_type::to_int_type(buffer_[0]);
  }
}

}  // namespace fathom::cli
