// SPDX-License-Identifier: GPL-3.0-or-later
// Choosing canonical pair i lights the arcs of A_i and B_i, and nothing else, in every view; and its facets of P. For all pairs of ten cases.
import assert from 'node:assert/strict';
import { drawn, explained, meshes, stored } from './explained.mjs';
import { onPage } from './lib.mjs';

const gallery = (id) => stored('docs/gallery/cases.jsonl', id);
const ten = {
  'a cube and an icosahedron': () => meshes('cube-icosahedron', 'tests/data/cube.off', 'tests/data/icosahedron.off'),
  'cube on cube': () => gallery('cube-on-cube'),
  'touching facets': () => gallery('touching-facets'),
  'a triangle in a solid': () => gallery('flat-in-solid'),
  'tiny beside huge': () => gallery('tiny-beside-huge'),
  'crossed fans': () => drawn('crossed_fans', 12),
  'random balls': () => drawn('random_ball', 30),
  'aligned solids': () => drawn('platonic_aligned', 12),
  'ties': () => drawn('exact_ties', 12),
  'edges in contact': () => drawn('contact_edge_edge', 6),
};

const sorted = (lit) => lit.map(([colour, edge]) => `${colour}${edge}`).sort();

for (const [name, line] of Object.entries(ten))
  onPage(`pairs of ${name}`, () => explained(line()).page, {}, async (page) => {
    const { stages } = explained(line());
    for (let i = 0; i < stages.pairs.length; ++i) {
      const { a, b } = stages.pairs[i];
      const expected = sorted([...a.map((e) => ['a', e]), ...b.map((e) => ['b', e])]);
      const { lit, marked } = await page.evaluate((pair) => {
        globalThis.fathom.select({ pair });
        return { lit: globalThis.fathom.lit(), marked: document.querySelectorAll('#where .chart .lit').length };
      }, i);
      for (const view of ['sphere', 'chart', 'bodies'])
        assert.deepEqual(sorted(lit[view]), expected, `law: pair ${i} lights its |A_i| + |B_i| arcs in ${view}`);
      assert.equal(marked, expected.length, `law: in the chart's picture as many arcs are marked, pair ${i}`);
      const facets = stages.sum.facets.filter((facet) => facet.pairs?.includes(i)).length;
      assert.equal(lit.blocks, facets, `law: pair ${i} lights its facets of P`);
    }
    await page.evaluate(() => globalThis.fathom.select({ pair: null }));
    const lit = await page.evaluate(() => globalThis.fathom.lit());
    assert.deepEqual([lit.sphere, lit.chart], [[], []], 'law: without a pair no arc is lit');
  });
