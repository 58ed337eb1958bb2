// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/c/boundary.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>

namespace fathom::c {
namespace {

/// Of a fixed size, so that a message needs no memory.
thread_local std::array<char, 1024> message{};

constexpr std::size_t most = std::size_t{1} << 31;  // of anything that is counted

}  // namespace

void set_message(std::string_view text) noexcept {
  const std::size_t length = std::min(text.size(), message.size() - 1);
  std::memcpy(message.data(), text.data(), length);
  message[length] = '\0';
}

void require(const void* pointer, const char* name) {
  if (pointer == nullptr) throw std::invalid_argument(std::string(name) + ": expected a pointer, found NULL");
}

char* text_for_caller(std::string_view text) {
  auto* const copy = static_cast<char*>(std::malloc(text.size() + 1));
  if (copy == nullptr) throw std::bad_alloc();
  std::memcpy(copy, text.data(), text.size());
  copy[text.size()] = '\0';
  return copy;
}

void require_convex(const Body& body, const std::string& name) {
  if (body.pieces) throw std::invalid_argument(name + ": expected a convex body, found a union of pieces: fathom_depth takes those");
}

void require_count(std::size_t count, const char* what) {
  if (count < 1 || count > most)
    throw std::invalid_argument(std::string("expected from 1 to 2^31 ") + what + ", found " + std::to_string(count));
}

void require_at_most(std::size_t count, const char* what) {
  if (count > most) throw std::invalid_argument(std::string("expected at most 2^31 ") + what + ", found " + std::to_string(count));
}

fathom_body handle(Body body) { return {std::make_shared<const Body>(std::move(body))}; }

Decimals decimals_from(int decimals) {
  if (decimals == FATHOM_BINARY64_DECIMALS) return Decimals::binary64;
  if (decimals == FATHOM_EXACT_DECIMALS) return Decimals::exact;
  throw std::invalid_argument("decimals: expected FATHOM_BINARY64_DECIMALS or FATHOM_EXACT_DECIMALS, found " + std::to_string(decimals));
}

}  // namespace fathom::c

const char* fathom_version() { return FATHOM_VERSION; }

const char* fathom_last_error() { return fathom::c::message.data(); }

void fathom_text_free(char* text) { std::free(text); }
