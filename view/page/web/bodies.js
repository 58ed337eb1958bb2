// SPDX-License-Identifier: GPL-3.0-or-later
// A and B as they stand in section 1: A solid, B glass with stripes; and outlines of A where it is not.
import { creases, frameOf } from "./geometry.js";
import { dots, layer, meshGeometry, segments, surface, triangles } from "./solids.js";

const mostHidden = 200;  // edges: of a body with more, those behind it are not drawn
const speck = 0.006;  // of the picture: what is smaller gets a dot

/** {group, setWires(on), size, stand, middle}: faces and edges of a body in a frame, half of its greatest extent; where its letter stands, the
 *  middle of its box or of its largest piece, and half of the extent of that. */
export function bodyParts(body, frame, isB, flat = false) {
  const T = globalThis.THREE, group = new T.Group(), name = isB ? "--b" : "--a", order = isB ? layer.edges : layer.solidEdges;
  const places = body.vertices.map(frame.place), faces = body.facets.length ? facesOf(places, body, name, isB, flat) : [];
  const seen = body.sampled ? creases(places, body.facets) : body.edges, edges = seen.flatMap(([v, w]) => [places[v], places[w]]);
  group.add(...faces, segments(edges, name, order + 1, { width: faces.length ? 1.6 : 3, depthWrite: false }));
  if (faces.length && seen.length <= mostHidden)
    group.add(segments(edges, name, order, { width: 1, dash: 0.035, opacity: 0.55, depthWrite: false, depthFunc: T.GreaterDepth }));
  const main = body.mainPart ? frameOf(body.mainPart.map(frame.place)) : null;
  const own = frameOf(places), size = places.length ? 1 / Math.min(...own.scale) : 0;
  if (places.length && size < speck) group.add(dots([own.center], name, layer.strong, { depthWrite: false }));
  const setWires = (on) => { for (const part of faces) part.visible = !on; };
  return { group, size, stand: main ? 1 / Math.min(...main.scale) : size, isSpeck: places.length > 0 && size < speck, middle: places.length ? (main ?? own).center : null, setWires };
}

function facesOf(places, { facets, isUnion }, name, isB, flat) {
  const T = globalThis.THREE, geometry = meshGeometry(triangles(places, facets));
  const back = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };  // faces of A and B in one plane do not flicker
  if (!isB) return [surface(geometry, name, layer.solid, { flat, opacity: 0.78, ...back })];
  const before = layer.glass - 1;  // what is behind other pieces of the same body is not seen
  return [
    surface(geometry, name, layer.backs, { flat, side: T.BackSide, opacity: 0.14, depthWrite: false }),
    surface(geometry, name, layer.glass, { flat, opacity: 0.5, depthWrite: false }, 0.3),
    surface(geometry, name, isUnion ? before : layer.glassDepth, { flat: true, colorWrite: false, ...back }),
  ];
}

/** Whether a body where it is not is a faint solid, as outlines would be too many or are none. */
export function isFaint(body) {
  return body.edges.length === 0 || body.edges.length > mostHidden;
}

/** A where it is not: a dashed outline. Of many edges that would be noise; then a faint solid. */
export function ghostOf(body, frame) {
  const T = globalThis.THREE, places = body.vertices.map(frame.place), edges = body.edges.flatMap(([v, w]) => [places[v], places[w]]);
  if (!isFaint(body))
    return segments(edges, "--a", layer.solidEdges + 2, { width: 1, dash: 0.03, opacity: 0.6, depthWrite: false });
  if (!body.facets.length) return new T.Group();
  return surface(meshGeometry(triangles(places, body.facets)), "--a", layer.backs + 1, { opacity: 0.13, depthWrite: false });
}
