// SPDX-License-Identifier: GPL-3.0-or-later
// A body as it was given: points in binary64, or exact ones; or a shape.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "fathom/point.hpp"
#include "fathom/shape.hpp"

namespace fathom {

namespace files {
struct NamedBody;
}
struct Solid;

/// Points in the form in which they were given: in binary64, as exact points, or as what makes
/// these. Read like a const std::vector<Point>: the exact points of the other forms are made when
/// they are first asked for, once, whoever asks; copies share them.
class GivenPoints {
 public:
  using value_type = Point;             ///< of the exact points
  using const_iterator = const Point*;  ///< of the exact points
  using iterator = const_iterator;      ///< of the exact points
  /// No points, or the exact ones that are given.
  GivenPoints() = default;
  GivenPoints(std::vector<Point> points)
      : exact_(std::move(points)) {}  // NOLINT(google-explicit-constructor): it is one of the forms
  GivenPoints(std::initializer_list<Point> points) : exact_(points) {}
  /// Throws std::invalid_argument if a coordinate is not finite.
  explicit GivenPoints(std::vector<std::array<double, 3>> points);
  /// `count` exact points, at least one, as `make` returns them. It is called once at most, by
  /// whatever thread asks first, and must not throw.
  GivenPoints(std::size_t count, std::function<std::vector<Point>()> make);

  /// Whether they are in binary64; never if there are none.
  [[nodiscard]] bool in_binary64() const { return !binary64().empty(); }
  /// The points, if they are in binary64; else none. No coordinate is -0.
  [[nodiscard]] std::span<const std::array<double, 3>> binary64() const;
  /// The exact points. May be called from many threads at once.
  [[nodiscard]] const std::vector<Point>& exact() const;
  operator const std::vector<Point>&() const {
    return exact();
  }  // NOLINT(google-explicit-constructor): it stands for them
  /// These are as of a const std::vector<Point>.
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] const Point* data() const { return exact().data(); }
  [[nodiscard]] const_iterator begin() const { return data(); }
  [[nodiscard]] const_iterator end() const { return data() + size(); }
  [[nodiscard]] const Point& operator[](std::size_t i) const { return exact()[i]; }
  [[nodiscard]] const Point& front() const { return exact().front(); }
  [[nodiscard]] const Point& back() const { return exact().back(); }

  /// The exact points, to be changed: from now on they are the form.
  std::vector<Point>& edit();
  void reserve(std::size_t count) { edit().reserve(count); }           ///< as of std::vector, after edit()
  void push_back(Point point) { edit().push_back(std::move(point)); }  ///< as of std::vector, after edit()

  /// Equal points, whatever the forms.
  friend bool operator==(const GivenPoints& p, const GivenPoints& q);

 private:
  struct Given;
  std::shared_ptr<const Given> given_;  // in binary64, or what makes them
  std::vector<Point> exact_;            // else
};

/// The faces of a mesh, each by its corners in order.
struct MeshFaces {
  /// indices of points, face after face. Empty, and so are `ends`: each three points are a triangle
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> ends;  ///< for each face, where its corners end. Empty: triangles
  friend bool operator==(const MeshFaces&, const MeshFaces&) = default;
};

/// A face, an edge or a vertex of a mesh.
struct MeshFeature {
  enum class Kind : std::uint8_t { face, edge, vertex };  ///< which of the three
  Kind kind;                                              ///< of the feature
  /// the number of the face, in the order of the mesh, or the index of the vertex; of an edge those
  /// of its ends, the lower one first
  std::vector<std::uint32_t> ids;
  /// Faces first, then edges, then vertices; by ids.
  friend auto operator<=>(const MeshFeature&, const MeshFeature&) = default;
};
/// "face", "edge" or "vertex".
std::string_view name(MeshFeature::Kind kind);

/// A body that need not be convex: the union of the convex hulls of these point sets.
using Pieces = std::vector<std::vector<Point>>;

/// A polytope: the convex hull of a finite, non-empty point set; or a shape that is none; or a
/// union of pieces.
struct Body {
  GivenPoints points;                         ///< the polytope is their convex hull
  std::optional<Shape> shape = std::nullopt;  ///< then there are no points
  /// The words that the body was read from, if it was given by the name of a shape: what fathom
  /// certify hands on. Whoever changes the points or the shape takes them away.
  std::shared_ptr<const files::NamedBody> words = nullptr;
  /// Of a mesh that has some. No answer depends on them: they tell whether the mesh is the hull
  /// that stands for it.
  std::shared_ptr<const MeshFaces> faces = nullptr;
  /// Then it is the union of these, and there are no points and no shape. Only what takes unions
  /// takes it (fathom/union.hpp).
  std::shared_ptr<const Pieces> pieces = nullptr;
  /// Then it is that of a closed mesh, and the pieces tile it (fathom/solid.hpp). Whoever changes
  /// the pieces takes it away.
  std::shared_ptr<const Solid> solid = nullptr;
  /// 2 of a body of the plane (fathom/plane.hpp): then the z of all that makes it is 0, and nothing
  /// of it is curved.
  unsigned dimension = 3;
};

}  // namespace fathom
