// SPDX-License-Identifier: GPL-3.0-or-later
// Beside section 2, of unions: the table of differences of pieces. A row, pointed at or chosen, lights its pieces and its differences.
import { element } from "./look.js";
import { nearestRoot, textOf } from "./numbers.js";

const mostSums = 200;

export function mountUnionSums(root, data, selection) {
  if (data.pairs.length === 0) return {};
  const rows = data.pairs.slice(0, mostSums).map((pair, i) => sumRow(data, i, selection));
  const name = "Differences of pieces that reach into the ball", left = data.pairs.length - rows.length;
  const heads = [["piece of A"], ["piece of B"], ["O is", "text"], ["distance"], ["touch", "text"]];
  const head = element("tr", {}, ...heads.map(([text, kind]) => element("th", { scope: "col", class: kind ?? null }, text)));
  const table = element("table", {}, element("caption", {}, name), element("thead", {}, head), element("tbody", {}, ...rows));
  root.replaceChildren(
    element("p", { class: "soft" }, "Point at a row: its two pieces are lit in section 1, their differences in the picture. j and k step."),
    element("div", { class: "wide", role: "region", tabindex: 0, "aria-label": name }, table),
    left > 0 ? element("p", { class: "soft" }, `${left} pairs more are not listed here.`) : "");
  selection.subscribe((state) => {
    const { pair } = selection.chosen();
    rows.forEach((row, i) => {
      row.classList.toggle("chosen", i === state.pair);
      row.querySelector("button").setAttribute("aria-pressed", String(i === pair));
    });
  });
  return {};
}

/** The cells of a pair of pieces, as text: where O lies, how far from the boundary, and after which ways the pieces touch. */
export function sumCells({ inside, distance_squared: squared, touches }, ways) {
  const where = inside ? "inside" : squared === "0" ? "on it" : "outside";
  const touch = touches.length === 0 ? "no" : ways === 1 ? "yes" : touches.map((k) => `after way ${k + 1}`).join(", ");
  return [where, textOf(nearestRoot(squared)), touch];
}

function sumRow(data, index, selection) {
  const { pieces, sum } = data.pairs[index], [where, distance, touch] = sumCells(sum, data.stages.ways.length);
  const choose = () => selection.set({ pair: selection.chosen().pair === index ? null : index });
  const title = "Show these two pieces";
  const button = element("button", { type: "button", class: "row", "aria-pressed": "false", title, onclick: choose }, String(pieces[0]));
  const row = element("tr", { class: sum.touches.length ? "optimal" : null, "data-pair": index }, element("th", { scope: "row" }, button),
    element("td", {}, String(pieces[1])), element("td", { class: "text" }, where), element("td", {}, distance),
    element("td", { class: "text" }, touch));
  row.addEventListener("click", (event) => { if (!event.target.closest("button")) choose(); });
  for (const event of ["mouseenter", "focusin"]) row.addEventListener(event, () => selection.preview({ pair: index }));
  for (const event of ["mouseleave", "focusout"]) row.addEventListener(event, () => selection.preview(null));
  return row;
}
