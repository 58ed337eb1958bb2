// SPDX-License-Identifier: GPL-3.0-or-later
// Section 5: the count of each stage beside the paper's bound, and its time.
import { costRows, timeText } from "./costrows.js";
import { columnHeading, element, toldTable } from "./look.js";
import { roughly } from "./numbers.js";

export function mountCost(root, data) {
  const rows = costRows(data.stages);
  if (rows.length > 0) root.replaceChildren(boundsTable(rows));
  return {};
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
    columnHeading("stage", "text"),
    columnHeading("what is counted", "text"),
    columnHeading("count"),
    columnHeading("the paper\u2019s bound", "text"),
    columnHeading("its value"),
    columnHeading("count / bound"),
    columnHeading("source", "text"),
    timed ? columnHeading("time") : null,
  );
  const sentence =
    "The paper\u2019s bounds hold up to a constant factor, which it does not give: the ratio is that factor for these bodies. " +
    "m and n are the sizes of A and B.";
  return toldTable("Counts and bounds", sentence, element("thead", {}, head), element("tbody", {}, ...rows.map(row)));
}
