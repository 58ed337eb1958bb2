// SPDX-License-Identifier: GPL-3.0-or-later
// Beside section 1: the facts of the answer, which stand in the page already, follow the optimum that is chosen; the case to take along.
import { contactText, wayOf } from "./contact.js";
import { stepOptimum } from "./keys.js";
import { element } from "./look.js";
import { decimalsOf, nearestRoot, gapOfRoots, roughly, textOf, unitOf, vectorText } from "./numbers.js";

export function mountFacts(root, data, selection) {
  document.getElementById("tools")?.replaceChildren(...caseTools(data));
  if (data.optima.length > 1) root.prepend(optimumStepper(data, selection));
  const told = element("p", { class: "way" }), written = [];
  root.append(told);
  selection.subscribe((state, changed) => {
    if (changed.has("optimum")) showOptimum(root, data, state.optimum, written);
    if (changed.has("facet")) told.replaceChildren(wayText(data, state));
    if (["optimum", "facet", "pair", "coincidence"].some((f) => changed.has(f))) announce(data, selection.chosen());
  });
}

/** "optimum 2 of 6" between two buttons. */
export function optimumStepper(data, selection) {
  const step = (by) => () => selection.set(stepOptimum(data, selection.chosen(), by));
  const count = data.depth.optima_count ?? data.optima.length;
  const where = element("span", { class: "where" });
  selection.subscribe((state) => {
    const more = count > data.optima.length ? `, ${data.optima.length} of them here` : "";
    where.textContent = `optimum ${state.optimum + 1} of ${count}${more}`;
  });
  return element("div", { class: "stepper", role: "group", "aria-label": "Optima: directions that attain the depth" },
    element("button", { type: "button", "aria-label": "previous optimum", onclick: step(-1) }, "\u2039"), where,
    element("button", { type: "button", "aria-label": "next optimum", onclick: step(1) }, "\u203a"));
}

/** Writes the direction, translation and contact of an optimum where those of the first one stand; the witness is of the first alone. */
function showOptimum(root, data, index, written) {
  for (const [place, nodes] of written.splice(0)) place.replaceChildren(...nodes);  // what stands there is of the first
  const optimum = data.depth.optima?.[index], first = index === 0;
  const write = (place, ...nodes) => {
    if (!place) return;
    written.push([place, [...place.childNodes]]);
    place.replaceChildren(...nodes);
  };
  const field = (name) => root.querySelector(`[data-field="${name}"]`);
  const exactText = (vector) => (Array.isArray(vector) ? `(${vector.join(", ")})` : JSON.stringify(vector));
  if (!first && optimum) {
    for (const [name, decimals, exact] of [["unit", unitOf, optimum.direction], ["translation", decimalsOf, optimum.translation]]) {
      write(field(name), vectorText(decimals(exact)));
      write(field(name)?.parentElement.querySelector("pre"), exactText(exact));
    }
    const contact = optimum.contact;
    if (contact)
      write(field("contact"), `${contact.kind}: `, element("span", { class: "key-a" }, "A"), ` at ${idsText(contact.a)}, `,
        element("span", { class: "key-b" }, "B"), ` at ${idsText(contact.b)}`);
  }
  for (const name of ["witness_a", "witness_b"]) {
    const row = field(name)?.closest("dd");
    if (row) row.hidden = row.previousElementSibling.hidden = !first;
  }
  for (const part of root.querySelectorAll("[data-patch]")) part.hidden = Number(part.dataset.patch) !== index;
  for (const row of root.querySelectorAll("[data-optimum]")) row.classList.toggle("chosen", Number(row.dataset.optimum) === index);
}

export const idsText = (ids) => (ids.length > 40 ? `${ids.slice(0, 40).join(", ")}, ...` : ids.join(", "));

/** A chosen facet of P in a sentence: how long that way out is. */
export function wayText(data, state) {
  const facet = state.facet === null ? null : data.facets[state.facet];
  if (!facet) return "";
  const contact = contactText(wayOf(data, state), data), least = data.facets[0].distance_squared, own = facet.distance_squared;
  if (!own) return `Facet ${state.facet + 1} of ${data.facets.length}, ${roughly(facet.distance, 5)} from O.`;
  const gap = gapOfRoots(own, least), longer = gap > 0 ? `, ${roughly(gap)} longer than the shortest` : ", as short as any";
  return `Way out through facet ${state.facet + 1} of P: ${textOf(nearestRoot(own))}${longer}.${contact ? ` ${contact}.` : ""}`;
}

/** What is chosen, for those who listen. */
function announce(data, state) {
  const place = document.getElementById("selection");
  if (!place) return;
  const pair = state.pair === null ? null : data.pairs[state.pair];
  const item = state.coincidence === null ? null : data.coincidence(state.coincidence);
  const parts = [];
  const count = state.pair === null ? 0 : data.facetsOfPair(state.pair).length;
  const ofP = `${count} ${count === 1 ? "facet" : "facets"} of P`;
  if (pair) parts.push(`Canonical pair ${state.pair}: ${pair.a.length} x ${pair.b.length} arcs; ${ofP}.`);
  if (state.facet !== null) parts.push(wayText(data, state));
  if (item) parts.push(`Coincidence: ${item.kind.replaceAll("_", " ")}.`);
  if (!parts.length && state.optimum > 0)
    parts.push(`Optimum ${state.optimum + 1} of ${data.optima.length}. ${contactText(data.optima[state.optimum], data)}`);
  const text = parts.join(" ");
  if (place.textContent !== text) place.textContent = text;
}

/** Buttons that copy the case and save it. */
export function caseTools(data) {
  if (!data.caseText.trim()) return [];
  const said = element("span", { role: "status", class: "soft" });
  const say = (text) => { said.textContent = text; };
  const done = "The case is on the clipboard: fathom depth - reads it.", closed = "The clipboard is closed to this page: save the case.";
  const copy = async () => say((await copied(data.caseText)) ? done : closed);
  return [
    element("button", { type: "button", onclick: copy }, "Copy this case"),
    element("button", { type: "button", onclick: () => saveText(`${fileStem(data.depth.id)}.case.json`, data.caseText) }, "Save this case"),
    said,
  ];
}

const fileStem = (id) => (id ?? "case").replace(/[^A-Za-z0-9._-]+/g, "-").replace(/^[-.]+|-+$/g, "").slice(0, 80) || "case";

async function copied(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = element("textarea", { "aria-hidden": "true" });
    area.value = text;
    document.body.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    return done;
  }
}

function saveText(name, text) {
  const url = URL.createObjectURL(new Blob([text.endsWith("\n") ? text : `${text}\n`], { type: "application/json" }));
  const link = element("a", { href: url, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}
