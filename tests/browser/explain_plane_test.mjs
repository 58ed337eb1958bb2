// SPDX-License-Identifier: GPL-3.0-or-later
// The page of `fathom explain` about bodies of the plane: they are seen from +z and do not turn, the axes are named, and A moves until it touches.
import assert from 'node:assert/strict';
import { accessible, colours, fathom, fits, inBothLooks, made, onPage, withoutWebGl } from './lib.mjs';

const square = { vertices: [[0, 0], [3, 0], [3, 3], [0, 3]] };
const lines = {
  polygons: { a: square, b: { vertices: [[2, 1], [5, 0], [5, 4], [2.5, 3.5]] } },
  ties: { a: square, b: square },
  round: { a: { shape: 'capsule', radius: '1/2', half_length: 2 }, b: { vertices: [[1, 0], [3, 1], [2, 2]], margin: '1/4' } },
  apart: { a: square, b: { shape: 'circle', radius: 1, pose: { translation: [6, 1] } } },
  touching: { a: square, b: { vertices: [[3, 1], [4, 0], [4, 2]] } },
  union: { a: { vertices: [[0.75, -1], [1.75, -1], [1.75, 1], [0.75, 1]] },
    b: { pieces: [[[-9, -5], [0, -5], [0, 5], [-9, 5]], [[1, -5], [10, -5], [10, 5], [1, 5]]] } },
  halfplane: { a: square, b: { shape: 'halfplane', normal: [1, 2], offset: 3 } },
};
const known = new Map();

/** {page, depth} of a case. Made once. */
function explained(name) {
  if (!known.has(name)) {
    const file = made(`${name}.jsonl`, `${JSON.stringify({ schema: 'fathom/case/1', id: name, dimension: 2, ...lines[name] })}\n`);
    const page = file.replace(/\.jsonl$/, '.html');
    fathom(['explain', file, '-o', page]);
    known.set(name, { page, depth: JSON.parse(fathom(['depth', file, '--json'])) });
  }
  return known.get(name);
}

for (const name of Object.keys(lines))
  inBothLooks(`plane ${name}`, () => explained(name).page, async (page) => {
    assert.equal(await page.evaluate(() => document.documentElement.dataset.ready), 'yes', 'law: the page starts');
    assert.deepEqual(await page.getByText('could not start').allTextContents(), [], 'law: every part of the page starts');
    assert.equal(await page.locator('main > section').count(), 2, 'law: what happens, and what is left out');
    await fits(page);
    await accessible(page);
  });

for (const name of ['polygons', 'ties', 'round', 'union'])
  onPage(`plane ${name}: flat, named axes, and no turning`, () => explained(name).page, {}, async (page) => {
    const canvas = '#what .scene canvas', label = await page.locator(canvas).getAttribute('aria-label');
    assert.match(label, /in the plane/);
    assert.deepEqual(await page.locator('.word.of-axis').allTextContents(), ['x', 'y']);
    const ends = () => page.locator('.word.of-axis').evaluateAll((all) => all.map((e) => [parseFloat(e.style.left), parseFloat(e.style.top)]));
    const before = await ends(), [x, y] = before;
    assert.ok(x[0] > y[0] && x[1] > y[1], `law: x points right, and y up (${before})`);
    assert.equal(await page.getByRole('button', { name: 'along n' }).count(), 0);
    await page.locator(canvas).scrollIntoViewIfNeeded();
    const { count } = await colours(page, canvas), { x: left, y: top, width, height } = await page.locator(canvas).boundingBox();
    assert.ok(count > 10, `law: there is a picture (${count} colours)`);
    await page.mouse.move(left + width / 2, top + height / 2);
    await page.mouse.down();
    await page.mouse.move(left + width / 2 + 80, top + height / 2 + 30, { steps: 4 });
    await page.mouse.up();
    await page.keyboard.press('Shift+ArrowLeft');
    await page.evaluate(() => new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); }));
    assert.deepEqual(await ends(), before, 'law: a plane turns neither under the pointer nor by keys');
    await page.keyboard.press('+');
    await page.evaluate(() => new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); }));
    assert.notDeepEqual(await ends(), before, 'law: it zooms');
  });

for (const name of ['polygons', 'ties', 'union', 'touching'])
  onPage(`plane ${name}: once A has moved, what touches coincides`, () => explained(name).page, {}, async (page) => {
    const { depth } = explained(name), gaps = (moved) => page.evaluate((share) => {
      globalThis.fathom.select({ moved: share });
      return globalThis.fathom.contact().gaps;
    }, moved);
    for (const gap of await gaps(1)) assert.ok(Math.abs(gap) < 1e-6, `law: at 1 the features of A lie on those of B (${gap})`);
    if (depth.status === 'penetrating') assert.ok((await gaps(0)).some((gap) => Math.abs(gap) > 1e-3), 'law: at 0 they do not');
  });

onPage('plane: vertices and edges are named', () => explained('polygons').page, {}, async (page) => {
  assert.equal(await page.locator('#facts [data-field=contact]').textContent(), 'edge-vertex: A at 1, 2, B at 0');
  assert.match(await page.locator('#what .scene canvas').getAttribute('aria-label'), /A's edge 1 2 meets B's vertex 0/);
  assert.match(await page.locator('#what .legend').innerText(), /vertices and edges that meet are thick/);
  assert.equal(await page.locator('#facts [data-field=unit]').textContent(), '(-1, 0)');
});

for (const name of Object.keys(lines))
  onPage(`plane ${name}: a picture stands still`, () => explained(name).page, { flags: withoutWebGl, javaScriptEnabled: false }, async (page) => {
    assert.ok(await page.locator('#what .scene svg').first().isVisible(), 'law: a picture of the bodies remains');
    assert.match(await page.locator('figcaption').first().textContent(), /seen from \+z: x to the right, y up/);
    assert.ok((await page.locator('#facts').innerText()).length > 60, 'law: the facts remain');
  });
