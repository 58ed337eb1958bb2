// SPDX-License-Identifier: GPL-3.0-or-later
// Exact numbers in, correctly rounded numbers out: a depth is the square root of a rational.
#include <fathom/numbers.hpp>
#include <iostream>

int main() {
  using fathom::Rounding;
  const mpq_class tenth = *fathom::parse_number("0.1", fathom::Decimals::exact).value;
  const mpq_class nearly = *fathom::parse_number("0.1", fathom::Decimals::binary64).value;
  std::cout << fathom::exact_text(tenth) << " or " << fathom::exact_text(nearly) << ", as a double holds "
            << (fathom::exact_value(0.1) == nearly) << "\n";
  std::cout << fathom::parse_number("1/0", fathom::Decimals::exact).error << "\n";

  const mpq_class squared = 2;  // depth^2
  for (const Rounding mode : {Rounding::rn, Rounding::rd, Rounding::ru}) {
    std::cout << fathom::hex_text(fathom::root_binary64(squared, mode)) << " "
              << fathom::hex_text(fathom::root_binary32(squared, mode)) << " "
              << fathom::hex_text(fathom::round_binary64(tenth, mode)) << " "
              << fathom::hex_text(fathom::round_binary32(tenth, mode)) << "\n";
  }
  const fathom::Enclosure root = fathom::enclose_root(squared, 30);
  std::cout << root.low << " < sqrt(2) < " << root.high << "\n";

  const fathom::Surd apart{mpq_class(3, 2), -2};  // 3/2 - sqrt(2)
  const fathom::Enclosure digits = fathom::enclose(apart, 5);
  std::cout << fathom::sign(apart) << " " << fathom::compare(apart, tenth) << " "
            << fathom::compare(apart, fathom::Surd{1, 0}) << " " << fathom::round_binary64(apart) << " " << digits.low
            << " " << digits.high << "\n";
}

//> 1/10 or 3602879701896397/36028797018963968, as a double holds 1
//> expected a number, found '1/0': the denominator is zero
//> 0x1.6a09e667f3bcdp+0 0x1.6a09e6p+0 0x1.999999999999ap-4 0x1.99999ap-4
//> 0x1.6a09e667f3bccp+0 0x1.6a09e6p+0 0x1.9999999999999p-4 0x1.999998p-4
//> 0x1.6a09e667f3bcdp+0 0x1.6a09e8p+0 0x1.999999999999ap-4 0x1.99999ap-4
//> 1.41421356237309504880168872420 < sqrt(2) < 1.41421356237309504880168872421
//> 1 -1 -1 0.0857864 0.085786 0.085787
