// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of verify/survey, of a small survey: the index with its filter and map, and the page of a cell.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { accessible, fathom, fits, inBothLooks, made, onPage, prints, root } from './lib.mjs';

const program = process.env.FATHOM_EXECUTABLE;
const there = fathom(['certify', '--list-adapters']).split('\n').filter((line) => line && !line.endsWith('; not built'))
  .map((line) => line.split(' ')[0]).filter((name) => /^(libccd|bullet)/.test(name));
let index;

function python(script, words) {
  const done = spawnSync(process.env.PYTHON ?? 'python3', ['-B', join(root, 'verify/survey', script), '--fathom', program, ...words],
    { encoding: 'utf8' });
  assert.equal(done.status, 0, done.stderr);
}

/** The index of a survey of some libraries on the real cases, one case of each family, and shapes. */
function surveyed() {
  if (index) return index;
  const folder = dirname(made('results.json'));
  python('survey.py', ['--adapters', there.join(','), '--sets', 'real,20,primitives', '--count', '20=92', '--count', 'primitives=7',
    '--work', folder, '--out', folder]);
  python('page.py', ['--results', join(folder, 'results.json'), '--out', join(folder, 'page')]);
  return (index = join(folder, 'page', 'index.html'));
}

/** The page of the first family of which a case fails. */
function cell() {
  const folder = join(dirname(surveyed()), 'cells', '20');
  return join(folder, readdirSync(folder).find((name) => name.endsWith('.html')));
}

const skip = there.length === 0;
const on = (...words) => (skip ? undefined : onPage(...words));

for (const [name, file] of skip ? [] : [['survey', surveyed], ['a cell of the survey', cell]])
  inBothLooks(name, file, async (page) => {
    await fits(page);
    await accessible(page);
  });

const shown = (page) => page.evaluate(() => [...document.querySelectorAll('section.set')].filter((e) => e.offsetParent).map((e) => e.id));

on('survey: sets are chosen by keys alone, without scripts', surveyed, { javaScriptEnabled: false }, async (page) => {
  await page.focus('#set-real');
  await page.keyboard.press('ArrowRight');
  assert.equal(await page.isVisible('#of-20'), true, 'law: the next set is shown');
  assert.equal(await page.isVisible('#of-real'), false, 'law: and the other hidden');
  const numbers = await page.locator('#of-20 table.bars tbody tr:visible').allInnerTexts();
  assert.equal(numbers.length, there.length, 'law: each subject has a row');
  for (const text of numbers) {
    const counts = text.replace(/^.*\n?.*?\s(?=\d+\s*(?:\t|$))/, '').match(/\b\d+\b/g).map(Number);
    assert.ok(counts.length > 0, text);
  }
});

on('survey: a cell opens the worst case, with its picture', surveyed, {}, async (page) => {
  assert.deepEqual(await shown(page), ['of-real'], 'law: one set is shown at first');
  await page.locator('#of-real table.map td a').first().click();
  const picture = page.locator('article img').first();
  assert.ok(await picture.evaluate((e) => e.complete && e.naturalWidth > 100), 'law: the picture is drawn');
  await page.locator('summary').first().click();
  const text = await page.locator('article pre').first().innerText();
  assert.match(text, /^cat > case.jsonl <<'END'\n\{.*\}\nEND\nfathom depth .* case.jsonl\nfathom certify --adapter /);
});

on('survey in print', surveyed, { colorScheme: 'dark' }, async (page) => {
  await prints(page);
  await page.emulateMedia({ media: 'print' });
  assert.deepEqual(await shown(page), ['of-real', 'of-20', 'of-primitives'], 'law: paper has every set');
});
