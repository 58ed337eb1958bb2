// SPDX-License-Identifier: GPL-3.0-or-later
// What a selection lights in the Gaussian diagrams: arcs of edges, nodes of facets, the border of a vertex's face.

/** An index of a body's facets by their vertices. */
function facetIndex(body) {
  body.facetOfVertices ??= new Map(body.facets.map((facet, i) => [[...facet].sort((v, w) => v - w).join(), i]));
  return body.facetOfVertices;
}

/** What a feature, given as vertices, is in a body's diagram: {arcs, nodes}. */
export function featureInDiagram(data, name, vertices) {
  const body = data.bodies[name];
  if (vertices.length === 1) return { arcs: [...(body.edgesAt[vertices[0]] ?? [])], nodes: [] };
  const facet = vertices.length > 2 ? facetIndex(body).get([...vertices].sort((v, w) => v - w).join()) : undefined;
  if (facet !== undefined) return { arcs: [], nodes: [facet] };
  return { arcs: data.edgesOf(name, vertices), nodes: [] };
}

/** The arcs and nodes of both diagrams that a selection lights: {a: {arcs: [edge..], nodes: [node..]}, b: ...}. A canonical pair lights its
 *  arcs and nothing else; a facet of P its features; a coincidence those of its features. */
export function litInDiagrams(data, { pair, facet, coincidence }) {
  if (pair !== null) return { a: { arcs: data.pairs[pair].a, nodes: [] }, b: { arcs: data.pairs[pair].b, nodes: [] } };
  const features = { a: [], b: [] };
  if (facet !== null) {
    for (const name of ["a", "b"]) features[name] = [data.verticesOf(name, data.facets[facet][name])];
  } else if (coincidence !== null) {
    const item = data.coincidence(coincidence);
    for (const name of ["a", "b"]) features[name] = item[name];
  }
  return { a: unitedFeatures(data, "a", features.a), b: unitedFeatures(data, "b", features.b) };
}

function unitedFeatures(data, name, features) {
  const parts = features.filter((vertices) => vertices.length > 0).map((vertices) => featureInDiagram(data, name, vertices));
  const united = (field) => [...new Set(parts.flatMap((part) => part[field]))].sort((i, j) => i - j);
  return { arcs: united("arcs"), nodes: united("nodes") };
}

/** The same as a list of [colour, edge], for tests. */
export function litArcs(lit) {
  return ["a", "b"].flatMap((name) => lit[name].arcs.map((edge) => [name, edge]));
}

/** Whether what is lit lies in the lower hemisphere, as far as there is a choice. */
export function liesBelow({ bodies }, lit) {
  let sum = 0;
  for (const name of ["a", "b"]) {
    const { nodes, arcs } = bodies[name];
    for (const n of [...lit[name].nodes, ...lit[name].arcs.flatMap((e) => arcs[e])]) if (n !== null) sum += Math.sign(nodes[n][2]);
  }
  return sum < 0;
}

/** The hemisphere that a new choice asks to be seen: that of a pair or of a chosen coincidence or facet; null if none does. */
export function hemisphereOfChoice(data, chosen, changed) {
  if (changed.has("pair") && chosen.pair !== null) return data.pairs[chosen.pair].chart;
  if (chosen.pair !== null || !(changed.has("coincidence") || changed.has("facet"))) return null;
  const lit = litInDiagrams(data, chosen), isEmpty = ["a", "b"].every((name) => lit[name].arcs.length + lit[name].nodes.length === 0);
  return isEmpty ? null : Number(liesBelow(data, lit));
}
