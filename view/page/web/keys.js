// SPDX-License-Identifier: GPL-3.0-or-later
// Keys: j and k step through the canonical pairs, 1 to 5 go to the sections, left and right step through the optima, Esc chooses nothing.
import { sectionIds } from "./selection.js";

/** What a key changes of a selection; null if nothing. Without a pair, j begins with the first and k with the last one of data.order. */
export function changeOfKey(key, data, state) {
  const step = (order, now, by) => order[now < 0 ? (by > 0 ? 0 : order.length - 1) : Math.min(order.length - 1, Math.max(0, now + by))];
  switch (key) {
    case "j": return data.order.length ? { pair: step(data.order, data.order.indexOf(state.pair), 1) } : null;
    case "k": return data.order.length ? { pair: step(data.order, data.order.indexOf(state.pair), -1) } : null;
    case "ArrowRight": return stepOptimum(data, state, 1);
    case "ArrowLeft": return stepOptimum(data, state, -1);
    case "Escape": return { pair: null, facet: null, coincidence: null, step: 0 };
    default: return /^[1-5]$/.test(key) ? { section: Number(key) } : null;
  }
}

/** The next optimum, round and round; the facet that was looked at gives way to it. */
export function stepOptimum(data, state, by) {
  const count = data.optima.length;
  return count > 1 ? { optimum: (state.optimum + by + count) % count, facet: null } : null;
}

/** Where keys have another meaning: in fields, sliders and lists of choices. */
function takesKeys(target) {
  return target instanceof Element && target.closest("input, select, textarea, [contenteditable]") !== null;
}

export function listenToKeys(page, data, selection) {
  page.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey || event.shiftKey) return;
    if (takesKeys(event.target) && event.key !== "Escape") return;
    // A region that scrolls sideways keeps its arrows.
    if (event.key.startsWith("Arrow") && event.target instanceof Element && event.target.closest(".wide")) return;
    const change = changeOfKey(event.key, data, selection.chosen());
    if (!change) return;
    event.preventDefault();
    selection.set(change);
  });
  selection.subscribe((state, changed) => {
    if (changed.has("section") && state.section !== null) goToSection(page, state.section);
  });
  // The page's links name sections; the address keeps the rest of the selection.
  for (const link of page.querySelectorAll("nav a[href^='#']"))
    link.addEventListener("click", (event) => {
      const index = sectionIds.indexOf(link.getAttribute("href").slice(1));
      if (index < 0) return;
      event.preventDefault();
      if (selection.chosen().section === index + 1) goToSection(page, index + 1);
      selection.set({ section: index + 1 });
    });
}

function goToSection(page, section) {
  const place = page.getElementById(sectionIds[section - 1]);
  place?.scrollIntoView({ block: "start" });
  place?.focus({ preventScroll: true });
}
