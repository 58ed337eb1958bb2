// SPDX-License-Identifier: GPL-3.0-or-later
// Beside section 2: the facets of P by their distance from O, with the gap to the second. A row, pointed at or chosen, shows its contact.
import { element } from "./look.js";
import { gapOfRoots, nearestRoot, roughly, textOf } from "./numbers.js";

const firstRows = 12;

/** What meets where A moves out through a facet: A's feature first, as a contact's kind in `depth --json`. */
export function kindOfFacet(facet) {
  const word = (ids) => ["facet", "vertex", "edge"][ids.length] ?? "facet";
  return `${word(facet.a ?? [])}-${word(facet.b ?? [])}`;
}

/** How many facets tie for the least distance, and the first one beyond them: {ties, second, gap, share}. Distances are exact. */
export function gapOf(facets) {
  const least = facets[0]?.distance_squared;
  if (least === undefined) return null;
  const beyond = facets.findIndex((f) => f.distance_squared !== least);
  if (beyond < 0) return { ties: facets.length, second: null, gap: null, share: null };
  const second = facets[beyond].distance_squared;
  if (second === undefined) return null;
  const gap = gapOfRoots(second, least), own = nearestRoot(least);
  return { ties: beyond, second: nearestRoot(second), gap, share: own > 0 ? gap / own : null };
}

export function mountRanked(root, data, selection) {
  if (!data.facets.length || data.facets[0].distance_squared === undefined || data.stages.sum.kind === "sampled") return {};
  const exact = data.facets.findIndex((facet) => facet.distance_squared === undefined), most = exact < 0 ? data.facets.length : exact;
  let count = Math.min(firstRows, most);
  const body = element("tbody"), rest = element("p", { class: "soft" });
  const rows = [];
  function grow(to) {
    for (let i = rows.length; i < to; ++i) rows.push(facetRow(data, i, selection));
    body.replaceChildren(...rows.slice(0, to));
    rest.replaceChildren(...restOf(data.facets.length, most, to, () => grow(most)));
    count = to;
  }
  grow(count);
  const head = ["#", "distance", "gap", "contact"].map((name, i) => element("th", { scope: "col", class: i === 3 ? "text" : null }, name));
  const name = "Facets by their distance from O";
  const table = element("table", {}, element("caption", {}, name), element("thead", {}, element("tr", {}, ...head)), body);
  root.replaceChildren(gapSentence(data), element("div", { class: "wide", role: "region", tabindex: 0, "aria-label": name }, table), rest);
  selection.subscribe((state, changed) => {
    if (!changed.has("facet") && !changed.has("pair")) return;
    const chosen = selection.chosen().facet, ofPair = new Set(state.pair === null ? [] : data.facetsOfPair(state.pair));
    if (chosen !== null && chosen >= count && chosen < most) grow(chosen + 1);
    rows.forEach((row, i) => {
      row.classList.toggle("chosen", i === state.facet);
      row.classList.toggle("lit", ofPair.has(i));
      row.querySelector("button").setAttribute("aria-pressed", String(i === chosen));
    });
  });
  return {};
}

function gapSentence(data) {
  const told = gapOf(data.facets), result = element("p", { class: "gap" });
  if (data.status !== "penetrating" || !told) return result;
  const name = data.stages.sum.kind === "Q" ? "Q" : "P";
  const nearest = `Nearest: ${textOf(nearestRoot(data.facets[0].distance_squared))}${told.ties > 1 ? `, ${told.ties} facets tie` : ""}. `;
  if (told.second === null) result.append(nearest, `All facets of ${name} are equally near.`);
  else {
    const farther = element("strong", {}, `${roughly(told.gap)} farther`);
    result.append(`${nearest}Second: ${textOf(told.second)}, `, farther, told.share > 0 ? ` (${roughly(100 * told.share)} %).` : ".");
  }
  return result;
}

function facetRow(data, index, selection) {
  const facet = data.facets[index], own = facet.distance_squared, least = data.facets[0].distance_squared;
  const gap = gapOfRoots(own, least), isTie = own === least;
  const choose = () => selection.set({ facet: selection.chosen().facet === index ? null : index });
  const title = "Show the contact of this facet";
  const button = element("button", { type: "button", class: "row", "aria-pressed": "false", title, onclick: choose }, String(index + 1));
  const row = element("tr", { class: facet.optimal ? "optimal" : null, "data-facet": index }, element("th", { scope: "row" }, button),
    element("td", {}, textOf(nearestRoot(facet.distance_squared))),
    element("td", {}, isTie ? (index ? "tie" : "") : `+${roughly(gap)}`),
    element("td", { class: "text" }, kindOfFacet(facet)));
  const over = () => selection.preview({ facet: index }), out = () => selection.preview(null);
  for (const event of ["mouseenter", "focusin"]) row.addEventListener(event, over);
  for (const event of ["mouseleave", "focusout"]) row.addEventListener(event, out);
  row.addEventListener("click", (event) => { if (!event.target.closest("button")) choose(); });
  return row;
}

/** What is not listed: of `all` facets `most` have an exact distance and may be. */
function restOf(all, most, shown, more) {
  const left = all - shown;
  if (left <= 0) return [];
  if (shown >= most) return [`${left} facets more are farther, and left out of the list.`];
  const name = most < all ? `list ${most}` : "list all";
  return [`${left} facets more are farther. `, element("button", { type: "button", onclick: more }, name)];
}
