// SPDX-License-Identifier: GPL-3.0-or-later
// Section 3, the table of canonical pairs. Choosing one lights its arcs, its edges and its facets of P; choosing one of another
// hemisphere goes there.
import { element } from "./look.js";
import { closestSentence, pairCells, pairHeadings, pairRows, pairSentence, pairSize, shownUpTo } from "./pairrows.js";

const rowsAtOnce = 200,
  fewSingles = 12;

export function mountPairs(root, data, selection) {
  if (data.pairs.length === 0) {
    root.replaceChildren(element("p", { class: "note" }, noPairsSentence(data)));
    return {};
  }
  const rows = pairRows(data);
  const view = {
    data,
    selection,
    rows,
    shown: { large: 0, single: 0 },
    rowOf: new Map(),
    open: rows.large.length === 0 || rows.single.length <= fewSingles,
  };
  Object.assign(view, pairElements(view));
  root.replaceChildren(
    element("h3", {}, `Canonical pairs (${data.pairs.length})`),
    element("p", { class: "soft" }, tableSentence(view)),
    view.box,
    view.details,
  );
  growRows(view, "large", -1);
  if (view.open) growRows(view, "single", -1);
  showFold(view);
  selection.subscribe((state, changed) => showPair(view, state, changed));
  return {};
}

function noPairsSentence({ charts }) {
  return charts.length === 0
    ? "There are no canonical pairs: the bodies are not both polytopes."
    : "No arc of \u2212A crosses one of B: there are no canonical pairs.";
}

// ---- what stands there ----

function pairElements(view) {
  const { rows } = view,
    words = ["", "text", "text", "", "", "", "text"];
  const head = element(
    "thead",
    {},
    element("tr", {}, ...pairHeadings.map((text, i) => element("th", { scope: "col", class: words[i] }, text))),
  );
  const large = element("tbody"),
    single = element("tbody"),
    fold = element("tbody");
  const moreLarge = moreButton(view, "large"),
    moreSingle = moreButton(view, "single");
  const count = rows.single.length,
    text = `${count} pair${count === 1 ? "" : "s"} of 1 \u00d7 1`;
  const opener = element("button", { type: "button", class: "fold", "aria-expanded": "false", onclick: () => toggleFold(view) }, text);
  if (count > 0) fold.append(element("tr", {}, element("th", { colspan: pairHeadings.length, scope: "rowgroup", class: "text" }, opener)));
  const table = element("table", { class: "pairs-table" }, head, large, fold, single);
  const box = element(
    "div",
    { class: "wide pairs-box", tabindex: 0, role: "region", "aria-label": "Canonical pairs" },
    table,
    moreLarge,
    moreSingle,
  );
  const details = element("div", { class: "pair-details" });
  return { box, details, opener, bodies: { large, single }, more: { large: moreLarge, single: moreSingle } };
}

function tableSentence({ data }) {
  const crossings = data.pairs.reduce((sum, pair) => sum + pairSize(pair), 0);
  const all = crossings === 1 ? "the one crossing occurs" : `each of the ${crossings} crossings occurs`;
  return `Every arc of A\u1d62 crosses every arc of B\u1d62; ${all} in one pair. Largest first; j and k step through them.`;
}

function moreButton(view, part) {
  return element("button", { type: "button", hidden: true, onclick: () => growRows(view, part, view.shown[part]) }, "");
}

/** Shows rows of a part of the table at least up to this position, -1: as many as at first. */
function growRows(view, part, position) {
  const list = view.rows[part],
    from = view.shown[part],
    to = shownUpTo(position, Math.max(from, rowsAtOnce), rowsAtOnce, list.length);
  for (const i of list.slice(from, to)) {
    const row = pairRow(view, i);
    view.rowOf.set(i, row);
    view.bodies[part].append(row);
  }
  view.shown[part] = Math.min(to, list.length);
  showFold(view);
}

function pairRow(view, i) {
  const [number, ...cells] = pairCells(view.data, i),
    text = [true, true, false, false, false, true];
  const choose = () => view.selection.set({ pair: view.selection.chosen().pair === i ? null : i });
  const button = element("button", { type: "button", class: "row", "aria-pressed": "false" }, number);
  const won = view.data.stages.winner?.pair === i;
  const row = element(
    "tr",
    { class: won ? "optimal" : null, "data-pair": i, onclick: choose },
    element("th", { scope: "row" }, button),
    ...cells.map((cell, k) => element("td", { class: text[k] ? "text" : null }, cell)),
  );
  if (won) row.cells[4].append(element("span", { class: "won-mark" }, " the depth"));
  return row;
}

function toggleFold(view) {
  view.open = !view.open;
  if (view.open && view.shown.single === 0) growRows(view, "single", -1);
  showFold(view);
}

function showFold(view) {
  view.bodies.single.hidden = !view.open;
  view.opener.setAttribute("aria-expanded", String(view.open));
  for (const part of ["large", "single"]) {
    const left = view.rows[part].length - view.shown[part];
    view.more[part].hidden = left === 0 || (part === "single" && !view.open);
    view.more[part].textContent =
      `${Math.min(left, rowsAtOnce)} more of ${left} ${part === "large" ? "larger pairs" : "pairs of 1 \u00d7 1"}`;
  }
}

// ---- what changes ----

function showPair(view, state, changed) {
  if (!changed.has("pair")) return;
  const { pair } = state;
  view.current?.classList.remove("lit");
  view.current?.querySelector("button").setAttribute("aria-pressed", "false");
  view.current = pair === null ? null : rowOfPair(view, pair);
  view.current?.classList.add("lit");
  view.current?.querySelector("button").setAttribute("aria-pressed", "true");
  if (view.current) scrollWithin(view.box, view.current);
  view.details.replaceChildren(...pairDetails(view, pair));
  // A choice goes to the pair's hemisphere; a link that names both keeps what it says.
  if (pair !== null && !changed.has("hemisphere")) goToHemisphere(view, pair);
}

function goToHemisphere({ data, selection }, pair) {
  const { hemisphere } = selection.get(),
    wanted = data.charts[data.pairs[pair].chart].hemisphere;
  if (hemisphere !== "both" && hemisphere !== wanted) selection.set({ hemisphere: wanted });
}

function rowOfPair(view, pair) {
  const part = pairSize(view.data.pairs[pair]) > 1 ? "large" : "single";
  if (part === "single" && !view.open) toggleFold(view);
  growRows(view, part, view.rows[part].indexOf(pair));
  return view.rowOf.get(pair);
}

/** Scrolls the box, never the page, so that the row is seen below the heading. */
function scrollWithin(box, row) {
  const head = box.querySelector("thead").offsetHeight,
    top = row.offsetTop - head,
    bottom = row.offsetTop + row.offsetHeight;
  if (top < box.scrollTop) box.scrollTop = top;
  else if (bottom > box.scrollTop + box.clientHeight) box.scrollTop = bottom - box.clientHeight;
}

function pairDetails({ data, selection }, pair) {
  if (pair === null) return [element("p", { class: "soft" }, "No pair is chosen: choose a row, or click an arc of the chart.")];
  const exact = data.pairs[pair].closest?.distance_squared,
    closest = closestSentence(data, pair);
  const clear = element("button", { type: "button", onclick: () => selection.set({ pair: null }) }, "choose none");
  return [
    element("p", {}, pairSentence(data, pair), closest ? ` ${closest}` : "", " ", clear),
    exact ? element("details", {}, element("summary", {}, "exact"), element("p", {}, "distance\u00b2 = ", element("code", {}, exact))) : "",
  ];
}
