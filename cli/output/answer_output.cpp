// SPDX-License-Identifier: GPL-3.0-or-later
// First the parts of an answer, for bodies of any kinds; then the three forms that arrange them:
// several lines, one line, and the text below a picture.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "cli/output/text_rows.hpp"
#include "fathom/numbers.hpp"
#include "kernels/context.hpp"
#include "kernels/number/irrational.hpp"
#include "reference/files/shape_names.hpp"
#include "view/picture/scene.hpp"

namespace fathom::cli {
namespace {

using Rows = std::vector<Row>;
using Parts = std::vector<std::string>;

const Depth* polytopes(const Answer& answer) { return std::get_if<Depth>(&answer.found); }
const SignedDepth* shapes_of(const Answer& answer) { return std::get_if<SignedDepth>(&answer.found); }
const UnionDepth* unions(const Answer& answer) { return std::get_if<UnionDepth>(&answer.found); }

// ---- lengths ----

/// A length, with its exact form and enclosure if requested, else "".
struct Length {
  std::string what, value;
  std::string exact_label = {}, exactly = {}, enclosure = {};
};

Length root_length(const std::string& what, const mpq_class& squared, const AnswerForm& form, bool enclosed = true) {
  return {what, root_text(squared), what + "^2", form.exact ? exact_text(squared) : "",
          form.digits && enclosed ? enclosure_text(squared, *form.digits) : ""};
}

/// Returns the signed depth of bodies that are not disjoint, or the distance of those that are.
Length surd_length(const std::string& what, const SignedDepth& depth, bool apart, const AnswerForm& form) {
  if (const Surd* const exactly = depth.exact()) {
    const Surd value = apart ? negated(*exactly) : *exactly;
    return {what, surd_text(value), "exactly", form.exact ? kernels::exact_surd_text(value) : "",
            form.digits ? enclosure_text(enclose(value, *form.digits)) : ""};
  }
  const Bounds& bounds = *depth.bounds();
  const mpq_class low = apart ? mpq_class(-bounds.high) : bounds.low,
                  high = apart ? mpq_class(-bounds.low) : bounds.high;
  Length length{what,
                fmt::format("from {} to {}", round_binary64(low, Rounding::rd), round_binary64(high, Rounding::ru))};
  if (form.digits)  // rounded outward
    length.enclosure =
        enclosure_text({enclose(Surd{low, 0}, *form.digits).low, enclose(Surd{high, 0}, *form.digits).high});
  return length;
}

std::vector<Length> lengths_of(const Depth& depth, const AnswerForm& form) {
  const Distance* const apart = depth.distance();
  std::vector<Length> lengths{root_length(quantity(form), depth.squared(), form, !apart)};
  if (apart) lengths.push_back(root_length("distance", apart->squared, form));
  return lengths;
}

std::vector<Length> lengths_of(const SignedDepth& depth, const AnswerForm& form) {
  const std::optional<Status> status = depth.status();
  if (!status)
    return {{"signed depth", fmt::format("from {} to {}: deep if positive, apart if negative", depth.low_binary64(),
                                         depth.high_binary64())}};
  if (status != Status::disjoint) return {surd_length(quantity(form), depth, false, form)};
  return {{quantity(form), "0"}, surd_length("distance", depth, true, form)};
}

std::vector<Length> lengths_of(const UnionDepth& depth, const AnswerForm& form) {
  if (!depth.complete) return {root_length("at least", depth.low, form), root_length("at most", depth.high, form)};
  std::vector<Length> lengths{root_length("depth", depth.low, form)};
  if (depth.apart) lengths.push_back(root_length("distance", depth.apart->distance.squared, form));
  return lengths;
}

/// Returns the lengths of an answer; the last one belongs to its status.
std::vector<Length> lengths_of(const Answer& answer, const AnswerForm& form) {
  return std::visit([&](const auto& found) { return lengths_of(found, form); }, answer.found);
}

// ---- translations and points ----

/// Returns the first shortest translation of A out of B, or to the contact; empty if only bounds
/// are known.
std::string way_of_a(const Answer& answer, const AnswerForm& form) {
  if (const Depth* const depth = polytopes(answer)) return place_text(depth->contact_translation(), form);
  if (const SignedDepth* const depth = shapes_of(answer)) {
    const std::vector<AlongNormal> ways = depth->translations();
    return ways.empty() ? "" : place_text(ways.front(), form);
  }
  const UnionDepth& depth = std::get<UnionDepth>(answer.found);
  if (depth.apart) return place_text(depth.apart->distance.translation, form);
  return depth.optima.empty() ? "" : place_text(depth.optima.front().translation, form);
}

void add_way(Rows& rows, const Answer& answer, const AnswerForm& form) {
  const std::string way = way_of_a(answer, form);
  if (way.empty() || form.width || answer.status() == Status::touching) return;
  rows.emplace_back(answer.status() == Status::disjoint ? "A to B" : "translation", way);
}

/// Returns "face 3, edge 0 5"; for a body that is no solid, by its piece.
std::string place_on(const std::vector<MeshFeature>& of_mesh, std::uint32_t piece) {
  if (of_mesh.empty()) return fmt::format("piece {}", piece);
  Parts texts;
  for (const MeshFeature& f : of_mesh) texts.push_back(fmt::format("{} {}", name(f.kind), fmt::join(f.ids, " ")));
  return fmt::format("{}", fmt::join(texts, ", "));
}

/// Adds the points of the answer; for unions the nearest pieces.
void add_places(Rows& rows, const Answer& answer, const AnswerForm& form) {
  const std::string what = answer.status() == Status::disjoint ? "nearest" : "witness";
  const auto add = [&](const auto& points) {
    add_points(rows, what, place_text(points.a, form), place_text(points.b, form), form.width);
  };
  if (const UnionDepth* const depth = unions(answer)) {
    if (depth->apart)
      rows.emplace_back("between", fmt::format("{} of A, {} of B", place_on(depth->apart->mesh_a, depth->apart->a),
                                               place_on(depth->apart->mesh_b, depth->apart->b)));
  } else if (const Depth* const depth = polytopes(answer)) {
    if (depth->distance()) add(depth->contact_points());
    else add_witness(rows, *depth->witness(), form);
  } else if (const std::optional<RoundedWitness> witness = shapes_of(answer)->witness()) {
    add(*witness);
  }
}

// ---- contacts ----

constexpr std::size_t most_contacts = 8;  // that the text lists
constexpr std::size_t most_below_picture = 3;

/// Returns texts of contacts of pieces, formatted by `one`, or for solids, by their meshes, by
/// `of_mesh`; after the first `most` the number of the others by `more`.
Parts contact_texts(const std::vector<PieceContact>& contacts, std::size_t most, const char* one, const char* of_mesh,
                    const char* more) {
  Parts texts;
  for (const PieceContact& met : contacts) {
    const bool known = !met.mesh_a.empty() || !met.mesh_b.empty();
    std::string text =
        known ? fmt::format(fmt::runtime(of_mesh), place_on(met.mesh_a, met.a), place_on(met.mesh_b, met.b))
              : fmt::format(fmt::runtime(one), met.a, met.b, contact_text(met.contact));
    if (std::ranges::find(texts, text) == texts.end()) texts.push_back(std::move(text));
  }
  if (const std::size_t count = texts.size(); count > most) {
    texts.resize(most);
    texts.push_back(fmt::format(fmt::runtime(more), count - most));
  }
  return texts;
}

void add_contacts(Rows& rows, const Answer& answer, const AnswerForm& form) {
  const UnionDepth* const depth = unions(answer);
  if (!depth) {
    if (answer.contact()) rows.emplace_back("contact", contact_text(*answer.contact(), form.width));
  } else if (!depth->optima.empty()) {
    const UnionOptimum& first = depth->optima.front();
    rows.emplace_back("clearance", first.clearance ? "yes" : "none: an exact fit");
    for (const std::string& text : contact_texts(first.contacts, most_contacts, "piece {} of A, piece {} of B; {}",
                                                 "{} of A; {} of B", "and {} more pairs"))
      rows.emplace_back(rows.back().first == "clearance" ? "touching" : "", text);
  }
}

// ---- ties ----

/// Returns the number of optima, listed or not; 0 if it is not known. Of a width, each pair of
/// planes is counted once, though it is found from both sides.
std::size_t ties(const Answer& answer, const AnswerForm& form) {
  if (unions(answer)) return answer.ways_out();
  const std::size_t count = answer.core() ? answer.core()->optima_count() : 0;
  return form.width ? count / 2 : count;
}

/// Returns the cone of optimal directions if cores touch and it has more than one direction; else
/// null.
const OptimalCone* continuum(const Answer& answer) {
  const SignedDepth* const depth = shapes_of(answer);
  const bool one =
      !depth || !depth->cone || (depth->cone->lineality == Lineality::none && depth->cone->rays.size() < 2);
  return one ? nullptr : &*depth->cone;
}

std::string cone_text(const OptimalCone& cone, const AnswerForm& form) {
  Parts parts;
  if (cone.lineality == Lineality::all) parts.emplace_back("every direction");
  if (cone.lineality == Lineality::plane) parts.push_back("the plane orthogonal to " + way_text(cone.axis, form));
  if (cone.lineality == Lineality::line) parts.push_back("the line of " + way_text(cone.axis, form));
  for (const Vector& ray : cone.rays) parts.push_back(way_text(ray, form));
  return fmt::format("the cone of {}", fmt::join(parts, ", "));
}

void add_ties(Rows& rows, const Answer& answer, const AnswerForm& form) {
  if (const OptimalCone* const cone = continuum(answer)) rows.emplace_back("ties", cone_text(*cone, form));
  if (const SignedDepth* const depth = shapes_of(answer); depth && depth->around())
    rows.emplace_back("ties", "around the axis " + way_text(*depth->around(), form));
  const std::size_t count = ties(answer, form);
  if (count == 1 && !shapes_of(answer)) rows.emplace_back("ties", "none");
  if (count > 1)
    rows.emplace_back("ties", fmt::format("{} {}; the first is shown, --json lists all", count,
                                          unions(answer)        ? "translations"
                                          : form.dimension == 2 ? (form.width ? "pairs of lines" : "nearest edges")
                                          : form.width          ? "pairs of planes"
                                                                : "nearest facets"));
}

// ---- contact manifolds ----

constexpr std::size_t most_corners = 8;  // that the text lists

/// Returns "vertex 3 of A", "edge 1 2 of A", "facet 0 1 2 of A", "the plane of A".
std::string feature_text(const std::vector<std::uint32_t>& ids, const char* body) {
  if (ids.empty()) return fmt::format("the plane of {}", body);
  const char* const what = ids.size() == 1 ? "vertex" : ids.size() == 2 ? "edge" : "facet";
  if (ids.size() > most_corners) return fmt::format("a facet of {} corners of {}", ids.size(), body);
  return fmt::format("{} {} of {}", what, fmt::join(ids, " "), body);
}

std::string patch_text(const Patch& patch, bool of_unions) {
  const std::string pieces = of_unions ? fmt::format("{} of A, {} of B; ", place_on(patch.mesh_a, patch.pieces.first),
                                                     place_on(patch.mesh_b, patch.pieces.second))
                                       : "";
  if (patch.rank() == 0) return pieces + "a point";
  const std::string size = root_text(patch.squared());
  return patch.rank() == 1 ? fmt::format("{}a segment of length {}", pieces, size)
                           : fmt::format("{}a polygon of {} corners, area {}", pieces, patch.corners.size(), size);
}

void add_patch(Rows& rows, const Patch& patch, const AnswerForm& form) {
  for (std::size_t k = 0; k < std::min(patch.corners.size(), most_corners); ++k)
    rows.emplace_back(
        "", fmt::format("{} on {}, {}", place_text(patch.a(k), form), feature_text(patch.corners[k].on_a, "A"),
                        feature_text(patch.corners[k].on_b, "B")));
  if (patch.corners.size() > most_corners)
    rows.emplace_back("", fmt::format("and {} more corners; --json lists all", patch.corners.size() - most_corners));
}

/// Adds the patch with the requested slack, by its corners on A.
void add_with_slack(Rows& rows, const output::Manifold& manifold, const Patch& patch, const AnswerForm& form) {
  if (!form.slack) return;
  const auto& corners = manifold.with_slack[static_cast<std::size_t>(&patch - manifold.geometry.patches.data())];
  if (!corners) return rows.emplace_back("with slack", "not told"), void();
  const char* const what = corners->size() == 1   ? "a point"
                           : corners->size() == 2 ? "a segment"
                                                  : "a polygon of corners";
  Parts parts;
  for (std::size_t k = 0; k < std::min(corners->size(), most_corners); ++k)
    parts.push_back(place_text((*corners)[k].a, form));
  if (corners->size() > most_corners)
    parts.push_back(fmt::format("{} more; --json lists all", corners->size() - most_corners));
  rows.emplace_back("with slack", fmt::format("{} {}", what, fmt::join(parts, ", ")));
}

std::string rate_text(const std::variant<DirectionalDerivative, LeftOut>& derivative, bool exact) {
  if (const LeftOut* const reason = std::get_if<LeftOut>(&derivative))
    return fmt::format("not told: {}", name(*reason));
  const Surd value = std::get<DirectionalDerivative>(derivative).value();
  if (exact) return kernels::exact_surd_text(value);
  return sign(value) < 0 ? "-" + surd_text(negated(value)) : surd_text(value);
}

/// Adds the patches of the first optimum, whether the depth is smooth, and the requested
/// derivative.
void add_manifold(Rows& rows, const AnsweredCase& answered, const AnswerForm& form) {
  if (!answered.manifold) return;
  const ContactGeometry& g = answered.manifold->geometry;
  if (form.patch && g.no_patches) rows.emplace_back("patch", fmt::format("not told: {}", name(*g.no_patches)));
  for (const Patch& patch : g.patches) {
    if (!form.patch || patch.way > 0) break;
    rows.emplace_back("patch", patch_text(patch, g.of_unions));
    add_patch(rows, patch, form);
    add_with_slack(rows, *answered.manifold, patch, form);
  }
  if (form.patch && g.tells_smoothness()) {
    Parts kinks;
    for (const Kink kink : g.kinks) kinks.emplace_back(name(kink));
    rows.emplace_back("smooth", g.smooth() ? "yes" : fmt::format("no: {}", fmt::join(kinks, ", ")));
  }
  if (const std::optional<Gradient> gradient = g.gradient(); form.patch && gradient)
    rows.emplace_back("gradient", fmt::format("{} by v, {} by w", decimals(gradient->by_translation(), form.dimension),
                                              spin_text(gradient->by_rotation(), form)));
  if (const auto& derivative = answered.manifold->derivative)
    rows.emplace_back("derivative", rate_text(*derivative, form.exact));
}

// ---- the work ----

/// Returns which method answered, with a reason if it is not the one that was tried first; empty if
/// there was no choice.
std::string method_text(const Answer& answer, const AnswerForm& form) {
  if (unions(answer)) return "";
  if (const SignedDepth* const depth = shapes_of(answer)) return std::string(output::method_name(*depth));
  const Depth& depth = *polytopes(answer);
  if (depth.status() != Status::penetrating) return "";
  const std::string ran(output::method_name(depth));
  if (depth.method == Method::certificate)
    return fmt::format("{}: an inner polytope of {} facets", ran, depth.counters.inner_facets);
  return form.by_default ? ran + ": the inner polytope took too many points" : ran;
}

/// Adds the counts of the stages that ran. Other stages are omitted: a count of 0 would be
/// misleading.
void add_counters(Rows& rows, const Counters& counters) {
  std::vector<std::string_view> stages;
  Rows counts;
  for (const kernels::StageCounts& stage : kernels::counts_by_stage(counters)) {
    if (!stage.ran()) continue;
    stages.push_back(stage.stage);
    for (const kernels::Count& count : stage.counts) counts.emplace_back(count.name, fmt::format("{}", count.value));
  }
  rows.emplace_back("counted", fmt::format("{}", fmt::join(stages, ", ")));
  rows.insert(rows.end(), counts.begin(), counts.end());
  for (std::size_t i = 0; i < predicate_names.size(); ++i) {
    const TierCounts& tiers = counters.predicates[i];
    if (tiers.calls == 0) continue;
    rows.emplace_back(predicate_names[i],
                      fmt::format("{} calls, {} exact, {} zero", tiers.calls, tiers.exact, tiers.zero));
  }
}

Rows counter_rows(const Answer& answer) {
  Rows rows;
  if (const UnionDepth* const depth = unions(answer)) {
    const UnionCounters& c = depth->counters;
    rows.emplace_back("counted", fmt::format("{} cells split, {} nearest points, {} of {} pairs of pieces looked at",
                                             c.nodes, c.nearest_points, c.pairs_touched, c.pairs));
  } else if (const Depth* const depth = polytopes(answer)) {
    add_counters(rows, depth->counters);
  } else {
    add_counters(rows, shapes_of(answer)->counters());
  }
  return rows;
}

/// Returns the bounds beside the depth of unions that penetrate; null for other answers.
const UnionBounds* bounds_beside(const Answer& answer) {
  const UnionDepth* const depth = unions(answer);
  return depth && depth->bounds && depth->status == Status::penetrating ? &*depth->bounds : nullptr;
}

// ---- below a picture ----

constexpr std::string_view until_touching = "arrow: the way of A until it touches B, and its outline there, dashed.";
constexpr std::string_view out_of_b =
    "arrow: the shortest way of A out of B, and its outline there, dashed; thick: the faces in contact.";

/// Returns the meaning of the parts of a picture.
std::string legend(const picture::PairScene& scene) {
  std::string result = scene.has_edges() ? "A toned, B hatched, hidden edges dashed" : "A toned, B hatched";
  if (!scene.moves()) return fmt::format("{}; the dot: {}.", result, scene.dot_text());
  return fmt::format("{}; {}", result, scene.status == Status::disjoint ? until_touching : out_of_b);
}

std::string legend_of_unions(const picture::PairScene& scene) {
  const std::string bodies = fmt::format("A toned, B hatched; thin: the edges of pieces{}; deeper: the pieces that ",
                                         scene.plane ? "" : ", hidden ones dashed");
  if (!scene.moves() && scene.status != Status::disjoint)
    return bodies + "touch; the dot: one of the places where they do.";
  return scene.status == Status::disjoint ? fmt::format("{}are nearest; {}", bodies, until_touching)
                                          : fmt::format("{}touch after the way out; {}", bodies, out_of_b);
}

std::string way_caption(const Answer& answer, const AnswerForm& form) {
  const UnionDepth* const depth = unions(answer);
  if (answer.status() == Status::disjoint)
    return "A to B: " + way_of_a(answer, form) +
           (depth ? fmt::format(", between piece {} of A and piece {} of B", depth->apart->a, depth->apart->b) : "");
  std::string text = "translation of A: " + way_of_a(answer, form);
  if (continuum(answer)) text += "; a continuum of ways is as short";
  else if (const std::size_t count = ties(answer, form); count > 1)
    text += fmt::format("; {} ways are as short", count);
  if (depth && !depth->optima.front().clearance) text += "; an exact fit, without clearance";
  return text;
}

/// Returns the patches of the first optimum, or of bodies that do not penetrate, for drawing:
/// rounded to binary64, without those beyond its range.
std::vector<std::vector<Point>> drawn_patches(const ContactGeometry& geometry) {
  std::vector<std::vector<Point>> drawn;
  const auto add = [&](const Patch& patch, RoundedPoint (Patch::*place)(std::size_t) const) {
    std::vector<Point> corners;
    for (std::size_t k = 0; k < patch.corners.size(); ++k) {
      const auto [x, y, z] = nearest_binary64((patch.*place)(k));
      if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) return;
      corners.push_back({x, y, z});
    }
    drawn.push_back(std::move(corners));
  };
  for (const Patch& patch : geometry.patches)
    if (patch.way == 0) (add(patch, &Patch::b), add(patch, &Patch::a));
  return drawn;
}

Parts contact_captions(const Answer& answer) {
  const UnionDepth* const depth = unions(answer);
  if (!depth) return answer.contact() ? Parts{"contact: " + contact_text(*answer.contact())} : Parts{};
  if (depth->optima.empty()) return {};
  return contact_texts(depth->optima.front().contacts, most_below_picture, "piece {} of A touches piece {} of B: {}",
                       "{} of A touches {} of B", "and {} more pairs of pieces touch");
}

}  // namespace

std::string answer_block(const AnsweredCase& answered, const AnswerForm& asked) {
  const Answer& answer = answered.answer;
  const AnswerForm form = asked.about(answer);
  Rows rows;
  for (const Length& length : lengths_of(answer, form)) {
    rows.emplace_back(length.what, length.value);
    if (!length.exactly.empty()) rows.emplace_back(length.exact_label, length.exactly);
    if (!length.enclosure.empty()) rows.emplace_back("enclosure", length.enclosure);
  }
  const bool places_first = answer.status() == Status::disjoint && !shapes_of(answer);
  if (places_first) add_places(rows, answer, form), add_way(rows, answer, form);
  if (!unions(answer)) rows.emplace_back("direction", way_text(*answer.direction(), form));
  if (!places_first) add_way(rows, answer, form);
  add_contacts(rows, answer, form);
  if (!places_first) add_places(rows, answer, form);
  add_ties(rows, answer, form);
  add_manifold(rows, answered, form);
  if (const UnionBounds* const bounds = bounds_beside(answer)) {
    rows.emplace_back("deepest pair", fmt::format("{}: piece {} of A, piece {} of B", root_text(bounds->deepest_pair),
                                                  bounds->a, bounds->b));
    rows.emplace_back("hulls", root_text(bounds->hulls));
  }
  if (unions(answer)) add_solids(rows, answered.bodies);
  else rows.emplace_back("sizes", shapes::sizes_text(answered.bodies.sizes));
  if (std::string method = method_text(answer, form); !method.empty()) rows.emplace_back("method", std::move(method));
  if (std::string flat = flat_text(answered.facts, form.width); !flat.empty())
    rows.emplace_back("flat", std::move(flat));
  if (polytopes(answer) && answered.facts.flat_a && answer.status() == Status::penetrating) rows.push_back(flat_note());
  if (form.counters) std::ranges::move(counter_rows(answer), std::back_inserter(rows));
  return aligned(form.width ? "" : answer.complete() ? std::string(answer.status_name()) : "interrupted", rows);
}

std::string answer_line(const AnsweredCase& answered, const AnswerForm& asked) {
  const Answer& answer = answered.answer;
  const AnswerForm form = asked.about(answer);
  const std::vector<Length> lengths = lengths_of(answer, form);
  if (!answer.complete())
    return case_line(answered.id, {"interrupted", "depth at least " + lengths[0].value, "at most " + lengths[1].value});
  const UnionDepth* const union_depth = unions(answer);
  const bool deep = answer.status() == Status::penetrating;
  Parts parts;
  if (!form.width) parts.emplace_back(answer.status_name());
  for (const Length& length : lengths) {
    parts.push_back(length.what + " " + length.value);
    if (!deep && !shapes_of(answer)) continue;
    if (!length.exactly.empty()) parts.push_back(length.exact_label + " " + length.exactly);
    if (!length.enclosure.empty()) parts.push_back((shapes_of(answer) ? "enclosure " : "in ") + length.enclosure);
  }
  if (!union_depth) parts.push_back("direction " + way_text(*answer.direction(), form));
  else if (deep) parts.push_back("translation " + way_of_a(answer, form));
  if (union_depth && deep && !union_depth->optima.front().clearance) parts.emplace_back("an exact fit");
  if (polytopes(answer) && answer.contact()) parts.emplace_back(name(answer.contact()->kind));
  if (!shapes_of(answer)) {
    if (const std::size_t count = ties(answer, form); count > 1) parts.push_back(fmt::format("{} ties", count));
    if (const std::string flat = flat_text(answered.facts, form.width); !flat.empty()) parts.push_back("flat " + flat);
  }
  if (answered.manifold && form.patch) {
    const ContactGeometry& g = answered.manifold->geometry;
    parts.push_back(g.no_patches ? fmt::format("patch not told: {}", name(*g.no_patches))
                                 : "patch " + patch_text(g.patches.front(), g.of_unions));
    if (g.patches.size() > 1) parts.push_back(fmt::format("{} more patches", g.patches.size() - 1));
  }
  if (answered.manifold && answered.manifold->derivative)
    parts.push_back("derivative " + rate_text(*answered.manifold->derivative, form.exact));
  if (const UnionBounds* const bounds = bounds_beside(answer))
    parts.push_back("deepest pair " + root_text(bounds->deepest_pair));
  if (form.counters)
    for (const auto& [label, text] : counter_rows(answer)) parts.push_back(label + " " + text);
  if (std::string dents = shapes::dents_text(answered.bodies.hull); !dents.empty()) parts.push_back(std::move(dents));
  return case_line(answered.id, parts);
}

picture::PairScene answer_scene(const Case& bodies, const AnsweredCase& answered, const AnswerForm& form) {
  picture::PairScene scene = picture::scene_of(bodies.a, bodies.b, answered.answer);
  if (answered.manifold && form.patch) scene.patches = drawn_patches(answered.manifold->geometry);
  return scene;
}

std::string answer_picture(const Case& bodies, const AnsweredCase& answered, const AnswerForm& asked) {
  const Answer& answer = answered.answer;
  const AnswerForm form = asked.about(answer);
  const picture::PairScene scene = answer_scene(bodies, answered, form);
  const Length length = lengths_of(answer, {}).back();
  Parts caption{fmt::format("{}: {} {}", answer.status_name(), length.what, length.value)};
  if (scene.moves() && answer.translation()) caption.push_back(way_caption(answer, form));
  std::ranges::move(contact_captions(answer), std::back_inserter(caption));
  if (!scene.patches.empty()) {
    const ContactGeometry& g = answered.manifold->geometry;
    caption.push_back("green: the contact patch, " + patch_text(g.patches.front(), g.of_unions) +
                      (scene.patches.size() > 2 ? ", and those of other pieces" : ""));
  }
  if (const UnionBounds* const bounds = bounds_beside(answer))
    caption.push_back(fmt::format("deepest pair: {}, piece {} of A and piece {} of B; hulls: {}",
                                  root_text(bounds->deepest_pair), bounds->a, bounds->b, root_text(bounds->hulls)));
  if (!unions(answer)) caption.push_back("sizes: " + shapes::sizes_text(answered.bodies.sizes));
  if (const std::string dents = shapes::dents_text(answered.bodies.hull); !dents.empty()) caption.push_back(dents);
  caption.push_back(unions(answer) ? legend_of_unions(scene) : legend(scene));
  return picture::scene_document(scene, answered.id, caption);
}

}  // namespace fathom::cli
