// SPDX-License-Identifier: GPL-3.0-or-later
// How the depth changes as A moves: one chart at a time of those that stand in the page, and a slider that puts A where a mark is.
import { cross, dot, plus, times } from "./geometry.js";
import { element, svg } from "./look.js";
import { integersOf, nearest, textOf } from "./numbers.js";
import { placesOf } from "./places.js";

/**
 * Where a place of the pictures is carried by a path after its step k, as fathom has it: turned by the quaternion (1, s w / 2), and then moved
 * by s v; or `back` from there. Where O goes is found exactly: of bodies far from O it is a small difference of large numbers.
 */
function rigid(along, turn, back, steps, k, stages) {
  const { center, length } = placesOf(stages), [v, ofV] = integersOf(along), [w, ofW] = integersOf(turn), [c, ofC] = integersOf(center);
  const s = BigInt(back ? -k : k), n = BigInt(steps), h = times(w, s), one = 2n * n * ofW, square = one * one + dot(h, h);  // (one, h)
  const turned = (u) => plus(times(cross(h, u), 2n * one), times(cross(h, cross(h, u)), 2n));  // less u, over square
  const way = back ? plus(times(v, square), turned(v)) : times(v, square);
  const offset = turned(c).map((t, i) => length(`${t * ofV * n + s * way[i] * ofC}/${square * ofC * ofV * n}`));
  const half = h.map((x) => nearest(`${x}/${one}`)), factor = 2 / (1 + dot(half, half));
  return (p) => plus(plus(p, times(plus(cross(half, p), cross(half, cross(half, p))), factor)), offset);
}

/** Where a place of A is after step k of a path; if B moves too, as it is seen from B. */
export function carrier({ along, turn = ["0", "0", "0"], along_b: alongB, turn_b: turnB, steps }, k, stages) {
  const there = rigid(along, turn, false, steps, k, stages);
  if (!alongB) return there;
  const back = rigid(alongB, turnB, true, steps, k, stages);
  return (p) => back(there(p));
}

/** What carries A as chosen; null where it stands. */
export function carrierOf(data, { motion, step }) {
  const chosen = data.motions[motion];
  return chosen && step > 0 ? carrier(chosen.path, Math.min(step, chosen.path.steps), data.stages) : null;
}

/** "s = 3/20: penetrating, signed depth 0.25". */
export function stepText({ path }, step) {
  const { s, status, value, signed_depth: { exact, low, high } } = path.values[step];
  return `s = ${s}: ${status}, signed depth ${exact ? textOf(value) : `from ${textOf(low)} to ${textOf(high)}`}`;
}

export function mountMotions(root, data, selection) {
  if (data.motions.length === 0) return {};
  const charts = [...root.children], cursors = charts.map(cursorOf), told = element("p", { class: "step" });
  const range = element("input", { type: "range", min: 0, step: 1 });
  range.addEventListener("input", () => selection.set({ step: Number(range.value), moved: 0 }));
  const choose = (motion) => () => selection.set({ motion, step: 0 });
  const buttons = data.motions.map(({ name }, i) => element("button", { type: "button", onclick: choose(i) }, name));
  const choice = buttons.length > 1 ? element("div", { class: "choice", role: "group", "aria-label": "Motions of A" }, ...buttons) : null;
  root.prepend(element("div", { class: "controls" }, choice, element("label", { class: "slider" }, data.motions[0].path.along_b ? "A seen from B" : "A on its motion", range)), told);
  selection.subscribe((state, changed) => {
    if (!changed.has("motion") && !changed.has("step")) return;
    const motion = data.motions[state.motion], step = Math.min(state.step, motion.path.steps);
    range.max = String(motion.path.steps);
    range.value = String(step);
    range.setAttribute("aria-valuetext", stepText(motion, step));
    told.textContent = stepText(motion, step);
    buttons.forEach((button, i) => button.setAttribute("aria-pressed", String(i === state.motion)));
    charts.forEach((chart, i) => { chart.hidden = i !== state.motion; });
    cursors[state.motion](step);
  });
  return {};
}

/** Puts a ring around the mark of a step; its place is that of the curve's corner. */
function cursorOf(chart) {
  const curve = chart.querySelector("path.look-0"), ring = svg("circle", { class: "cursor", r: 8 });
  const corners = [...(curve?.getAttribute("d") ?? "").matchAll(/[ML]([-\d.]+) ([-\d.]+)/g)];
  curve?.parentNode.append(ring);
  return (step) => {
    const corner = corners[step];
    ring.toggleAttribute("hidden", !corner);
    if (!corner) return;
    ring.setAttribute("cx", corner[1]);
    ring.setAttribute("cy", corner[2]);
  };
}
