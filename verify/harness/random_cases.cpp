// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <span>
#include <utility>

#include "verify/families/families.hpp"
#include "verify/families/random.hpp"
#include "verify/harness/seen_case.hpp"
#include "verify/harness/two_ways.hpp"

namespace fathom::harness {

namespace {

/// Of these families, whose cases have a size and a seed of their own.
Case random_of(std::span<const families::Family> families, std::uint64_t seed, std::uint64_t number, unsigned least, unsigned most) {
  families::Random random(families::Random(seed).next() + number);
  const auto size = static_cast<unsigned>(random.between(least, most));
  const std::uint64_t of_family = random.next();
  Case pair = families[number % families.size()].make(of_family, size);
  const std::int64_t form = random.between(0, 2);
  if (form == 0) return pair;
  const Precision precision = form == 1 ? Precision::binary64 : Precision::binary32;
  std::optional<Case> rounded = as_seen(pair, precision);
  if (!rounded) return pair;
  rounded->id += precision == Precision::binary64 ? ".b64" : ".b32";
  return *std::move(rounded);
}

}  // namespace

Case random_case(std::uint64_t seed, std::uint64_t number) {
  return random_of(families::families(), seed, number, least_random_size, most_random_size);
}

Case random_unions(std::uint64_t seed, std::uint64_t number) {
  return random_of(families::families(families::Kind::unions), seed, number, 1, most_random_pieces);
}

}  // namespace fathom::harness
