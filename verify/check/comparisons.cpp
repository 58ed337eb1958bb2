// SPDX-License-Identifier: Apache-2.0
#include "comparisons.hpp"

#include <algorithm>

#include "checks.hpp"
#include "json.hpp"
#include "limits.hpp"
#include "text.hpp"
#include "vectors.hpp"

namespace fathom_check {
namespace {

using Kind = Json::Kind;
using Pose = std::array<std::array<mpq_class, 4>, 3>;

/// One case while it is read; knows the line for messages.
class CaseReader {
 public:
  CaseReader(const Json& value, std::size_t line, Budget& budget, bool of_export)
      : case_(&value), line_(line), budget_(&budget), of_export_(of_export) {
    if (value.kind != Kind::object) throw wrong("a case, a JSON object");
    dimension_ = dimension();
    if (of_export) return;
    const Json* const schema = value.field("schema", line);
    if (schema && (schema->kind != Kind::text || schema->text != "fathom/case/1"))
      throw wrong("the schema fathom/case/1 or fathom/golden-export/1");
    rounded_ = is_rounded(value);
  }

  [[nodiscard]] std::string id() const {
    const Json* const id = case_->field(of_export_ ? "name" : "id", line_);
    if (!id || id->kind == Kind::null) return std::to_string(line_);
    if (id->kind != Kind::text && id->kind != Kind::number) throw wrong("an id that is a text or a number");
    return id->text;
  }

  [[nodiscard]] bool is_of_plane() const { return dimension_ == 2; }

  [[nodiscard]] OwnBody body(const char* name) const {
    const Json* const body = case_->field(name, line_);
    if (of_export_) {
      if (!body) throw wrong("an array " + shown(name) + " of points");
      return {{points(*body, name, {}, false)}, false};
    }
    if (!body || body->kind != Kind::object) throw wrong("an object " + shown(name) + " with 'vertices' or 'pieces'");
    const Json* const pieces = body->field("pieces", line_);
    const bool rounding = rounded_ || is_rounded(*body);
    const std::optional<Pose> placing = pose(*body);
    OwnBody result;
    result.has_pieces = pieces && pieces->kind != Kind::null;
    if (!result.has_pieces) {
      result.pieces.push_back(vertices_of(*body, name, {placing, std::nullopt}, rounding));
      return result;
    }
    if (pieces->kind != Kind::array || pieces->items.empty())
      throw wrong("an array 'pieces' of bodies in " + shown(name));
    if (body->field("vertices", line_)) throw wrong("no 'vertices' beside the 'pieces' of " + shown(name));
    for (const Json& piece : pieces->items) {
      if (is_of_plane() && piece.kind == Kind::array) {
        result.pieces.push_back(points(piece, name, {placing, std::nullopt}, rounding));
        continue;
      }
      if (piece.kind != Kind::object || piece.field("pose_rounding", line_))
        throw wrong("pieces with 'vertices' in " + shown(name));
      budget_->store(sizeof(result.pieces.front()), line_);
      result.pieces.push_back(vertices_of(piece, name, {pose(piece), placing}, rounding));
    }
    return result;
  }

 private:
  [[nodiscard]] Fault wrong(const std::string& expected) const { return malformed(line_, "expected " + expected); }

  /// The vertices of an object, placed by one pose after the other, and then rounded.
  [[nodiscard]] std::vector<ExactPoint> vertices_of(const Json& object, const char* name,
                                                    const std::array<std::optional<Pose>, 2>& poses,
                                                    bool rounding) const {
    const Json* const vertices = object.field("vertices", line_);
    if (!vertices) throw wrong("an array 'vertices' of points in " + shown(name));
    return points(*vertices, name, poses, rounding);
  }

  [[nodiscard]] std::vector<ExactPoint> points(const Json& rows, const char* name,
                                               const std::array<std::optional<Pose>, 2>& poses, bool rounding) const {
    if (rows.kind != Kind::array) throw wrong("an array of points in " + shown(name));
    std::vector<ExactPoint> points;
    for (const Json& vertex : rows.items) {
      std::vector<mpq_class> row = numbers(vertex, dimension_);
      row.resize(3);
      ExactPoint point{row[0], row[1], row[2]};
      for (const std::optional<Pose>& pose : poses)
        if (pose) point = placed(point, *pose);
      for (mpq_class& x : point) {
        if (rounding && !round_to_binary64(x)) throw wrong("placed points within the range of binary64");
        constexpr std::uint64_t mpz_bytes = 48;  // that a small mpz_class occupies, its block on the heap included
        budget_->store(sizeof(mpq_class) + 2 * mpz_bytes + (bits(x.get_num()) + bits(x.get_den())) / 8, line_);
      }
      points.push_back(std::move(point));
    }
    return points;
  }

  [[nodiscard]] std::size_t dimension() const {
    const Json* const field = case_->field("dimension", line_);
    if (!field || field->kind == Kind::null) return 3;
    if (field->kind != Kind::number || (field->text != "2" && field->text != "3")) throw wrong("the dimension 2 or 3");
    return field->text == "2" ? 2 : 3;
  }

  [[nodiscard]] bool is_rounded(const Json& object) const {
    const Json* const rounding = object.field("pose_rounding", line_);
    if (!rounding || rounding->kind == Kind::null) return false;
    if (rounding->kind != Kind::text || rounding->text != "binary64") throw wrong("the pose_rounding 'binary64'");
    return true;
  }

  [[nodiscard]] mpq_class number(const Json& value) const {
    std::optional<mpq_class> result;
    if (value.kind == Kind::number) result = nearest_binary64(value.text);
    if (value.kind == Kind::text) result = exact_number(value.text);
    if (!result) throw wrong("numbers within the range of binary64, or exact ones in quotes, for coordinates");
    return *result;
  }

  [[nodiscard]] std::vector<mpq_class> numbers(const Json& row, std::size_t count) const {
    if (row.kind != Kind::array || row.items.size() != count)
      throw wrong("rows of " + std::to_string(count) + " numbers");
    std::vector<mpq_class> result;
    for (const Json& item : row.items) result.push_back(number(item));
    return result;
  }

  [[nodiscard]] std::optional<Pose> pose(const Json& body) const {
    const Json* const rows = body.field("pose", line_);
    if (!rows || rows->kind == Kind::null) return std::nullopt;
    if (rows->kind != Kind::array || rows->items.size() != dimension_)
      throw wrong(is_of_plane() ? "a pose of two rows" : "a pose of three rows");
    Pose result;
    for (std::size_t i = 0; i < dimension_; ++i) {
      const std::vector<mpq_class> row = numbers(rows->items[i], dimension_ + 1);
      for (std::size_t k = 0; k < dimension_; ++k) result[i][k] = row[k];
      result[i][3] = row[dimension_];
    }
    return result;
  }

  static ExactPoint placed(const ExactPoint& p, const Pose& pose) {
    ExactPoint result;
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = pose[i][0] * p[0] + pose[i][1] * p[1] + pose[i][2] * p[2] + pose[i][3];
    return result;
  }

  const Json* case_;
  std::size_t line_;
  Budget* budget_;
  bool of_export_;
  bool rounded_ = false;
  std::size_t dimension_ = 3;
};

bool same(const RationalPoint& p, const RationalPoint& q) { return same(p.x, q.x) && same(p.y, q.y) && same(p.z, q.z); }
template <class T>
bool same(const std::vector<T>& s, const std::vector<T>& t) {
  return std::equal(s.begin(), s.end(), t.begin(), t.end(), [](const T& x, const T& y) { return same(x, y); });
}

bool equal(const Rational& r, const mpq_class& q) {
  return mpz_cmp(r.num.get_mpz_t(), q.get_num_mpz_t()) == 0 && mpz_cmp(r.den.get_mpz_t(), q.get_den_mpz_t()) == 0;
}

/// The points of the certificate from number `first` on are these; of the plane, as they were
/// before they were raised.
void compare_points(const Part<std::vector<RationalPoint>>& part, std::size_t first, const std::vector<ExactPoint>& own,
                    const std::string& name, bool plane) {
  for (std::size_t k = 0; k < own.size(); ++k) {
    const RationalPoint& p = part.items[first + k];
    if (!equal(p.x, own[k][0]) || !equal(p.y, own[k][1]) || (!plane && !equal(p.z, own[k][2])))
      throw refused(part.lines[first + k], "point " + std::to_string(k) + " of " + name + " is not that of the case");
  }
}

void compare_count(std::size_t line, std::size_t own, const std::string& what, std::size_t found) {
  if (found == own) return;
  throw refused(line,
                "the case has " + std::to_string(own) + " " + what + ", the certificate " + std::to_string(found));
}

void compare_body(const Body& body, const OwnBody& own, const std::string& name, bool plane) {
  if (body.core == Body::Core::pieces) {
    compare_count(body.line, own.pieces.size(), "pieces in " + name, body.pieces.size());
    for (std::size_t i = 0; i < own.pieces.size(); ++i) {
      const std::string piece = "piece " + std::to_string(i) + " of " + name;
      compare_count(body.pieces[i].line, own.pieces[i].size(), "points in " + piece,
                    (body.pieces[i].end - begin_of(body.pieces, i)) / body.levels);
      compare_points(body.points, begin_of(body.pieces, i), own.pieces[i], piece, plane);
    }
    return;
  }
  if (own.has_pieces)
    throw refused(body.line, "the case has pieces in " + name + ", the certificate is about a convex body");
  if (body.core != Body::Core::points)
    throw refused(body.line, "the case has points in " + name + ": only points can be compared with it");
  if (body.radius.num.sign() != 0)
    throw refused(body.line, "the case has no radius around " + name + ", the certificate has one");
  compare_count(body.points.line, own.pieces.front().size(), "points in " + name,
                body.points.items.size() / body.levels);
  compare_points(body.points, 0, own.pieces.front(), name, plane);
}

}  // namespace

CaseFile::CaseFile(std::string_view text) {
  JsonReader reader(text, 1);
  while (reader.more()) {
    const std::size_t line = reader.line();
    Budget for_json;
    read(reader.next(for_json), line);
  }
  if (cases_.empty()) throw malformed(1, "expected a case, found none");
}

void CaseFile::read(const Json& value, std::size_t line) {
  const Json* const schema = value.kind == Kind::object ? value.field("schema", line) : nullptr;
  if (!schema || schema->kind != Kind::text || schema->text != "fathom/golden-export/1")
    return read_one(value, line, false);
  const Json* const cases = value.field("cases", line);
  if (!cases || cases->kind != Kind::array) throw malformed(line, "expected an array 'cases' in the export");
  for (const Json& item : cases->items) read_one(item, line, true);
}

void CaseFile::read_one(const Json& value, std::size_t line, bool of_export) {
  const CaseReader reader(value, line, budget_, of_export);
  by_id_[reader.id()].push_back(cases_.size());
  cases_.push_back({reader.body("a"), reader.body("b"), reader.is_of_plane()});
}

const CaseFile::Bodies& CaseFile::find(const Certificate& certificate,
                                       const std::optional<std::string>& result_id) const {
  if (!result_id && cases_.size() == 1) return cases_.front();
  constexpr std::size_t first_line = 1;
  if (!result_id && certificate.id.empty()) throw refused(first_line, "without an id, none of the cases can be found");
  const auto found = by_id_.find(result_id ? *result_id : unescaped(certificate.id));
  if (found == by_id_.end()) throw refused(first_line, "no case has this id");
  if (found->second.size() > 1) throw refused(first_line, "several cases have this id");
  return cases_[found->second.front()];
}

void CaseFile::compare(const Certificate& certificate, bool width, const std::optional<std::string>& result_id) const {
  for (const Body* const body : {&certificate.a, &certificate.b})
    if (body->core == Body::Core::solid) throw refused(body->line, "a solid is not what a case holds");
  if (certificate.format == 6) throw refused(certificate.a.line, "bodies in motion are not compared with a case");
  const Bodies& own = find(certificate, result_id);
  if (own.plane != certificate.raising.has_value())
    throw refused(certificate.a.line, own.plane ? "the case is of the plane, the certificate of space"
                                                : "the case is of space, the certificate of the plane");
  compare_body(certificate.a, own.a, "a", own.plane);
  if (!width) compare_body(certificate.b, own.b, "b", own.plane);
}

void require_width(const Certificate& certificate) {
  const Body &a = certificate.a, &b = certificate.b;
  if (certificate.raising) throw refused(certificate.raising->line, "bodies of the plane have no width here");
  if (certificate.format == 6) throw refused(a.line, "bodies in motion have no width");
  if (a.core == Body::Core::solid) throw refused(a.line, "solids have no width here: it is that of a convex body");
  if (a.core == Body::Core::pieces) throw refused(a.line, "unions have no width here: it is that of a convex body");
  const bool equal =
      a.core == b.core && same(a.points.items, b.points.items) && same(a.terms, b.terms) && same(a.radius, b.radius);
  // A half-space has no width, and two of them are refused.
  if (!equal) throw refused(b.line, "b does not repeat what a is: this is not the width of a body");
}

// Lines of results.

namespace {

/// The fields of one object that matter here; knows the line for messages.
class Fields {
 public:
  Fields(const Json& object, std::size_t line) : object_(&object), line_(line) {}

  [[nodiscard]] std::optional<std::string> text(std::string_view key, bool or_number = false) const {
    const Json* const field = object_->field(key, line_);
    if (!field) return std::nullopt;
    if (field->kind != Json::Kind::text && (!or_number || field->kind != Json::Kind::number))
      throw wrong("a text", key);
    return field->text;
  }

  [[nodiscard]] std::optional<Result::Square> square(std::string_view key) const {
    const std::optional<Fields> fields = object(key);
    if (!fields) return std::nullopt;
    const Json* const squared = fields->object_->field("squared", line_);
    if (squared && squared->kind == Json::Kind::null) return Result::Square{};
    return Result::Square{fields->rational("squared")};
  }

  /// Of unions it is in the field "apart", which is null unless they are.
  [[nodiscard]] std::vector<Result::Square> distances() const {
    std::vector<Result::Square> result;
    if (const auto found = square("distance")) result.push_back(*found);
    const Json* const of_unions = object_->field("apart", line_);
    if (!of_unions || of_unions->kind == Json::Kind::null) return result;
    if (const auto found = object("apart")->square("distance")) result.push_back(*found);
    return result;
  }

  [[nodiscard]] std::optional<Result::SignedDepth> signed_depth(std::string_view key) const {
    const std::optional<Fields> fields = object(key);
    if (!fields) return std::nullopt;
    Result::SignedDepth result{fields->number("low"), fields->number("high"), std::nullopt};
    const Json* const exact = fields->object_->field("exact", line_);
    if (!exact || exact->kind == Json::Kind::null) return result;
    const Fields parts = *fields->object("exact");
    result.exact = Result::Exact{parts.sign("sign"), parts.rational("root"), parts.rational("plus")};
    return result;
  }

 private:
  [[nodiscard]] std::optional<Fields> object(std::string_view key) const {
    const Json* const field = object_->field(key, line_);
    if (!field) return std::nullopt;
    if (field->kind != Json::Kind::object) throw wrong("an object", key);
    return Fields(*field, line_);
  }

  /// A text that holds an exact number.
  [[nodiscard]] mpq_class rational(std::string_view key) const {
    const std::optional<std::string> found = text(key);
    const std::optional<mpq_class> value = found ? rational_of(*found) : std::nullopt;
    if (!value) throw wrong("an integer or a fraction, in the notation of certificates,", key);
    return *value;
  }

  /// A number, or null.
  [[nodiscard]] std::optional<mpq_class> number(std::string_view key) const {
    const Json* const field = object_->field(key, line_);
    if (field && field->kind == Json::Kind::null) return std::nullopt;
    std::optional<mpq_class> value;
    if (field && field->kind == Json::Kind::number) value = nearest_binary64(field->text);
    if (!value) throw wrong("a number within the range of binary64, or null,", key);
    return value;
  }

  [[nodiscard]] int sign(std::string_view key) const {
    const Json* const field = object_->field(key, line_);
    if (field && field->kind == Json::Kind::number)
      for (const int sign : {-1, 0, 1})
        if (field->text == std::to_string(sign)) return sign;
    throw wrong("-1, 0 or 1", key);
  }

  [[nodiscard]] Fault wrong(const std::string& expected, std::string_view key) const {
    return malformed(line_, "expected " + expected + " in the field " + shown(key));
  }

  static std::optional<mpq_class> rational_of(std::string_view text) {
    const std::size_t slash = text.find('/');
    const std::string_view num = text.substr(0, slash),
                           den = slash == std::string_view::npos ? "1" : text.substr(slash + 1);
    const std::string_view digits = num.substr(!num.empty() && num[0] == '-' ? 1 : 0);
    if (!is_natural(digits) || !is_natural(den) || std::max(digits.size(), den.size()) > longest_number)
      return std::nullopt;
    mpq_class result(to_integer(num), to_integer(den));
    if (result.get_den() == 0) return std::nullopt;
    result.canonicalize();
    return result;
  }

  const Json* object_;
  std::size_t line_;
};

/// With its sign.
mpq_class squared(const mpq_class& x) { return x * abs(x); }

/// How x compares with the signed depth, of which this bound was proved.
int compare_with(const mpq_class& x, const Certificate& c, const Rational& bound) {
  if (is_exact(c)) return cmp(squared(x - radii(c)), squared_of_cores(c));
  return c.claim == Claim::bounds ? cmp(squared(x), value(bound)) : cmp(x, value(bound));
}

bool is_proved(const Result::Exact& exact, const Certificate& c) {
  if (exact.root < 0 || (exact.sign == 0) != (exact.root == 0)) return false;
  if (is_exact(c)) return exact.sign * exact.root == squared_of_cores(c) && exact.plus == radii(c);
  return c.claim == Claim::signed_bounds && exact.sign == 0 && exact.plus == value(c.low) &&
         exact.plus == value(c.high);
}

/// Whether the root of `square` is the depth or the distance that is proved: x^2 = square for the
/// signed depth x. If it is root + rho, the square is square(root) + 2 rho root + rho^2: so it must
/// be (square + rho^2 - square(root)) / (2 rho).
bool is_square_of_signed_depth(const mpq_class& square, const Certificate& c) {
  if (!is_exact(c)) return value(c.low) == value(c.high) && square == value(c.low) * value(c.low);
  const mpq_class rho = radii(c), cores = squared_of_cores(c);
  if (rho == 0) return square == abs(cores);
  const mpq_class depth = (square + rho * rho - abs(cores)) / (2 * rho);
  return depth * depth == square && sgn(depth - rho) == sgn(cores);
}

/// Whether the result's depth is that of a certificate of format 2 or 4: 0 unless they penetrate,
/// and then null or its square.
bool is_depth(const std::optional<mpq_class>& square, const Certificate& c) {
  const std::string_view state = status(c);
  if (state == "penetrating") return !square || is_square_of_signed_depth(*square, c);
  return state == "undecided" ? !square : square && *square == 0;
}

/// Whether the result's distance is that of a certificate of another format than 1: of bodies
/// that are disjoint, null or its square.
bool is_distance(const std::optional<mpq_class>& square, const Certificate& c) {
  if (std::string_view(status(c)) != "disjoint") return false;
  return is_of_unions(c) ? square && *square == value(c.low) : !square || is_square_of_signed_depth(*square, c);
}

/// `disjoint` proves that the signed depth is negative, and nothing else.
bool says_negative_alone(const Result::SignedDepth& depth) {
  return !depth.low && (!depth.high || *depth.high >= 0) && !depth.exact;
}

}  // namespace

void read_result(std::string_view text, std::size_t line, Result& result) {
  Budget budget;
  JsonReader reader(text, line);
  const Json object = reader.next(budget);
  if (reader.more() || object.kind != Json::Kind::object) throw malformed(line, "expected one JSON object on the line");
  const Fields fields(object, line);
  result.id = fields.text("id", true);
  const std::optional<std::string> certificate = fields.text("certificate");
  if (!certificate) throw malformed(line, "expected a field 'certificate', found none");
  result.certificate = *certificate;
  result.status = fields.text("status");
  result.depth = fields.square("depth");
  result.bound = fields.square("bound");
  result.signed_depth = fields.signed_depth("signed_depth");
  result.distances = fields.distances();
}

void compare(const Result& result, const Certificate& c) {
  const auto demand = [&c](bool right, const char* fault) {
    if (!right) throw refused(c.claim_line, fault);
  };
  demand(c.claim != Claim::solid, "a solid is no result");
  demand(c.format != 6, "a result of bodies at rest, of a certificate of bodies in motion");
  demand(!result.id || c.id.empty() || unescaped(c.id) == *result.id,
         "the result's id is another than the certificate's");
  demand(!result.status || *result.status == status(c), "the result's status is another than the certificate's");
  if (c.claim == Claim::disjoint)
    demand(result.distances.empty() && (!result.signed_depth || says_negative_alone(*result.signed_depth)),
           "distance not proved: 'disjoint' says that there is one, not how long it is");
  for (const Result::Square& distance : result.distances)
    demand(is_distance(distance.value, c), "the result's distance is another than the certificate's");
  if (is_of_unions(c)) {
    demand(!result.depth || result.depth->value == (c.claim == Claim::depth ? value(c.low) : 0),
           "the result's depth is another than the certificate's");
    demand(!result.bound && !result.signed_depth,
           "the result has a bound or a signed depth, which do not go with unions");
    return;
  }
  if (result.signed_depth && c.claim != Claim::disjoint) {
    const auto& [low, high, exact] = *result.signed_depth;
    demand(!low || compare_with(*low, c, c.low) <= 0, "the result's signed depth is above what the certificate proves");
    demand(!high || compare_with(*high, c, c.high) >= 0,
           "the result's signed depth is below what the certificate proves");
    demand(!exact || is_proved(*exact, c), "the result's exact signed depth is another than the certificate's");
  }
  if (is_of_bodies(c.format)) {
    demand(!result.depth || is_depth(result.depth->value, c), "the result's depth is another than the certificate's");
    return demand(!result.bound, "the result has a bound, which goes with format 1");
  }
  const mpq_class low = value(c.low), high = value(c.high);
  demand(!result.depth || result.depth->value == high, "the result's depth is another than the certificate's");
  demand(!result.bound || result.bound->value == low, "the result's bound is another than the certificate's");
  demand(!result.depth || result.bound || low == high, "the result has a depth, the certificate proves bounds only");
}

}  // namespace fathom_check
