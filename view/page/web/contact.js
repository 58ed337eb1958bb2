// SPDX-License-Identifier: GPL-3.0-or-later
// The way out of the overlap that a selection is about: along the chosen facet of P, or along the chosen optimum; and where it ends.
import { nearest } from "./numbers.js";
import { dot, meetingPoint, minus, norm, plus, times, unit } from "./geometry.js";
import { placesOf } from "./places.js";

/** {direction, translation, a: [vertex], b: [vertex], kind, facet: index or null, patches: of data.patches}; null where there is nothing to show. */
export function wayOf(data, state) {
  const facet = state.facet === null ? null : data.facets[state.facet];
  if (facet)
    return {
      direction: facet.normal, translation: times(facet.normal, facet.distance), kind: facet.kind, facet: state.facet,
      a: data.verticesOf("a", facet.a), b: data.verticesOf("b", facet.b), patches: [],
    };
  const optimum = data.optima[state.optimum], patches = data.patches.filter(({ way }) => way === (optimum ? state.optimum : 0));
  if (optimum) return { ...optimum, facet: null, isFirst: state.optimum === 0, patches };
  const contact = data.stages.contact;
  if (!contact) return data.way ? { ...data.way, facet: null, isFirst: true, patches } : null;
  const translation = contact.translation ?? [0, 0, 0], direction = norm(translation) > 0 ? unit(translation) : contact.direction;
  const way = { direction, translation, kind: contact.kind ?? null, facet: null, isFirst: true, patches };
  return { ...way, a: data.verticesOf("a", contact.features?.a), b: data.verticesOf("b", contact.features?.b) };
}

/** Where the two features meet once A has moved out: a point of B. Without features the answer's witness, or what of B is farthest out. */
export function meetingOf(data, first) {
  const way = first.contacts?.length ? { ...first, ...first.contacts[0] } : first;
  const moved = way.a.map((v) => plus(data.bodies.a.vertices[v], way.translation)), own = way.b.map((v) => data.bodies.b.vertices[v]);
  if (moved.length || own.length) return meetingPoint(moved, own, way.direction);
  return touchingOf(data, way) ?? witnessOf(data, way) ?? farthest(data.bodies.b.vertices, way.direction) ?? [0, 0, 0];
}

/** Of bodies that touch, about the middle of where they do: good for the place of a plane, and no more. */
function touchingOf(data, way) {
  if (data.status !== "touching") return null;
  const { a, b } = data.bodies, all = [...a.vertices, ...b.vertices], height = (p) => dot(p, way.direction);
  const most = farthest(b.vertices, way.direction), least = farthest(all, times(way.direction, -1));
  const near = 1e-4 * norm(minus(farthest(all, way.direction), least));
  const level = (points) => points.filter((p) => Math.abs(height(p) - height(most)) <= near);
  const [own, other] = [level(a.vertices), level(b.vertices)];
  return own.length && other.length ? meetingPoint(own, other, way.direction) : null;
}

/** The answer's witness of B as a place; it belongs to the first optimum, or to the distance. */
function witnessOf(data, way) {
  const told = data.status === "disjoint" ? data.depth.distance : data.depth, witness = told?.witness_f64?.b, { center, drawn } = placesOf(data.stages);
  if (!witness || !data.stages.scale || !way.isFirst) return null;
  return center.map((c, i) => drawn((witness[i] ?? 0) - nearest(c)));
}

function farthest(points, direction) {
  let best = null, most = -Infinity;
  for (const p of points) {
    const height = dot(p, unit(direction));
    if (height > most) [best, most] = [p, height];
  }
  return best;
}

/** The arrow of the way, in places of the input: from a point of A now to where it ends. */
export function arrowOf(data, way) {
  const to = meetingOf(data, way);
  return { from: minus(to, way.translation), to };
}

/** What a way is called: "edge 1 3 of A on edge 2 4 of B". */
export function contactText(way, data) {
  if (way?.contacts) return way.contacts.slice(0, 8).map(({ pieces: [i, j] }) => `Piece ${i} of A touches piece ${j} of B.`).join(" ");
  const named = (body, vertices) => {
    const word = ["", data.plane ? "vertex" : "point", "edge"][vertices.length] ?? "facet";
    const ids = vertices.map((v) => data.bodies[body].ids[v]);
    const few = ids.length > 8 ? `${ids.slice(0, 8).join(" ")} ... (${ids.length} points)` : ids.join(" ");
    return `${body.toUpperCase()}'s ${word} ${few}`;
  };
  if (!way || !way.a.length || !way.b.length) return "";
  return `${named("a", way.a)} meets ${named("b", way.b)}`;
}
