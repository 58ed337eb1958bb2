// SPDX-License-Identifier: GPL-3.0-or-later
// Section 5: the count of each stage beside the paper's bound, and its time; the predicates that were zero, and what decided then.
import { costRows, timeText, zeroRows } from "./costrows.js";
import { element } from "./look.js";
import { roughly } from "./numbers.js";

const mostMonomials = 12;

export function mountCost(root, data) {
  const rows = costRows(data.stages),
    zeros = zeroRows(data.stages.decided);
  if (rows.length === 0 && zeros.length === 0) return {};
  root.replaceChildren(...(rows.length > 0 ? [boundsTable(rows)] : []), ...(data.charts.length > 0 ? [zerosTable(zeros)] : []));
  return {};
}

const costHeading = (text, kind = "") => element("th", { scope: "col", class: kind }, text);
/** A table in a box that scrolls if it is wider, under a sentence on what it says. */
function costTable(label, sentence, ...parts) {
  return element(
    "div",
    {},
    element("p", { class: "soft" }, sentence),
    element("div", { class: "wide", tabindex: 0, role: "region", "aria-label": label }, element("table", {}, ...parts)),
  );
}

function boundsTable(rows) {
  const timed = rows.some(({ seconds }) => seconds !== undefined);
  const cell = (text, kind = "") => element("td", { class: kind }, text ?? "\u2013");
  const row = ({ stage, what, count, bound, bound_value: value, source, seconds, ratio }) =>
    element(
      "tr",
      {},
      element("th", { scope: "row" }, stage),
      cell(what, "text prose"),
      cell(count === null ? null : String(count)),
      cell(bound, "text"),
      cell(value === null ? null : roughly(value)),
      cell(ratio === null ? null : String(ratio)),
      cell(source, "text prose"),
      timed ? cell(timeText(seconds)) : null,
    );
  const head = element(
    "tr",
    {},
    costHeading("stage", "text"),
    costHeading("what is counted", "text"),
    costHeading("count"),
    costHeading("the paper\u2019s bound", "text"),
    costHeading("its value"),
    costHeading("count / bound"),
    costHeading("source", "text"),
    timed ? costHeading("time") : null,
  );
  const sentence =
    "The paper\u2019s bounds hold up to a constant factor, which it does not give: the ratio is that factor for these bodies. " +
    "m and n are the sizes of A and B.";
  return costTable("Counts and bounds", sentence, element("thead", {}, head), element("tbody", {}, ...rows.map(row)));
}

function zerosTable(zeros) {
  if (zeros.length === 0) return element("p", {}, "No predicate was zero: the perturbation had nothing to decide.");
  const decided = (monomials) =>
    monomials
      .slice(0, mostMonomials)
      .map(({ name, count }) => `${name}: ${count}`)
      .join(", ") + (monomials.length > mostMonomials ? ", \u2026" : "");
  const rows = zeros.map(({ predicate, zero, monomials = [] }) =>
    element(
      "tr",
      {},
      element("th", { scope: "row" }, predicate.replaceAll("_", " ")),
      element("td", {}, String(zero)),
      element("td", { class: "text" }, decided(monomials)),
    ),
  );
  return costTable(
    "Predicates that were zero",
    "Predicates that were exactly zero, and the monomials that decided then.",
    element(
      "thead",
      {},
      element("tr", {}, costHeading("predicate", "text"), costHeading("zeros"), costHeading("decided by: how often", "text")),
    ),
    element("tbody", {}, ...rows),
  );
}
