// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/digest/sha256.hpp"

#include <openssl/evp.h>

#include <array>
#include <stdexcept>

namespace fathom::digest {

struct Sha256::Context {
  EVP_MD_CTX* state = EVP_MD_CTX_new();
};

void Sha256::Free::operator()(Context* context) const noexcept {
  EVP_MD_CTX_free(context->state);
  delete context;
}

Sha256::Sha256() : context_(new Context) {
  if (EVP_DigestInit_ex(context_->state, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("libcrypto offers no SHA-256");
}

void Sha256::add(std::string_view bytes) {
  EVP_DigestUpdate(context_->state, bytes.data(), bytes.size());
  bytes_ += bytes.size();
}

Digest Sha256::digest() {
  std::array<unsigned char, EVP_MAX_MD_SIZE> raw;
  unsigned size = 0;
  EVP_DigestFinal_ex(context_->state, raw.data(), &size);
  Digest digest{bytes_, ""};
  for (unsigned i = 0; i < size; ++i) {
    constexpr std::string_view digits = "0123456789abcdef";
    digest.sha256 += {digits[raw[i] >> 4], digits[raw[i] & 15]};
  }
  return digest;
}

Digest digest_of(std::string_view text) {
  Sha256 sum;
  sum.add(text);
  return sum.digest();
}

}  // namespace fathom::digest
