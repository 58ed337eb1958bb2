// SPDX-License-Identifier: GPL-3.0-or-later
// Section 2 of unions: the differences of pieces around O, with the ball of the depth. Those that touch at the end of the way out are solid glass,
// their facets there striped; the others that reach into the ball are outlines.
import { frameOf, plus, sideView } from "./geometry.js";
import { element } from "./look.js";
import { onViewLook, withView } from "./scene.js";
import { arrow, dots, emptied, layer, meshGeometry, recolour, segments, surface, triangles } from "./solids.js";
import { secondNormal } from "./uniondata.js";
import { ballCorners, ballOf, marked, whyControls } from "./why.js";

export function mountUnionWhy(root, data, selection) {
  if (!data.pairs.some(({ sum }) => sum.facets.length) || !data.optima.length) return {};
  const label = "The differences of pieces around O, with the ball whose radius is the depth. Shift and arrow keys turn, plus and minus zoom.";
  return withView(root, label, (view) => sumsPicture(root, view, data, selection));
}

function sumsPicture(root, view, data, selection) {
  const T = globalThis.THREE, origin = [0, 0, 0], drawn = data.pairs.map((_, i) => i).filter((i) => data.pairs[i].sum.facets.length);
  const frame = frameOf([...drawn.flatMap((i) => data.pairs[i].sum.vertices), origin]), center = frame.place(origin);
  const parts = new T.Group(), chosen = new T.Group(), shaft = arrow(view, "--true"), ball = ballOf(data, frame, center);
  const placed = (i) => data.pairs[i].sum.vertices.map(frame.place);
  view.scene.add(parts, chosen, shaft.group, dots([center], "--ink", layer.strong, { size: 8, depthTest: false, depthWrite: false }));
  if (ball) view.scene.add(ball);
  view.label("O", "of-o", () => center);
  let lit = [];
  const showWay = (index) => {
    emptied(parts);
    const touching = drawn.filter((i) => data.pairs[i].sum.touches.includes(index)), others = drawn.filter((i) => !touching.includes(i));
    parts.add(...glassOf(data, touching, placed, index), ...outlinesOf(data, others, placed));
    shaft.place(center, frame.place(plus(origin, data.optima[index].translation)));
  };
  const showPair = (pair) => {
    emptied(chosen);
    lit = pair === null || !drawn.includes(pair) ? [] : [pair];
    for (const i of lit) chosen.add(...marked(placed(i), data.pairs[i].sum.facets, data.pairs[i].sum.facets.map((_, f) => f), "--lit", 0.35));
  };
  selection.subscribe((state, changed) => {
    if (changed.has("optimum")) showWay(state.optimum);
    if (changed.has("pair")) showPair(state.pair);
    if (changed.has("optimum") || changed.has("pair")) view.render();
  });
  const way = () => data.optima[selection.get().optimum] ?? data.optima[0];
  const side = () => sideView(frame.move(way().translation), secondNormal(way()));
  const near = () => view.fit(ballCorners(data, frame, center), side());
  const touchingNow = () => drawn.filter((i) => data.pairs[i].sum.touches.includes(selection.get().optimum));
  const all = () => view.fit([...(touchingNow().length ? touchingNow() : drawn).flatMap(placed), center], side());
  root.append(whyControls(all, near, "All that touch"), sumsLegend(data, drawn, frame));
  all();
  onViewLook(view, () => recolour(view.scene));
  return { drawCalls: view.drawCalls, lit: () => ({ blocks: lit.length }) };
}

/** All vertices and facets of some differences, as one mesh. */
function united(data, pairs, placed) {
  const vertices = [], facets = [];
  for (const i of pairs) {
    const first = vertices.length;
    vertices.push(...placed(i));
    facets.push(...data.pairs[i].sum.facets.map((facet) => facet.map((v) => first + v)));
  }
  return { vertices, facets };
}

const sidesOf = (vertices, facets) => facets.flatMap((facet) => facet.flatMap((v, i) => [vertices[v], vertices[facet[(i + 1) % facet.length]]]));

/** The differences that touch, with the facets through the end of the way striped. */
function glassOf(data, pairs, placed, way) {
  if (pairs.length === 0) return [];
  const T = globalThis.THREE, { vertices, facets } = united(data, pairs, placed), geometry = meshGeometry(triangles(vertices, facets));
  const through = pairs.flatMap((i) => {
    const own = placed(i), { sum } = data.pairs[i];
    return sum.through.filter(([, end]) => end === way).map(([facet]) => sum.facets[facet].map((v) => own[v]));
  });
  const flat = through.flat(), polygons = through.reduce(({ list, at }, corners) => ({ list: [...list, corners.map((_, k) => at + k)], at: at + corners.length }), { list: [], at: 0 }).list;
  return [
    surface(geometry, "--soft", layer.glass, { opacity: 0.14, depthWrite: false }),
    surface(geometry, "--soft", layer.backs, { opacity: 0.12, depthWrite: false, side: T.BackSide }),
    surface(meshGeometry(triangles(flat, polygons)), "--true", layer.glass + 1, { opacity: 0.5, depthWrite: false, side: T.DoubleSide }, 0.45),
    segments(sidesOf(vertices, facets), "--ink", layer.edges, { width: 1.2, opacity: 0.7, depthWrite: false }),
  ];
}

function outlinesOf(data, pairs, placed) {
  if (pairs.length === 0) return [];
  const { vertices, facets } = united(data, pairs, placed);
  return [segments(sidesOf(vertices, facets), "--soft", layer.edges, { width: 1, dash: 0.03, opacity: 0.4, depthWrite: false })];
}

function sumsLegend(data, drawn, frame) {
  const others = drawn.some((i) => !data.pairs[i].sum.touches.includes(0));
  const words = "Ball: its radius is the depth; the arrow ends where the striped facets of those that touch meet. ";
  const legendText = element("p", { class: "soft legend" }, words, others ? "Dashed: the others that reach into the ball." : "");
  if (frame.apart) legendText.append(element("strong", {}, " Axes scaled apart: the ball is drawn as an ellipsoid."));
  return legendText;
}
