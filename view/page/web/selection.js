// SPDX-License-Identifier: GPL-3.0-or-later
// What the reader has chosen. There is one selection for the whole page: every section shows it, any section may change it, and it
// stands in the address after '#', so that a link shows what its sender saw.
//
//   optimum      number            an index into data.optima; 0 at first
//   pair         number or null    a canonical pair, an index into stages.pairs
//   facet        number or null    a facet of P, an index into stages.sum.facets
//   coincidence  string or null    "i.j": item j of what stages.coincidences[i] lists
//   hemisphere   "both", "upper", "lower"
//   plane        boolean           the charts in the paper's plane z = 1, not as longitude and latitude
//   moved        number in [0, 1]  how far A has moved out along the translation
//   motion       number            an index into data.motions
//   step         number            of that motion: where A stands on it; 0 where it is
//   section      number or null    1 to 5: the section that was gone to by key or link
//
//   selection.get()                the selection, frozen; what the pointer is over (see preview) in place of what is chosen
//   selection.chosen()             the same without the pointer
//   selection.set({pair: 3})       changes fields; a value that the data does not have is dropped; null chooses nothing
//   selection.clear()              no pair, no facet, no coincidence
//   selection.preview({facet: 3})  shows something until preview(null), without choosing it: for the pointer and the focus
//   selection.subscribe(f)         calls f(selection, changed) after each change, changed a Set of the names of fields that are shown or
//                                  chosen otherwise, and once now with all names; returns the function that ends it
//   selection.hash()               as it stands in the address, without '#': "optimum=1&pair=12"

const unselected = { optimum: 0, pair: null, facet: null, coincidence: null, hemisphere: "both", plane: false, moved: 0, motion: 0,
  step: 0, section: null };
const selectionFields = Object.keys(unselected);

/** The ids of the sections, in their order on the page. */
export const sectionIds = ["what", "why", "where", "coincided", "cost"];

/** Whether data has what this value of a field names. */
function isSelectable(data, field, value) {
  const isBelow = (count) => Number.isInteger(value) && value >= 0 && value < count;
  switch (field) {
    case "optimum": return isBelow(Math.max(1, data.optima.length));
    case "pair": return value === null || isBelow(data.pairs.length);
    case "facet": return value === null || isBelow(data.facets.length);
    case "coincidence": return value === null || (typeof value === "string" && data.coincidence(value) !== null);
    case "hemisphere": return value === "both" || value === "upper" || value === "lower";
    case "plane": return typeof value === "boolean";
    case "moved": return typeof value === "number" && value >= 0 && value <= 1;
    case "motion": return isBelow(Math.max(1, data.motions.length));
    case "step": return value === 0 || isBelow(1 + Math.max(0, ...data.motions.map(({ path }) => path.steps)));
    case "section": return value === null || (Number.isInteger(value) && value >= 1 && value <= sectionIds.length);
    default: return false;
  }
}

/** The text of a selection after '#': what differs from the first one, in the order of the fields above. */
export function hashOf(state) {
  const text = { plane: () => "z1", moved: () => Number(state.moved.toFixed(3)) };
  return selectionFields
    .filter((f) => state[f] !== unselected[f])
    .map((f) => `${f}=${text[f] ? text[f]() : encodeURIComponent(state[f])}`)
    .join("&");
}

/** The fields that such a text names. Text that means nothing is no error; the id of a section, as in the page's links, is one. */
export function stateOf(hash) {
  const state = {}, text = hash.replace(/^#/, "");
  if (sectionIds.includes(text)) return { section: sectionIds.indexOf(text) + 1 };
  for (const part of text.split("&")) {
    const [field, value] = part.split("=");
    if (!selectionFields.includes(field) || !value) continue;
    if (field === "plane") state.plane = value === "z1";
    else if (field === "hemisphere" || field === "coincidence") state[field] = value;
    else state[field] = Number(value);
  }
  return state;
}

/** The selection of a page. address is window in a browser; tests give an object with location.hash and history.replaceState. */
export function createSelection(data, address = null) {
  const valid = (changes) => Object.fromEntries(Object.entries(changes).filter(([f, v]) => isSelectable(data, f, v)));
  let chosen = Object.freeze({ ...unselected, ...valid(stateOf(address?.location.hash ?? "")) });
  let over = {};
  let shown = chosen, told = chosen;
  const listeners = new Set();

  function refresh() {
    const next = Object.freeze({ ...chosen, ...over });
    const changed = new Set(selectionFields.filter((f) => next[f] !== shown[f] || chosen[f] !== told[f]));
    shown = next;
    told = chosen;
    if (changed.size > 0) for (const listener of [...listeners]) listener(shown, changed);
  }

  function write() {
    const text = hashOf(chosen);
    if (!address || address.location.hash.replace(/^#/, "") === text) return;
    try {
      address.history.replaceState(null, "", text ? `#${text}` : address.location.pathname + address.location.search);
    } catch {
      // A page without an address of its own (srcdoc) has nowhere to write to.
    }
  }

  function set(changes) {
    chosen = Object.freeze({ ...chosen, ...valid(changes) });
    write();
    refresh();
  }

  address?.addEventListener?.("hashchange", () => {
    const named = stateOf(address.location.hash);
    set(address.location.hash.includes("=") ? { ...unselected, ...valid(named) } : named);
  });
  return {
    set,
    get: () => shown,
    chosen: () => chosen,
    clear: () => set({ pair: null, facet: null, coincidence: null }),
    preview(changes) {
      over = changes ? valid(changes) : {};
      refresh();
    },
    subscribe(listener) {
      listeners.add(listener);
      listener(shown, new Set(selectionFields));
      return () => listeners.delete(listener);
    },
    hash: () => hashOf(chosen),
  };
}
