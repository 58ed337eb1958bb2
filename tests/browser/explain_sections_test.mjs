// SPDX-License-Identifier: GPL-3.0-or-later
// What the sections of the page of `fathom explain` do: a facet of P under the pointer shows its contact, charts have two projections, the cutting
// goes level by level, coincidences light and split, costs are those counted, exact numbers are there on demand.
import assert from 'node:assert/strict';
import { drawn, explained, meshes, stored } from './explained.mjs';
import { colours, onPage } from './lib.mjs';

const gallery = (id) => explained(stored('docs/gallery/cases.jsonl', id));
const plain = () => explained(meshes('cube-icosahedron', 'tests/data/cube.off', 'tests/data/icosahedron.off'));
const fans = () => explained(drawn('crossed_fans', 12));
const ties = () => explained(drawn('exact_ties', 12));
const select = (page, changes) => page.evaluate((each) => globalThis.fathom.select(each), changes);
const chosen = (page) => page.evaluate(() => globalThis.fathom.selection());

onPage('explain: a facet of P under the pointer shows its contact above', () => plain().page, {}, async (page) => {
  const contact = () => page.evaluate(() => { const { a, b } = globalThis.fathom.contact(); return JSON.stringify([a, b]); });
  const before = await contact(), canvas = page.locator('#why .scene canvas');
  await canvas.scrollIntoViewIfNeeded();
  const { x, y, width, height } = await canvas.boundingBox(), seen = new Set();
  for (const [i, j] of [[0.5, 0.5], [0.4, 0.4], [0.6, 0.35], [0.45, 0.62]]) {
    await page.mouse.move(x + i * width, y + j * height);
    await page.evaluate(() => new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); }));
    seen.add(await contact());
  }
  assert.ok(seen.size > 1, 'law: other facets have other contacts');
  assert.equal((await chosen(page)).facet, null, 'law: the pointer chooses nothing');
  await page.mouse.click(x + 0.5 * width, y + 0.5 * height);
  const { facet } = await chosen(page), { stages } = plain();
  assert.ok(facet !== null, 'law: a click chooses the facet');
  await page.mouse.move(1, 1);
  const ids = (body) => page.evaluate((of) => { const { data, contact: c } = globalThis.fathom; const { vertices, ids: own } = data.bodies[of];
    return c()[of].map((p) => own[vertices.findIndex((v) => v.every((c2, k) => Math.abs(c2 - p[k]) < 1e-9))]); }, body);
  assert.deepEqual((await ids('b')).sort(), [...stages.sum.facets[facet].b].sort(), "law: B's feature is the facet's");
  await page.keyboard.press('Escape');
  assert.equal(await contact(), before, 'law: without a choice the contact is that of the optimum');
});

onPage('explain: the ranking says how far the second facet is', () => plain().page, {}, async (page) => {
  const [least, second] = plain().stages.sum.facets.map((facet) => facet.distance), text = await page.locator('#ranked .gap').innerText();
  const [, , gap] = text.match(/\d+(\.\d+)?/g).map(Number);
  assert.ok(Math.abs(gap - (second - least)) < 1e-3 * (second - least) + 1e-5, `law: the gap to the second (${text})`);
});

onPage('explain: longitude and latitude, and the plane of the paper', () => fans().page, {}, async (page) => {
  const chart = () => page.evaluate(() => ({ walls: [...document.querySelectorAll('#where .chart .wall')].map((e) => ['x1', 'x2'].map((n) => e.getAttribute(n))),
    arcs: [...document.querySelectorAll('#where .chart .arc')].map((e) => e.getAttribute('d')), axis: [...document.querySelectorAll('#where .chart text')].map((e) => e.textContent) }));
  const before = await chart();
  assert.ok(before.walls.length > 2 && before.walls.every(([x, x2]) => x === x2), 'law: walls are vertical');
  assert.ok(before.axis.includes('longitude') && before.axis.includes('latitude'));
  await page.getByRole('button', { name: /plane z = 1/ }).click();
  const plane = await chart();
  assert.match(page.url(), /plane=z1/, 'law: the projection stands in the address');
  assert.ok(plane.walls.every(([x, x2]) => x === x2), 'law: walls are vertical there too');
  assert.notDeepEqual(plane.arcs, before.arcs);
  for (const d of plane.arcs.filter(Boolean)) assert.equal(d.match(/L/g)?.length ?? 1, 1, 'law: in the plane an arc is a segment');
  assert.ok(!plane.axis.includes('longitude'));
});

onPage('explain: hemispheres, and dots where arcs of a pair cross', () => fans().page, {}, async (page) => {
  const { stages } = fans();
  for (const pair of stages.pairs.keys()) {
    await select(page, { pair });
    const dots = await page.locator('#where .chart .crossings').evaluateAll((all) => all.flatMap((e) => e.getAttribute('d').match(/M/g)).length);
    const facets = stages.sum.facets.filter((facet) => facet.pairs.includes(pair)).length;
    assert.equal(dots, facets, `law: pair ${pair} has a dot for each of its facets of P`);
  }
  const largest = [...stages.pairs.keys()].sort((i, j) => stages.pairs[j].a.length * stages.pairs[j].b.length - stages.pairs[i].a.length * stages.pairs[i].b.length)[0];
  await select(page, { pair: largest, hemisphere: 'both' });
  const seen = await colours(page, '#where .chart svg');
  await page.locator('#where .chart .crossings').evaluate((e) => e.remove());
  assert.ok(!seen.picture.equals((await colours(page, '#where .chart svg')).picture), 'law: dots are seen');
  await select(page, { pair: null });
  assert.equal(await page.locator('#where .chart .crossings').count(), 0);
  for (const name of ['upper', 'lower']) {
    await page.locator('#where').getByRole('button', { name, exact: true }).click();
    const arcs = await page.locator('#where .chart .arcs .arc').count(), of = stages.charts.find((chart) => chart.hemisphere === name);
    assert.equal(arcs, of.a.arcs.length + of.b.arcs.length, `law: the ${name} hemisphere has its arcs`);
  }
});

onPage('explain: an arc that is clicked chooses a pair that holds it', () => fans().page, {}, async (page) => {
  const { pairs, charts } = fans().stages, shown = charts[pairs[0].chart].hemisphere, [edge] = pairs.find(({ chart }) => chart === pairs[0].chart).a;
  await select(page, { hemisphere: shown });
  const arc = page.locator(`#where .chart .arc.a[data-edge="${edge}"]`).first();
  await arc.scrollIntoViewIfNeeded();
  const [x, y] = await arc.evaluate((e) => { const at = e.getPointAtLength(e.getTotalLength() / 2).matrixTransform(e.getScreenCTM()); return [at.x, at.y]; });
  await page.mouse.click(x, y);
  const { pair } = await chosen(page);
  assert.ok(pair !== null && fans().stages.pairs[pair].a.includes(edge), `law: pair ${pair} holds edge ${edge}`);
});

onPage('explain: the cutting, level by level', () => fans().page, {}, async (page) => {
  const { cutting } = fans().stages;
  assert.ok(cutting.levels.length > 1, 'else the case has to be another');
  await page.locator('#cutting-level').fill('0');
  for (const [level, { blocks }] of cutting.levels.entries()) {
    await page.locator('#cutting-level').fill(`${level}`);
    for (const fate of ['cleared', 'refined', 'scanned', 'won']) {
      const own = await page.locator(`#cutting .block.last.${fate}`).count();
      assert.equal(own, blocks.filter((block) => block.fate === fate).length, `law: level ${level} has its blocks that were ${fate}`);
    }
  }
});

onPage('explain: coincidences light their features, and a visible epsilon splits them', () => gallery('touching-facets').page, {}, async (page) => {
  const { coincidences } = gallery('touching-facets').stages, places = coincidences.flatMap(({ listed }, i) => listed.map((_, j) => `${i}.${j}`));
  for (const name of places.slice(0, 12)) {
    const [i, j] = name.split('.').map(Number), { decided_by: by } = coincidences[i].listed[j];
    await select(page, { coincidence: name });
    assert.equal(await page.locator('#coincided button.item[aria-pressed=true]').count(), 1, 'law: one item is chosen');
    const text = await page.locator('#coincided .decided').innerText();
    for (const monomial of by) assert.ok(text.includes(monomial.replace('^2', '\u00b2')), `law: ${name} was decided by ${monomial} (${text})`);
  }
  const edges = places.find((name) => { const [i, j] = name.split('.').map(Number); return coincidences[i].listed[j].a[0]?.length === 2; });
  await select(page, { coincidence: edges });
  assert.ok((await page.evaluate(() => globalThis.fathom.lit().bodies.length)) > 0, 'law: its edges are lit in section 1');
  assert.ok((await page.evaluate(() => globalThis.fathom.lit().chart.length)) > 0, 'law: and in section 3');
  const picture = () => page.locator('#coincided svg.split').innerHTML();
  const slider = page.locator('#epsilon');
  await slider.fill('0');
  const given = await picture();
  await slider.fill('1');
  assert.notEqual(await picture(), given, 'law: the slider moves -A');
  assert.match(await page.locator('#coincided figcaption').innerText(), /A picture, not to scale/, 'law: it is called a picture');
});

onPage('explain: costs are those that were counted', () => plain().page, {}, async (page) => {
  const { bounds } = plain().stages;
  const rows = await page.locator('#cost table').first().locator('tbody tr').evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
  assert.deepEqual(rows.map(([stage, what, count, bound]) => [stage, what, Number(count), bound]), bounds.map((b) => [b.stage, b.what, b.count, b.bound]),
    'law: each stage has its count beside the bound of the paper');
});

onPage('explain: exact numbers are there on demand', () => plain().page, {}, async (page) => {
  const { depth } = plain(), row = page.locator('#facts dd', { has: page.locator('[data-field=depth]') });
  const shown = row.locator('pre');
  assert.equal(await shown.isVisible(), false, 'law: decimals come first');
  await row.locator('summary').click();
  assert.ok((await shown.innerText()).includes(depth.depth.squared), 'law: then the exact square');
});

for (const [name, make] of Object.entries({ ties, fans, plain, cubes: () => gallery('cube-on-cube'), flat: () => gallery('flat-in-solid') }))
  onPage(`explain: features coincide once A has moved, at every optimum of ${name}`, () => make().page, { width: 480, height: 480 }, async (page) => {
    const { depth } = make(), length = depth.depth.value;
    for (let optimum = 0; optimum < Math.min(depth.optima.length, 12); ++optimum) {
      const gap = (moved) => page.evaluate((each) => { globalThis.fathom.select(each); return globalThis.fathom.contact().gap; }, { optimum, moved });
      assert.ok(Math.abs(await gap(0) - length) < 1e-4 * length, `law: at 0 the features of optimum ${optimum} are as far apart as A is deep`);
      assert.ok(Math.abs(await gap(1)) < 1e-4 * length, `law: at 1 those of A lie on those of B`);
    }
  });

onPage('explain: extents beyond 100 : 1 have their axes scaled apart', () => explained(JSON.stringify({ schema: 'fathom/case/1', id: 'thin',
  a: { vertices: [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1 ? 1000 : 0, i & 2 ? 1 : 0, i & 4 ? 1 : 0]) },
  b: { vertices: [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1 ? 900 : -90, i & 2 ? 1.5 : 0.5, i & 4 ? 1 : 0]) } })).page, {}, async (page) => {
  assert.match(await page.locator('#what').innerText(), /axes scaled apart/i);
  assert.ok((await colours(page, '#what .scene canvas')).count > 40, 'law: what is thin is seen');
});
