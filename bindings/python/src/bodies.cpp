// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/python/src/bodies.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bindings/python/src/numbers.hpp"
#include "fathom/files.hpp"
#include "fathom/plane.hpp"
#include "fathom/shape.hpp"
#include "fathom/solid.hpp"
#include "fathom/union.hpp"
#include "kernels/messages.hpp"
#include "reference/answer/plane.hpp"
#include "reference/files/cases.hpp"
#include "reference/files/piece_files.hpp"
#include "reference/files/pose.hpp"
#include "reference/files/robot.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/shapes/body_notes.hpp"
#include "reference/shapes/core.hpp"
#include "reference/solve/depth.hpp"

namespace fathom::python {
namespace {

/// Remembers how the mesh differs from its hull, for the points of the last call. It is the deleter
/// of the faces, because all copies of a body share these.
class RememberedFact {
 public:
  std::optional<polytope::MeshConvexity> of(const Body& body) const {
    const std::lock_guard lock(last_->mutex);
    const bool convex = last_->fact && last_->fact->tried && !last_->fact->dents;  // convex in every pose
    if (last_->asked && (convex || last_->points == body.points)) return last_->fact;
    last_->fact = shapes::hull_fact(body);
    last_->points = body.points;
    last_->asked = true;
    return last_->fact;
  }
  void operator()(const MeshFaces* faces) const { delete faces; }

 private:
  struct Last {
    std::mutex mutex;
    bool asked = false;
    GivenPoints points;
    std::optional<polytope::MeshConvexity> fact;
  };
  std::shared_ptr<Last> last_ = std::make_shared<Last>();
};

Body given_body(py::handle from, const char* no_union) {
  if (py::isinstance<Body>(from)) {
    Body& body = from.cast<Body&>();
    if (body.faces && !std::get_deleter<RememberedFact>(body.faces))
      body.faces = std::shared_ptr<const MeshFaces>(new MeshFaces(*body.faces), RememberedFact());
    return convex(body, no_union);
  }
  Body body = given_points(from);
  body.faces = given_faces(from, body.points.size());
  if (body.faces && body.dimension == 2) refuse("expected no faces beside points of two coordinates, found some");
  return body;
}

/// Returns the pose of 2 rows of 3 numbers, or 3 with the last 0 0 1: it leaves z as it is.
files::GivenPose plane_pose(const py::sequence& rows) {
  std::array<std::array<mpq_class, 3>, 2> matrix;
  for (std::size_t i = 0; i < py::len(rows); ++i) {
    const py::object row = rows[i];  // indexing an array makes each row when it is read
    if (!PySequence_Check(row.ptr()) || py::len(row) != 3)
      refuse("expected a pose in the plane of 2 or 3 rows of 3 numbers");
    const auto entries = py::reinterpret_borrow<py::sequence>(row);
    const Point p = point_from(entries);
    if (i < 2) matrix[i] = {p.x, p.y, p.z};
    else if (p != Point{0, 0, 1}) refuse("expected 0 0 1 as the last row of a pose in the plane, found another");
  }
  return files::plane_pose(matrix);
}

/// Returns whether the first row has three numbers.
bool is_plane_pose(const py::sequence& rows) {
  const py::object first = rows[0];
  return PySequence_Check(first.ptr()) && py::len(first) == 3;
}

/// `dimension`: that of the body, or 2 if it is not known.
files::GivenPose given_pose(py::handle from, unsigned dimension) {
  if (py::isinstance<files::GivenPose>(from)) return from.cast<files::GivenPose>();
  std::string fault;
  files::GivenPose pose;
  if (py::isinstance<py::str>(from)) {
    pose = files::parse_pose(text_from(from), Decimals::exact, fault);
  } else {
    std::vector<std::array<mpq_class, 4>> rows;
    const bool listed = PySequence_Check(from.ptr());
    if (!listed || py::len(from) < 2 || py::len(from) > 4) refuse("expected a pose of 3 or 4 rows of 4 numbers");
    const auto given = py::reinterpret_borrow<py::sequence>(from);
    if (dimension == 2 && py::len(given) < 4 && is_plane_pose(given)) return plane_pose(given);
    for (const py::object row : given) {  // indexing an array makes each row when it is read
      if (!PySequence_Check(row.ptr()) || py::len(row) != 4) refuse("expected a pose of 3 or 4 rows of 4 numbers");
      const auto entries = py::reinterpret_borrow<py::sequence>(row);
      rows.push_back(
          {number_from(entries[0]), number_from(entries[1]), number_from(entries[2]), number_from(entries[3])});
    }
    pose = files::pose_of(rows, fault);
  }
  if (!fault.empty()) refuse("pose: " + fault);
  return pose;
}

py::object in_python(const GivenPoints& given, unsigned dimension) {
  if (given.in_binary64()) {
    const auto points = given.binary64();
    py::array_t<double> array({static_cast<py::ssize_t>(points.size()), static_cast<py::ssize_t>(dimension)});
    auto view = array.mutable_unchecked<2>();
    for (py::ssize_t i = 0; i < view.shape(0); ++i)
      for (py::ssize_t j = 0; j < view.shape(1); ++j)
        view(i, j) = points[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    return array;
  }
  py::list list;
  for (const Point& p : given) list.append(fractions(p, dimension));
  return list;
}

py::object points_in_python(const Body& body) {
  return body.shape || body.pieces ? py::object(py::none()) : in_python(body.points, body.dimension);
}

py::object pieces_in_python(const Body& body) {
  if (!body.pieces) return py::none();
  py::list list;
  for (const std::vector<Point>& piece : *body.pieces) list.append(in_python(given_form(piece), body.dimension));
  return py::object(std::move(list));
}

/// Returns whether the body has no interior; of a union, whether no piece has one.
bool has_no_interior(const Body& body) {
  if (!body.pieces) return answer::is_flat_body(body);
  return std::ranges::all_of(*body.pieces, [&](const std::vector<Point>& piece) {
    return answer::is_flat_body({.points = piece, .dimension = body.dimension});
  });
}

py::object description(const Body& body) {
  return py::module_::import("json").attr("loads")(files::body_json(body).text());
}

// ---- what pickle keeps ----

/// Returns the body as the JSON of a case, its faces as corners and their ends, and its dimension.
py::tuple state_of(const Body& body) {
  const MeshFaces faces = body.faces ? *body.faces : MeshFaces{};
  return py::make_tuple(files::body_json(body).text(), body.faces != nullptr, faces.corners, faces.ends,
                        body.dimension);
}

Body body_of_state(const std::string& json, bool has_faces, std::vector<std::uint32_t> corners,
                   std::vector<std::uint32_t> ends, unsigned dimension) {
  CaseItem item =
      parse_case("{\"dimension\":" + std::to_string(dimension) + ",\"a\":" + json + ",\"b\":" + json + "}", "body");
  if (!item.ok()) throw item.error();
  Body body = std::move(std::get<Case>(item.outcome).a);
  if (has_faces) body.faces = std::make_shared<const MeshFaces>(MeshFaces{std::move(corners), std::move(ends)});
  return body;
}

std::string described(const Body& body) {
  const std::string where = body.dimension == 2 ? " of the plane>" : ">";
  if (body.pieces) return "<fathom.Body, a union of " + std::to_string(body.pieces->size()) + " pieces" + where;
  if (!body.shape) return "<fathom.Body of " + std::to_string(body.points.size()) + " points" + where;
  if (shapes::is_halfspace(*body.shape))
    return body.dimension == 2 ? "<fathom.Body, a half-plane>" : "<fathom.Body, a half-space>";
  return "<fathom.Body, a shape" + where;
}

py::object extent_in_python(const Body& body) {
  const std::optional<std::array<double, 3>> lengths = shapes::extent(body);
  return lengths ? py::object(array(*lengths, body.dimension)) : py::object(py::none());
}

std::optional<polytope::MeshConvexity> fact_of(const Body& body) {
  const py::gil_scoped_release unlocked;
  return hull_fact(body);
}

/// Returns the facts on convexity; None if there are none.
py::object convexity(const Body& body) {
  const std::optional<polytope::MeshConvexity> found = fact_of(body);
  if (!found) return py::none();
  if (!found->dents) return py::make_tuple(true, py::none(), py::none(), py::none());
  const polytope::Dents& dents = *found->dents;
  const py::object ratio = dents.volume_ratio ? fraction(*dents.volume_ratio) : py::object(py::none());
  if (!dents.deepest) return py::make_tuple(false, ratio, py::none(), py::none());
  return py::make_tuple(false, ratio, dents.deepest->point, fraction(dents.deepest->squared_depth));
}

// ---- shapes, each with the name and the numbers that describe it in a case ----

Axis axis_from(const std::string& axis) {
  if (axis == "x") return Axis::x;
  if (axis == "y") return Axis::y;
  if (axis == "z") return Axis::z;
  throw py::value_error("expected the axis 'x', 'y' or 'z', found '" + axis + "'");
}

/// Returns the description of a convex body as a case writes it: its own, or that of a hull of
/// points.
files::NamedBody words_of(const Body& body) {
  if (convex(body).words) return *body.words;
  if (body.shape) throw std::logic_error("a shape has no words");
  return files::named_hull(body.points.exact());
}

using Numbers = std::vector<mpq_class>;

Numbers one(const py::object& number) { return {number_from(number)}; }

Numbers three(const py::object& numbers) {
  const Point p = point_from(numbers);
  return {p.x, p.y, p.z};
}

/// Returns the shape, with its description for cases.
Body shape(const char* name, files::NumbersByName numbers, const std::string& axis = "z") {
  return files::body_of(files::named(name, numbers, axis_from(axis)));
}

Body body_with_margin(const Body& body, const mpq_class& margin) {
  Body result = files::body_of(with_margin(files::shape_of(convex(body)), margin));
  if (body.dimension == 2) return in_plane(std::move(result));
  files::NamedBody words = words_of(body);
  const auto present = words.fields.numbers.find("margin");
  if (present == words.fields.numbers.end()) words = files::rounded(std::move(words), margin);
  else present->second = {present->second.front() + margin};
  result.words = std::make_shared<const files::NamedBody>(std::move(words));
  return result;
}

Body body_sum(const Body& a, const Body& b) {
  require_same_dimension(a, b);
  Body result = files::body_of(minkowski_sum(files::shape_of(convex(a)), files::shape_of(convex(b))));
  if (a.dimension == 2) return in_plane(std::move(result));
  result.words = std::make_shared<const files::NamedBody>(files::named_sum({words_of(a), words_of(b)}));
  return result;
}

void bind_shapes(py::module_& module) {
  using py::arg;
  using Object = const py::object&;
  using Text = const std::string&;
  module.def(
      "sphere",
      [](Object radius) {
        return shape("sphere", {{"radius", one(radius)}});
      },
      arg("radius"));
  for (const char* name : {"capsule", "cylinder", "cone"}) {
    module.def(
        name,
        [name](Object radius, Object half_length, Text axis) {
          return shape(name, {{"radius", one(radius)}, {"half_length", one(half_length)}}, axis);
        },
        arg("radius"), arg("half_length"), arg("axis") = "z");
  }
  for (const char* name : {"tapered_capsule", "frustum"}) {
    module.def(
        name,
        [name](Object low, Object high, Object half_length, Text axis) {
          return shape(name, {{"radius_low", one(low)}, {"radius_high", one(high)}, {"half_length", one(half_length)}},
                       axis);
        },
        arg("radius_low"), arg("radius_high"), arg("half_length"), arg("axis") = "z");
  }
  module.def(
      "box",
      [](Object half) {
        return shape("box", {{"half", three(half)}});
      },
      arg("half"));
  module.def(
      "ellipsoid",
      [](Object radii) {
        return shape("ellipsoid", {{"radii", three(radii)}});
      },
      arg("radii"));
  module.def(
      "halfspace",
      [](Object normal, Object offset) {
        return shape("halfspace", {{"normal", three(normal)}, {"offset", one(offset)}});
      },
      arg("normal"), arg("offset"));
}

/// Returns the shape of the plane that cases call `name`.
Body plane_shape(const std::string& name, const py::dict& numbers, const std::string& axis) {
  const files::ShapeName& shape = *files::named_shape(name, 2).shape;
  files::ShapeFields fields;
  fields.axis = axis_from(axis);
  for (const files::NumberField& field : shape.numbers) {
    const py::object given = numbers[py::str(std::string(field.name))];
    Numbers& read = fields.numbers[std::string(field.name)];
    if (field.count == 1) {
      read = {number_from(given)};
    } else {
      const Point p = point_from(given, 2);
      read = {p.x, p.y};
    }
  }
  return in_plane(files::body_of(files::made_shape(shape, fields)));
}

void bind_poses(py::module_& module) {
  py::class_<files::GivenPose>(module, "Pose",
                               "An exact affine map: `rows` are three rows of four numbers, or four with the last 0 0 "
                               "0 1; in the plane two of three.")
      .def(py::init([](const py::object& rows) { return given_pose(rows, 2); }), py::arg("rows"))
      .def_property_readonly(
          "rows",
          [](const files::GivenPose& given) {
            py::list rows;
            for (const auto& row : files::exact_pose(given))
              rows.append(py::make_tuple(fraction(row[0]), fraction(row[1]), fraction(row[2]), fraction(row[3])));
            return py::tuple(rows);
          })
      .def_property_readonly("note", [](const files::GivenPose& given) { return files::pose_note(given, false); });
  module.def(
      "pose",
      [](const py::object& quaternion, const py::object& translation) {
        const auto q = py::reinterpret_borrow<py::sequence>(quaternion);
        if (!PySequence_Check(quaternion.ptr()) || py::len(quaternion) != 4) refuse("expected a quaternion w, x, y, z");
        const Quaternion turn = {number_from(q[0]), number_from(q[1]), number_from(q[2]), number_from(q[3])};
        if (turn == Quaternion{0, 0, 0, 0}) refuse("expected a quaternion that is not 0, found 0");
        return files::GivenPose{.turn = turn, .place = point_from(translation)};
      },
      py::arg("quaternion"), py::arg("translation"));
}

// ---- unions of pieces ----

/// Returns the points of a convex body. `called`: its name in warnings, "piece 3 of A"; `name`:
/// that in errors, "a: piece 3".
Body piece_from(py::handle from, const std::string& called, const std::string& name) {
  const Body body = body_from(from, py::none(), name.c_str());
  if (body.shape)
    throw py::value_error(name + ": expected a polytope, found another shape: pieces are neither round nor curved");
  warn_of_dents(body, called);
  return body;
}

/// Returns one piece, or a list of them, all of the plane or all of space.
std::vector<Body> pieces_from(py::handle from, const std::string& called, const std::string& name) {
  if (is_one_body(from)) return {piece_from(from, called, name)};
  if (py::isinstance<py::str>(from) || !py::isinstance<py::iterable>(from))
    throw py::type_error(name + ": expected convex pieces, or one convex body, found " +
                         py::repr(py::type::of(from)).cast<std::string>());
  std::vector<Body> pieces;
  for (const py::handle item : py::reinterpret_borrow<py::iterable>(from)) {
    const std::string piece = "piece " + std::to_string(pieces.size());
    pieces.push_back(piece_from(item, piece + " of " + called, name + ": " + piece));
    named(name + ": " + piece, [&] { require_same_dimension(pieces.front(), pieces.back()); });
  }
  if (pieces.empty()) throw py::value_error(name + ": expected at least one convex piece, found none");
  return pieces;
}

files::MeshAs meshes_from(const std::string& text) {
  if (text == "hull") return files::MeshAs::hull;
  if (text == "pieces") return files::MeshAs::pieces;
  if (text == "solid") return files::MeshAs::solid;
  refuse("expected meshes to be one of 'hull', 'pieces', 'solid', found " + kernels::shown(text));
}

/// Reads what a word of the command line stands for; what users may not expect is a warning.
Body body_in_input(const std::string& name, const std::string& meshes, const py::dict& joints,
                   const std::vector<std::string>& package_path, const std::string& decimals) {
  const files::RobotOptions options{decimals_from(decimals), meshes_from(meshes), package_path};
  files::JointValues values;
  for (const auto& [joint, value] : joints)
    values[joint.cast<std::string>()] = named("joints", [&, given = value] { return number_from(given); });
  files::InputBody read = files::read_input(name, options, values);
  files::require_joints(read.robot ? std::vector{*read.robot} : std::vector<files::Robot>(), values);
  if (options.meshes == files::MeshAs::solid && !read.body.pieces) {
    const py::gil_scoped_release unlocked;
    read.body = solid_body(read.body);
  }
  for (const std::string& note : read.notes)
    if (PyErr_WarnEx(PyExc_UserWarning, note.c_str(), 2) != 0) throw py::error_already_set();
  if (options.meshes == files::MeshAs::pieces) warn_of_dents(read.body, name);
  return read.body;
}

Body union_in_files(const std::string& path, const std::string& decimals) {
  Body body = files::read_union(path, decimals_from(decimals));
  warn_of_dents(body, path);
  return body;
}

}  // namespace

void require_same_dimension(const Body& a, const Body& b) {
  if (a.dimension != b.dimension)
    refuse("expected bodies that are all of the plane, or all of space, found some of each");
}

const Body& convex(const Body& body, const char* no_union) {
  if (body.pieces) refuse(std::string("expected a convex body, found a union of pieces: ") + no_union);
  return body;
}

std::optional<files::GivenPose> pose_from(py::handle pose, const char* name, unsigned dimension) {
  if (pose.is_none()) return std::nullopt;
  return named(name, [&] { return given_pose(pose, dimension); });
}

Body posed(Body body, const std::optional<files::GivenPose>& pose, const char* name, std::vector<std::string>* notes) {
  if (!pose) return body;
  return named(name, [&] {
    if (notes)
      if (const std::string note = files::pose_note(*pose, body.shape && body.shape->radius > 0); !note.empty())
        notes->push_back(std::string("pose_") + name + ": " + note);
    files::place(body, *pose);
    return std::move(body);
  });
}

Body posed(Body body, py::handle pose, const char* name, std::vector<std::string>* notes) {
  const std::optional<files::GivenPose> given = pose_from(pose, name, body.dimension);
  return posed(std::move(body), given, name, notes);
}

std::optional<polytope::MeshConvexity> hull_fact(const Body& body) {
  const auto* const remembered = body.faces ? std::get_deleter<RememberedFact>(body.faces) : nullptr;
  return remembered ? remembered->of(body) : shapes::hull_fact(body);
}

Body body_from(py::handle from, py::handle pose, const char* name, std::vector<std::string>* notes,
               const char* no_union) {
  return posed(named(name,
                     [&] {
                       Body body = given_body(from, no_union);
                       if (!body.shape && body.points.empty()) refuse("expected at least one point, found none");
                       return body;
                     }),
               pose, name, notes);
}

Decimals decimals_from(const std::string& decimals) {
  if (decimals != "binary64" && decimals != "exact")
    refuse("expected decimals 'binary64' or 'exact', found '" + decimals + "'");
  return decimals == "exact" ? Decimals::exact : Decimals::binary64;
}

const GivenPoints& points_of(const Body& body, const char* name) {
  if (body.shape)
    refuse(std::string(name) +
           ": expected a polytope, found a shape that is none: depth, width, study and judge take those");
  return body.points;
}

Body union_from(py::handle from, const std::string& called, const std::string& name) {
  if (py::isinstance<Body>(from) && from.cast<const Body&>().pieces) return from.cast<Body>();
  const std::vector<Body> pieces = pieces_from(from, called, name);
  Pieces points;
  for (const Body& piece : pieces) points.push_back(piece.points.exact());
  Body body = files::union_of(std::move(points));
  body.dimension = pieces.front().dimension;
  return body;
}

namespace {

using py::literals::operator""_a;

// The fields of fathom.Coverage.
py::dict coverage_of(const py::object& mesh, const py::object& pieces) {
  const Body body = body_from(mesh, py::none(), "mesh"), given = union_from(pieces, "the pieces", "pieces");
  solve::require_space(body, given, "coverage");
  const Body solid = body.solid ? body : named("mesh", [&] {
    const py::gil_scoped_release unlocked;
    return solid_body(body);
  });
  const PieceCoverage found = named("pieces", [&] {
    const py::gil_scoped_release unlocked;
    return coverage(*solid.solid, pieces_of(given));
  });
  const auto point = [](const std::optional<Point>& p) { return p ? py::object(fractions(*p)) : py::none(); };
  py::list outside_of;
  for (const mpq_class& volume : found.outside_of) outside_of.append(fraction(volume));
  return py::dict("tiles"_a = found.tiles(), "same_union"_a = found.same_union(), "missing"_a = fraction(found.missing),
                  "outside"_a = fraction(found.outside), "overlap"_a = fraction(found.overlap),
                  "outside_of"_a = outside_of, "most_outside"_a = py::cast(found.most_outside()),
                  "uncovered"_a = point(found.uncovered), "stray"_a = point(found.stray));
}

}  // namespace

void warn_of_dents(const Body& body, const std::string& called) {
  const std::string sentence = [&]() -> std::string {
    const py::gil_scoped_release unlocked;
    if (body.pieces) return shapes::dents_text(called, shapes::dented_pieces(body).value_or(shapes::DentedPieces()));
    const std::optional<polytope::MeshConvexity> fact = hull_fact(body);
    return fact ? shapes::dents_of(called, *fact) : "";
  }();
  if (sentence.empty()) return;
  constexpr py::ssize_t caller = 2;  // the frame of the Python function that called this one
  const py::object category = py::module_::import("fathom").attr("NotConvexWarning");
  if (PyErr_WarnEx(category.ptr(), sentence.c_str(), caller) != 0) throw py::error_already_set();
}

void bind_bodies(py::module_& module) {
  bind_poses(module);
  py::class_<Body>(module, "Body", "A convex body: the hull of `points`, or a shape; or a union of convex `pieces`.")
      .def(py::init([](const py::object& points) { return body_from(points, py::none(), "points"); }),
           py::arg("points"))
      .def_property_readonly("points", points_in_python)
      .def_property_readonly("pieces", pieces_in_python)
      .def_property_readonly("is_shape", [](const Body& body) { return body.shape.has_value(); })
      .def_property_readonly("dimension", [](const Body& body) { return body.dimension; })
      .def_property_readonly("extent", extent_in_python)
      .def_property_readonly("is_flat", has_no_interior)
      .def(
          "moved", [](const Body& body, const py::object& pose) { return posed(body, pose, "body"); }, py::arg("pose"))
      .def(
          "with_margin",
          [](const Body& body, const py::object& margin) { return body_with_margin(body, number_from(margin)); },
          py::arg("margin"))
      .def("__add__", body_sum, py::is_operator())
      .def("__repr__", described)
      .def_property_readonly(
          "description", description,
          "The body as a case has it: the name of a shape, its numbers and its pose; the vertices of other bodies, the "
          "pieces of a union. Floats are exact, and so are texts as \"1/3\".")
      .def_property_readonly("state", state_of);
  module.def("body_of_state", body_of_state, py::arg("json"), py::arg("has_faces"), py::arg("corners"), py::arg("ends"),
             py::arg("dimension") = 3);
  module.def(
      "convexity", [](const py::object& body) { return convexity(body_from(body, py::none(), "body")); },
      py::arg("body"));
  bind_shapes(module);
  module.def("plane_shape", plane_shape, py::arg("name"), py::arg("numbers"), py::arg("axis") = "x");
  module.def(
      "union", [](const py::object& pieces) { return union_from(pieces, "the body", "pieces"); }, py::arg("pieces"));
  module.def(
      "solid",
      [](const py::object& mesh) {
        const Body body = body_from(mesh, py::none(), "mesh");
        solve::require_space(body, body, "solid");
        return named("mesh", [&] {
          const py::gil_scoped_release unlocked;
          return solid_body(body);
        });
      },
      py::arg("mesh"));
  module.def("coverage", coverage_of, py::arg("mesh"), py::arg("pieces"));
  module.def("read", body_in_input, py::arg("name"), py::arg("meshes"), py::arg("joints"), py::arg("package_path"),
             py::arg("decimals"));
  module.def("read_pieces", union_in_files, py::arg("path"), py::arg("decimals"));
  module.def(
      "read_mesh",
      [](const std::string& path, const std::string& decimals) { return read_mesh(path, decimals_from(decimals)); },
      py::arg("path"), py::arg("decimals") = "binary64");
}

}  // namespace fathom::python
