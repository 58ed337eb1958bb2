// SPDX-License-Identifier: GPL-3.0-or-later
#include "c/boundary.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>

namespace fathom::c {
namespace {

/// Of a fixed size, so that a message needs no memory.
thread_local std::array<char, 1024> message{};

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

Decimals decimals_from(int decimals) {
  if (decimals == FATHOM_BINARY64_DECIMALS) return Decimals::binary64;
  if (decimals == FATHOM_EXACT_DECIMALS) return Decimals::exact;
  throw std::invalid_argument("decimals: expected FATHOM_BINARY64_DECIMALS or FATHOM_EXACT_DECIMALS, found " + std::to_string(decimals));
}

}  // namespace fathom::c

const char* fathom_version() { return FATHOM_VERSION; }

const char* fathom_last_error() { return fathom::c::message.data(); }

void fathom_text_free(char* text) { std::free(text); }
