// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of `fathom study --html`, of one case and of a stream of polytopes and shapes: they fit, can be read by all, print, say the numbers
// of `study --json`, and light the features of a row.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { accessible, fathom, fits, inBothLooks, made, onPage, prints, root, shadows } from './lib.mjs';

const known = new Map();

/** {page, studies}: the page of these inputs, and what --json says beside it. Made once. */
function studied(name, words) {
  if (!known.has(name)) {
    const page = made(`${name}.html`);
    const studies = fathom(['study', '--json', '--html', page, ...words]).trim().split('\n').map((line) => JSON.parse(line));
    known.set(name, { page, studies });
  }
  return known.get(name);
}

const one = () => studied('one', ['tests/data/cube.off', 'tests/data/icosahedron.off']);
function stream() {
  const drawn = ['boxes_aligned', 'crossed_fans', 'contact_edge_edge'].map((family) => fathom(['cases', '--family', family, '--count', '2'])).join('');
  const shapes = readFileSync(join(root, 'docs/gallery/cases.jsonl'), 'utf8').split('\n').filter((line) => line.includes('"cylinder"')).join('\n');
  return studied('stream', [made('stream.jsonl', `${drawn}${shapes}\n`)]);
}

for (const [name, make] of [['a study', one], ['studies', stream]])
  inBothLooks(name, () => make().page, async (page, width) => {
    const unfold = (open) => page.evaluate((is) => document.querySelectorAll('details').forEach((each) => { each.open = is; }), open);
    for (const open of [false, true]) {
      await unfold(open);
      await fits(page);
      await accessible(page);
    }
    assert.ok((await shadows(page)) || width > 390, 'law: on a phone the tables scroll');
  });

const spoken = (name) => name.replaceAll('_', ' ').replace(/ of ([ab])$/, (_, body) => ` of ${body.toUpperCase()}`);

/** What a part of the page says of one case: counts by name, the rows of its predicates, and its facts. */
const said = (part) => part.evaluate((e) => {
  const text = (node) => node.textContent.trim();
  const facts = [...e.querySelector('dl').children].map(text);
  return {
    facts: Object.fromEntries(facts.flatMap((word, i) => (i % 2 ? [] : [[word, facts[i + 1]]]))),
    counts: Object.fromEntries([...e.querySelectorAll('ul.legend li')].map((li) => [text(li.querySelector('a')), Number(text(li.querySelector('b')))])),
    predicates: [...e.querySelectorAll('[aria-label="What the perturbation decided"] tbody tr')].map((row) => [...row.children].map(text).slice(0, 4)),
  };
});

function compare(shown, study) {
  const counts = Object.entries(study.coincidences).filter(([, { count }]) => count > 0).map(([kind, { count }]) => [spoken(kind), count]);
  for (const [kind, count] of counts) assert.equal(shown.counts[kind], count, `law: the count of ${kind} in ${study.id} is that of study --json`);
  if (!study.bodies?.a?.vertices || !study.predicates) return;
  assert.equal(Object.keys(shown.counts).length, counts.length, 'law: nothing else is counted');
  assert.deepEqual(shown.predicates, Object.entries(study.predicates).map(([name, { calls, exact, zero }]) => [spoken(name), `${calls}`, `${exact}`, `${zero}`]),
    `law: the calls in ${study.id} are those of study --json`);
  assert.equal(shown.facts.status, study.status);
  if (study.status === 'penetrating') assert.equal(shown.facts['depth^2'], study.squared, `law: the depth of ${study.id} is that of study --json`);
}

onPage('the numbers of a study', () => one().page, {}, async (page) => compare(await said(page.locator('main')), one().studies[0]));

onPage('the numbers of studies, without scripts', () => stream().page, { javaScriptEnabled: false }, async (page) => {
  const { studies } = stream(), parts = page.locator('#list > details');
  assert.equal(await parts.count(), studies.length, 'law: each case has a part');
  for (const [i, study] of studies.entries()) {
    assert.ok((await parts.nth(i).locator('summary').first().textContent()).includes(study.id));
    compare(await said(parts.nth(i)), study);
    assert.ok(await parts.nth(i).locator('svg').count(), 'law: each case has a picture');
  }
});

onPage('a study: a row lights its features', () => one().page, {}, async (page) => {
  const row = page.locator('tr[data-lights]').first();
  const lit = () => row.evaluate((e) => e.dataset.lights.split(' ').map((id) => {
    const { stroke, opacity, display, visibility } = getComputedStyle(document.getElementById(id));
    return [stroke, opacity, display, visibility].join();
  }));
  const before = await lit();
  await row.scrollIntoViewIfNeeded();
  await row.hover();
  assert.notDeepEqual(await lit(), before, 'law: the features of the row under the pointer are seen in the picture');
});

onPage('studies: the filter leaves what it is asked for', () => stream().page, {}, async (page) => {
  const shown = () => page.evaluate(() => [...document.querySelectorAll('#list > details')].filter((e) => e.offsetParent).map((e) => e.textContent));
  const all = (await shown()).length;
  await page.locator('main input[type=search], main input[type=text]').first().fill('crossed_fans');
  const found = await shown();
  assert.ok(found.length > 0 && found.length < all, `law: some cases are left (${found.length} of ${all})`);
  for (const text of found) assert.ok(text.includes('crossed_fans'), 'law: those that have the text');
});

onPage('studies in print', () => stream().page, { colorScheme: 'dark' }, async (page) => {
  await prints(page);
  await page.emulateMedia({ media: 'print' });
  const ground = await page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/[\d.]+/g).map(Number));
  assert.ok(ground[3] === 0 || Math.min(...ground.slice(0, 3)) > 200, `law: print is light (${ground})`);
});
