// SPDX-License-Identifier: GPL-3.0-or-later
// The names of what can coincide of two polytopes, as `fathom study` counts it, and what each means.

export const coincidenceSentences = {
  parallel_edges:
    "An edge of A is parallel to one of B: their arcs lie on one great circle. Once moved they may cross; that crossing is " +
    "passed over, as the two edges span no facet of P.",
  parallel_edges_of_a: "Two edges of A are parallel: their arcs lie on one great circle.",
  parallel_edges_of_b: "Two edges of B are parallel: their arcs lie on one great circle.",
  coincident_normals:
    "A facet of A and one of B have opposite outward normals: one node in both diagrams. Moved, the node of \u2212A lies in " +
    "one face of B\u2019s diagram.",
  equal_normals: "A facet of A and one of B have the same outward normal: their nodes are opposite each other on the sphere.",
  coplanar_facets: "A facet of A and one of B, with parallel normals, lie in one plane.",
  normals_on_arcs:
    "A node of one diagram lies inside an arc of the other: a facet of one body is parallel to an edge of the other. Moved, " +
    "it lies on one side.",
  nodes_on_equator: "A facet\u2019s normal has z = 0: its node lies between the hemispheres. The tilted pole puts it into one of them.",
  arcs_on_equator: "An edge is parallel to the z-axis: its arc lies on the equator.",
  crossings_on_equator:
    "The arcs of an edge of A and one of B cross on the equator, inside both. Tilted, the crossing is in one hemisphere.",
  nodes_on_one_vertical: "Two nodes have one abscissa in the chart: their walls coincide. The tilted vertical puts one to the left.",
  arcs_on_verticals:
    "An edge along which y is constant: its arc lies on a vertical of the chart and has no left and right end until the " +
    "vertical is tilted.",
  touching_features: "The bodies touch: these are their faces in the direction that proves it. Nothing is moved here; values never are.",
  ties: "Several optima are equally near: these are their contacts. All of them are reported; values are never moved.",
};

export const spokenName = (name) => name.replaceAll("_", " ").replace(/ of ([ab])$/, (_, body) => ` of ${body.toUpperCase()}`);

/** The kinds that occur, with their index in the data, and the names of polytopes' kinds that do not. */
export function coincidenceKinds(coincidences) {
  const present = coincidences.map((entry, index) => ({ ...entry, index })).filter(({ count }) => count > 0);
  const names = new Set(present.map(({ kind }) => kind));
  return { present, absent: Object.keys(coincidenceSentences).filter((name) => !names.has(name)) };
}

/** "axis (0, 0, 1) at (0, 0, 0)": what of a shape takes part. */
const shapeFeatureText = ({ feature, length, direction, point }) =>
  [feature, length, direction && `(${direction.join(", ")})`, point && `at (${point.join(", ")})`].filter(Boolean).join(" ");

/** "A 0 1, B 4 5": the input points of each feature, long ones cut short; or the features of shapes. */
export function involvedText({ a = [], b = [], features }, most = 8) {
  if (features) return `A ${shapeFeatureText(features.a)}, B ${shapeFeatureText(features.b)}`;
  const feature = (name) => (ids) => `${name} ${ids.slice(0, most).join(" ")}${ids.length > most ? ` \u2026 (${ids.length} in all)` : ""}`;
  return [...a.map(feature("A")), ...b.map(feature("B"))].join(", ");
}
