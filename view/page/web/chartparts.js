// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the chart's picture, of its controls and of what is said about it; chart.js puts them together.
import { chartSide, chartTicks, pairsOfArc, planeReach } from "./chartpainter.js";
import { element, svg } from "./look.js";

export const mostSvgArcs = 2000, mostWalls = 400, mostCrossings = 5000;
export const chartNames = ["upper", "lower"];

export function chartTools(selection) {
  const choice = (field, value, text) => element("button", { type: "button", onclick: () => selection.set({ [field]: value }) }, text);
  const hemispheres = Object.fromEntries(["upper", "lower", "both"].map((name) => [name, choice("hemisphere", name, name)]));
  const planes = [choice("plane", false, "longitude \u00d7 latitude"), choice("plane", true, "the paper\u2019s plane z = 1")];
  const group = (label, buttons) => element("div", { role: "group", "aria-label": label, class: "choice" }, ...buttons);
  const bar = element("div", { class: "bar" }, group("Hemisphere", Object.values(hemispheres)), group("Projection", planes));
  const show = (state) => {
    for (const [name, button] of Object.entries(hemispheres)) button.setAttribute("aria-pressed", String(state.hemisphere === name));
    planes.forEach((button, i) => button.setAttribute("aria-pressed", String(state.plane === (i === 1))));
  };
  return { bar, show };
}

export function axisElements(plane) {
  const reach = plane ? planeReach : 90,
    at = (v) => ((v + reach) / (2 * reach)) * chartSide;
  const ticks = chartTicks(plane).flatMap(([value, label]) => [
    svg("path", { class: "tick", d: `M${at(value)} ${chartSide}v5M0 ${chartSide - at(value)}h-5` }),
    svg("text", { x: at(value), y: chartSide + 9, "text-anchor": "middle", "dominant-baseline": "hanging" }, label),
    svg("text", { x: -9, y: chartSide - at(value), "text-anchor": "end", "dominant-baseline": "central" }, label),
  ]);
  const middle = chartSide / 2;
  return [
    svg("rect", { class: "border", x: 0, y: 0, width: chartSide, height: chartSide }),
    ...ticks,
    svg("text", { x: middle, y: chartSide + 52, "text-anchor": "middle" }, plane ? "x" : "longitude"),
    svg("text", { transform: `translate(-50 ${middle}) rotate(-90)`, "text-anchor": "middle" }, plane ? "y" : "latitude"),
  ];
}

export function nodeMark(place, name) {
  if (!place) return [];
  const [x, y] = place;
  return [
    name === "a"
      ? svg("circle", { class: "node a lit", cx: x, cy: y, r: 6 })
      : svg("rect", { class: "node b lit", x: x - 8, y: y - 8, width: 16, height: 16 }),
  ];
}

export function chartCaption(view) {
  const { data, chart, lists, projection } = view,
    walls = chart.walls.length;
  const shown = (name) => `${lists[name].length} arc${lists[name].length === 1 ? "" : "s"} of ${name === "a" ? "\u2212A" : "B"}`;
  const sentences = [`The ${chartNames[view.index]} hemisphere, seen from outside: `];
  const key = (name, what) => element("span", { class: `key-${name}` }, what);
  const outside = chart.a.arcs.length + chart.b.arcs.length - lists.a.length - lists.b.length;
  const more = [];
  if (projection.plane)
    more.push(` The window ends at ${planeReach}; the equator is at infinity.${outside > 0 ? ` ${outside} arcs lie outside of it.` : ""}`);
  if (walls > mostWalls) more.push(` Its ${walls} walls are not drawn, only the strip of a chosen pair.`);
  else more.push(` Its ${walls} walls are the verticals through the nodes.`);
  if (view.onCanvas)
    more.push(` More than ${mostSvgArcs.toLocaleString("en")} arcs are painted as one picture; they can be clicked all the same.`);
  if (data.optima.length > 0) more.push(" n marks the optimum.");
  return [...sentences, key("a", `${shown("a")}, solid`), "; ", key("b", `${shown("b")}, dashed`), ".", ...more];
}

/** What the dots are; `count`: of the facets of P that hold a crossing of the pair. */
export function crossingsSentence({ stages }, pair, count) {
  if (stages.sum?.kind !== "P") return `The crossings of pair ${pair} are not drawn: P is not listed.`;
  if (count === 0) return `Arcs of pair ${pair} cross only once they are perturbed: there is no dot.`;
  const what = count === 1 ? "The dot is where arcs of" : `${count} dots are where arcs of`;
  const told = `${what} pair ${pair} cross: ${count === 1 ? "the normal of a facet" : "normals of facets"} of P.`;
  return count > mostCrossings ? `${told} The first ${mostCrossings} are drawn.` : told;
}

export function arcSentence(view, { name, edge }) {
  const body = view.data.bodies[name],
    count = pairsOfArc(view.data, name, edge, view.index).length;
  const points = body.edges[edge].map((v) => body.ids[v]).join(" and ");
  const crosses =
    count === 0 ? `crosses no arc of ${name === "a" ? "B" : "\u2212A"} here` : `in ${count} canonical pair${count === 1 ? "" : "s"} here`;
  return `Arc of edge ${edge} of ${body.name}, from point ${points}: ${crosses}.`;
}
