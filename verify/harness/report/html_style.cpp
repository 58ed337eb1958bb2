// SPDX-License-Identifier: GPL-3.0-or-later
// The style sheet of the page.
#include "verify/harness/report/html_parts.hpp"

namespace fathom::harness {

// Of the colours for A, B, what is true and what is claimed, any two can be told apart by the colour-blind, and by dashes or letters too.
std::string_view page_style() {
  return R"(
:root { color-scheme: light dark; --ground: #ffffff; --ink: #1b1f24; --soft: #57606a; --line: #d0d7de; --shade: #f6f8fa;
  --a: #0550ae; --b: #8a4600; --true: #116329; --claimed: #a40e26; --link: #0550ae; }
@media (prefers-color-scheme: dark) { :root { --ground: #14181d; --ink: #e6edf3; --soft: #9da7b1; --line: #3d444d; --shade: #1d232a;
  --a: #79c0ff; --b: #f0b072; --true: #56d364; --claimed: #ff8f88; --link: #79c0ff; } }
body { margin: 0 auto; max-width: 84rem; padding: 1.5rem; background: var(--ground); color: var(--ink);
  font: 16px/1.5 system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif; }
h1 { font-size: 1.6rem; line-height: 1.25; margin: 0 0 .5rem; } h2 { font-size: 1.25rem; margin: 2.5rem 0 .75rem; }
h3 { font-size: 1.05rem; margin: 2rem 0 .5rem; } h4 { font-size: 1rem; margin: 0; }
h1, h3, h4, td.text, dd, p { overflow-wrap: anywhere; }
a { color: var(--link); } code, pre, .number, td { font-family: ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; font-size: .86rem; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .15rem 1rem; margin: .5rem 0; }
dt { color: var(--soft); } dd { margin: 0; min-width: 0; }
.wide { overflow-x: auto; } table { border-collapse: collapse; font-size: .9rem; } caption { text-align: left; color: var(--soft); padding: .25rem 0; }
th, td { padding: .2rem .45rem; border-bottom: 1px solid var(--line); text-align: right; vertical-align: top; font-variant-numeric: tabular-nums; }
td { white-space: nowrap; } td.text { white-space: normal; }
thead th { vertical-align: bottom; font-weight: 600; } tbody th { text-align: left; font-weight: 400; white-space: nowrap; }
tr.all th, tr.all td { font-weight: 700; } td.text, th.text { text-align: left; } tbody th.id { white-space: normal; overflow-wrap: anywhere; }
article { border: 1px solid var(--line); border-radius: 6px; padding: 1rem; margin: 0 0 1rem; }
article > p { margin: .25rem 0 .5rem; } .verdict { color: var(--claimed); font-weight: 600; } .soft { color: var(--soft); }
.warning { border-left: .3rem solid var(--claimed); padding-left: .7rem; } footer code { overflow-wrap: anywhere; }
figure { margin: .5rem 0; } figcaption { color: var(--soft); font-size: .9rem; }
.pairs { display: flex; flex-wrap: wrap; gap: .5rem; } svg { max-width: 100%; height: auto; }
svg.pair { background: var(--shade); border-radius: 4px; }
.facts dl { grid-template-columns: minmax(6rem, auto) minmax(11.5rem, 1fr); } .facts { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(24rem, 100%), 1fr)); gap: 0 2rem; }
pre { overflow: auto; max-height: 20rem; background: var(--shade); padding: .5rem; margin: .25rem 0; }
summary { cursor: pointer; }
svg path { fill: none; stroke-linejoin: round; stroke-linecap: round; } svg text { fill: var(--ink); font-size: 12px; }
.body-a { --own: var(--a); } .body-b { --own: var(--b); } .true { --own: var(--true); } .claimed { --own: var(--claimed); }
svg path.area { fill: var(--own); fill-opacity: .13; stroke: none; } svg path.wire { stroke: var(--own); stroke-width: 1.4; }
svg path.hidden { stroke: var(--own); stroke-width: .8; stroke-opacity: .45; } svg path.ghost { stroke: var(--a); stroke-width: 1; stroke-dasharray: 2 4; }
svg path.shaft { stroke: var(--own); stroke-width: 2.6; } svg path.claimed.shaft { stroke-dasharray: 7 4; stroke-linecap: butt; }
svg path.head, svg .dot { fill: var(--own); } svg text.letter { fill: var(--own); font-size: 17px; font-weight: 700; text-anchor: middle; }
.key { font-weight: 700; color: var(--own); } svg rect.bar { fill: var(--link); } svg rect.bar.failing { fill: var(--claimed); }
svg line { stroke: var(--line); } svg line.limit { stroke: var(--ink); stroke-dasharray: 3 3; }
svg text.soft { fill: var(--soft); font-size: 11px; }
@media print { :root { --ground: #fff; --ink: #000; --soft: #444; --line: #999; --shade: #fff; --a: #0550ae; --b: #8a4600; --true: #116329;
  --claimed: #a40e26; --link: #0550ae; } body { max-width: none; padding: 0; font-size: 11px; } article, figure, tr { break-inside: avoid; }
  h2, h3, h4 { break-after: avoid; } pre { max-height: none; } .wide { overflow: visible; } svg.pair { border: 1px solid var(--line); } }
)";
}

}  // namespace fathom::harness
