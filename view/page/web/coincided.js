// SPDX-License-Identifier: GPL-3.0-or-later
// Section 4: what coincides, by name; a click lights the features everywhere. Beside it a chart in which a visible epsilon moves -A and
// tilts the frame, so that one sees how the perturbation takes apart what coincides, and by which monomial. Then each predicate: how often
// it was asked, and what decided where it was zero.
import { chartPolylines, chartProjection, chartSide, pathText } from "./chartpainter.js";
import { coincidenceKinds, coincidenceSentences, involvedText, spokenName } from "./coincidences.js";
import { dot } from "./geometry.js";
import { liesBelow, litInDiagrams } from "./lit.js";
import { columnHeading, element, svg, toldTable } from "./look.js";
import { roughly } from "./numbers.js";
import { infinitesimalNames, movedDiagram, seenMonomial, seenSizes, tiltedFrame } from "./perturbed.js";

const mostBackground = 600,
  startsAt = 0.4;

export function mountCoincided(root, data, selection) {
  const view = { data, selection, epsilon: startsAt, items: new Map() };
  const { cores, decided = [] } = data.stages;
  const list = kindsElement(view, data.coincidences, data.charts.length > 0);
  if (cores) list.append(element("h3", {}, "The cores, without their radii"), kindsElement(view, cores, true));
  const picture = data.charts.length > 0 && data.coincidences.length > 0 ? splitElements(view) : null;
  root.replaceChildren(element("div", { class: "columns equal" }, list, picture), ...(decided.length > 0 ? [decidedTable(decided)] : []));
  selection.subscribe((state, changed) => {
    if (changed.has("coincidence")) showCoincidence(view, state.coincidence);
  });
  return {};
}

// ---- the list ----

function kindsElement(view, coincidences, ofPolytopes) {
  const { present, absent } = coincidenceKinds(coincidences);
  return element(
    "div",
    { class: "coincidences" },
    ...(present.length > 0 ? present.map((kind) => kindElement(view, kind)) : [element("p", {}, "Nothing coincides.")]),
    ofPolytopes && present.length > 0 ? element("p", { class: "soft" }, `None: ${absent.map(spokenName).join(", ")}.`) : null,
  );
}

function kindElement(view, { kind, count, listed, index }) {
  const items = listed.map((item, j) => itemElement(view, `${index}.${j}`, item));
  const left = count - listed.length,
    more = left > 0 ? element("li", { class: "soft" }, `and ${left} more, counted and not listed`) : null;
  const few = listed.length <= 4,
    list = element("ul", {}, ...items, more);
  const shown =
    listed.length === 0
      ? ""
      : few
        ? list
        : element("details", {}, element("summary", {}, left > 0 ? `the first ${listed.length}` : `all ${count}`), list);
  return element(
    "div",
    { class: "kind" },
    element("h3", {}, spokenName(kind), " ", element("span", { class: "count" }, String(count))),
    coincidenceSentences[kind] ? element("p", {}, coincidenceSentences[kind]) : "",
    shown,
  );
}

function itemElement(view, name, item) {
  if (view.data.charts.length === 0) return element("li", {}, involvedText(item));
  const monomials = item.decided_by ?? [];
  const decided =
    monomials.length === 0 ? [] : [" ", element("span", { class: "monomial" }, `decided by ${monomials.map(monomialText).join(", ")}`)];
  const button = element(
    "button",
    { type: "button", class: "item", "aria-pressed": "false", onclick: () => chooseCoincidence(view, name) },
    involvedText(item),
    ...decided,
  );
  view.items.set(name, button);
  return element("li", {}, button);
}

/** "E12 b^2" as it is written: E12 b². */
function monomialText(name) {
  return name.replace(/\^(\d+)/g, (_, digits) =>
    [...digits].map((d) => "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"[d]).join(""),
  );
}

function chooseCoincidence({ selection }, name) {
  selection.set({ coincidence: selection.chosen().coincidence === name ? null : name, pair: null, facet: null });
}

function showCoincidence(view, name) {
  for (const [item, button] of view.items) button.setAttribute("aria-pressed", String(item === name));
  const button = view.items.get(name),
    fold = button?.closest("details");
  if (fold) fold.open = true;
  // Until one is chosen the picture shows the first, and only the picture.
  view.name = name ?? view.items.keys().next().value ?? null;
  if (view.picture) paintSplit(view);
}

// ---- the picture ----

function splitElements(view) {
  const slider = element("input", {
    type: "range",
    min: 0,
    max: 1,
    step: 0.01,
    value: view.epsilon,
    id: "epsilon",
    "aria-describedby": "epsilon-said",
  });
  slider.addEventListener("input", () => {
    view.epsilon = Number(slider.value);
    paintSplit(view);
  });
  view.picture = svg("svg", {
    viewBox: `-1 -1 ${chartSide + 2} ${chartSide + 2}`,
    role: "img",
    class: "chart-picture split",
    "aria-label": "Chart with a visible perturbation",
  });
  view.sizes = element("p", { class: "soft sizes", id: "epsilon-said" });
  view.decided = element("p", { class: "decided" });
  const label = element("label", { for: "epsilon" }, "a visible \u03b5"),
    ends = (text) => element("span", { class: "soft" }, text);
  const words =
    "A picture, not to scale. In the program a, b, c, E11, \u2026, E33 are symbols: each is positive, and smaller than every power of " +
    "the one before. Here they are numbers, each a little smaller than the one before. Topology is decided on what is moved; distances " +
    "are always those of the input.";
  return element(
    "figure",
    { class: "split-figure" },
    element("div", { class: "bar" }, label, ends("0: as given"), slider, ends("1")),
    view.picture,
    view.decided,
    view.sizes,
    element("figcaption", {}, words),
  );
}

function paintSplit(view) {
  const { data, epsilon } = view,
    sizes = seenSizes(epsilon),
    bodies = { a: movedDiagram(data.bodies.a, sizes), b: data.bodies.b };
  const lit = litInDiagrams(data, { pair: null, facet: null, coincidence: view.name ?? null });
  const lower = data.charts.length > 1 && liesBelow(data, lit);
  const projection = chartProjection(tiltedFrame(sizes, lower), false),
    parts = [];
  const few = data.bodies.a.arcs.length + data.bodies.b.arcs.length <= mostBackground;
  for (const name of ["a", "b"]) {
    const all = few ? bodies[name].arcs.keys() : arcsNear(data, name, lit[name]);
    for (const { points } of chartPolylines(bodies[name], all, projection))
      parts.push(svg("path", { class: `arc ${name}`, d: pathText(points) }));
  }
  for (const name of ["a", "b"]) parts.push(...litParts(bodies[name], name, lit[name], projection));
  view.picture.replaceChildren(...parts, svg("rect", { class: "border", x: 0, y: 0, width: chartSide, height: chartSide }));
  view.sizes.textContent = infinitesimalNames.map((name) => `${name} = ${roughly(sizes[name], 2)}`).join(", ");
  view.decided.replaceChildren(...decidedSentence(view, sizes, lower));
}

/** Of large bodies only the arcs round what is lit are drawn. */
function arcsNear({ bodies }, name, { arcs, nodes }) {
  const { edges, edgesAt, facets } = bodies[name];
  const vertices = new Set([...arcs.flatMap((e) => edges[e]), ...nodes.flatMap((f) => facets[f])]);
  return new Set([...vertices].flatMap((v) => edgesAt[v]));
}

function litParts(body, name, lit, projection) {
  const parts = chartPolylines(body, lit.arcs, projection).map(({ points }) =>
    svg("path", { class: `arc ${name} lit`, d: pathText(points) }),
  );
  for (const node of lit.nodes) {
    const place = projection.place(body.nodes[node]);
    if (!place || dot(body.nodes[node], projection.axes.z) < 0) continue;
    const [x, y] = place;
    parts.push(svg("line", { class: `wall ${name}`, x1: x, x2: x, y1: 0, y2: chartSide }));
    parts.push(
      name === "a"
        ? svg("circle", { class: "node a lit", cx: x, cy: y, r: 7 })
        : svg("rect", { class: "node b lit", x: x - 9, y: y - 9, width: 18, height: 18 }),
    );
  }
  return parts;
}

function listedItem({ coincidences }, name) {
  const [i, j] = name.split(".");
  return coincidences[i].listed[j];
}

function decidedSentence({ data, name }, sizes, lower) {
  const where = `The ${lower ? "lower" : "upper"} hemisphere. `;
  const item = name ? data.coincidence(name) : null;
  if (!item) return [where];
  const what = `${spokenName(item.kind)}, ${involvedText(listedItem(data, name))}`,
    shown = [element("strong", {}, what), ". ", where];
  if (item.decided_by.length === 0) return [...shown, "No predicate was asked about it, or none that was zero: no monomial decided."];
  const monomials = item.decided_by.map((monomial) => {
    const size = seenMonomial(monomial, sizes);
    return `${monomialText(monomial)}${size === null ? "" : `, here ${roughly(size, 2)}`}`;
  });
  const rule = ": of each sign that was asked, the largest monomial whose coefficient is not 0.";
  return [...shown, "Decided by ", element("strong", {}, monomials.join("; ")), rule];
}

// ---- the predicates ----

function decidedTable(decided) {
  const names = ({ monomials }) => monomials.map(({ name, count }) => `${monomialText(name)}: ${count}`).join(", ");
  const rows = decided.map((row) =>
    element(
      "tr",
      {},
      element("th", { scope: "row" }, spokenName(row.predicate)),
      ...[row.calls, row.exact, row.zero].map((count) => element("td", {}, String(count))),
      element("td", { class: "text" }, names(row)),
    ),
  );
  const heads = [columnHeading("predicate", "text"), ...["calls", "exact", "zero"].map((text) => columnHeading(text))];
  return toldTable(
    "What the perturbation decided",
    "How often the topology asked each predicate. exact: floating point could not decide; zero: the value is 0, and these monomials decided.",
    element("thead", {}, element("tr", {}, ...heads, columnHeading("decided by: how often", "text"))),
    element("tbody", {}, ...rows),
  );
}
