// SPDX-License-Identifier: GPL-3.0-or-later
// Beside section 1, of unions: the facts of the answer, and what touches, follow the optimum that is chosen.
import { caseTools, optimumStepper, idsText } from "./facts.js";
import { element } from "./look.js";
import { decimalsOf, vectorText } from "./numbers.js";

const mostContacts = 50;

export function mountUnionFacts(root, data, selection) {
  document.getElementById("tools")?.replaceChildren(...caseTools(data));
  if (data.optima.length > 1) root.prepend(optimumStepper(data, selection));
  const written = [], contacts = contactsTable();
  document.getElementById("contacts")?.replaceChildren(contacts.box);
  selection.subscribe((state, changed) => {
    if (changed.has("optimum")) contacts.show(contactsOfDepth(data.depth, state.optimum));
    if (changed.has("optimum") && data.optima.length > 1) showWay(root, data, state.optimum, written);
    if (changed.has("optimum") || changed.has("pair")) announcePieces(data, selection.chosen());
  });
}

/** Writes an optimum where the first one stands, whose text comes back with it. */
function showWay(root, data, index, written) {
  for (const [place, nodes] of written.splice(0)) place.replaceChildren(...nodes);
  for (const row of document.querySelectorAll("#what [data-optimum]")) row.classList.toggle("chosen", Number(row.dataset.optimum) === index);
  for (const part of root.querySelectorAll("[data-patch]")) part.hidden = Number(part.dataset.patch) !== index;
  const optimum = data.depth.optima[index];
  if (index === 0 || !optimum) return;
  const write = (place, ...nodes) => {
    if (!place) return;
    written.push([place, [...place.childNodes]]);
    place.replaceChildren(...nodes);
  };
  const place = root.querySelector('[data-field="translation"]');
  write(place, vectorText(decimalsOf(optimum.translation)));
  write(place?.parentElement.querySelector("pre"), `(${optimum.translation.join(", ")})`);
  write(root.querySelector('[data-field="clearance"]'), optimum.clearance ? "yes" : "none: an exact fit");
}

/** What touches once A has moved by an optimum, or to the contact: [{pieces, contact}]. */
function contactsOfDepth({ apart, optima }, index) {
  return apart ? [apart] : (optima[index]?.contacts ?? []);
}

function contactsTable() {
  const name = "What touches once A has moved", body = element("tbody"), rest = element("p", { class: "soft" });
  const head = (text, kind = null) => element("th", { scope: "col", class: kind }, text);
  const heads = element("tr", {}, head("piece of A"), head("piece of B"), head("contact", "text"), head("A\u2019s points", "text"), head("B\u2019s points", "text"));
  const table = element("table", {}, element("caption", {}, name), element("thead", {}, heads), body);
  return {
    box: element("div", {}, element("div", { class: "wide", role: "region", tabindex: 0, "aria-label": name }, table), rest),
    show(contacts) {
      body.replaceChildren(...contacts.slice(0, mostContacts).map(contactRow));
      rest.textContent = contacts.length > mostContacts ? `${contacts.length - mostContacts} pairs more are not listed here.` : "";
    },
  };
}

function contactRow({ pieces, contact }, index) {
  const cell = (text, name = null) => element("td", { class: name }, text);
  return element("tr", { "data-contact": index }, element("th", { scope: "row" }, String(pieces[0])), cell(String(pieces[1])), cell(contact.kind, "text"),
    cell(idsText(contact.a), "text"), cell(idsText(contact.b), "text"));
}

function announcePieces(data, { pair, optimum }) {
  const place = document.getElementById("selection"), parts = [];
  if (pair !== null) parts.push(`Piece ${data.pairs[pair].pieces[0]} of A and piece ${data.pairs[pair].pieces[1]} of B.`);
  if (optimum > 0) parts.push(`Optimum ${optimum + 1} of ${data.optima.length}.`);
  if (place && place.textContent !== parts.join(" ")) place.textContent = parts.join(" ");
}
