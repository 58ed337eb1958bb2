// SPDX-License-Identifier: GPL-3.0-or-later
// Section 2, Why no shorter way: P around O, the ball that reaches its nearest facets, and the facets that a choice lights.
import { wayOf } from "./contact.js";
import { creases, edgesOfPolygons, frameOf, norm, plus, sideView, times } from "./geometry.js";
import { element } from "./look.js";
import { onViewLook, withView } from "./scene.js";
import { arrow, dots, emptied, layer, meshGeometry, recolour, segments, surface, triangles } from "./solids.js";

const mostHiddenOfSum = 300;  // edges: behind more, they are noise

export function mountWhy(root, data, selection) {
  const sum = data.stages.sum;
  if (!sum?.vertices?.length || !data.facets.length) return {};
  const names = { Q: "Q, the certificate's polytope inside P", sampled: "P, the sum of B and -A, as a mesh" };
  const name = names[sum.kind] ?? "P, the sum of B and -A";
  const about = "around O, with the ball whose radius is the depth; its nearest facets are marked";
  const label = `${name}, ${about}. Shift and arrow keys turn, plus and minus zoom.`;
  return withView(root, label, (view) => whyPicture(root, view, data, selection));
}

function whyPicture(root, view, data, selection) {
  const sum = data.stages.sum, origin = sum.origin ?? [0, 0, 0], frame = frameOf([...sum.vertices, origin]);
  const center = frame.place(origin), places = sum.vertices.map(frame.place), shape = triangles(places, data.facets.map((f) => f.vertices));
  const front = addSum(view, data, places, shape), ball = ballOf(data, frame, center), choice = choiceOf(view, data, frame, places, origin);
  if (ball) view.scene.add(ball);
  view.scene.add(dots([center], "--ink", layer.strong, { size: 8, depthTest: false, depthWrite: false }));
  view.label("O", "of-o", () => center);
  selection.subscribe((state, changed) => {
    if (!["pair", "facet", "optimum"].some((f) => changed.has(f))) return;
    choice.show(state);
    view.render();
  });
  if (isListed(data)) pointAtFacets(view, front, shape, selection);
  const way = () => wayOf(data, selection.get()) ?? { translation: [0, 0, 0] };
  const side = () => sideView(frame.move(way().translation));
  const all = () => view.fit([...places, center], side()), near = () => view.fit(ballCorners(data, frame, center), side());
  root.append(whyControls(all, ball ? near : null), whyLegend(data, frame));
  all();
  onViewLook(view, () => recolour(view.scene));
  return { drawCalls: view.drawCalls, lit: () => ({ blocks: choice.lit().length }) };
}

/** P as glass, its edges, its nearest facets striped. Returns the mesh that the pointer hits. */
function addSum(view, data, places, shape) {
  const T = globalThis.THREE, polygons = data.facets.map((f) => f.vertices), geometry = meshGeometry(shape);
  const nearest = meshGeometry(triangles(places, data.facets.filter((f) => f.optimal).map((f) => f.vertices)));
  const front = surface(geometry, "--soft", layer.glass, { opacity: 0.13, depthWrite: false });
  const hiding = { flat: true, colorWrite: false, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
  const edges = data.stages.sum.kind === "sampled" ? creases(places, polygons) : edgesOfPolygons(polygons);
  const ends = edges.flatMap(([v, w]) => [places[v], places[w]]);
  view.scene.add(front, surface(geometry, "--soft", layer.backs, { opacity: 0.16, depthWrite: false, side: T.BackSide }),
    surface(nearest, "--true", layer.glass + 1, { opacity: 0.5, depthWrite: false, side: T.DoubleSide }, 0.45),
    surface(geometry, "--soft", layer.glassDepth, hiding),
    segments(ends, "--ink", layer.edges, { width: 1.2, opacity: edges.length > 6000 ? 0.25 : 0.75, depthWrite: false }));
  const behind = { width: 1, dash: 0.03, opacity: 0.35, depthWrite: false, depthFunc: T.GreaterDepth };
  if (edges.length <= mostHiddenOfSum) view.scene.add(segments(ends, "--ink", layer.edges, behind));
  return front;
}

/** What a selection lights: the facets of a pair, one facet, the way from O to it. */
function choiceOf(view, data, frame, places, origin) {
  const T = globalThis.THREE, polygons = data.facets.map((f) => f.vertices), chosen = new T.Group(), shaft = arrow(view, "--true");
  view.scene.add(chosen, shaft.group);
  let lit = [];
  return {
    lit: () => lit,
    show(state) {
      lit = state.pair === null ? [] : data.facetsOfPair(state.pair);
      const facet = state.facet === null ? null : data.facets[state.facet], way = wayOf(data, state);
      emptied(chosen);
      if (lit.length) chosen.add(...marked(places, polygons, lit, "--lit", 0.55));
      if (facet) chosen.add(...marked(places, polygons, [state.facet], facet.optimal ? "--true" : "--lit", 0.4));
      shaft.place(frame.place(origin), frame.place(plus(origin, way?.translation ?? [0, 0, 0])));
    },
  };
}

export function whyControls(all, near, title = "All of P") {
  const button = (name, title, act) => element("button", { type: "button", title, onclick: act }, name);
  const buttons = [button("fit", title, all), near ? button("ball", "The ball and the nearest facets", near) : null];
  return element("div", { class: "controls" }, element("div", { class: "buttons", role: "group", "aria-label": `Views: ${title}` }, ...buttons));
}

/** Whether facets are those of P or Q, with features; those of a mesh are none. */
function isListed(data) {
  return data.stages.sum.kind !== "sampled";
}

function pointAtFacets(view, front, shape, selection) {
  const facetAt = (hit) => (hit ? shape.owner[hit.faceIndex] : null);
  view.onPoint([front], {
    over(hit) {
      view.canvas.style.cursor = hit ? "pointer" : "";
      selection.preview(hit ? { facet: facetAt(hit) } : null);
    },
    chosen: (hit) => selection.set({ facet: facetAt(hit) === selection.chosen().facet ? null : facetAt(hit) }),
  });
}

/** Facets filled and outlined, one draw call each. */
export function marked(places, polygons, facets, name, opacity) {
  const T = globalThis.THREE, own = facets.map((f) => polygons[f]);
  const outline = edgesOfPolygons(own).flatMap(([v, w]) => [places[v], places[w]]);
  return [
    surface(meshGeometry(triangles(places, own)), name, layer.glass + 2, { flat: true, opacity, depthWrite: false, side: T.DoubleSide }),
    segments(outline, name, layer.faint, { width: 2.5, opacity: 0.45, depthTest: false, depthWrite: false }),
    segments(outline, name, layer.strong, { width: 2.5, depthWrite: false }),
  ];
}

/** The ball around O with the depth as its radius: an ellipsoid where axes are scaled apart. */
export function ballOf(data, frame, center) {
  const radius = radiusOf(data);
  if (!(radius > 0)) return null;
  const T = globalThis.THREE, ball = surface(new T.SphereGeometry(1, 48, 32), "--true", layer.solid, { opacity: 0.55, depthWrite: false });
  ball.scale.set(...frame.move([radius, radius, radius]));
  ball.position.set(...center);
  return ball;
}

function radiusOf(data) {
  return data.status === "penetrating" && data.optima.length ? norm(data.optima[0].translation) : 0;
}

export function ballCorners(data, frame, center) {
  const r = frame.move([1, 1, 1].map(() => radiusOf(data) * 1.15));
  return [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].map((z) => plus(center, [x * r[0], y * r[1], z * r[2]]))));
}

function whyLegend(data, frame) {
  const ties = data.facets.filter((f) => f.optimal).length, overlap = data.status === "penetrating";
  const touched = ties === 0 ? "" : `; it touches ${ties === 1 ? "one facet" : `${ties} facets`}, striped`;
  const words = overlap ? `Ball: its radius is the depth${touched}. ` : "O is not inside. ";
  const invitation = isListed(data) ? "Point at a facet: section 1 shows the contact there." : "";
  const legendText = element("p", { class: "soft legend" }, words, invitation);
  if (frame.apart) legendText.append(element("strong", {}, " Axes scaled apart: the ball is drawn as an ellipsoid."));
  return legendText;
}
