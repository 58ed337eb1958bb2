// SPDX-License-Identifier: GPL-3.0-or-later
// Starts the page: reads the data, makes the selection, mounts each section, and lets none of them take the others down.
//
// A section module NAME.js exports mountNAME(root, data, selection), root its place in the page (see `sections`). Of these only #facts, #motion
// and the scene of the bodies hold anything before it is called: what is seen without scripts. It returns a handle, each member of which may
// be absent:
//   lit()        what is lit there, for tests: part of {sphere: [[colour, edge]..], chart: [..], bodies: [..], blocks: n}
//   drawCalls()  how many draw calls its last frame took
// The modules are joined into one scope, where imports are stripped: names at the top of a module differ from all others'.
import { readData } from "./data.js";
import { createSelection, sectionIds } from "./selection.js";
import { element } from "./look.js";
import { listenToKeys } from "./keys.js";
import { mountFacts } from "./facts.js";
import { mountWhat } from "./what.js";
import { mountMotions } from "./motions.js";
import { mountWhy } from "./why.js";
import { mountRanked } from "./ranked.js";
import { mountSphere } from "./sphere.js";
import { mountChart } from "./chart.js";
import { mountPairs } from "./pairs.js";
import { mountCutting } from "./cutting.js";
import { mountCoincided } from "./coincided.js";
import { mountCost } from "./cost.js";
import { mountUnionFacts } from "./unionfacts.js";
import { mountUnionWhy } from "./unionwhy.js";
import { mountUnionSums } from "./unionsums.js";

const sections = [
  ["#facts", () => mountFacts],
  ["#what .scene", () => mountWhat],
  ["#motion", () => mountMotions],
  ["#why .scene", () => mountWhy],
  ["#ranked", () => mountRanked],
  ["#where .sphere", () => mountSphere],
  ["#where .chart", () => mountChart],
  ["#pairs", () => mountPairs],
  ["#cutting", () => mountCutting],
  ["#coincided .body", () => mountCoincided],
  ["#cost .body", () => mountCost],
];

const unionSections = [
  ["#facts", () => mountUnionFacts],
  ["#what .scene", () => mountWhat],
  ["#why .scene", () => mountUnionWhy],
  ["#sums", () => mountUnionSums],
];

/** Mounts one section; a failure leaves what stood there, and says so under it. */
function mounted(place, mount, data, selection) {
  const root = document.querySelector(place);
  if (!root) return {};
  const before = [...root.childNodes];
  try {
    return mount()(root, data, selection) ?? {};
  } catch (error) {
    console.warn(`${place}: ${error.stack ?? error}`);
    root.replaceChildren(...before, element("p", { class: "note" }, `This part of the page could not start: ${error.message ?? error}`));
    return {};
  }
}

/** What tests and the curious may ask of the page, as window.fathom. */
function publicFace(data, selection, handles) {
  const all = (name) => handles.flatMap((handle) => (handle[name] ? [handle[name]()] : []));
  return {
    data,
    selection: () => selection.chosen(),
    select: selection.set,
    lit: () => Object.assign({ sphere: [], chart: [], bodies: [], blocks: 0 }, ...all("lit")),
    drawCalls: () => all("drawCalls").reduce((sum, n) => sum + n, 0),
    contact: () => Object.assign({}, ...all("contact")),
  };
}

function startPage() {
  for (const part of document.querySelectorAll("nav[hidden], main > section[hidden]")) part.hidden = false;
  const data = readData();
  const selection = createSelection(data, window);
  const handles = (data.isUnion ? unionSections : sections).map(([place, mount]) => mounted(place, mount, data, selection));
  listenToKeys(document, data, selection);
  window.fathom = publicFace(data, selection, handles);
  const opens = sectionIds.indexOf(document.body.dataset.opens);
  if (!location.hash && opens >= 0) selection.set({ section: opens + 1 });
  document.documentElement.dataset.ready = "yes";
}

startPage();
