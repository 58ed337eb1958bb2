// SPDX-License-Identifier: Apache-2.0
#include "cases.hpp"

#include "json.hpp"
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

}  // namespace fathom_check
