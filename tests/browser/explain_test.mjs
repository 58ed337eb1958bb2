// SPDX-License-Identifier: GPL-3.0-or-later
// The page of `fathom explain`: it shows, turns, moves, answers to keys, remembers what was chosen, fits, prints, and can be read by all.
import assert from 'node:assert/strict';
import { drawn, explained, meshes, stored } from './explained.mjs';
import { accessible, colours, fits, inBothLooks, onPage, prints, shadows, withoutWebGl } from './lib.mjs';

const gallery = (id) => () => explained(stored('docs/gallery/cases.jsonl', id)).page;
const plain = () => explained(meshes('cube-icosahedron', 'tests/data/cube.off', 'tests/data/icosahedron.off')).page;
const fans = () => explained(drawn('crossed_fans', 12)).page;
const ties = () => explained(drawn('exact_ties', 12)).page;
const looks = { 'a cube and an icosahedron': plain, 'crossed fans': fans, 'touching bodies': gallery('touching-facets'), 'two cones': gallery('two-cones'),
  'tiny beside huge': gallery('tiny-beside-huge'), 'a triangle in a solid': gallery('flat-in-solid') };
const chosen = (page) => page.evaluate(() => globalThis.fathom.selection());

async function started(page) {
  assert.equal(await page.evaluate(() => document.documentElement.dataset.ready), 'yes', 'law: the page starts');
  const broken = await page.getByText('could not start').allTextContents();
  assert.deepEqual(broken, [], 'law: every part of the page starts');
}

for (const [name, page] of Object.entries(looks))
  inBothLooks(`explain ${name}`, page, async (open, width) => {
    await started(open);
    await fits(open);
    await accessible(open);
    const shadowed = await shadows(open);
    if (width === 390 && page === fans) assert.ok(shadowed, 'law: on a phone the tables scroll');
  });

onPage('explain: the canvas shows a picture, and turns', plain, {}, async (page) => {
  for (const scene of ['#what .scene canvas', '#why .scene canvas', '#where .sphere canvas']) {
    await page.locator(scene).first().scrollIntoViewIfNeeded();
    const before = await colours(page, scene);
    assert.ok(before.count > 40, `law: ${scene} has many colours (${before.count})`);
    const { x, y, width, height } = await page.locator(scene).first().boundingBox();
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + width / 2 + 80, y + height / 2 + 30, { steps: 4 });
    await page.mouse.up();
    await page.mouse.move(1, 1);
    const turned = await colours(page, scene);
    assert.ok(!before.picture.equals(turned.picture), `law: ${scene} turns under the pointer`);
  }
});

onPage('explain: where A has moved out, contact features coincide', plain, {}, async (page) => {
  const slider = page.locator('#what input[type=range]').first();
  const gap = () => page.evaluate(() => globalThis.fathom.contact().gap);
  const before = await gap();
  await slider.focus();
  await slider.press('End');
  assert.equal((await chosen(page)).moved, 1, 'law: the slider moves A out');
  const after = await gap();
  const { value } = await page.evaluate(() => globalThis.fathom.data.depth.depth);
  assert.ok(Math.abs(before - value) < 1e-4 * value, `law: at 0 the contact features are as far apart as A is deep (${before}, ${value})`);
  assert.ok(Math.abs(after) < 1e-4 * value, `law: at 1 those of A lie on those of B (${after})`);
});

for (const [name, page] of Object.entries(looks))
  onPage(`explain ${name} without scripts: the answer, the facts and the bodies`, page, { javaScriptEnabled: false }, async (open) => {
    assert.match(await open.locator('#answer').innerText(), /^A overlaps B|^A and B|^The bounds/, 'law: the answer is there');
    assert.ok((await open.locator('#facts').innerText()).length > 60, 'law: the facts are there');
    assert.ok(await open.locator('#what .scene svg').first().isVisible(), 'law: a picture of the bodies is there');
    for (const each of await open.locator('main > section:not(#what):not(#left-out), nav').all())
      assert.equal(await each.isVisible(), false, 'law: what only scripts fill is not seen, and not referred to');
    await fits(open);
  });

onPage('explain: all facets of P can be listed', plain, {}, async (page) => {
  const { length } = await page.evaluate(() => globalThis.fathom.data.facets);
  const rows = page.locator('#ranked tr[data-facet]');
  assert.ok(await rows.count() < length, 'at first the nearest ones');
  await page.getByRole('button', { name: 'list all' }).click();
  assert.equal(await rows.count(), length, 'law: then all of them');
  await page.evaluate((facet) => globalThis.fathom.select({ facet }), length - 1);
  assert.equal(await rows.last().locator('button').getAttribute('aria-pressed'), 'true', 'law: the farthest can be chosen');
  await rows.first().click();
  assert.equal(await rows.first().locator('button').getAttribute('aria-pressed'), 'true', 'law: and so can the one under the pointer');
});

onPage('explain: keys', ties, {}, async (page) => {
  const { order, count } = await page.evaluate(() => ({ order: globalThis.fathom.data.order, count: globalThis.fathom.data.optima.length }));
  await page.keyboard.press('j');
  assert.equal((await chosen(page)).pair, order[0], 'law: j chooses the first pair');
  await page.keyboard.press('j');
  assert.equal((await chosen(page)).pair, order[1], 'law: j chooses the next pair');
  await page.keyboard.press('k');
  assert.equal((await chosen(page)).pair, order[0], 'law: k goes back');
  await page.keyboard.press('Escape');
  assert.equal((await chosen(page)).pair, null, 'law: Esc chooses nothing');
  for (const [i, id] of ['what', 'why', 'where', 'coincided', 'cost'].entries()) {
    await page.keyboard.press(`${i + 1}`);
    const shown = await page.evaluate((section) => document.getElementById(section).contains(document.activeElement), id);
    assert.ok(shown, `law: ${i + 1} goes to ${id}`);
  }
  assert.ok(count > 1);
  await page.keyboard.press('ArrowRight');
  assert.equal((await chosen(page)).optimum, 1, 'law: the right arrow goes to the next optimum');
  await page.keyboard.press('ArrowLeft');
  assert.equal((await chosen(page)).optimum, 0, 'law: the left arrow goes back');
});

onPage('explain: the address holds what was chosen', fans, {}, async (page) => {
  await page.evaluate(() => globalThis.fathom.select({ pair: globalThis.fathom.data.order[1], facet: 2, hemisphere: 'upper' }));
  const before = await chosen(page);
  const lit = await page.evaluate(() => globalThis.fathom.lit());
  assert.match(page.url(), /#.*pair=\d+/, 'law: the choice stands in the address');
  await page.reload();
  assert.deepEqual(await chosen(page), before, 'law: the address restores what was chosen');
  assert.deepEqual(await page.evaluate(() => globalThis.fathom.lit()), lit, 'law: and what is lit');
});

onPage('explain: dark, and print in light', plain, { colorScheme: 'dark' }, async (page) => {
  const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/[\d.]+/g).map(Number));
  assert.ok(Math.max(...(await ground()).slice(0, 3)) < 80, 'law: in dark mode the page is dark');
  await prints(page);
  await page.emulateMedia({ media: 'print' });
  const printed = await ground();
  assert.ok(printed[3] === 0 || Math.min(...printed.slice(0, 3)) > 200, `law: print is light (${printed})`);
});

for (const width of [390, 1280])
  onPage(`explain without WebGL at ${width} pixels`, fans, { width, flags: withoutWebGl }, async (page) => {
    for (const place of ['#what .scene svg', '#where .chart svg', '#ranked table', '#pairs table', '#why .no-webgl', '#where .sphere .no-webgl'])
      assert.ok(await page.locator(place).first().isVisible(), `law: without WebGL ${place} remains`);
    assert.ok(await page.locator('#facts').innerText().then((text) => text.length > 100), 'law: without WebGL the facts remain');
    assert.equal(await page.locator('.scene canvas, .sphere canvas').count(), 0, 'law: no empty canvas is left');
    await fits(page);
  });
