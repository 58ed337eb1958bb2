// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate of unions as text: format 3, with a direction for each pair of pieces; or format
// 5, with blocks of pairs, and with solids as they are.
//                                                 [verify/check/FORMAT.md, sections 12, 14 and 15]
#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "fathom/certificate.hpp"
#include "fathom/solid.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/certificate/certificate.hpp"
#include "reference/polytope/position.hpp"
#include "reference/solids/solid_values.hpp"
#include "reference/unions/union_prover.hpp"

namespace fathom::certificate {
namespace {

/// A body as a certificate lists its pieces: a solid may list one several times.
struct ListedBody {
  explicit ListedBody(const Pieces& all) : pieces(all) {}
  explicit ListedBody(const Body& body) : solid(body.solid.get()) {
    if (solid == nullptr) pieces = pieces_of(body);
    else list();
  }

  /// The number here of a piece of pieces_of(body).
  [[nodiscard]] std::uint32_t number(std::uint32_t piece) const {
    if (piece >= (solid == nullptr ? pieces.size() : first.size())) contradiction("no such pieces");
    return solid == nullptr ? piece : first[piece];
  }

  const Solid* solid = nullptr;
  Pieces pieces;
  std::vector<std::vector<std::uint32_t>> corners;  ///< of a solid: for each piece the numbers of its points
  std::vector<std::uint32_t> first;                 ///< of a solid: which of its pieces are no repetitions

 private:
  void list() {
    for (std::uint32_t i = 0; i < solid->pieces.size(); ++i) {
      if (!solids::is_repeated(*solid, i)) first.push_back(i);
      corners.push_back(solids::corners_of(solid->pieces[i]));
      std::vector<Point>& points = pieces.emplace_back();
      for (const std::uint32_t k : corners.back()) points.push_back(solid->points.at(k));
    }
  }
};

// Half of the numbers that a certificate may have, three for each direction: the others are for
// points, polytopes and the tree.                                            [FORMAT.md, section 8]
constexpr std::size_t most_numbers = 10'000'000 / 2;

/// Whether the proof is of format 5: where format 3 has no words for a body, where its one lattice
/// for all pieces would be out of proportion, or its directions of all pairs too many.
bool needs_blocks(const ListedBody& a, const ListedBody& b, const unions::PlacedPieces& placed,
                  const UnionDepth& answer) {
  if (a.solid != nullptr || b.solid != nullptr || !placed.on_one_lattice()) return true;
  const std::size_t lists = std::max<std::size_t>(answer.optima.size(), 1);
  return a.pieces.size() * b.pieces.size() > most_numbers / 3 / lists;
}

class UnionWriter {
 public:
  UnionWriter(kernels::Context& context, ListedBody a, ListedBody b, const UnionDepth& answer, std::string_view id)
      : context_(context),
        a_(std::move(a)),
        b_(std::move(b)),
        pieces_(unions::place_pieces(a_.pieces, b_.pieces)),
        answer_(answer),
        blocks_(needs_blocks(a_, b_, pieces_, answer)),
        out_(20000) {
    write_header(out_, blocks_ ? 5 : 3, id);
    numbers_a_ = write_body("solid_a", "pieces_a", "a", a_);
    numbers_b_ = write_body("solid_b", "pieces_b", "b", b_);
  }

  std::string run() {
    if (answer_.status == Status::penetrating) penetrating();
    else if (answer_.status == Status::touching) touching(answer_.optima.at(0));
    else disjoint(answer_.apart.value());
    write_end(out_, counts_);
    return out_.take();
  }

 private:
  void penetrating() {
    const unions::UnionProof proof = unions::prove(context_, pieces_, answer_.optima);
    if (proof.squared != answer_.squared()) contradiction("another depth");
    out_.word("claim").word("depth").word(proof.squared).end();
    announce("optima", proof.optima.size());
    for (std::size_t i = 0; i < proof.optima.size(); ++i) {
      out_.word("optimum").words(proof.optima[i]).end();
      write_free(pieces_.point(proof.optima[i]), answer_.optima.at(i));
    }
    announce("polytopes", proof.polytopes.size());
    for (const unions::PiecePolytope& polytope : proof.polytopes) write_polytope(polytope);
    announce("tree", proof.nodes.size());
    for (const unions::ProofNode& node : proof.nodes) {
      if (node.split) out_.word("split").word(std::size_t{node.polytope});
      else out_.word("leaf");
      for (const std::uint32_t number : node.numbers) out_.word(std::size_t{number});
      out_.end();
    }
  }

  // The first pair of pieces that touch has a common point.
  void touching(const UnionOptimum& here) {
    const std::uint32_t i = a_.number(here.contacts.at(0).a), j = b_.number(here.contacts.at(0).b);
    out_.word("claim").word("touching").end();
    write_free({}, here);
    const polytope::PlacedPair pair = pieces_.pair(i, j);
    const polytope::PositionOfOrigin origin = polytope::position_of_origin(pair.a, pair.b);
    if (origin.position != polytope::Position::boundary) contradiction("pieces that do not touch");
    write_nearest(i, j, origin.a, origin.b);
  }

  // The first pair of nearest pieces has the nearest points.
  void disjoint(const UnionDistance& answer) {
    const std::uint32_t i = a_.number(answer.a), j = b_.number(answer.b);
    const polytope::PlacedPair pair = pieces_.pair(i, j);
    const polytope::NearestPoints nearest = polytope::nearest_points(pair.a, pair.b);
    if (squared(pair, nearest) != answer.distance.squared) contradiction("another distance");
    out_.word("claim").word("apart").word(answer.distance.squared).end();
    if (blocks_) {
      const Vector known[] = {answer.distance.direction};
      write_blocks(unions::distance_tree(context_, pieces_, answer.distance.squared, known));
    } else {
      write_separations(distances(answer.distance.squared));
    }
    write_nearest(i, j, nearest.a, nearest.b);
  }

  static mpq_class squared(const polytope::PlacedPair& pair, const polytope::NearestPoints& nearest) {
    return kernels::ratio(nearest.height * nearest.height, dot(nearest.normal, nearest.normal)) * pair.unit() *
           pair.unit();
  }

  // Each pair has a direction in which it is as far apart as it is.
  [[nodiscard]] std::vector<Vector> distances(const mpq_class& least) const {
    std::vector<Vector> directions;
    for (std::uint32_t i = 0; i < a_.pieces.size(); ++i) {
      for (std::uint32_t j = 0; j < b_.pieces.size(); ++j) {
        context_.check();
        const polytope::PlacedPair pair = pieces_.pair(i, j);
        polytope::NearestPoints nearest = polytope::nearest_points(pair.a, pair.b);
        if (squared(pair, nearest) < least) contradiction("nearer pieces");
        directions.push_back(std::move(nearest.normal));
      }
    }
    return directions;
  }

  // A line with a count, which the last line repeats.
  void announce(std::string_view name, std::size_t count) {
    counts_.push_back(count);
    out_.word(name).word(count).end();
  }

  // Returns the numbers of a solid's points in the text.
  std::vector<std::uint32_t> write_body(std::string_view of_solid, std::string_view all, std::string_view one,
                                        const ListedBody& body) {
    if (body.solid != nullptr) return write_solid(out_, of_solid, *body.solid, counts_);
    announce(all, body.pieces.size());
    for (const std::vector<Point>& piece : body.pieces) {
      counts_.push_back(piece.size());
      write_points(out_, one, std::span<const Point>(piece));
    }
    return {};
  }

  // That all pairs keep O moved by p free.
  void write_free(const kernels::RationalPoint& p, const UnionOptimum& optimum) {
    if (!blocks_) return write_separations(unions::separations(context_, pieces_, p));
    std::vector<Vector> known;
    for (const PieceContact& contact : optimum.contacts) known.push_back(contact.direction);
    write_blocks(unions::apart_tree(context_, pieces_, p, known));
  }

  void write_separations(const std::vector<Vector>& directions) {
    announce("separations", directions.size());
    for (const Vector& u : directions) out_.words(u).end();
  }

  void write_blocks(const std::vector<unions::ApartBlock>& blocks) {
    announce("apart", blocks.size());
    for (const unions::ApartBlock& block : blocks) {
      if (block.kind == unions::ApartBlock::Kind::apart) out_.words(block.direction);
      else out_.word(block.kind == unions::ApartBlock::Kind::halves_of_a ? "a" : "b");
      out_.end();
    }
  }

  void write_polytope(const unions::PiecePolytope& polytope) {
    out_.word("polytope").word(std::size_t{polytope.a}).word(std::size_t{polytope.b}).end();
    InnerPolytope inner = polytope.inner;
    for (auto& [k, l] : inner.vertices) {
      k = number(a_, numbers_a_, polytope.a, k);
      l = number(b_, numbers_b_, polytope.b, l);
    }
    write_inner(out_, inner);
    counts_.insert(counts_.end(), {inner.vertices.size(), inner.facets.size()});
  }

  // Of a point of a piece: in the piece, or among the points of a solid.
  static std::uint32_t number(const ListedBody& body, const std::vector<std::uint32_t>& numbers, std::uint32_t piece,
                              std::uint32_t point) {
    return body.solid == nullptr ? point : numbers[body.corners[piece][point]];
  }

  void write_nearest(std::uint32_t i, std::uint32_t j, std::vector<Weight> a, std::vector<Weight> b) {
    for (Weight& w : a) w.index = number(a_, numbers_a_, i, w.index);
    for (Weight& w : b) w.index = number(b_, numbers_b_, j, w.index);
    out_.word("nearest").word(std::size_t{i}).word(std::size_t{j}).end();
    write_weights(out_, "weights_a", a);
    write_weights(out_, "weights_b", b);
    counts_.insert(counts_.end(), {a.size(), b.size()});
  }

  kernels::Context& context_;
  ListedBody a_, b_;
  unions::PlacedPieces pieces_;
  const UnionDepth& answer_;
  bool blocks_;
  Writer out_;
  std::vector<std::uint32_t> numbers_a_, numbers_b_;
  std::vector<std::size_t> counts_;
};

std::string text_of_union(ListedBody a, ListedBody b, const UnionDepth& answer, std::string_view id, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  kernels::Context context(monitor);
  if (!answer.complete) throw std::logic_error("a certificate of an answer about unions that is not complete");
  return UnionWriter(context, std::move(a), std::move(b), answer, id).run();
}

}  // namespace

// Points that nothing uses are left out.
std::vector<std::uint32_t> write_solid(Writer& out, std::string_view name, const Solid& solid,
                                       std::vector<std::size_t>& counts) {
  std::vector<std::uint32_t> numbers(solid.points.size());
  for (const auto& triangle : solid.triangles)
    for (const std::uint32_t k : triangle) numbers.at(k) = 1;
  for (const Solid::Piece& piece : solid.pieces)
    for (const auto& facet : piece.facets)
      for (const std::uint32_t k : facet) numbers.at(k) = 1;
  std::vector<Point> points;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (numbers[k] == 0) continue;
    numbers[k] = static_cast<std::uint32_t>(points.size());
    points.push_back(solid.points[k]);
  }
  const auto write_indices = [&](const auto& indices) {
    for (const std::uint32_t k : indices) out.word(std::size_t{numbers[k]});
    out.end();
  };
  write_points(out, name, std::span<const Point>(points));
  out.word("mesh").word(solid.triangles.size()).end();
  for (const auto& triangle : solid.triangles) write_indices(triangle);
  out.word("pieces").word(solid.pieces.size()).end();
  counts.insert(counts.end(), {points.size(), solid.triangles.size(), solid.pieces.size()});
  for (const Solid::Piece& piece : solid.pieces) {
    out.word("piece").word(piece.facets.size()).end();
    counts.push_back(piece.facets.size());
    for (const auto& facet : piece.facets) {
      out.word(facet.size());
      write_indices(facet);
    }
  }
  return numbers;
}

std::string union_text(const Body& a, const Body& b, const UnionDepth& answer, std::string_view id, Monitor* monitor) {
  return text_of_union(ListedBody(a), ListedBody(b), answer, id, monitor);
}

}  // namespace fathom::certificate

namespace fathom {

std::string certificate_text(const Pieces& a, const Pieces& b, const UnionDepth& answer, std::string_view id,
                             Monitor* monitor) {
  return certificate::text_of_union(certificate::ListedBody(a), certificate::ListedBody(b), answer, id, monitor);
}

std::string certificate_text(const Solid& solid, std::string_view id) {
  certificate::Writer out(20000);
  std::vector<std::size_t> counts;
  certificate::write_header(out, 5, id);
  certificate::write_solid(out, "solid_a", solid, counts);
  out.word("claim").word("solid").end();
  certificate::write_end(out, counts);
  return out.take();
}

}  // namespace fathom
