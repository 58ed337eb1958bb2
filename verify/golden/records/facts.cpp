// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/records/facts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/number/rational.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::golden {
namespace {

// ---- faces ----

// A face lies in a plane with normal n. Dropping a coordinate in which n is not 0 maps it
// one-to-one into a coordinate plane, and there a monotone chain finds the corners.

/// The two coordinates that remain.
struct Shadow {
  mpz_class Vector::*u;
  mpz_class Vector::*v;

  explicit Shadow(const Vector& n) : u(&Vector::x), v(&Vector::y) {
    if (n.z != 0) return;
    v = &Vector::z;
    if (n.y == 0) u = &Vector::y;
  }

  /// Positive when p, q, r turn left.
  [[nodiscard]] int turn(const Vector& p, const Vector& q, const Vector& r) const {
    const mpz_class left = (q.*u - p.*u) * (r.*v - p.*v), right = (q.*v - p.*v) * (r.*u - p.*u);
    return cmp(left, right);
  }
  [[nodiscard]] int order(const Vector& p, const Vector& q) const {
    const int first = cmp(p.*u, q.*u);
    return first != 0 ? first : cmp(p.*v, q.*v);
  }
};

using Ids = std::vector<std::uint32_t>;

/// Appends the lower chain of `sorted`, its last point left out.
template <class Iterator>
void append_chain(Iterator first, Iterator last, std::span<const Vector> points, const Shadow& shadow, Ids& cycle) {
  const std::size_t begin = cycle.size();
  for (; first != last; ++first) {
    while (cycle.size() >= begin + 2 &&
           shadow.turn(points[cycle[cycle.size() - 2]], points[cycle.back()], points[*first]) <= 0)
      cycle.pop_back();
    cycle.push_back(*first);
  }
  cycle.pop_back();
}

/// The corners of coplanar points in cyclic order.
Ids corner_cycle(Ids ids, std::span<const Vector> points, const Shadow& shadow) {
  std::ranges::sort(ids, [&](std::uint32_t i, std::uint32_t j) {
    const int order = shadow.order(points[i], points[j]);
    return order != 0 ? order < 0 : i < j;
  });
  const auto equal = [&](std::uint32_t i, std::uint32_t j) { return shadow.order(points[i], points[j]) == 0; };
  ids.erase(std::unique(ids.begin(), ids.end(), equal), ids.end());
  if (ids.size() == 1) return ids;
  Ids cycle;
  append_chain(ids.begin(), ids.end(), points, shadow, cycle);
  append_chain(ids.rbegin(), ids.rend(), points, shadow, cycle);
  return cycle;
}

void take_denominator(const mpq_class& value, mpz_class& common) {
  mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), value.get_den_mpz_t());
}

std::vector<Vector> scaled(std::span<const Point> points, const mpz_class& denominator) {
  const auto times = [&denominator](const mpq_class& value) {
    return mpz_class(denominator / value.get_den() * value.get_num());
  };
  std::vector<Vector> result;
  result.reserve(points.size());
  for (const Point& p : points) result.push_back({times(p.x), times(p.y), times(p.z)});
  return result;
}

/// The hull and the measures of a body.
struct BodyLook {
  std::vector<Vector> distinct;  ///< its points, each once, in lexicographic order
  polytope::Polytope hull;
  std::vector<Vector> edges;    ///< primitive directions with a positive first component that is not 0, sorted
  std::vector<Vector> normals;  ///< of facets, outward, sorted
  mpq_class shortest, longest;  ///< sides of the axis-parallel bounding box

  BodyLook(const std::vector<Vector>& points, const mpz_class& denominator);
};

/// A record with the hulls and measures of its bodies.
struct Look {
  const HullStatement& truth;
  Integers integers;
  BodyLook a, b;
  /// magnitudes of coordinates other than 0, in the unit of `integers`; 0 if there are none
  mpz_class greatest, least;

  Look(const HullPair& hulls, const HullStatement& found);

  [[nodiscard]] const mpq_class& extent() const { return a.longest < b.longest ? b.longest : a.longest; }
};

void sort_uniquely(std::vector<Vector>& vectors) {
  std::ranges::sort(vectors, lexicographically_less);
  vectors.erase(std::unique(vectors.begin(), vectors.end()), vectors.end());
}

/// v or -v, whichever comes later in lexicographic order.
Vector without_sense(Vector v) {
  const int sign = v.x != 0 ? sgn(v.x) : v.y != 0 ? sgn(v.y) : sgn(v.z);
  return sign < 0 ? -v : v;
}

BodyLook::BodyLook(const std::vector<Vector>& points, const mpz_class& denominator)
    : distinct(points), hull(polytope::convex_hull(points)) {
  sort_uniquely(distinct);
  for (const polytope::Edge& edge : hull.edges)
    edges.push_back(without_sense(primitive(hull.vertices[edge.to] - hull.vertices[edge.from])));
  for (const polytope::Facet& facet : hull.facets) normals.push_back(facet.normal);
  sort_uniquely(edges);
  sort_uniquely(normals);
  const mpz_class Vector::*const axes[] = {&Vector::x, &Vector::y, &Vector::z};
  std::vector<mpz_class> sides;
  for (const auto axis : axes) {
    const auto [low, high] =
        std::ranges::minmax_element(hull.vertices, {}, [axis](const Vector& v) -> const mpz_class& { return v.*axis; });
    sides.emplace_back((*high).*axis - (*low).*axis);
  }
  shortest = kernels::ratio(*std::ranges::min_element(sides), denominator);
  longest = kernels::ratio(*std::ranges::max_element(sides), denominator);
}

Look::Look(const HullPair& hulls, const HullStatement& found)
    : truth(found),
      integers(integers_of(hulls.a.points, hulls.b.points)),
      a(integers.a, integers.denominator),
      b(integers.b, integers.denominator) {
  for (const std::vector<Vector>* points : {&integers.a, &integers.b}) {
    for (const Vector& p : *points) {
      for (const mpz_class* c : {&p.x, &p.y, &p.z}) {
        if (*c == 0) continue;
        const mpz_class size = abs(*c);
        if (size > greatest) greatest = size;
        if (least == 0 || size < least) least = size;
      }
    }
  }
}

/// Whether two sorted lists share a vector.
bool meet(const std::vector<Vector>& u, const std::vector<Vector>& v) {
  auto i = u.begin(), j = v.begin();
  while (i != u.end() && j != v.end()) {
    if (lexicographically_less(*i, *j)) ++i;
    else if (lexicographically_less(*j, *i)) ++j;
    else return true;
  }
  return false;
}

mpq_class magnitude(const mpz_class& n, const Look& look) { return kernels::ratio(n, look.integers.denominator); }

bool penetrating(const Look& look) { return look.truth.answer.status() == Status::penetrating; }

bool flat_difference(const Look& look) {
  std::vector<Vector> directions{{0, 0, 0}};
  for (const std::vector<Vector>* points : {&look.integers.a, &look.integers.b}) {
    for (const Vector& p : *points) directions.push_back(p - points->front());
  }
  return polytope::affine_rank(directions) < 3;
}

bool near_tie(const Look& look) {
  return look.truth.gap && *look.truth.gap < look.truth.answer.squared() * (1 + kernels::times_power_of_two(1, -20));
}

bool degenerate_contact(const Look& look) {
  return std::ranges::any_of(look.truth.answer.optima(), [](const Optimum& optimum) {
    const ContactKind kind = optimum.contact.kind;
    return kind == ContactKind::facet_edge || kind == ContactKind::edge_facet || kind == ContactKind::facet_facet;
  });
}

bool duplicate_points(const Look& look) {
  return look.a.distinct.size() < look.integers.a.size() || look.b.distinct.size() < look.integers.b.size();
}

bool redundant_points(const Look& look) {
  return look.a.hull.vertices.size() < look.a.distinct.size() || look.b.hull.vertices.size() < look.b.distinct.size();
}

bool identical_bodies(const Look& look) {
  std::vector<Vector> a = look.a.hull.vertices, b = look.b.hull.vertices;
  std::ranges::sort(a, lexicographically_less);
  std::ranges::sort(b, lexicographically_less);
  return a == b;
}

bool polygonal(const polytope::Polytope& hull) {
  return hull.rank == 3 &&
         std::ranges::any_of(hull.facets, [](const polytope::Facet& facet) { return facet.end - facet.begin > 3; });
}

bool opposite_normals(const Look& look) {
  std::vector<Vector> turned;
  for (const Vector& n : look.a.normals) turned.push_back(-n);
  std::ranges::reverse(turned);  // sorted again
  return meet(turned, look.b.normals);
}

bool offset(const Look& look) {
  return magnitude(look.greatest, look) > kernels::times_power_of_two(1, 20) * look.extent();
}

/// Whether a squared length is below (2^-20 of the larger extent)^2.
bool short_length(const mpq_class& squared, const Look& look) {
  return squared < look.extent() * look.extent() * kernels::times_power_of_two(1, -40);
}

bool deep(const Look& look) {
  const mpq_class& side = std::min(look.a.shortest, look.b.shortest);
  return penetrating(look) && 4 * look.truth.answer.squared() >= side * side && side > 0;
}

using Modes = std::array<double, 3> Rounded::*;

// These functions read correctly rounded values: rd and ru are equal exactly if the value is a
// number of the format, and the value is below a number of the format exactly if rd is.
template <Modes Format>
bool depth_in_format(const Look& look) {
  return penetrating(look) && (look.truth.depth.*Format)[1] == (look.truth.depth.*Format)[2];
}

template <Modes Format>
bool depth_outside(const Look& look) {
  const double normal =
      Format == &Rounded::binary64 ? std::numeric_limits<double>::min() : std::numeric_limits<float>::min();
  return penetrating(look) && ((look.truth.depth.*Format)[1] < normal || std::isinf((look.truth.depth.*Format)[0]));
}

/// floor(sqrt(q)) after scaling by a power of two, with exactly `bits` bits.
mpz_class leading_bits_of_root(const mpq_class& q, long bits) {
  const long shift = bits + 1 - kernels::binary_order(q) / 2;
  const mpq_class scaled = q * kernels::times_power_of_two(1, 2 * shift);
  const mpz_class square = scaled.get_num() / scaled.get_den();
  mpz_class root = sqrt(square);
  root >>= mpz_sizeinbase(root.get_mpz_t(), 2) - static_cast<std::size_t>(bits);
  return root;
}

/// Returns whether the depth is not a number of the format, but within 2^-20 ulp of a number of the
/// format or of the middle between two, where rounded values change.
template <Modes Format, long Precision>
bool hard_rounding(const Look& look) {
  constexpr long beyond = 19;
  if (!penetrating(look) || depth_in_format<Format>(look) || depth_outside<Format>(look)) return false;
  mpz_class tail = leading_bits_of_root(look.truth.answer.squared(), Precision + 1 + beyond);
  mpz_fdiv_r_2exp(tail.get_mpz_t(), tail.get_mpz_t(), beyond);
  return tail == 0 || tail == (1 << beyond) - 1;
}

struct Flag {
  std::string_view name;
  bool (*holds)(const Look& look);
};

constexpr Modes f64 = &Rounded::binary64, f32 = &Rounded::binary32;

const Flag table[] = {
    {"flat_a", [](const Look& look) { return look.truth.answer.flat_a; }},
    {"flat_b", [](const Look& look) { return look.truth.answer.flat_b; }},
    {"flat_difference", flat_difference},
    {"ties", [](const Look& look) { return look.truth.answer.optima().size() > 1; }},
    {"near_tie", near_tie},
    {"all_tie", [](const Look& look) { return penetrating(look) && !look.truth.gap; }},
    {"degenerate_contact", degenerate_contact},
    {"duplicate_points", duplicate_points},
    {"redundant_points", redundant_points},
    {"polygonal_facets", [](const Look& look) { return polygonal(look.a.hull) || polygonal(look.b.hull); }},
    {"shared_points", [](const Look& look) { return meet(look.a.distinct, look.b.distinct); }},
    {"identical_bodies", identical_bodies},
    {"parallel_edges", [](const Look& look) { return meet(look.a.edges, look.b.edges); }},
    {"equal_normals", [](const Look& look) { return meet(look.a.normals, look.b.normals); }},
    {"opposite_normals", opposite_normals},
    {"huge_coordinates",
     [](const Look& look) { return magnitude(look.greatest, look) >= kernels::times_power_of_two(1, 128); }},
    {"tiny_coordinates",
     [](const Look& look) {
       return look.least != 0 && magnitude(look.least, look) < kernels::times_power_of_two(1, -126);
     }},
    {"uneven_coordinates",
     [](const Look& look) { return look.greatest > look.least * mpz_class(kernels::times_power_of_two(1, 53)); }},
    {"offset_coordinates", offset},
    {"thin_penetration",
     [](const Look& look) { return penetrating(look) && short_length(look.truth.answer.squared(), look); }},
    {"deep_penetration", deep},
    {"thin_clearance",
     [](const Look& look) {
       return look.truth.answer.distance() && short_length(look.truth.answer.distance()->squared, look);
     }},
    {"depth_in_binary64", depth_in_format<f64>},
    {"depth_in_binary32", depth_in_format<f32>},
    {"depth_outside_binary64", depth_outside<f64>},
    {"depth_outside_binary32", depth_outside<f32>},
    {"hard_rounding_binary64", hard_rounding<f64, 53>},
    {"hard_rounding_binary32", hard_rounding<f32, 24>},
};

Rounded in_order(const kernels::Roundings& roundings) {
  const auto& [rn, rd, ru] = roundings.binary64;
  const auto& [rn32, rd32, ru32] = roundings.binary32;
  return {{rn, rd, ru}, {rn32, rd32, ru32}};
}

Rounded signed_root(const mpz_class& component, const mpz_class& norm) {
  if (component == 0) return {};
  Rounded root = rounded_root(kernels::ratio(component * component, norm));
  if (component > 0) return root;
  for (std::array<double, 3>* values : {&root.binary64, &root.binary32}) {
    for (double& value : *values) value = -value;
    std::swap((*values)[1], (*values)[2]);
  }
  return root;
}

/// Returns the flags that hold. Everything in `truth` but the flags must be set.
std::vector<std::string_view> flags_of(const HullPair& hulls, const HullStatement& truth) {
  const Look look(hulls, truth);
  std::vector<std::string_view> result;
  for (const Flag& flag : table) {
    if (flag.holds(look)) result.push_back(flag.name);
  }
  return result;
}

}  // namespace

Integers integers_of(std::span<const Point> a, std::span<const Point> b) {
  Integers result;
  for (const std::span<const Point> points : {a, b}) {
    for (const Point& p : points) {
      for (const mpq_class* c : {&p.x, &p.y, &p.z}) take_denominator(*c, result.denominator);
    }
  }
  result.a = scaled(a, result.denominator);
  result.b = scaled(b, result.denominator);
  return result;
}

SupportingFace face_in_direction(std::span<const Vector> points, const Vector& n) {
  SupportingFace face;
  Ids highest;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const mpz_class height = dot(n, points[i]);
    const int above = highest.empty() ? 1 : cmp(height, face.height);
    if (above > 0) {
      highest.clear();
      face.height = height;
    }
    if (above >= 0) highest.push_back(i);
  }
  face.corners = corner_cycle(std::move(highest), points, Shadow(n));
  for (const std::uint32_t i : face.corners) face.cycle.push_back(points[i]);
  std::ranges::sort(face.corners);
  return face;
}

bool contains(const SupportingFace& face, const Vector& n, const mpz_class& denominator, const Point& p) {
  // In the unit 1 / (denominator * own) everything is an integer.
  mpz_class own = 1;
  for (const mpq_class* c : {&p.x, &p.y, &p.z}) take_denominator(*c, own);
  const mpz_class unit = own * denominator;
  const Vector at = scaled(std::span(&p, 1), unit).front();
  if (dot(n, at) != face.height * own) return false;
  std::vector<Vector> cycle;
  for (const Vector& corner : face.cycle) cycle.push_back({corner.x * own, corner.y * own, corner.z * own});
  const Shadow shadow(n);
  if (cycle.size() == 1) return shadow.order(at, cycle[0]) == 0;
  if (cycle.size() == 2) {
    return shadow.turn(cycle[0], cycle[1], at) == 0 && shadow.order(cycle[0], at) * shadow.order(at, cycle[1]) >= 0;
  }
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    if (shadow.turn(cycle[i], cycle[(i + 1) % cycle.size()], at) < 0) return false;
  }
  return true;
}

// ---- flags ----

std::vector<std::string_view> flag_names() {
  std::vector<std::string_view> names;
  for (const Flag& flag : table) names.push_back(flag.name);
  return names;
}

// ---- numbers ----

Rounded rounded_value(const mpq_class& value) { return in_order(kernels::roundings(value)); }

Rounded rounded_surd(const Surd& value) {
  if (value.root == 0) return rounded_value(value.rational);
  Rounded result{};
  constexpr std::array modes{Rounding::rn, Rounding::rd, Rounding::ru};
  for (std::size_t i = 0; i < modes.size(); ++i) {
    result.binary64[i] = round_binary64(value, modes[i]);
    result.binary32[i] = double{round_binary32(value, modes[i])};
  }
  return result;
}

Rounded rounded_root(const mpq_class& squared) { return in_order(kernels::roundings_of_root(squared)); }

RoundedVector rounded_unit(const Vector& n) {
  const mpz_class norm = dot(n, n);
  return {signed_root(n.x, norm), signed_root(n.y, norm), signed_root(n.z, norm)};
}

RoundedVector rounded_point(const Point& p) { return {rounded_value(p.x), rounded_value(p.y), rounded_value(p.z)}; }

RoundedVector rounded_along(const AlongNormal& vector) {
  const mpz_class norm = dot(vector.normal, vector.normal);
  const auto component = [&](const mpz_class& n) {
    const mpq_class along = vector.beta * n;
    return rounded_surd({vector.alpha * n, along * abs(along) / norm});
  };
  return {component(vector.normal.x), component(vector.normal.y), component(vector.normal.z)};
}

// ---- truth ----

HullStatement truth_of(const HullPair& hulls, Depth answer, Monitor* monitor, Workspace* workspace) {
  HullStatement truth;
  truth.depth = rounded_root(answer.squared());
  for (const Optimum& optimum : answer.optima()) {
    truth.units.push_back(rounded_unit(optimum.direction));
    truth.translations.push_back(rounded_point(optimum.translation()));
  }
  if (const Penetration* const penetration = answer.penetration())
    truth.gap = second_nearest_squared(hulls.a, hulls.b, *penetration, monitor, workspace);
  else truth.units.push_back(rounded_unit(answer.direction()));
  if (const Distance* const distance = answer.distance()) {
    truth.distance = rounded_root(distance->squared);
    truth.translations.push_back(rounded_point(distance->translation));
  }
  truth.answer = std::move(answer);
  truth.flags = flags_of(hulls, truth);
  return truth;
}

ShapeStatement truth_of(const SignedDepth& answer) {
  return {answer.exact() ? std::variant<Surd, Bounds>(*answer.exact()) : *answer.bounds(), answer.direction(),
          answer.translations(), answer.cone};
}

UnionStatement truth_of(const UnionDepth& answer) {
  UnionStatement truth{answer.status, answer.squared(), {}, std::nullopt};
  if (answer.status == Status::penetrating)
    for (const UnionOptimum& optimum : answer.optima) truth.optima.push_back(optimum.translation);
  if (answer.apart)
    truth.gap = {answer.apart->distance.squared, answer.apart->a, answer.apart->b, answer.apart->distance.translation};
  return truth;
}

PlaneStatement truth_of(const Answer& answer) {
  const SignedDepth& depth = std::get<SignedDepth>(answer.found);
  const Depth& cores = std::get<Depth>(depth.core);
  PlaneStatement truth{truth_of(depth), {}};
  for (const Optimum& optimum : cores.optima()) truth.contacts.push_back(optimum.contact);
  if (const Distance* const distance = cores.distance()) truth.contacts.push_back(distance->contact);
  return truth;
}

SignedDepth answer_about(const Shape& a, const Shape& b, const Options& options) {
  constexpr unsigned first_bits = 40, most_bits = 80;
  SignedDepthOptions asked;
  asked.cores = options;
  asked.coaxial = false;  // the certificate, which has to prove the record, does not state it
  for (asked.bits = first_bits;; asked.bits *= 2) {
    SignedDepth answer = signed_depth(a, b, asked);
    if (answer.status() || asked.bits == most_bits) return answer;
  }
}

UnionDepth answer_about(const Pieces& a, const Pieces& b, Monitor* monitor) {
  UnionOptions options;
  options.monitor = monitor;
  options.bounds = false;
  UnionDepth answer = union_depth(a, b, options);
  if (!answer.complete) throw Interrupted();
  return answer;
}

Answer answer_about(const families::PlanePair& bodies, const Options& options) {
  Question question;
  question.options = options;
  return exact_answer(bodies.a, bodies.b, question);
}

// ---- records ----

Facts facts_of(const Recipe& recipe, FormedCase made, RecordStatement truth, std::string certificate_sha256,
               std::optional<ContactFacts> contacts) {
  Facts facts{
      recipe, std::move(made), false, false, std::move(truth), std::move(certificate_sha256), std::move(contacts)};
  if (auto* const hulls = std::get_if<HullPair>(&facts.made.bodies))
    for (Body* body : {&hulls->a, &hulls->b}) body->points = in_simplest_form(body->points);
  facts.in_binary64 = in_format(facts.made.bodies, Form::binary64);
  facts.in_binary32 = facts.in_binary64 && in_format(facts.made.bodies, Form::binary32);
  return facts;
}

}  // namespace fathom::golden
