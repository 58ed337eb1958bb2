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

/** What is lit with each pair chosen in turn, and with none; in one go, so that no picture is drawn between. */
const litBy = (page) => page.evaluate(() => {
  const { data, select, lit } = globalThis.fathom;
  const arcs = () => [...document.querySelectorAll('#where .chart .arc.lit')];
  const marked = () => arcs().map((e) => [e.classList.contains('a') ? 'a' : 'b', Number(e.dataset.edge)]);
  return [...data.pairs.keys(), null].map((pair) => {
    select({ pair });
    return { ...lit(), marked: marked() };
  });
});

for (const [name, line] of Object.entries(ten))
  onPage(`pairs of ${name}`, () => explained(line()).page, { width: 480, height: 480 }, async (page) => {
    const { pairs, sum } = explained(line()).stages;
    const lit = await litBy(page);
    assert.equal(lit.length, pairs.length + 1);
    assert.ok(pairs.length > 0, 'the case has pairs');
    for (const [i, { a, b }] of pairs.entries()) {
      const expected = sorted([...a.map((e) => ['a', e]), ...b.map((e) => ['b', e])]);
      for (const view of ['sphere', 'chart', 'bodies', 'marked'])
        assert.deepEqual(sorted(lit[i][view]), expected, `law: pair ${i} lights its |A_i| + |B_i| arcs (${view})`);
      const facets = sum.facets.filter((facet) => facet.pairs?.includes(i)).length;
      assert.equal(lit[i].blocks, facets, `law: pair ${i} lights its facets of P`);
    }
    const none = lit.at(-1);
    assert.deepEqual([none.sphere, none.chart, none.marked], [[], [], []], 'law: without a pair no arc is lit');
  });
