// SPDX-License-Identifier: GPL-3.0-or-later
// Beside section 2, of unions: the table of differences of pieces. A row, pointed at or chosen, lights its pieces and its differences.
import { element } from "./look.js";

export function mountUnionSums(root, data, selection) {
  const rows = new Map();
  for (const row of root.querySelectorAll("tr[data-pair]")) rows.set(Number(row.dataset.pair), row);
  if (rows.size === 0) return {};
  for (const [pair, row] of rows) {
    const choose = () => selection.set({ pair: selection.chosen().pair === pair ? null : pair });
    const head = row.querySelector("th");
    const button = element("button", { type: "button", class: "row", "aria-pressed": "false", title: "Show these two pieces", onclick: choose }, head.textContent);
    head.replaceChildren(button);
    row.addEventListener("click", (event) => { if (!event.target.closest("button")) choose(); });
    for (const event of ["mouseenter", "focusin"]) row.addEventListener(event, () => selection.preview({ pair }));
    for (const event of ["mouseleave", "focusout"]) row.addEventListener(event, () => selection.preview(null));
  }
  root.prepend(element("p", { class: "soft" }, "Point at a row: its two pieces are lit in section 1, their differences in the picture. j and k step."));
  selection.subscribe((state) => {
    const { pair } = selection.chosen();
    for (const [i, row] of rows) {
      row.classList.toggle("chosen", i === state.pair);
      row.querySelector("button").setAttribute("aria-pressed", String(i === pair));
    }
  });
  return {};
}
