// SPDX-License-Identifier: GPL-3.0-or-later
// Every number on the page of `fathom explain` is one of `depth --json`, or of the data of the pictures; with scripts and without.
import assert from 'node:assert/strict';
import { drawn, explained, meshes, stored } from './explained.mjs';
import { cases, onPage } from './lib.mjs';

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
    onPage(`numbers of ${name}, scripts ${javaScriptEnabled ? 'on' : 'off'}`, () => explained(line()).page, { javaScriptEnabled, width: 480, height: 480 }, async (page) => {
      const { depth, stages } = explained(line());
      for (const [field, value] of expected(depth)) {
        const shown = await page.locator(`#facts [data-field="${field}"]`).first().textContent();
        assert.deepEqual(numbers(shown).map(Number), flat(value), `law: ${field} is that of depth --json`);
      }
      const answers = new Set([...numbers(JSON.stringify(depth)), ...flat(depth.sizes ? [depth.sizes.a, depth.sizes.b] : []).map(String)]);
      const values = new Set([...answers].map(Number));
      const optima = stages.contact?.optima?.length ?? 0;
      for (let i = 0; i <= optima; ++i) values.add(i); // "1 of 6"
      for (const part of ['#answer', '#facts']) {
        const text = await page.locator(part).evaluate((e) => [...e.querySelectorAll('*'), e].filter((x) => !x.children.length).map((x) => x.textContent).join(' ') || e.textContent);
        const foreign = numbers(text.replaceAll(/\.\.\. \(\d+ characters\)/g, '')).filter((each) => !answers.has(each) && !values.has(Number(each)) && !values.has(-Number(each)));
        assert.deepEqual(foreign, [], `law: every number in ${part} is one of depth --json`);
      }
      const ranked = await page.locator('#ranked tr[data-facet] td:nth-child(2)').allTextContents();
      for (const [i, text] of ranked.entries()) {
        const distance = stages.sum.facets[i].distance * 2 ** -stages.scale.exponent; // places have a unit of their own
        if (distance === 0) continue; // in that unit it is too small for a binary64
        assert.ok(Math.abs(Number(text) - distance) <= 1e-4 * Math.abs(distance), `law: facet ${i} is as far as fathom stages says (${text}, ${distance})`);
      }
      if (ranked.length && depth.status === 'penetrating' && stages.sum.facets[0].optimal && stages.scale.exponent === 0)
        assert.equal(Number(ranked[0]), depth.depth.value, 'law: the nearest facet of P is as far as A is deep');
    });
