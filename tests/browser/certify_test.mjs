// SPDX-License-Identifier: GPL-3.0-or-later
// The page of `fathom certify --html`, of a run with failures of every kind that has pictures, unions among them.
import assert from 'node:assert/strict';
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

const facts = (page) => page.evaluate(() => ({
  text: document.querySelector('main').textContent.length,
  pictures: document.querySelectorAll('main svg').length,
  rows: document.querySelectorAll('main table tr').length,
}));

inBothLooks('certify', certified, async (page) => {
  await fits(page);
  await accessible(page);
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
