// SPDX-License-Identifier: GPL-3.0-or-later
// The colours of the page, as the style sheet says them: --a, --b, --true, --lit, ... differ in light, dark and on paper.
// A is one hue and solid, B another and hatched: colour never speaks alone.

/** The value of a custom property of the style sheet, such as colour("--a"). */
export function colour(name, element = document.documentElement) {
  return getComputedStyle(element).getPropertyValue(name).trim() || "#808080";
}

/** Calls f now and whenever the colours change: by the reader's scheme, before and after printing. */
export function onLook(f) {
  f();
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", f);
  window.matchMedia("print").addEventListener("change", f);
}

/** Whether the reader asked for less motion. */
export function calm() {
  return window.matchMedia("(prefers-reduced-motion: reduce)").matches;
}

/** An element with attributes and children: element("button", {type: "button", class: "small"}, "fit"). */
export function element(name, attributes = {}, ...children) {
  const result = document.createElement(name);
  fillElement(result, attributes, children);
  return result;
}

/** The same in SVG. */
export function svg(name, attributes = {}, ...children) {
  const result = document.createElementNS("http://www.w3.org/2000/svg", name);
  fillElement(result, attributes, children);
  return result;
}

/** A table in a box that scrolls if it is wider, under a sentence on what it says. */
export function toldTable(label, sentence, ...parts) {
  return element(
    "div",
    {},
    element("p", { class: "soft" }, sentence),
    element("div", { class: "wide", tabindex: 0, role: "region", "aria-label": label }, element("table", {}, ...parts)),
  );
}

export const columnHeading = (text, kind = "") => element("th", { scope: "col", class: kind }, text);

function fillElement(target, attributes, children) {
  for (const [key, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (key.startsWith("on")) target.addEventListener(key.slice(2), value);
    else target.setAttribute(key, value === true ? "" : String(value));
  }
  target.append(...children.filter((child) => child !== null && child !== undefined));
}
