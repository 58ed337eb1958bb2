// SPDX-License-Identifier: GPL-3.0-or-later
// What the page about two unions of convex pieces shows, in the form of data.js as far as it goes, so that sections are shared. A body is the
// vertices, edges and facets of all its pieces; a pair is one of pieces, whose differences reach into the ball; there are no facets of P, no
// charts, no coincidences.
//
//   data.isUnion                true; data.plane as in data.js
//   data.bodies.a, .b           with pieces: [{edges: [edge], vertexOfId: Map}], and mainPart: the vertices of the largest piece
//   data.optima                 as data.js, with clearance and contacts: [{pieces: [i, j], direction, kind, a: [vertex], b: [vertex]}]
//   data.way                    of bodies that do not overlap: an optimum's fields, to the contact
//   data.pairs                  [{pieces, a: [edge], b: [edge], sum}], sum as `sums` of the stages
import { patchesOf } from "./patches.js";
import { middle, minus, norm, unit } from "./geometry.js";

/** The data of two parsed objects, fathom/union/1 and fathom/union_stages/1, and the text of the case. */
export function makeUnionData(depth, stages, caseText = "") {
  const bodies = { a: unitedBody("A", stages.a), b: unitedBody("B", stages.b) };
  const ways = stages.ways.map((way) => wayOfPieces(bodies, way)), overlap = stages.status === "penetrating";
  const pairs = stages.sums.map((sum) => {
    const [i, j] = sum.pieces;
    return { pieces: sum.pieces, a: bodies.a.pieces[i].edges, b: bodies.b.pieces[j].edges, sum };
  });
  return {
    isUnion: true, plane: depth.dimension === 2, depth, stages, caseText, bodies, pairs, status: stages.status,
    optima: overlap ? ways : [], way: overlap ? null : (ways[0] ?? null),
    patches: patchesOf(depth, stages), motions: [],
    facets: [], coincidences: [], charts: [], cutting: null,
    order: pairs.map((_, i) => i),
    verticesOf: () => [], edgesOf: () => [], facetsOfPair: (i) => (pairs[i].sum.facets.length ? [i] : []), coincidence: () => null,
  };
}

function unitedBody(name, pieces) {
  const body = { name, vertices: [], edges: [], facets: [], nodes: [], arcs: [], pieces: [], isUnion: true };
  let largest = -1;
  for (const piece of pieces) {
    const first = body.vertices.length, moved = (list) => list.map((v) => first + v), edge = body.edges.length;
    body.vertices.push(...piece.vertices);
    body.edges.push(...piece.edges.map(moved));
    body.facets.push(...piece.facets.map(moved));
    body.pieces.push({ edges: piece.edges.map((_, i) => edge + i), vertexOfId: new Map(piece.ids.map((id, i) => [id, first + i])) });
    const size = extent(piece.vertices);
    if (size > largest) [largest, body.mainPart] = [size, piece.vertices];
  }
  return body;
}

function extent(points) {
  const m = middle(points);
  return points.reduce((sum, p) => sum + norm(minus(p, m)) / points.length, 0);
}

function wayOfPieces(bodies, { translation, clearance, contacts }) {
  const found = contacts.map(({ pieces, direction, kind, a, b }) => {
    const of = (body, i, ids) => ids.map((id) => bodies[body].pieces[i].vertexOfId.get(id)).filter((v) => v !== undefined);
    return { pieces, direction, kind, a: of("a", pieces[0], a), b: of("b", pieces[1], b) };
  });
  const direction = norm(translation) > 0 ? unit(translation) : found[0]?.direction;
  return { direction, translation, kind: null, clearance, contacts: found, a: found[0]?.a ?? [], b: found[0]?.b ?? [] };
}

/** Of the planes between pieces in contact the normal that is least along the way: a picture looks along this plane too. */
export function secondNormal(way) {
  let best = null, least = 1 - 1e-6;
  for (const { direction } of way.contacts ?? []) {
    const cosine = Math.abs(direction.reduce((sum, x, i) => sum + x * way.direction[i], 0));
    if (cosine < least) [best, least] = [direction, cosine];
  }
  return best;
}
