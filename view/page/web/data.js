// SPDX-License-Identifier: GPL-3.0-or-later
// What the page shows, read once and indexed. Numbers that a reader may copy come from `depth --json` as they stand there; places from
// `fathom stages`, which are good for pixels and decide nothing. Every index is one of the hull ("hull indices") unless it says "id".
//
//   data.depth, data.stages     the two objects; data.caseText the line of the case, as it was given
//   data.plane                  whether the bodies are of the plane: looked at from +z, and flat; places have z = 0
//   data.status                 "penetrating", "touching", "disjoint", "undecided"
//   data.bodies.a, .b           {name, vertices, edges, facets, nodes, arcs, ids}; all of them arrays, empty where there is nothing
//   data.optima                 [{direction: unit vector, translation, kind, a: [vertex], b: [vertex]}], as stages.contact.optima
//   data.patches                where they touch after a way out: see patches.js
//   data.motions                of A, with the depth at their steps: see motions.js
//   data.pairs                  stages.pairs, each with its exact distance_squared; data.charts; data.cutting; data.coincidences
//   data.facets                 stages.sum.facets, ascending by distance; [] where P is not listed
//   data.edgesOf("a", vertices) the edges of A whose two ends are among the vertices: of a facet its boundary, of an edge itself
//   data.verticesOf("a", ids)   the vertices with these ids of input points
//   data.facetsOfPair(i)        the indices of the facets of P that hold a crossing of canonical pair i
//   data.order                  the pairs' indices by |A_i| |B_i|, greatest first: the order in which they are listed and stepped through
//   data.coincidence("i.j")     {kind, count, a: [[vertex]..], b: [[vertex]..], decided_by}, or null

import { patchesOf } from "./patches.js";
import { makeUnionData } from "./uniondata.js";

/** Reads the blocks of the page. */
export function readData(page = document) {
  const text = (id) => page.getElementById(id)?.textContent ?? "";
  const stages = JSON.parse(text("stages")), squares = JSON.parse(text("squares") || "[]");
  if (stages.schema?.startsWith("fathom/union_stages/")) return makeUnionData(JSON.parse(text("depth")), stages, text("case"));
  squares.forEach((square, i) => { if (square !== null) stages.pairs[i].closest.distance_squared ??= square; });
  return makeData(JSON.parse(text("depth")), stages, text("case"), JSON.parse(text("motions") || "[]"));
}

/** The data of two parsed objects, the text of the case, and the motions. */
export function makeData(depth, stages, caseText = "", motions = []) {
  const bodies = { a: indexedBody("A", stages.a), b: indexedBody("B", stages.b) };
  const pairs = stages.pairs ?? [], facets = stages.sum?.facets ?? [], coincidences = stages.coincidences ?? [];
  const verticesOf = (body, ids) => (ids ?? []).map((id) => bodies[body].vertexOfId.get(id)).filter((v) => v !== undefined);
  const facetsOfPairs = facetsByPair(facets, pairs.length);
  const size = (pair) => pair.a.length * pair.b.length;
  return {
    depth, stages, caseText, bodies, pairs, facets, coincidences, verticesOf,
    plane: depth.dimension === 2,
    status: depth.status ?? stages.status,
    charts: stages.charts ?? [],
    cutting: stages.cutting ?? null,
    optima: optimaOf(stages, verticesOf),
    patches: patchesOf(depth, stages),
    motions,
    order: pairs.map((_, i) => i).sort((i, j) => size(pairs[j]) - size(pairs[i]) || i - j),
    edgesOf: (body, vertices) => edgesAmong(bodies[body], vertices),
    facetsOfPair: (i) => facetsOfPairs[i] ?? [],
    coincidence(name) {
      const [i, j] = name.split(".").map(Number), kind = coincidences[i], item = kind?.listed?.[j];
      if (!item) return null;
      const features = (body) => (item[body] ?? []).map((ids) => verticesOf(body, Array.isArray(ids) ? ids : [ids]));
      return { kind: kind.kind, count: kind.count, a: features("a"), b: features("b"), decided_by: item.decided_by ?? [] };
    },
  };
}

function indexedBody(name, body) {
  const { vertices = [], edges = [], facets = [], nodes = [], arcs = [] } = body ?? {};
  const ids = body?.ids ?? vertices.map((_, i) => i);
  const vertexOfId = new Map(ids.map((id, i) => [id, i]));
  return { ...body, name, vertices, edges, facets, nodes, arcs, ids, vertexOfId, edgesAt: edgesAtOf(vertices, edges) };
}

/** The edges at each vertex. */
function edgesAtOf(vertices, edges) {
  const result = vertices.map(() => []);
  edges.forEach(([v, w], e) => {
    result[v]?.push(e);
    result[w]?.push(e);
  });
  return result;
}

function edgesAmong(body, vertices) {
  const among = new Set(vertices), result = new Set();
  for (const v of among)
    for (const e of body.edgesAt[v] ?? []) if (among.has(body.edges[e][0]) && among.has(body.edges[e][1])) result.add(e);
  return [...result].sort((x, y) => x - y);
}

function facetsByPair(facets, count) {
  const result = Array.from({ length: count }, () => []);
  facets.forEach((facet, f) => (facet.pairs ?? []).forEach((i) => result[i]?.push(f)));
  return result;
}

function optimaOf(stages, verticesOf) {
  return (stages.contact?.optima ?? []).map((optimum) => ({
    direction: optimum.direction ?? stages.contact.direction ?? null,
    translation: optimum.translation ?? [0, 0, 0],
    kind: optimum.kind ?? null,
    a: verticesOf("a", optimum.features?.a),
    b: verticesOf("b", optimum.features?.b),
  }));
}
