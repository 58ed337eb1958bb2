// SPDX-License-Identifier: GPL-3.0-or-later
// Section 3, the cutting: the grid of a canonical pair, rows by columns, and what became of its blocks level by level. Fates differ in
// pattern as well as in colour.
import { blockFates, blocksAt, crossingsByFate, fateSentences, gridCells, levelSentence } from "./cuttinggrid.js";
import { element, svg } from "./look.js";

const mostGridLines = 80;

export function mountCutting(root, data, selection) {
  const { cutting } = data;
  if (!cutting) {
    if (data.pairs.length > 0) root.replaceChildren(element("h3", {}, "Cutting"), element("p", { class: "note" }, nothingCut(data)));
    return {};
  }
  const view = { data, selection, cutting, pair: data.pairs[cutting.pair], level: cutting.levels.length - 1 };
  const slider = element("input", {
    type: "range",
    min: 0,
    max: cutting.levels.length - 1,
    step: 1,
    value: view.level,
    id: "cutting-level",
  });
  slider.addEventListener("input", () => goToLevel(view, Number(slider.value)));
  const step = (by, text, label) =>
    element("button", { type: "button", "aria-label": label, onclick: () => goToLevel(view, view.level + by) }, text);
  Object.assign(view, {
    slider,
    grid: element("div", { class: "cutting-grid" }),
    said: element("p", { class: "cutting-said", "aria-live": "polite" }),
    key: element("div", { class: "cutting-key" }),
    about: element("p"),
  });
  const bar = element(
    "div",
    { class: "bar" },
    element("label", { for: "cutting-level" }, "level"),
    step(-1, "\u2212", "one level back"),
    slider,
    step(1, "+", "one level on"),
  );
  root.replaceChildren(
    element("h3", {}, "Cutting"),
    view.about,
    ...(cutting.levels.length > 1 ? [bar] : []),
    view.said,
    element("div", { class: "cutting-both" }, view.grid, view.key),
  );
  goToLevel(view, view.level);
  selection.subscribe((state, changed) => changed.has("pair") && sayWhichPair(view, state));
  return {};
}

function nothingCut({ pairs }) {
  if (pairs.every((pair) => pair.a.length * pair.b.length === 1)) return "No pair has more than one crossing: there is nothing to cut.";
  const most = Math.max(...pairs.map((pair) => pair.a.length * pair.b.length));
  return `The largest grid has ${most} crossings: it was not cut.`;
}

function goToLevel(view, level) {
  view.level = Math.min(view.cutting.levels.length - 1, Math.max(0, level));
  view.slider.value = view.level;
  const blocks = blocksAt(view.cutting, view.level);
  view.grid.replaceChildren(gridPicture(view, blocks));
  view.said.textContent = levelSentence(view.cutting, view.level);
  view.key.replaceChildren(gridKey(blocks));
}

function sayWhichPair(view, { pair }) {
  const { data, cutting } = view,
    mine = cutting.pair,
    of = cutting.of === "winner" ? "the pair with the optimum" : "the largest pair";
  const choose = element("button", { type: "button", onclick: () => view.selection.set({ pair: mine }) }, `choose pair ${mine}`);
  const sizes = `${view.pair.a.length} rows are edges of A, ${view.pair.b.length} columns edges of B`;
  const what = `The grid of canonical pair ${mine}, ${of}: ${sizes}. `;
  const searched = cutting.as_searched
    ? ""
    : "The search does not cut a grid this small, or not so finely: it is cut here for the picture. ";
  const other =
    pair !== null && pair !== mine ? `Pair ${pair} is chosen, whose search was not recorded (${otherSearch(data.pairs[pair])}). ` : "";
  view.about.replaceChildren(other, what, searched, ...(pair === mine ? [] : [choose]));
}

function otherSearch({ engine, evaluated }) {
  return engine === null ? "there was none" : `${engine}, ${evaluated} evaluated`;
}

// ---- the picture ----

function gridPicture({ pair, level }, blocks) {
  const rows = pair.a.length,
    columns = pair.b.length,
    cell = gridCells(rows, columns),
    width = columns * cell.width,
    height = rows * cell.height;
  const place = (block) => ({
    x: block.columns[0] * cell.width,
    y: block.rows[0] * cell.height,
    width: (block.columns[1] - block.columns[0]) * cell.width,
    height: (block.rows[1] - block.rows[0]) * cell.height,
  });
  const shapes = blocks.map((block) =>
    svg(
      "rect",
      { class: `block ${block.fate}${block.level === level ? " last" : ""}`, ...place(block) },
      svg("title", {}, blockTitle(block)),
    ),
  );
  const lines = [];
  if (rows <= mostGridLines) for (let i = 1; i < rows; ++i) lines.push(`M0 ${i * cell.height}h${width}`);
  if (columns <= mostGridLines) for (let i = 1; i < columns; ++i) lines.push(`M${i * cell.width} 0v${height}`);
  const won = blocks.find((block) => block.fate === "won"),
    marks = won ? [wonMark(place(won))] : [];
  return svg(
    "svg",
    {
      viewBox: `-30 -24 ${width + 36} ${height + 30}`,
      width: width + 36,
      height: height + 30,
      role: "img",
      "aria-label": `Grid of ${rows} rows and ${columns} columns with ${blocks.length} blocks`,
    },
    gridPatterns(),
    ...shapes,
    svg("path", { class: "cells", d: lines.join("") }),
    svg("rect", { class: "outline", x: 0, y: 0, width, height }),
    ...marks,
    svg("text", { x: width / 2, y: -8, "text-anchor": "middle" }, "edges of B"),
    svg("text", { transform: `translate(-12 ${height / 2}) rotate(-90)`, "text-anchor": "middle" }, "edges of A"),
  );
}

function blockTitle({ rows, columns, fate, level }) {
  const run = ([first, last], word) => (last - first === 1 ? `${word} ${first + 1}` : `${word}s ${first + 1} to ${last}`);
  return `${run(rows, "row")}, ${run(columns, "column")}: ${fate}, at level ${level}`;
}

function wonMark({ x, y, width, height }) {
  return svg("path", { class: "won-ring", d: `M${x + width / 2} ${y + height / 2}m-5 0a5 5 0 1 0 10 0a5 5 0 1 0 -10 0` });
}

/** Cleared: sparse dots. Refined: one hatch. Scanned: crossed hatch. Won: filled. */
function gridPatterns() {
  const pattern = (fate, size, d, extra = {}) =>
    svg(
      "pattern",
      { id: `fate-${fate}`, width: size, height: size, patternUnits: "userSpaceOnUse", ...extra },
      svg("rect", { class: `ground ${fate}`, width: size, height: size }),
      svg("path", { class: `hatch ${fate}`, d }),
    );
  return svg(
    "defs",
    {},
    pattern("cleared", 8, "M3 4h1.6"),
    pattern("refined", 7, "M0 3.5h7", { patternTransform: "rotate(45)" }),
    pattern("scanned", 6, "M0 3h6M3 0v6"),
  );
}

function gridKey(blocks) {
  const counts = crossingsByFate(blocks);
  const swatch = (fate) =>
    svg(
      "svg",
      { width: 26, height: 18, viewBox: "0 0 26 18", "aria-hidden": "true" },
      svg("rect", { class: `block ${fate}`, x: 0.5, y: 0.5, width: 25, height: 17 }),
    );
  const row = (fate) =>
    element(
      "tr",
      {},
      element("th", { scope: "row", class: "text" }, swatch(fate), ` ${fate}`),
      element("td", {}, String(counts[fate].blocks)),
      element("td", {}, String(counts[fate].crossings)),
      element("td", { class: "text prose" }, fateSentences[fate]),
    );
  const heading = (text) => element("th", { scope: "col" }, text);
  return element(
    "table",
    {},
    element("caption", {}, "Blocks up to this level"),
    element("thead", {}, element("tr", {}, element("td"), heading("blocks"), heading("crossings"), element("td"))),
    element("tbody", {}, ...blockFates.map(row)),
  );
}
