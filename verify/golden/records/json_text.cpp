// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/json_text.hpp"

#include "kernels/number/rounding.hpp"

namespace fathom::golden {

void JsonText::separate() {
  if (!first_) text_ += ',';
  first_ = false;
}

JsonText& JsonText::open(char bracket) {
  separate();
  text_ += bracket;
  first_ = true;
  return *this;
}

JsonText& JsonText::close(char bracket) {
  text_ += bracket;
  first_ = false;
  return *this;
}

JsonText& JsonText::key(std::string_view name) {
  text(name);
  text_ += ':';
  first_ = true;
  return *this;
}

JsonText& JsonText::text(std::string_view plain) {
  separate();
  text_ += '"';
  text_ += plain;
  text_ += '"';
  return *this;
}

JsonText& JsonText::number(std::int64_t n) {
  separate();
  text_ += std::to_string(n);
  return *this;
}

JsonText& JsonText::null() {
  separate();
  text_ += "null";
  return *this;
}

void JsonText::digits(mpz_srcptr n) {
  const std::size_t begin = text_.size();
  text_.resize(begin + mpz_sizeinbase(n, 10) + 2);
  mpz_get_str(text_.data() + begin, 10, n);
  text_.resize(text_.find('\0', begin));
}

JsonText& JsonText::exact(const mpz_class& n) {
  separate();
  text_ += '"';
  digits(n.get_mpz_t());
  text_ += '"';
  return *this;
}

JsonText& JsonText::exact(const mpq_class& q) {
  separate();
  text_ += '"';
  digits(q.get_num_mpz_t());
  if (q.get_den() != 1) {
    text_ += '/';
    digits(q.get_den_mpz_t());
  }
  text_ += '"';
  return *this;
}

JsonText& JsonText::hex(double value) {
  separate();
  text_ += '"';
  kernels::append_hex(value, text_);
  text_ += '"';
  return *this;
}

}  // namespace fathom::golden
