// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "verify/digest/sha256.hpp"
#include "view/picture/markup.hpp"

namespace fathom::picture {

namespace {

unsigned hex_value(char c) { return static_cast<unsigned>(c <= '9' ? c - '0' : c - 'a' + 10); }

/// Returns the base64 form of bytes given as lower-case hexadecimal digits.
std::string base64(std::string_view hex) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  for (; !hex.empty(); hex.remove_prefix(std::min<std::size_t>(6, hex.size()))) {  // 3 bytes make 4 letters
    const std::size_t digits = std::min<std::size_t>(6, hex.size());
    unsigned bits = 0;
    for (std::size_t i = 0; i < 6; ++i) bits = bits << 4 | (i < digits ? hex_value(hex[i]) : 0U);
    for (std::size_t i = 0; i < 4; ++i) result += i <= digits / 2 ? letters[bits >> (18 - 6 * i) & 63U] : '=';
  }
  return result;
}

std::string sources(std::string_view what, std::span<const std::string_view> texts) {
  std::string result(what);
  if (texts.empty()) result += " 'none'";
  for (const std::string_view text : texts)
    result += fmt::format(" 'sha256-{}'", base64(digest::digest_of(text).sha256));
  return result;
}

}  // namespace

std::string security_policy(std::span<const std::string_view> scripts, std::span<const std::string_view> styles) {
  return fmt::format("default-src 'none'; {}; {}; img-src data:; base-uri 'none'; form-action 'none'",
                     sources("script-src", scripts), sources("style-src", styles));
}

std::string policy_element(std::span<const std::string_view> scripts, std::span<const std::string_view> styles) {
  return fmt::format("<meta http-equiv=\"Content-Security-Policy\" content=\"{}\"/>", security_policy(scripts, styles));
}

// The document around a page.

std::string page(const std::string& title, const std::string& body) {
  const std::string style = colour_style() + picture_style() + std::string(scroll_style()) + std::string(page_style());
  const std::array<std::string_view, 1> scripts{page_script()}, styles{style};
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>{}"
      "<meta name=\"viewport\" content=\"width=device-width, "
      "initial-scale=1\"/><title>{}</title><style>{}</style></head>\n<body>\n"
      "{}<script>{}</script></body></html>\n",
      policy_element(scripts, styles), title, style, body, page_script());
}

// The style of pages.

std::string_view page_style() {
  return R"(
body { margin: 0 auto; max-width: 84rem; padding: 1.25rem; background: var(--ground); color: var(--ink);
  font: 1rem/1.5 system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif; }
h1 { font-size: 1.5rem; line-height: 1.25; margin: 0 0 .35rem; } h2 { font-size: 1.25rem; margin: 2.25rem 0 .6rem; }
h3 { font-size: 1.05rem; margin: 1.5rem 0 .5rem; } h4 { font-size: 1rem; margin: 0; }
h1, h2, h3, h4, td.text, dd, p, li, summary { overflow-wrap: anywhere; } h3 a, h4 a { color: inherit; text-decoration: none; }
h3 a:hover, h4 a:hover { text-decoration: underline; }
a { color: var(--link); } code, pre, .number, td { font-family: ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; font-size: .86rem; }
dl { display: grid; grid-template-columns: max-content minmax(0, 1fr); gap: .15rem 1rem; margin: .5rem 0; }
dt { color: var(--soft); } dd { margin: 0; min-width: 0; } .answer { font-size: 1.05rem; font-weight: 600; margin: .25rem 0; }
.soft { color: var(--soft); } .warning { border-left: .3rem solid var(--claimed); padding-left: .7rem; } footer { margin-top: 2.5rem; }
footer code { overflow-wrap: anywhere; } [hidden] { display: none !important; }
summary { cursor: pointer; } details { margin: .35rem 0; } details.part { border: 1px solid var(--line); border-radius: 6px; margin: 1rem 0; }
details.part > summary { padding: .55rem .9rem; font-weight: 600; } summary > .soft { font-weight: 400; } details.part > :not(summary) { margin-left: .9rem; margin-right: .9rem; }
pre { overflow: auto; max-height: 20rem; background: var(--shade); padding: .5rem; margin: .25rem 0; }
pre.wrap { white-space: pre-wrap; overflow-wrap: anywhere; }
:focus-visible { outline: 2px solid var(--link); outline-offset: 2px; }

.shares { margin: .6rem 0 1rem; } .shares > svg { display: block; border-radius: 4px; background: var(--shade); }
.share { stroke: var(--ground); stroke-width: 1; } .share.good { fill: var(--true); } .share.fair { fill: var(--true); fill-opacity: .55; }
.share.left { fill: var(--line); } .share.wrong { fill: var(--claimed); } .share.other { fill-opacity: .62; } .share.lost { fill: var(--soft); }
.legend { list-style: none; display: flex; flex-wrap: wrap; gap: .2rem 1.1rem; padding: 0; margin: .5rem 0 0; } .swatch { vertical-align: -1px; }

.filter { display: flex; flex-wrap: wrap; gap: .5rem 1rem; align-items: center; margin: .5rem 0; }
.filter input, .filter select, button { font: inherit; color: var(--ink); background: var(--ground); border: 1px solid var(--soft);
  border-radius: 5px; padding: .2rem .55rem; max-width: 100%; box-sizing: border-box; } .filter output { color: var(--soft); }
button { cursor: pointer; background: var(--shade); } .copying { margin: .75rem 0 .25rem; min-height: 0; } .copying > span { color: var(--soft); }

.tall { overflow: auto; max-height: 34rem; border-bottom: 1px solid var(--line); }
table { border-collapse: separate; border-spacing: 0; font-size: .9rem; }
th, td { padding: .25rem .55rem; border-bottom: 1px solid var(--line); text-align: right; vertical-align: top; font-variant-numeric: tabular-nums; }
td { white-space: nowrap; } td.text { white-space: normal; min-width: 24rem; font-family: inherit; font-size: inherit; } td.name { text-align: left; }
thead th { vertical-align: bottom; font-weight: 600; background: var(--ground); position: sticky; top: 0; }
tbody th { text-align: left; font-weight: 400; white-space: nowrap; } td.text, th.text { text-align: left; }
tbody th.id { white-space: normal; overflow-wrap: anywhere; min-width: 19rem; } tr.all th, tr.all td { font-weight: 700; }
tbody tr:hover { background: var(--shade); }

article { border: 1px solid var(--line); border-radius: 6px; padding: 1rem; margin: 0 0 1rem; scroll-margin-top: .5rem; }
article:target { border-color: var(--link); box-shadow: 0 0 0 1px var(--link); } article > p { margin: .25rem 0 .5rem; }
.verdict { color: var(--claimed); font-weight: 600; }
.facts { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(24rem, 100%), 1fr)); gap: 0 2rem; }
.facts dl { grid-template-columns: minmax(6rem, auto) minmax(0, 1fr); }
figure { margin: .5rem 0; } figcaption { color: var(--soft); font-size: .9rem; }
.pairs { display: flex; flex-wrap: wrap; gap: .5rem; } .pairs svg { max-width: 100%; height: auto; }
.key { font-weight: 700; } .key.body-a { color: var(--a); } .key.body-b { color: var(--b); } .key.true { color: var(--true); } .key.claimed { color: var(--claimed); }
svg.chart text { fill: var(--ink); font-size: 12px; } svg.chart text.soft { fill: var(--soft); font-size: 11px; }
svg.chart rect.bar { fill: var(--true); } svg.chart rect.bar.failing { fill: var(--claimed); } svg.chart line { stroke: var(--line); }
svg.chart line.limit { stroke: var(--ink); stroke-dasharray: 3 3; }
@media (min-width: 70rem) { .beside { display: grid; grid-template-columns: 27rem minmax(0, 1fr); gap: 0 1.5rem; align-items: start; }
  .beside > .picture { position: sticky; top: .5rem; } .beside .facts { grid-template-columns: minmax(0, 1fr); } }
@media (max-width: 36rem) { tbody th.id { min-width: 9rem; } body { padding: .75rem; } article { padding: .7rem; } .facts dl { grid-template-columns: minmax(0, 1fr); gap: 0; }
  .facts dd { margin-bottom: .3rem; } dl.settings { grid-template-columns: minmax(0, 1fr); gap: 0; } details.part > :not(summary) { margin-left: .5rem; margin-right: .5rem; } }
@media print { html { font-size: 11px; } body { max-width: none; padding: 0; } .pairs svg { width: 49%; } article, figure, tr { break-inside: avoid; }
  h2, h3, h4 { break-after: avoid; } pre, .tall { max-height: none; } .tall { overflow: visible; } thead th { position: static; }
  button, .filter { display: none; } * { print-color-adjust: exact; } }
)";
}

// The script of pages.

std::string_view page_script() {
  return R"script(
'use strict';
(() => {
  const all = (what) => Array.from(document.querySelectorAll(what));
  const open = (element) => {
    for (let at = element; at; at = at.parentElement) if (at.tagName === 'DETAILS') at.open = true;
  };

  // ---- filters ----
  const filters = new Map();
  all('form.filter').forEach((form) => {
    const items = Array.from(document.getElementById(form.dataset.of).children);
    const words = items.map((item) => (item.querySelector('summary') || item).textContent.toLowerCase());
    const text = form.elements.text, kind = form.elements.kind, told = form.querySelector('output');
    const apply = () => {
      const wanted = text.value.trim().toLowerCase();
      let shown = 0;
      items.forEach((item, i) => {
        const fits = (kind.value === '' || kind.value === item.dataset.kind) ? words[i].includes(wanted) : false;
        item.hidden = !fits;
        if (fits) shown += 1;
      });
      told.textContent = shown + ' of ' + items.length;
    };
    form.addEventListener('input', apply);
    form.addEventListener('submit', (event) => event.preventDefault());
    form.hidden = false;
    filters.set(form.dataset.of, (find, choice) => { text.value = find; kind.value = choice; apply(); });
    apply();
  });
  all('a[data-find]').forEach((link) => link.addEventListener('click', () => {
    const of = link.dataset.of;
    if (filters.has(of)) filters.get(of)(link.dataset.find, link.dataset.choice || '');
    open(document.getElementById(of));
  }));

  // ---- copying ----
  all('button.copy').forEach((button) => {
    const from = document.getElementById(button.dataset.of), told = button.nextElementSibling;
    const tell = (what) => { told.textContent = what; setTimeout(() => { told.textContent = ''; }, 4000); };
    const select = () => {
      open(from);
      window.getSelection().selectAllChildren(from);
      tell(document.execCommand('copy') ? 'copied' : 'selected: copy it by hand');
    };
    button.addEventListener('click', () => {
      if (!navigator.clipboard) return select();
      navigator.clipboard.writeText(from.textContent).then(() => tell('copied'), select);
    });
    button.hidden = false;
  });

  // ---- links into what is folded ----
  const follow = () => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (!target) return;
    open(target);
    target.scrollIntoView({ block: 'nearest' });
  };
  window.addEventListener('hashchange', follow);
  follow();
})();
)script";
}

namespace {

struct Colour {
  std::string_view name, light, dark;
};

constexpr std::array<Colour, 11> colours{{
    {"ground", "#ffffff", "#14181d"},   // background
    {"ink", "#1b1f24", "#e6edf3"},      // text
    {"soft", "#57606a", "#9da7b1"},     // text beside it
    {"line", "#d0d7de", "#3d444d"},     // borders
    {"shade", "#f6f8fa", "#1d232a"},    // background of pictures and code
    {"a", "#0550ae", "#79c0ff"},        // body A
    {"b", "#8a4600", "#f0b072"},        // body B
    {"true", "#116329", "#56d364"},     // fathom's result
    {"claimed", "#a40e26", "#ff8f88"},  // others' claims
    {"link", "#0550ae", "#79c0ff"},     // links
    {"lit", "#8250df", "#d2a8ff"},      // the chosen element
}};

/// "@name" stands for a colour of that name.
constexpr std::string_view rules = R"(
svg.pair .wire,svg.pair .hidden,svg.pair .seam,svg.pair .ghost,svg.pair .shaft,svg.pair .feature,svg.pair .bar{fill:none;stroke-linejoin:round;stroke-linecap:round}
svg.pair .ground{fill:@shade}
svg.pair .toned.body-a{fill:@a;fill-opacity:.16}
svg.pair .toned.body-b{fill:@b;fill-opacity:.05}
svg.pair .stripe.body-b{fill:none;stroke:@b;stroke-width:1.1;stroke-opacity:.5}
svg.pair .wire{stroke-width:1.4}
svg.pair .hidden{stroke-width:.9;stroke-opacity:.6;stroke-dasharray:3 3}
svg.pair .toned.in-contact{fill-opacity:.2}
svg.pair .seam{stroke-width:.8;stroke-opacity:.75}
svg.pair .body-a.seam{stroke:@a}
svg.pair .body-b.seam{stroke:@b}
svg.pair .ghost{stroke:@a;stroke-width:1.2;stroke-dasharray:7 4}
svg.pair .feature{stroke-width:4.5}
svg.pair .body-a.wire,svg.pair .body-a.hidden,svg.pair .body-a.feature{stroke:@a}
svg.pair .body-b.wire,svg.pair .body-b.hidden,svg.pair .body-b.feature{stroke:@b}
svg.pair .body-a.dot,svg.pair .body-a.letter{fill:@a}
svg.pair .body-b.dot,svg.pair .body-b.letter{fill:@b}
svg.pair .shaft{stroke-width:2.6}
svg.pair .true.shaft{stroke:@true}
svg.pair .claimed.shaft{stroke:@claimed;stroke-dasharray:7 4;stroke-linecap:butt}
svg.pair .true.head,svg.pair .true.dot{fill:@true}
svg.pair .claimed.head,svg.pair .claimed.dot{fill:@claimed}
svg.pair .sum.toned{fill:@soft;fill-opacity:.12}
svg.pair .sum.wire,svg.pair .sum.hidden{stroke:@ink}
svg.pair .sum.wire{stroke-width:1.1}
svg.pair .ball{fill:@true;fill-opacity:.14;stroke:@true;stroke-width:1.4}
svg.pair .near{fill:@true;fill-opacity:.3;stroke:@true;stroke-width:3.5;stroke-linejoin:round}
svg.pair .origin{fill:@ink}
svg.pair .bar{stroke:@ink;stroke-width:1.4}
svg.pair text{fill:@ink;font-family:system-ui,-apple-system,'Segoe UI','DejaVu Sans',sans-serif;font-size:12px}
svg.pair .letter{font-size:18px;font-weight:700;text-anchor:middle;paint-order:stroke;stroke:@shade;stroke-width:4px;stroke-linejoin:round}
svg.pair .note,svg.pair .scale{paint-order:stroke;stroke:@shade;stroke-width:3px;stroke-linejoin:round}
svg.pair .note{fill:@soft}
svg.pair .paper{fill:@ground}
svg.pair .heading,svg.pair .answer{font-size:14px;font-weight:600}
svg.pair .caption{font-size:13px}
)";

std::string properties(std::string_view Colour::*shade) {
  std::string result;
  for (const Colour& colour : colours) result += fmt::format("--{}:{};", colour.name, colour.*shade);
  return result;
}

/// Returns the colour of a property in light pages: light_colour("a") is that of --a. Throws
/// std::out_of_range for other names.
std::string_view light_colour(std::string_view name) {
  const auto found = std::ranges::find(colours, name, &Colour::name);
  if (found == colours.end()) throw std::out_of_range("no colour is called " + std::string(name));
  return found->light;
}

}  // namespace

std::string colour_style() {
  return fmt::format(
      ":root{{color-scheme:light dark;{0}}}\n@media (prefers-color-scheme: dark){{:root{{{1}}}}}\n"
      "@media print{{:root{{color-scheme:light;{0}}}}}\n",
      properties(&Colour::light), properties(&Colour::dark));
}

// Two shadows are fixed at the edges; two covers of the background colour move with the scrolled
// content, and hide a shadow at the end of the content.
std::string_view scroll_style() {
  return R"(.wide { max-width: 100%; overflow-x: auto; background:
  linear-gradient(to right, var(--ground) 50%, transparent) left / 3rem 100% no-repeat local,
  linear-gradient(to left, var(--ground) 50%, transparent) right / 3rem 100% no-repeat local,
  linear-gradient(to right, var(--soft), transparent) left / .5rem 100% no-repeat scroll,
  linear-gradient(to left, var(--soft), transparent) right / .5rem 100% no-repeat scroll; }
@media print { .wide { overflow: visible; background: none; } }
)";
}

std::string coloured(std::string_view rules, bool plain) {
  std::string result;
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (rules[i] != '@') {
      result += rules[i];
      continue;
    }
    const std::size_t end = rules.find_first_of(";}", i);
    const std::string_view name = rules.substr(i + 1, end - i - 1);
    const std::string property = result.substr(result.find_last_of("{;") + 1);
    if (plain) result += fmt::format("{};{}", light_colour(name), property);
    result += fmt::format("var(--{})", name);
    i = end - 1;
  }
  return result;
}

std::string picture_style() { return coloured(rules, false); }

std::string document_style() { return colour_style() + coloured(rules, true); }

}  // namespace fathom::picture
