// SPDX-License-Identifier: GPL-3.0-or-later
// Section 3, the chart: one hemisphere of both Gaussian diagrams, with walls, and the strip of the chosen canonical pair. Arcs can be
// clicked. Up to 2,000 arcs are paths of SVG; more are painted on a canvas under it, and only what is lit are paths.
import { arcCurve } from "./arcs.js";
import {
  chartMargin, chartPolylines, chartProjection, chartSide, hemisphereShown, nearestArc, nextPairOfArc, pathText, stripBorders,
} from "./chartpainter.js";
import {
  arcSentence, axisElements, chartCaption, chartNames, chartTools, crossingsSentence, mostCrossings, mostSvgArcs, mostWalls, nodeMark,
} from "./chartparts.js";
import { hemisphereOfChoice, litArcs, litInDiagrams } from "./lit.js";
import { colour, element, onLook, svg } from "./look.js";

const hitReach = 9;

export function mountChart(root, data, selection) {
  if (data.charts.length === 0) return {};
  const view = { data, selection, facing: firstFacing(data, selection), key: "", lists: { a: [], b: [] } };
  Object.assign(view, chartElements(view));
  root.replaceChildren(view.figure);
  const place = root.closest("section") ?? root;
  place.addEventListener("facing", (event) => turnChart(view, event.detail));
  selection.subscribe((state, changed) => showChart(view, state, changed));
  onLook(() => paintCanvas(view));
  return { lit: () => ({ chart: litArcs(litInDiagrams(data, selection.get())) }) };
}

/** Of "both" the hemisphere with the pair or the optimum is shown until the sphere is turned. */
function firstFacing(data, selection) {
  const { pair, optimum } = selection.get();
  if (pair !== null) return data.pairs[pair].chart;
  return (data.optima[optimum]?.direction?.[2] ?? 0) < 0 ? 1 : 0;
}

function turnChart(view, hemisphere) {
  if (view.facing === hemisphere) return;
  view.facing = hemisphere;
  showChart(view, view.selection.get(), new Set());
}

// ---- what stands there ----

function chartElements(view) {
  const { left, right, top, bottom } = chartMargin;
  const layer = (name) => svg("g", { class: name });
  const layers = { walls: layer("walls"), arcs: layer("arcs"), lit: layer("chosen"), marks: layer("marks"), axes: layer("axes") };
  const strip = svg("rect", { class: "strip", y: 0, height: chartSide });
  const clip = svg("clipPath", { id: "chart-square" }, svg("rect", { x: 0, y: 0, width: chartSide, height: chartSide }));
  const square = svg("g", { "clip-path": "url(#chart-square)" }, strip, layers.walls, layers.arcs, layers.lit);
  const picture = svg(
    "svg",
    {
      viewBox: `${-left} ${-top} ${left + chartSide + right} ${top + chartSide + bottom}`,
      role: "img",
      class: "chart-picture",
      "aria-label": "Chart of one hemisphere",
    },
    svg("defs", {}, clip),
    square,
    layers.marks,
    layers.axes,
  );
  const canvas = element("canvas", {
    class: "chart-canvas",
    width: 2 * chartSide,
    height: 2 * chartSide,
    "aria-hidden": "true",
    hidden: true,
  });
  const width = left + chartSide + right,
    height = top + chartSide + bottom;
  Object.assign(canvas.style, {
    left: `${(100 * left) / width}%`,
    top: `${(100 * top) / height}%`,
    width: `${(100 * chartSide) / width}%`,
  });
  const caption = element("figcaption", { class: "chart-caption" }),
    over = element("p", { class: "chart-over soft" }),
    elsewhere = element("p", { class: "note", hidden: true }),
    crossings = element("p", { class: "chart-crossings soft" });
  const tools = chartTools(view.selection);
  const frame = element("div", { class: "chart-frame" }, canvas, picture);
  listenToArcs(view, picture);
  return {
    layers,
    strip,
    picture,
    canvas,
    caption,
    over,
    elsewhere,
    crossings,
    tools,
    figure: element("figure", {}, tools.bar, frame, over, elsewhere, crossings, caption),
  };
}

// ---- what changes ----

function showChart(view, state, changed) {
  const { data } = view;
  if (state.hemisphere === "both") view.facing = hemisphereOfChoice(data, view.selection.chosen(), changed) ?? view.facing;
  view.index = Math.min(hemisphereShown(state, view.facing), data.charts.length - 1);
  view.chart = data.charts[view.index];
  const key = `${view.index}${state.plane}`;
  if (key !== view.key) {
    view.key = key;
    view.projection = chartProjection(view.chart.frame, state.plane);
    paintBase(view);
  }
  view.tools.show(state);
  paintLit(view, state);
  paintMarks(view, state);
  sayElsewhere(view, state);
}

function paintBase(view) {
  const { data, chart, projection, layers } = view;
  for (const name of ["a", "b"])
    view.lists[name] = chartPolylines(
      data.bodies[name],
      chart[name].arcs.map(([edge]) => edge),
      projection,
    );
  const count = view.lists.a.length + view.lists.b.length;
  view.onCanvas = count > mostSvgArcs;
  view.canvas.hidden = !view.onCanvas;
  const paths = (name) =>
    view.lists[name].map(({ edge, points }) => svg("path", { class: `arc ${name}`, d: pathText(points), "data-edge": edge }));
  layers.arcs.replaceChildren(...(view.onCanvas ? [] : [...paths("a"), ...paths("b")]));
  layers.walls.replaceChildren(
    ...(chart.walls.length > mostWalls ? [] : chart.walls.flatMap(([name, node]) => wallLine(view, name, node))),
  );
  layers.axes.replaceChildren(...axisElements(projection.plane));
  paintCanvas(view);
  view.picture.setAttribute(
    "aria-label",
    `Chart of the ${chartNames[view.index]} hemisphere: ${count} arcs. The table of canonical pairs below says the same in text.`,
  );
  view.caption.replaceChildren(...chartCaption(view));
}

function wallLine(view, name, node) {
  const x = view.projection.abscissa(view.data.bodies[name].nodes[node]);
  return x === null ? [] : [svg("line", { class: `wall ${name}`, x1: x, x2: x, y1: 0, y2: chartSide })];
}

function paintCanvas(view) {
  if (!view.onCanvas) return;
  const context = view.canvas.getContext("2d");
  context.setTransform(2, 0, 0, 2, 0, 0);
  context.clearRect(0, 0, chartSide, chartSide);
  context.lineWidth = 0.7;
  for (const name of ["a", "b"]) {
    context.strokeStyle = colour(`--${name}`);
    context.setLineDash(name === "b" ? [3, 2] : []);
    context.beginPath();
    for (const { points } of view.lists[name]) points.forEach(([x, y], i) => (i === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
    context.stroke();
  }
}

function paintLit(view, state) {
  const { data, projection, chart } = view,
    lit = litInDiagrams(data, state),
    elements = [];
  const pair = state.pair === null ? null : data.pairs[state.pair],
    here = pair === null || pair.chart === view.index;
  for (const name of ["a", "b"]) {
    const body = data.bodies[name];
    for (const edge of here ? lit[name].arcs : []) {
      const curve = arcCurve(body, edge),
        points = curve && (projection.path(curve) ?? (projection.plane ? null : [projection.point(curve), projection.point(curve)]));
      elements.push(svg("path", { class: `arc ${name} lit`, d: points ? pathText(points) : "", "data-edge": edge }));
    }
    for (const node of lit[name].nodes) elements.push(...nodeMark(projection.place(body.nodes[node]), name));
  }
  view.layers.lit.replaceChildren(...elements);
  const borders = pair !== null && here ? stripBorders(pair.strip, chart.walls, data.bodies, projection) : null;
  view.strip.setAttribute("x", borders?.[0] ?? 0);
  view.strip.setAttribute("width", borders ? Math.max(1, borders[1] - borders[0]) : 0);
}

function paintMarks(view, state) {
  const marks = [],
    { data, projection } = view;
  const ring = (direction, name, label) => {
    const place = direction && projection.place(direction);
    if (!place) return;
    const [x, y] = place,
      inward = x > chartSide - 30 ? -14 : 12;
    marks.push(svg("circle", { class: name, cx: x, cy: y, r: 7 }), svg("circle", { class: `${name} dot`, cx: x, cy: y, r: 1.5 }));
    if (label)
      marks.push(
        svg("text", { class: name, x: x + inward, y: y < 20 ? y + 16 : y - 8, "text-anchor": inward < 0 ? "end" : "start" }, label),
      );
  };
  data.optima.slice(0, 100).forEach((optimum, i) => i !== state.optimum && ring(optimum.direction, "optimum other", ""));
  ring(data.optima[state.optimum]?.direction, "optimum", "n");
  if (state.facet !== null) ring(data.facets[state.facet].normal, "normal", "facet");
  view.layers.marks.replaceChildren(...crossingDots(view, state), ...marks);
}

/** A dot where arcs of the chosen pair cross: the round ends of a line that has hardly any length, all in one path. */
function crossingDots({ data, projection, index, crossings }, { pair }) {
  const here = pair !== null && data.pairs[pair].chart === index;
  const facets = here ? data.facetsOfPair(pair) : [], drawn = facets.slice(0, mostCrossings);
  const places = drawn.map((f) => projection.place(data.facets[f].normal)).filter((place) => place !== null);
  crossings.replaceChildren(...(here ? [crossingsSentence(data, pair, facets.length)] : []));
  if (places.length === 0) return [];
  return [svg("path", { class: "crossings", d: places.map(([x, y]) => `M${x.toFixed(1)} ${y.toFixed(1)}h.01`).join("") })];
}

// ---- what is said ----

function sayElsewhere(view, { pair }) {
  const other = pair !== null && view.data.pairs[pair].chart !== view.index;
  view.elsewhere.hidden = !other;
  if (!other) return view.elsewhere.replaceChildren();
  const name = chartNames[view.data.pairs[pair].chart];
  view.elsewhere.replaceChildren(
    `Canonical pair ${pair} lies in the ${name} hemisphere. `,
    element("button", { type: "button", onclick: () => view.selection.set({ hemisphere: name }) }, `show the ${name} hemisphere`),
  );
}

function listenToArcs(view, picture) {
  const at = (event) => {
    const box = picture.getBoundingClientRect(),
      scale = (chartMargin.left + chartSide + chartMargin.right) / box.width;
    return [(event.clientX - box.left) * scale - chartMargin.left, (event.clientY - box.top) * scale - chartMargin.top, hitReach * scale];
  };
  const arcUnder = (event) => {
    const [x, y, reach] = at(event);
    return nearestArc(view.lists, [x, y], reach);
  };
  picture.addEventListener("pointermove", (event) => {
    const arc = arcUnder(event);
    picture.classList.toggle("over-arc", arc !== null);
    view.over.textContent = arc ? arcSentence(view, arc) : "";
  });
  picture.addEventListener("pointerleave", () => (view.over.textContent = ""));
  picture.addEventListener("click", (event) => {
    const arc = arcUnder(event);
    if (!arc) return;
    const next = nextPairOfArc(view.data, arc.name, arc.edge, view.index, view.selection.chosen().pair);
    if (next !== null) view.selection.set({ pair: next });
    view.over.textContent = arcSentence(view, arc);
  });
}
