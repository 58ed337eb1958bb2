// SPDX-License-Identifier: GPL-3.0-or-later

#include "verify/golden/records/record.hpp"

#include <array>
#include <charconv>
#include <limits>
#include <stdexcept>
#include <utility>

#include "fathom/certificate.hpp"
#include "fathom/numbers.hpp"
#include "kernels/context.hpp"
#include "kernels/messages.hpp"
#include "reference/answer/plane.hpp"
#include "reference/text/json_value.hpp"
#include "verify/check/check.hpp"
#include "verify/digest/sha256.hpp"
#include "verify/golden/records/facts.hpp"
#include "verify/golden/records/prove.hpp"

namespace fathom::golden {
namespace {

/// The answer of the library about two bodies.
struct Answered {
  RecordStatement truth;
  std::string certificate;
  std::optional<ContactFacts> contacts = std::nullopt;
};

/// Throws std::logic_error unless the checker, which shares no code with the library, accepts the
/// certificate. Of polytopes, which are most records, only the verdict is compared with the answer,
/// because proving the whole record takes as long as making it.
void insist_on(const std::string& id, const std::string& text, const Depth& answer) {
  const fathom_check::Verdict verdict = fathom_check::verify(text);
  const auto refuse = [&id](const std::string& why) { throw std::logic_error(id + ": " + why); };
  if (!verdict.accepted())
    refuse("the certificate is not accepted: line " + std::to_string(verdict.line) + ": " + verdict.reason);
  const Distance* const distance = answer.distance();
  const bool same_length = distance ? verdict.signed_depth == "-sqrt(" + exact_text(distance->squared) + ")+0"
                                    : verdict.depth_squared == exact_text(answer.squared());
  if (verdict.id != id || verdict.status != name(answer.status()) || !same_length ||
      verdict.optima != answer.optima().size())
    refuse("the certificate proves something else: " + fathom_check::verdict_line(verdict, id));
}

/// Answers about polytopes. Usually the expanding polytope yields answer and certificate in one
/// run; if it gives up, the exact method answers and the certificate is made afterwards.
Answered answered(const HullPair& hulls, const std::string& id, Monitor* monitor, Workspace* workspace) {
  Options options;
  options.monitor = monitor;
  options.workspace = workspace;
  Depth answer = penetration_depth(hulls.a, hulls.b, options);
  std::string certificate = certificate_text(hulls.a, hulls.b, answer, id, monitor);
  insist_on(id, certificate, answer);
  return {truth_of(hulls, std::move(answer), monitor, workspace), std::move(certificate)};
}

Answered answered(const families::NamedPair& shapes, const std::string& id, Monitor* monitor, Workspace*) {
  const Shape a = families::shape_of(shapes.a), b = families::shape_of(shapes.b);
  Options options;
  options.monitor = monitor;
  const SignedDepth answer = answer_about(a, b, options);
  return {truth_of(answer), certificate_text(a, b, answer, id, ShapeFormat::richest, monitor)};
}

Answered answered(const Unions& unions, const std::string& id, Monitor* monitor, Workspace*) {
  const UnionDepth answer = answer_about(unions.a, unions.b, monitor);
  return {truth_of(answer), certificate_text(unions.a, unions.b, answer, id, monitor)};
}

Answered answered(const families::PlanePair& plane, const std::string& id, Monitor* monitor, Workspace* workspace) {
  Options options;
  options.monitor = monitor;
  options.workspace = workspace;
  const Answer answer = answer_about(plane, options);
  return {truth_of(answer), answer::certificate_in_plane(plane.a, plane.b, answer, id, ShapeFormat::richest, monitor)};
}

Answered with_contacts(const RecordBodies& bodies, const std::string& id, Monitor* monitor) {
  Options options;
  options.monitor = monitor;
  ContactStatement found = contacts_of(bodies, options);
  std::string certificate = certificate_of(bodies, found, id, monitor);
  return {std::move(found.truth), std::move(certificate), std::move(found.contacts)};
}

}  // namespace

Record record_of(const Recipe& recipe, FormedCase made, Monitor* monitor, Workspace* workspace) {
  const std::string id = made.id;
  auto [truth, certificate, contacts] =
      made.contacts
          ? with_contacts(made.bodies, id, monitor)
          : std::visit([&](const auto& bodies) { return answered(bodies, id, monitor, workspace); }, made.bodies);
  const Facts facts =
      facts_of(recipe, std::move(made), std::move(truth), digest::digest_of(certificate).sha256, std::move(contacts));
  Record record{id, line_of(facts), std::move(certificate), csv_row(facts), facts.in_binary64, facts.in_binary32};
  if (recipe.source == Source::real && std::holds_alternative<families::PlanePair>(facts.made.bodies)) {
    // Made by no recipe: what the certificate proves is written again.
    RecordStatement proved = proved_truth(facts.made, std::nullopt, record.certificate, workspace);
    const Facts again = facts_of(recipe, facts.made, std::move(proved), facts.certificate_sha256, std::nullopt);
    if (line_of(again) != record.line) throw std::logic_error(id + ": the certificate proves another record");
  } else if (facts.contacts || !std::holds_alternative<HullPair>(facts.made.bodies)) {
    if (const auto fault = faults_of(record.line, record.certificate)) throw std::logic_error(id + ": " + *fault);
  }
  return record;
}

std::vector<Record> records_of(const Recipe& recipe, Monitor* monitor, Workspace* workspace) {
  kernels::Context context(monitor);
  std::vector<Record> records;
  for (FormedCase& made : cases_of(recipe)) {
    context.check();
    records.push_back(record_of(recipe, std::move(made), monitor, workspace));
  }
  return records;
}

// ---- reading ----

namespace {

using text::JsonValue;

Point point(const JsonValue& value) {
  if (value.items().size() != 3) throw NotARecord("expected three coordinates, found something else");
  return {number_in(value.at(0)), number_in(value.at(1)), number_in(value.at(2))};
}

Body body(const JsonValue& value) {
  Body result;
  for (const JsonValue& vertex : value.at("vertices").items()) result.points.push_back(point(vertex));
  if (result.points.empty()) throw NotARecord("expected at least one point, found none");
  return result;
}

template <class Unsigned>
Unsigned unsigned_number(const std::string& digits) {
  Unsigned value{};
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size())
    throw NotARecord("expected a natural number, found '" + digits + "'");
  return value;
}

template <class Value, std::size_t N>
Value named(const std::array<Value, N>& values, const std::string& name) {
  for (const Value value : values) {
    if (name_of(value) == name) return value;
  }
  throw NotARecord("expected a word of the schema, found '" + name + "'");
}

void read_source(const JsonValue& source, ReadRecord& claimed) {
  Recipe& recipe = claimed.recipe;
  recipe.source =
      named(std::array{Source::family, Source::catalogue, Source::real, Source::shape_family, Source::shape_catalogue,
                       Source::union_family, Source::union_catalogue, Source::plane_family},
            source.at("kind").string());
  recipe.name = source.at("name").string();
  if (from_family(recipe.source)) {
    recipe.size = static_cast<unsigned>(source.at("size").natural(std::numeric_limits<unsigned>::max()));
    recipe.seed = unsigned_number<std::uint64_t>(source.at("seed").string());
  }
  claimed.form = named(std::array{Form::given, Form::binary64, Form::binary32}, source.at("form").string());
}

std::optional<Witness> read_witness(const JsonValue& expected) {
  const JsonValue* const distance = expected.find("distance");
  const JsonValue* const witness = (distance ? *distance : expected).find("witness");
  if (!witness) return std::nullopt;
  return Witness{point(witness->at("a")), point(witness->at("b"))};
}

/// Returns take(line as JSON).
template <class Take>
auto read(std::string_view line, Take take) {
  try {
    return take(text::parsed_json(line));
  } catch (const text::JsonFault& fault) {
    throw NotARecord(std::string("expected a record, found a fault: ") + fault.what());
  }
}

std::string shortened(const std::string& value) {
  constexpr std::size_t most = 80;
  return value.size() <= most ? value : value.substr(0, most) + "...";
}

/// Returns the first difference of two values at `path`: first the fields of `expected` by name,
/// then additional fields of `found`; nullopt if there is none.
std::optional<std::string> difference(const JsonValue* expected, const JsonValue* found, const std::string& path) {
  const auto within = [&path](const std::string& part) { return path.empty() ? part : path + '.' + part; };
  const auto shown = [](const JsonValue* value) {
    return value ? shortened(value->written().text()) : std::string("nothing");
  };
  if (expected && found && expected->is_object() && found->is_object()) {
    for (const auto& [key, value] : expected->fields())
      if (auto step = difference(value, found->find(key), within(std::string(key)))) return step;
    for (const auto& [key, value] : found->fields())
      if (!expected->find(key)) return difference(nullptr, value, within(std::string(key)));
    return std::nullopt;
  }
  if (expected && found && expected->is_array() && found->is_array()) {
    const auto item = [](const JsonValue* list, std::size_t i) {
      return i < list->items().size() ? &list->items()[i] : nullptr;
    };
    for (std::size_t i = 0; item(expected, i) || item(found, i); ++i)
      if (auto step = difference(item(expected, i), item(found, i), within(std::to_string(i)))) return step;
    return std::nullopt;
  }
  if (expected && found && expected->written().text() == found->written().text()) return std::nullopt;
  return (path.empty() ? "the line" : path) + ": expected " + shown(expected) + ", found " + shown(found);
}

}  // namespace

mpq_class number_in(const JsonValue& value) {
  ParsedNumber parsed = text::exact_number(value);
  if (parsed.value) return *std::move(parsed.value);
  throw NotARecord(parsed.error.empty() ? "expected a number, found " + shortened(value.written().text())
                                        : parsed.error);
}

ReadRecord read_record(std::string_view line) {
  return read(line, [](const JsonValue& record) {
    ReadRecord claimed;
    read_source(record.at("source"), claimed);
    claimed.id = record.at("id").string();
    claimed.recipe.contacts = record.at("expected").find("manifold") != nullptr;
    if (kind_of(claimed.recipe.source) == Kind::polytopes) {
      claimed.hulls = {body(record.at("a")), body(record.at("b"))};
      claimed.witness = read_witness(record.at("expected"));
    }
    claimed.certificate_sha256 = record.at("certificate").at("sha256").string();
    return claimed;
  });
}

std::pair<Surd, Surd> signed_depth_in(std::string_view line) {
  return read(line, [](const JsonValue& record) -> std::pair<Surd, Surd> {
    const JsonValue& value = record.at("expected").at("signed_depth");
    if (const JsonValue* const bounds = value.find("bounds"))
      return {{number_in(bounds->at(0)), 0}, {number_in(bounds->at(1)), 0}};
    const JsonValue& exact = value.at("exact");
    const Surd surd{number_in(exact.at("plus")), number_in(exact.at("root")) * exact_value(exact.at("sign").number())};
    return {surd, surd};
  });
}

std::pair<std::uint32_t, std::uint32_t> nearest_pieces_in(std::string_view line) {
  return read(line, [](const JsonValue& record) -> std::pair<std::uint32_t, std::uint32_t> {
    const JsonValue& pieces = record.at("expected").at("distance").at("pieces");
    const auto piece = [&](std::size_t i) {
      return static_cast<std::uint32_t>(pieces.at(i).natural(std::numeric_limits<std::uint32_t>::max()));
    };
    return {piece(0), piece(1)};
  });
}

std::string first_difference(std::string_view expected, std::string_view found) {
  const text::JsonRead right = text::read_json(expected), given = text::read_json(found);
  if (auto step = difference(&right.value, given.whole ? &given.value : nullptr, "")) return *std::move(step);
  return "expected each field once, in the order and form in which records are written, found another text";
}

std::string_view id_in(std::string_view line) {
  for (const std::string_view kind : record_schemas) {
    text::JsonStream head;
    open_line(head, kind);
    const std::string before = head.take() + '"';
    if (!line.starts_with(before)) continue;
    line.remove_prefix(before.size());
    const std::size_t end = line.find('"');
    return end == std::string_view::npos ? "" : line.substr(0, end);
  }
  return "";
}

}  // namespace fathom::golden
