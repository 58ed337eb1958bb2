// SPDX-License-Identifier: GPL-3.0-or-later
// Every number on the page of `fathom explain` is one of `depth --patch --json`, or of the data of the pictures; with scripts and without.
import assert from 'node:assert/strict';
import { drawn, explained, meshes, numbersOfPatches, stored } from './explained.mjs';
import { cases, onPage, withoutWebGl } from './lib.mjs';
import { nearestRoot } from '../../view/page/web/numbers.js';

const gallery = 'docs/gallery/cases.jsonl';
const lines = {
  'a cube and an icosahedron': () => meshes('cube-icosahedron', 'tests/data/cube.off', 'tests/data/icosahedron.off'),
  'ties': () => drawn('exact_ties', 12),
  'bodies apart': () => drawn('random_disjoint', 20),
  'a capsule and a box': () => drawn('capsule_box', 1),
  ...Object.fromEntries(cases(gallery).map(({ id }) => [id, () => stored(gallery, id)])),
};

/** The numbers in a text, as written: not those in words (binary64), nor hexadecimal ones. */
const numbers = (text) => text.match(/(?<![\w.])-?\d+(?:\.\d+)?(?:e[+-]?\d+)?(?![\w])/g) ?? [];
const flat = (value) => [value].flat(Infinity).map((each) => (typeof each === 'number' ? each : `${each}`));

/** An exact number of a case, as a fraction of whole numbers. */
function fraction(value) {
  if (typeof value === 'string') return [...value.split('/').map(BigInt), 1n].slice(0, 2);
  let power = 0;
  while (!Number.isInteger(value)) [value, power] = [value * 2, power + 1];  // a binary64 that is not tiny
  return [BigInt(value), 1n << BigInt(power)];
}

/** The ends of an edge, exactly. */
const ends = (stages, bodies, body, edge) => stages[body].edges[edge].map((v) => bodies[body].vertices[stages[body].ids[v]].map(fraction));

/** The squared distance of two lines, each given by two points, from the input alone: <p - q, u x v>^2 / |u x v|^2, as "p/q". */
function squareOfLines([p, p2], [q, q2]) {
  const all = [p, p2, q, q2].flat(), unit = all.reduce((product, [, denominator]) => (product % denominator ? product * denominator : product), 1n);
  const whole = (point) => point.map(([n, d]) => (n * unit) / d), minus = (x, y) => x.map((c, i) => c - y[i]);
  const dot = (x, y) => x.reduce((sum, c, i) => sum + c * y[i], 0n);
  const [o, x, r, y] = [p, p2, q, q2].map(whole), u = minus(x, o), v = minus(y, r), d = minus(o, r);
  const n = [0, 1, 2].map((i) => u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3]);
  return `${dot(d, n) ** 2n}/${dot(n, n) * unit * unit}`;
}

/** What each fact must say: the name of its field on the page, and the value in `depth --json`. */
function expected(depth) {
  const told = depth.status === 'disjoint' ? depth.distance : depth;
  return Object.entries({
    depth: depth.status === 'penetrating' ? depth.depth.value : undefined, distance: depth.distance?.value, unit: told.unit_f64,
    translation: depth.status === 'touching' ? undefined : told.translation_f64, witness_a: told.witness_f64?.a, witness_b: told.witness_f64?.b,
    size_a: depth.sizes?.a, size_b: depth.sizes?.b,
  }).filter(([, value]) => value !== undefined && value !== null);
}

for (const [name, line] of Object.entries(lines))
  for (const javaScriptEnabled of [true, false])
    onPage(`numbers of ${name}, scripts ${javaScriptEnabled ? 'on' : 'off'}`, () => explained(line()).page, { javaScriptEnabled, flags: withoutWebGl, width: 480, height: 480 }, async (page) => {
      const { depth, stages } = explained(line());
      for (const [field, value] of expected(depth)) {
        const shown = await page.locator(`#facts [data-field="${field}"]`).first().textContent();
        assert.deepEqual(numbers(shown).map(Number), flat(value), `law: ${field} is that of depth --json`);
      }
      const answers = new Set([...numbers(JSON.stringify(depth)), ...flat(depth.sizes ? [depth.sizes.a, depth.sizes.b] : []).map(String)]);
      const values = new Set([...answers, ...numbersOfPatches(depth)].map(Number));
      const optima = stages.contact?.optima?.length ?? 0;
      for (let i = 0; i <= optima; ++i) values.add(i); // "1 of 6"
      for (const part of ['#answer', '#facts']) {
        const text = await page.locator(part).evaluate((e) => [...e.querySelectorAll('*'), e].filter((x) => !x.children.length).map((x) => x.textContent).join(' ') || e.textContent);
        const foreign = numbers(text.replaceAll(/\.\.\. \(\d+ characters\)/g, '')).filter((each) => !answers.has(each) && !values.has(Number(each)) && !values.has(-Number(each)));
        assert.deepEqual(foreign, [], `law: every number in ${part} is one of depth --patch --json`);
      }
      const ranked = await page.locator('#ranked tr[data-facet] td:nth-child(2)').allTextContents();
      for (const [i, text] of ranked.entries()) {
        const distance = stages.sum.facets[i].distance * 2 ** -stages.scale.exponent; // places have a unit of their own
        if (distance === 0) continue; // in that unit it is too small for a binary64
        assert.ok(Math.abs(Number(text) - distance) <= 1e-4 * Math.abs(distance), `law: facet ${i} is as far as fathom stages says (${text}, ${distance})`);
      }
      const fold = page.locator('#pairs button.fold[aria-expanded=false]');
      if (await fold.count()) await fold.click();
      const pairs = await page.locator('#pairs tr[data-pair]').evaluateAll((rows) => rows.map((e) => [Number(e.dataset.pair), e.children[4].firstChild.textContent]));
      const bodies = JSON.parse(line());
      for (const [pair, text] of pairs) {
        const { closest, a, b } = stages.pairs[pair];
        if (!closest) { assert.equal(text.length, 1, 'law: without closest lines there is no number'); continue; }
        const square = closest.distance_squared ?? squareOfLines(ends(stages, bodies, 'a', closest.a), ends(stages, bodies, 'b', closest.b));
        assert.equal(Number(text), nearestRoot(square), `law: pair ${pair} of ${a.length} x ${b.length} is as near as its lines are, exactly`);
      }
      if (ranked.length && depth.status === 'penetrating' && stages.sum.facets[0].optimal && stages.scale.exponent === 0)
        assert.equal(Number(ranked[0]), depth.depth.value, 'law: the nearest facet of P is as far as A is deep');
    });
