// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate of unions as text: format 3.                 [verify/check/FORMAT.md, section 12]
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "fathom/certificate.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/certificate/certificate.hpp"
#include "reference/polytope/position.hpp"
#include "reference/unions/union_prover.hpp"

namespace fathom::certificate {
namespace {

class UnionWriter {
 public:
  UnionWriter(const Pieces& a, const Pieces& b, std::string_view id) : a_(a), b_(b), out_(20000) {
    out_.word("fathom-certificate 3").end();
    if (!id.empty()) out_.word("id").word(escaped(id)).end();
    write_pieces("pieces_a", "a", a);
    write_pieces("pieces_b", "b", b);
  }

  std::string penetrating(kernels::Context& context, const UnionDepth& answer) {
    const unions::UnionProof proof = unions::prove(context, unions::place_pieces(a_, b_), answer.optima);
    if (proof.squared != answer.squared()) contradiction("another depth");
    out_.word("claim").word("depth").word(proof.squared).end();
    announce("optima", proof.optima.size());
    for (const unions::ProofOptimum& optimum : proof.optima) {
      out_.word("optimum").words(optimum.translation).end();
      write_separations(optimum.directions);
    }
    announce("polytopes", proof.polytopes.size());
    for (const unions::PiecePolytope& polytope : proof.polytopes) {
      out_.word("polytope").word(std::size_t{polytope.a}).word(std::size_t{polytope.b}).end();
      write_inner(out_, polytope.inner);
      counts_.insert(counts_.end(), {polytope.inner.vertices.size(), polytope.inner.facets.size()});
    }
    announce("tree", proof.nodes.size());
    for (const unions::ProofNode& node : proof.nodes) {
      if (node.split) out_.word("split").word(std::size_t{node.polytope});
      else out_.word("leaf");
      for (const std::uint32_t number : node.numbers) out_.word(std::size_t{number});
      out_.end();
    }
    return end();
  }

  // The first pair of pieces that touch has a common point.
  std::string touching(kernels::Context& context, const PieceContact& first) {
    if (first.a >= a_.size() || first.b >= b_.size()) contradiction("no such pieces");
    const unions::PlacedPieces pieces = unions::place_pieces(a_, b_);
    out_.word("claim").word("touching").end();
    write_separations(unions::separations(context, pieces, {}));
    const polytope::PlacedPair pair = pieces.pair(first.a, first.b);
    const polytope::PositionOfOrigin origin = polytope::position_of_origin(pair.a, pair.b);
    if (origin.position != polytope::Position::boundary) contradiction("pieces that do not touch");
    write_nearest(first.a, first.b, origin.a, origin.b);
    return end();
  }

  // Each pair has a direction in which it is as far apart as it is; the first nearest one has the
  // nearest points.
  std::string disjoint(kernels::Context& context, const UnionDistance& answer) {
    if (answer.a >= a_.size() || answer.b >= b_.size()) contradiction("no such pieces");
    const unions::PlacedPieces pieces = unions::place_pieces(a_, b_);
    std::vector<Vector> directions;
    polytope::NearestPoints nearest;
    for (std::uint32_t i = 0; i < a_.size(); ++i) {
      for (std::uint32_t j = 0; j < b_.size(); ++j) {
        context.check();
        const polytope::PlacedPair pair = pieces.pair(i, j);
        polytope::NearestPoints found = polytope::nearest_points(pair.a, pair.b);
        const mpq_class squared =
            kernels::ratio(found.height * found.height, dot(found.normal, found.normal)) * pair.unit() * pair.unit();
        if (squared < answer.distance.squared) contradiction("nearer pieces");
        directions.push_back(found.normal);
        if (std::pair(i, j) != std::pair(answer.a, answer.b)) continue;
        if (squared != answer.distance.squared) contradiction("another distance");
        nearest = std::move(found);
      }
    }
    out_.word("claim").word("apart").word(answer.distance.squared).end();
    write_separations(directions);
    write_nearest(answer.a, answer.b, nearest.a, nearest.b);
    return end();
  }

 private:
  // A line with a count, which the last line repeats.
  void announce(std::string_view name, std::size_t count) {
    counts_.push_back(count);
    out_.word(name).word(count).end();
  }

  void write_pieces(std::string_view all, std::string_view one, const Pieces& pieces) {
    announce(all, pieces.size());
    for (const std::vector<Point>& piece : pieces) {
      counts_.push_back(piece.size());
      write_points(out_, one, std::span<const Point>(piece));
    }
  }

  void write_separations(const std::vector<Vector>& directions) {
    announce("separations", directions.size());
    for (const Vector& u : directions) out_.words(u).end();
  }

  void write_nearest(std::uint32_t i, std::uint32_t j, const std::vector<Weight>& a, const std::vector<Weight>& b) {
    out_.word("nearest").word(std::size_t{i}).word(std::size_t{j}).end();
    write_weights(out_, "weights_a", a);
    write_weights(out_, "weights_b", b);
    counts_.insert(counts_.end(), {a.size(), b.size()});
  }

  std::string end() {
    out_.word("end");
    for (const std::size_t n : counts_) out_.word(n);
    out_.end();
    return out_.take();
  }

  const Pieces &a_, &b_;
  Writer out_;
  std::vector<std::size_t> counts_;
};

}  // namespace
}  // namespace fathom::certificate

namespace fathom {

std::string certificate_text(const Pieces& a, const Pieces& b, const UnionDepth& answer, std::string_view id,
                             Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  kernels::Context context(monitor);
  if (!answer.complete) throw std::logic_error("a certificate of an answer about unions that is not complete");
  certificate::UnionWriter writer(a, b, id);
  if (answer.status == Status::penetrating) return writer.penetrating(context, answer);
  if (answer.status == Status::touching) return writer.touching(context, answer.optima.at(0).contacts.at(0));
  return writer.disjoint(context, answer.apart.value());
}

}  // namespace fathom
