// SPDX-License-Identifier: GPL-3.0-or-later
// Where bodies touch, and how the depth changes as A moves, on the page of `fathom explain`.
import assert from 'node:assert/strict';
import { explained, meshes, stored } from './explained.mjs';
import { accessible, colours, fits, inBothLooks, onPage } from './lib.mjs';

const box = (low, high) => [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [0, 1, 2].map((axis) => (i >> axis & 1 ? high : low)[axis]));
const faces = JSON.stringify({ schema: 'fathom/case/1', id: 'two boxes', a: { vertices: box([-1, -1, -1], [1, 1, 1]) },
  b: { vertices: box([0.5, -0.5, -0.75], [2.5, 1.5, 1.25]) } });
const round = JSON.stringify({ schema: 'fathom/case/1', id: 'a capsule and a box', a: { shape: 'capsule', radius: 0.25, half_length: 2 },
  b: { shape: 'box', half: [1, 1, 1], pose: { translation: [0.5, 0.25, 1.75] } } });
const boxes = () => explained(faces).page, capsule = () => explained(round).page;
const twisted = () => explained(meshes('twisted', 'tests/data/cube.off', 'tests/data/icosahedron.off'), ['--twist=0,0,0,0,0,1']).page;
const fans = () => explained(stored('docs/gallery/cases.jsonl', 'crossed-fans')).page;

for (const [name, page] of Object.entries({ boxes, capsule, twisted }))
  inBothLooks(`motions of ${name}`, page, async (open) => {
    await open.evaluate(() => globalThis.fathom.select({ step: 3 }));
    await fits(open);
    await accessible(open);
  });

for (const [name, page, corners] of [['boxes', boxes, 4], ['a capsule', capsule, 2], ['crossed fans', fans, 1]])
  onPage(`motions: the patches of ${name} are one over the other where A has moved out`, page, {}, async (open) => {
    const { a, b, way } = await open.evaluate(() => {
      const { patches, optima, stages } = globalThis.fathom.data;
      return { ...patches[0], way: (optima[0] ?? stages.contact).translation };
    });
    assert.equal(a.length, corners, 'law: each corner is drawn');
    a.forEach((p, k) => p.forEach((x, i) => assert.ok(Math.abs(x + way[i] - b[k][i]) < 1e-6, `law: they meet (${p}, ${b[k]})`)));
  });

onPage('motions: the slider puts A where a mark is', boxes, {}, async (page) => {
  const slider = page.locator('#motion input[type=range]'), told = page.locator('#motion .step');
  await page.getByRole('button', { name: 'about y' }).click();
  const before = await colours(page, '#what .scene canvas');
  await slider.focus();
  await slider.press('End');
  const { step, motion, moved } = await page.evaluate(() => globalThis.fathom.selection());
  assert.deepEqual([step, motion, moved], [10, 2, 0]);
  const { value } = await page.evaluate(() => globalThis.fathom.data.motions[2].path.values[10]);
  assert.equal(await told.innerText(), `s = 1: penetrating, signed depth ${value}`, 'law: the number is that of the data');
  await page.mouse.move(1, 1);
  assert.ok(!before.picture.equals((await colours(page, '#what .scene canvas')).picture), 'law: A stands elsewhere');
  const marks = await page.locator('#motion > div:not([hidden]) g[clip-path] path.mark').evaluateAll((all) => all.map((e) => e.getBoundingClientRect().x));
  const ring = await page.locator('#motion > div:not([hidden]) .cursor').boundingBox();
  assert.ok(Math.abs(ring.x + ring.width / 2 - Math.max(...marks) - 4) < 3, 'law: the ring is around the last mark');
  await page.locator('#what .slider input').first().press('End');
  assert.deepEqual(await page.evaluate(() => [globalThis.fathom.selection().step, globalThis.fathom.selection().moved]), [0, 1], 'law: one slider lets go of the other');
});

onPage('motions: one chart at a time, and all without scripts', boxes, {}, async (page) => {
  assert.equal(await page.locator('#motion svg:visible').count(), 1);
});
onPage('motions without scripts', boxes, { javaScriptEnabled: false }, async (page) => {
  assert.equal(await page.locator('#motion svg:visible').count(), 4, 'law: every chart is there');
  assert.match(await page.locator('#facts').innerText(), /Where they touch then: a polygon of 4 corners, area 2.625/i, 'law: and so are the corners');
  await fits(page);
});

onPage('motions: the patch that is told is that of the chosen optimum', () => explained(JSON.stringify({ schema: 'fathom/case/1', id: 'ties',
  a: { vertices: box([-1, -1, -1], [1, 1, 1]) }, b: { vertices: box([-1, -1, -1], [1, 1, 1]) } })).page, {}, async (page) => {
  for (const optimum of [0, 4]) {
    await page.evaluate((i) => globalThis.fathom.select({ optimum: i }), optimum);
    assert.deepEqual(await page.locator('[data-patch]:visible').evaluateAll((all) => all.map((e) => e.dataset.patch)), [`${optimum}`]);
  }
});
