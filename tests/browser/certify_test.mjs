// SPDX-License-Identifier: GPL-3.0-or-later
// The page of `fathom certify --html`, of a run with failures of every kind that has pictures, unions among them; and of one in the plane.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { accessible, fathom, fits, inBothLooks, made, onPage, prints, root } from './lib.mjs';

const subject = `${process.env.PYTHON ?? 'python3'} ${root}/examples/data/mine`;
let written;

/** A run over the examples and a family each that the boxes around bodies are right and wrong about. */
function certified() {
  if (written) return written;
  const families = ['boxes_aligned', 'random_ball', 'polygon_solid', 'combs', 'keys'];
  const more = families.map((family) => fathom(['cases', '--family', family, '--count', '6'])).join('');
  const cases = made('cases.jsonl', more);
  written = made('page.html');
  fathom(['certify', '--subject', subject, '--html', written, cases], { ends: [1] });
  return written;
}

let flat;

/** The same in the plane: polygons, circles and capsules, of which the boxes' corners are no part. */
function certifiedInPlane() {
  if (flat) return flat;
  const text = readFileSync(join(root, 'examples/data/mine'), 'utf8').replaceAll('range(3)', 'range(2)')
    .replace('"unit": True}}', '"unit": True}, "dimension": 2, "capabilities": {"shapes": ["circle", "capsule", "margin"]}}');
  const program = made('mine_in_plane', text), cases = made('plane.jsonl', fathom(['cases', '--family', 'all', '--plane', '--count', '60']));
  flat = made('plane.html');
  fathom(['certify', '--subject', `${process.env.PYTHON ?? 'python3'} ${program}`, '--html', flat, cases], { ends: [1] });
  return flat;
}

const facts = (page) => page.evaluate(() => ({
  text: document.querySelector('main').textContent.length,
  pictures: document.querySelectorAll('main svg').length,
  rows: document.querySelectorAll('main table tr').length,
}));

inBothLooks('certify', certified, async (page) => {
  await fits(page);
  await accessible(page);
});

inBothLooks('certify in the plane', certifiedInPlane, async (page) => {
  await fits(page);
  await accessible(page);
});

onPage('certify in the plane: each failure is drawn as it is seen from above', certifiedInPlane, {}, async (page) => {
  const articles = await page.locator('article').count(), figures = page.locator('article figure');
  assert.ok(articles > 5, `law: there are failures (${articles})`);
  assert.equal(await figures.count(), articles, 'law: each has a picture');
  for (const desc of await page.locator('article svg desc').allTextContents()) assert.match(desc, /in the plane: x to the right, y up/);
  const captions = await page.locator('article figcaption').allTextContents();
  assert.ok(captions.some((text) => /thick: the edges in contact; dashed arrow: the translation of A that is claimed/.test(text)), captions[0]);
  assert.ok(captions.every((text) => !/hidden edges|faces/.test(text)), 'law: a plane hides nothing');
  const shapes = await page.locator('article svg title').allTextContents();
  for (const kind of ['Hulls of', 'Shapes of']) assert.ok(shapes.some((text) => text.startsWith(kind)), kind);
  assert.equal(await page.locator('article button').count(), articles, 'law: each case can be copied, of round bodies too');
  assert.doesNotMatch(await page.locator('article dl').first().textContent(), /\([^()]*,[^()]*,[^()]*\)/, 'law: no point has a z');
});

onPage('certify: pictures and tables', certified, {}, async (page) => {
  const { pictures, rows } = await facts(page);
  assert.ok(pictures > 3, `law: failures have pictures (${pictures})`);
  assert.ok(rows > 3, `law: verdicts are counted in tables (${rows} rows)`);
  const loose = await page.evaluate(() => [...document.querySelectorAll('a[href^="#"]')].map((a) => a.getAttribute('href').slice(1))
    .filter((id) => !document.getElementById(decodeURIComponent(id))));
  assert.deepEqual(loose, [], 'law: each link leads to a place of the page');
  const empty = await page.evaluate(() => [...document.querySelectorAll('main svg')].filter((e) => !e.getBBox().width).length);
  assert.equal(empty, 0, 'law: no picture is empty');
});

onPage('certify without scripts', certified, { javaScriptEnabled: false }, async (page) => {
  const { pictures, rows } = await facts(page);
  assert.ok(pictures > 3 && rows > 3, `law: without scripts pictures and tables remain (${pictures}, ${rows})`);
  await fits(page);
});

onPage('certify in print', certified, { colorScheme: 'dark' }, async (page) => {
  await prints(page);
  await page.emulateMedia({ media: 'print' });
  const ground = await page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/[\d.]+/g).map(Number));
  assert.ok(ground[3] === 0 || Math.min(...ground.slice(0, 3)) > 200, `law: print is light (${ground})`);
});
