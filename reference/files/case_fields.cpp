// SPDX-License-Identifier: GPL-3.0-or-later
// Listens to the events of a JSON parser. It knows its place in the object and skips unknown fields without storing them. It goes on after
// a fault: an id that comes later still names the case.
#include "reference/files/case_fields.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "fathom/numbers.hpp"
#include "kernels/printable.hpp"
#include "reference/files/case_places.hpp"
#include "reference/files/misspelt_fields.hpp"

namespace fathom::files {
namespace {

using Json = nlohmann::json;

constexpr std::size_t readable = 40;  // what a message shows of a text
constexpr std::size_t deepest = 64;   // objects and arrays within each other, as in the checker of certificates

class Listener : public nlohmann::json_sax<Json> {
 public:
  CaseFields fields;

  explicit Listener(std::string_view text) : text_(text) {}

  bool null() override {
    const CasePlace place = next_place();
    return may_be_null(place) ? done() : wrong(place, "null");
  }
  bool boolean(bool value) override {
    const CasePlace place = next_place();
    if (place == CasePlace::shape) return read_elsewhere();
    return place == CasePlace::other ? done() : wrong(place, value ? "true" : "false");
  }
  static_assert(sizeof(long) >= sizeof(number_integer_t), "GMP takes longs: shorter ones would cut integers");
  bool number_integer(number_integer_t value) override { return number(mpz_class(static_cast<long>(value))); }
  bool number_unsigned(number_unsigned_t value) override { return number(mpz_class(static_cast<unsigned long>(value))); }
  bool number_float(number_float_t value, const std::string& text) override {
    return number(next_place(), text, [&](mpq_class& target) { target = value; });
  }
  bool string(std::string& text) override;
  bool binary(binary_t&) override { return done(); }
  bool start_object(std::size_t) override {
    const CasePlace place = next_place();
    if (place == CasePlace::shape || place == CasePlace::pose) body().is_shape = true;
    return place == CasePlace::whole || place == CasePlace::body ? enter(place) : skip(place, "an object");
  }
  bool start_array(std::size_t) override;
  bool key(std::string& name) override;
  bool end_object() override;
  bool end_array() override;
  bool parse_error(std::size_t position, const std::string& last_token, const Json::exception& error) override;
  void refuse_null_byte();

 private:
  // A container that is being read: an object with its current key, or an array with its current index.
  struct Frame {
    CasePlace place;
    std::size_t index = 0;
    std::string key;
    std::vector<std::string> seen;  // keys of ours
  };

  [[nodiscard]] CasePlace next_place() const;
  [[nodiscard]] std::string path() const;
  [[nodiscard]] BodyFields& body() { return frames_.front().key == "a" ? fields.a : fields.b; }

  // Each of these ends the handling of one event; all return true: go on.
  bool enter(CasePlace place) {
    frames_.push_back({place, 0, {}, {}});
    return true;
  }
  bool skip(CasePlace place, const std::string& found) {
    if (place == CasePlace::faces) body().has_faces = true;
    if (place == CasePlace::shape) body().is_shape = true;
    const bool ours = place != CasePlace::other && place != CasePlace::shape && place != CasePlace::faces &&
                      (place != CasePlace::pose || !body().is_shape);
    if (ours) fault(path(), expected_at(place), found);
    if (++skipped_ + frames_.size() > deepest) fault("", "values nested at most 64 deep", "a deeper one");
    return true;
  }
  bool done() {
    if (skipped_ == 0 && !frames_.empty()) ++frames_.back().index;
    return true;
  }
  // Part of a shape: of another reader's.
  bool read_elsewhere() {
    body().is_shape = true;
    return done();
  }
  bool wrong(CasePlace place, const std::string& found) {
    fault(path(), expected_at(place), found);
    return done();
  }
  bool leave() {
    frames_.pop_back();
    return done();
  }
  template <class Assign>
  bool number(CasePlace place, const std::string& text, Assign assign);
  bool number(const mpz_class& value);
  [[nodiscard]] mpq_class* target(CasePlace place);
  void fault(const std::string& where, const std::string& expected, const std::string& found) {
    report((where.empty() ? "" : where + ": ") + "expected " + expected + ", found " + found);
  }
  void report(const std::string& sentence) {
    if (fields.fault.empty()) fields.fault = sentence;
  }
  std::size_t set_fault_line(std::size_t position);

  std::string_view text_;
  std::vector<Frame> frames_;
  std::size_t skipped_ = 0;  // depth inside something that is not read
};

CasePlace Listener::next_place() const {
  if (skipped_ != 0) return CasePlace::other;
  if (frames_.empty()) return CasePlace::whole;
  const Frame& top = frames_.back();
  switch (top.place) {
    case CasePlace::whole: return field_of_case(top.key);
    case CasePlace::body: return field_of_body(top.key);
    case CasePlace::vertices: return CasePlace::vertex;
    case CasePlace::vertex: return CasePlace::coordinate;
    case CasePlace::pose: return CasePlace::pose_row;
    default: return CasePlace::pose_entry;
  }
}

std::string Listener::path() const {
  std::string result;
  for (const Frame& frame : frames_) {
    if (frame.place != CasePlace::whole && frame.place != CasePlace::body) {
      result += "[" + std::to_string(frame.index) + "]";
    } else if (!frame.key.empty()) {
      result += (result.empty() ? "" : ".") + frame.key;
    }
  }
  return result;
}

// Where the number that comes next belongs; nowhere if there are too many, which the end of the array will tell.
mpq_class* Listener::target(CasePlace place) {
  const std::size_t index = frames_.back().index;
  if (place == CasePlace::coordinate && index < 3) {
    Point& point = body().vertices.edit().back();
    return index == 0 ? &point.x : index == 1 ? &point.y : &point.z;
  }
  if (place != CasePlace::pose_entry || index >= 4) return nullptr;
  const std::size_t row = frames_[frames_.size() - 2].index;
  return row < 3 ? &(*body().pose)[row][index] : nullptr;
}

template <class Assign>
bool Listener::number(CasePlace place, const std::string& text, Assign assign) {
  if (place == CasePlace::coordinate || place == CasePlace::pose_entry) {
    if (mpq_class* const to = target(place)) assign(*to);
  } else if (place == CasePlace::id) {
    fields.id = text;
  } else if (place == CasePlace::shape) {
    return read_elsewhere();
  } else if (place != CasePlace::other) {
    return wrong(place, kernels::printable(text, readable));
  }
  return done();
}

// A JSON number means the nearest binary64, an integer too.
bool Listener::number(const mpz_class& value) {
  constexpr long exact_up_to = 1L << 53;
  const CasePlace place = next_place();
  return number(place, place == CasePlace::coordinate || place == CasePlace::pose_entry ? "" : value.get_str(), [&](mpq_class& to) {
    to = value;
    if (abs(value) > exact_up_to) to = round_binary64(to, Rounding::rn);
  });
}

bool Listener::string(std::string& text) {
  const CasePlace place = next_place();
  bool good = true;
  if (place == CasePlace::shape || place == CasePlace::pose) return read_elsewhere();
  if (place == CasePlace::coordinate || place == CasePlace::pose_entry) {
    ParsedNumber number = parse_number(text, Decimals::exact);
    mpq_class* const to = target(place);
    if (!number.value) report(path() + ": " + number.error);
    if (number.value && to) *to = *std::move(number.value);
  } else if (place == CasePlace::id) {
    fields.id = text;
  } else if (place == CasePlace::schema) {
    good = text == "fathom/case/1";
  } else if (place == CasePlace::rounding || place == CasePlace::body_rounding) {
    good = text == "binary64";
    (place == CasePlace::rounding ? fields.rounded : body().rounded) = good;
  } else {
    good = place == CasePlace::other;
  }
  return good ? done() : wrong(place, "\"" + kernels::printable(text, readable) + "\"");
}

bool Listener::start_array(std::size_t) {
  const CasePlace place = next_place();
  const bool ours = place == CasePlace::vertices || place == CasePlace::vertex || place == CasePlace::pose || place == CasePlace::pose_row;
  if (!ours) return skip(place, "an array");
  if (place == CasePlace::vertex) body().vertices.push_back({});
  if (place == CasePlace::pose) body().pose.emplace();
  return enter(place);
}

// A repeated key of ours is refused: readers differ in which of the two they take.
bool Listener::key(std::string& name) {
  if (skipped_ != 0) return true;
  Frame& top = frames_.back();
  top.key = name;
  const CasePlace place = next_place();
  if (place == CasePlace::other) {
    fields.misspelt = fields.misspelt || looks_misspelt(name, top.place == CasePlace::body);
    return true;
  }
  if (std::ranges::find(top.seen, name) == top.seen.end()) top.seen.push_back(name);
  else fault(path(), "one field of this name", "a second one");
  return true;
}

bool Listener::end_object() {
  if (skipped_ != 0) {
    --skipped_;
    return done();
  }
  Frame& top = frames_.back();
  top.key.clear();
  const auto require = [&](const std::string& name) {
    if (std::ranges::find(top.seen, name) == top.seen.end()) fault(path(), "a field '" + name + "'", "none");
  };
  if (top.place == CasePlace::body) {
    if (!body().is_shape) require("vertices");
  } else {
    require("a");
    require("b");
  }
  return leave();
}

bool Listener::end_array() {
  if (skipped_ != 0) {
    --skipped_;
    return done();
  }
  const Frame ended = frames_.back();
  frames_.pop_back();
  const std::size_t wanted = ended.place == CasePlace::pose_row ? 4 : 3;
  const bool four_rows = ended.place == CasePlace::pose && ended.index == 4;
  if (four_rows) return read_elsewhere();
  if (ended.place == CasePlace::vertices) {
    if (ended.index == 0) fault(path(), "at least one point", "none");
  } else if (ended.index != wanted) {
    fault(path(), expected_at(ended.place), std::to_string(ended.index));
  }
  return done();
}

// For a fault at this byte; its column.
std::size_t Listener::set_fault_line(std::size_t position) {
  const std::string_view before = text_.substr(0, position);
  fields.fault_line = static_cast<std::size_t>(std::ranges::count(before, '\n'));
  return before.size() - (before.rfind('\n') + 1) + 1;
}

// To the parser it is the end of the text: what follows would be passed over.
void Listener::refuse_null_byte() {
  const std::size_t position = text_.find('\0');
  if (position == std::string_view::npos) return;
  const std::size_t column = set_fault_line(position);
  fields.fault = "expected JSON, found a null byte at column " + std::to_string(column);
}

bool Listener::parse_error(std::size_t position, const std::string& last_token, const Json::exception& error) {
  constexpr int number_overflow = 406;
  constexpr std::size_t readable_reason = 160;
  const std::size_t column = set_fault_line(position > 0 ? position - 1 : 0);
  fields.fault.clear();  // text that is not JSON gets the error for that
  if (error.id == number_overflow) {
    fault(path(), "a number within the range of binary64", kernels::shown(last_token));
    return false;
  }
  std::string_view reason = error.what();
  const std::size_t dash = reason.find(" - ");
  if (dash != std::string_view::npos) reason.remove_prefix(dash + 3);
  fault("", "JSON", "a syntax error at column " + std::to_string(column) + ": " + kernels::printable(reason, readable_reason));
  return false;
}

}  // namespace

CaseFields read_case_fields(std::string_view text) {
  Listener listener(text);
  Json::sax_parse(text, &listener);
  listener.refuse_null_byte();
  return std::move(listener.fields);
}

}  // namespace fathom::files
