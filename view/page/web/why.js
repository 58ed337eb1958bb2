// SPDX-License-Identifier: GPL-3.0-or-later
// Section 2, Why no shorter way: P around O, the ball that reaches its nearest facets, and the facets that a choice lights.
import { edgesOfPolygons, frameOf, plus, sideView, times } from "./geometry.js";
import { element } from "./look.js";
import { onViewLook, withView } from "./scene.js";
import { arrow, dots, emptied, layer, meshGeometry, recolour, segments, surface, triangles } from "./solids.js";

const mostHiddenOfSum = 300;  // edges: behind more, they are noise

export function mountWhy(root, data, selection) {
  const sum = data.stages.sum;
  if (!sum?.vertices?.length || !data.facets.length) return {};
  const name = { P: "P, the sum of B and -A", Q: "Q, the certificate's polytope inside P", sampled: "P, the sum of B and -A, as a mesh" }[sum.kind] ?? "P";
  const label = `${name}, around O, with the ball whose radius is the depth; its nearest facets are marked. Shift and arrow keys turn, plus and minus zoom.`;
  return withView(root, label, (view) => whyPicture(root, view, data, selection));
}

function whyPicture(root, view, data, selection) {
  const T = globalThis.THREE, sum = data.stages.sum, origin = sum.origin ?? [0, 0, 0], polygons = data.facets.map((f) => f.vertices);
  const frame = frameOf([...sum.vertices, origin]), places = sum.vertices.map(frame.place), center = frame.place(origin);
  const shape = triangles(places, polygons), geometry = meshGeometry(shape), optimal = data.facets.flatMap((f, i) => (f.optimal ? [i] : []));
  const front = surface(geometry, "--soft", layer.glass, { opacity: 0.13, depthWrite: false });
  const back = surface(geometry, "--soft", layer.backs, { opacity: 0.16, depthWrite: false, side: T.BackSide });
  const nearestFacets = surface(partOf(places, polygons, optimal), "--true", layer.glass + 1, { opacity: 0.5, depthWrite: false, side: T.DoubleSide }, 0.45);
  const ball = ballOf(data, frame, center), chosen = new T.Group(), shaft = arrow(view, "--true");
  const edges = edgesOfPolygons(polygons), ends = edges.flatMap(([v, w]) => [places[v], places[w]]);
  const depthOnly = surface(geometry, "--soft", layer.glassDepth, { flat: true, colorWrite: false, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
  const few = edges.length <= mostHiddenOfSum, many = edges.length > 6000;
  view.scene.add(back, front, nearestFacets, depthOnly, segments(ends, "--ink", layer.edges, { width: 1.2, opacity: many ? 0.25 : 0.75, depthWrite: false }), chosen, shaft.group);
  if (few) view.scene.add(segments(ends, "--ink", layer.edges, { width: 1, dash: 0.03, opacity: 0.35, depthWrite: false, depthFunc: T.GreaterDepth }));
  if (ball) view.scene.add(ball);
  view.scene.add(dots([center], "--ink", layer.strong, { size: 8, depthTest: false, depthWrite: false }));
  view.label("O", "of-o", () => center);

  let lit = [];
  function drawChoice(state) {
    const own = state.pair === null ? [] : data.facetsOfPair(state.pair);
    lit = own;
    emptied(chosen);
    if (own.length) chosen.add(...marked(places, polygons, own, "--lit", 0.55));
    if (state.facet !== null) chosen.add(...marked(places, polygons, [state.facet], data.facets[state.facet].optimal ? "--true" : "--lit", 0.4));
    const facet = data.facets[state.facet ?? -1] ?? nearestOf(data, state);
    shaft.place(center, facet ? frame.place(plus(origin, times(facet.normal, facet.distance))) : center);
  }

  selection.subscribe((state, changed) => {
    if (!["pair", "facet", "optimum"].some((f) => changed.has(f))) return;
    drawChoice(state);
    view.render();
  });
  const facetAt = (hit) => (hit ? shape.owner[hit.faceIndex] : null);
  view.onPoint([front], {
    over: (hit) => {
      view.canvas.style.cursor = hit ? "pointer" : "";
      selection.preview(hit ? { facet: facetAt(hit) } : null);
    },
    chosen: (hit) => selection.set({ facet: facetAt(hit) === selection.chosen().facet ? null : facetAt(hit) }),
  });

  const way = () => nearestOf(data, selection.get()) ?? data.facets[0], towards = () => frame.move(times(way().normal, Math.max(way().distance, 1e-300)));
  const all = () => view.fit([...places, center], sideView(towards()));
  const near = () => view.fit(ballCorners(data, frame, center), sideView(towards()));
  root.append(element("div", { class: "controls" }, element("div", { class: "buttons", role: "group", "aria-label": "Views of P" },
    element("button", { type: "button", title: "All of P", onclick: all }, "fit"),
    data.stages.depth ? element("button", { type: "button", title: "The ball and the nearest facets", onclick: near }, "ball") : null)), whyLegend(data, frame));
  all();
  onViewLook(view, () => recolour(view.scene));
  return { drawCalls: view.drawCalls, lit: () => ({ blocks: lit.length }) };
}

/** The facet that the chosen optimum lies on. */
export function nearestOf(data, state) {
  const optimum = data.optima[state.optimum], optimal = data.facets.filter((f) => f.optimal);
  if (!optimum || !optimal.length) return optimal[0] ?? null;
  const along = (f) => f.normal.reduce((s, x, i) => s + x * optimum.direction[i], 0);
  return optimal.reduce((best, f) => (along(f) > along(best) ? f : best));
}

function partOf(places, polygons, facets) {
  return meshGeometry(triangles(places, facets.map((f) => polygons[f])));
}

/** Facets filled and outlined, one draw call each. */
function marked(places, polygons, facets, name, opacity) {
  const T = globalThis.THREE, own = facets.map((f) => polygons[f]);
  const outline = edgesOfPolygons(own).flatMap(([v, w]) => [places[v], places[w]]);
  return [
    surface(meshGeometry(triangles(places, own)), name, layer.glass + 2, { flat: true, opacity, depthWrite: false, side: T.DoubleSide }),
    segments(outline, name, layer.faint, { width: 2.5, opacity: 0.45, depthTest: false, depthWrite: false }),
    segments(outline, name, layer.strong, { width: 2.5, depthWrite: false }),
  ];
}

/** The ball around O with the depth as its radius: an ellipsoid where axes are scaled apart. */
function ballOf(data, frame, center) {
  const radius = data.stages.depth === null ? 0 : data.facets[0].distance;
  if (!(radius > 0)) return null;
  const T = globalThis.THREE, ball = surface(new T.SphereGeometry(1, 48, 32), "--true", layer.solid, { opacity: 0.55, depthWrite: false });
  ball.scale.set(...frame.move([radius, radius, radius]));
  ball.position.set(...center);
  return ball;
}

function ballCorners(data, frame, center) {
  const r = frame.move([1, 1, 1].map(() => data.facets[0].distance * 1.15));
  return [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].map((z) => plus(center, [x * r[0], y * r[1], z * r[2]]))));
}

function whyLegend(data, frame) {
  const ties = data.facets.filter((f) => f.optimal).length, overlap = data.status === "penetrating";
  const words = overlap ? `Ball: radius is the depth; it touches ${ties === 1 ? "one facet" : `${ties} facets`}, striped. ` : "O is not inside. ";
  const legendText = element("p", { class: "soft legend" }, words, "Point at a facet: section 1 shows the contact there.");
  if (frame.apart) legendText.append(element("strong", {}, " Axes scaled apart: the ball is drawn as an ellipsoid."));
  return legendText;
}
