// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of `fathom study --html`: of two bodies it opens at what coincided, and says the numbers of `study --json`; of a stream it is a
// table that fits, can be read by all, is filtered, and prints.
import assert from 'node:assert/strict';
import { accessible, cases, fathom, fits, inBothLooks, made, onPage, prints, shadows } from './lib.mjs';

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

const meshes = () => studied('meshes', ['tests/data/cube.off', 'tests/data/icosahedron.off']);
const capsule = () => studied('capsule', ['capsule:r=1/4,h=2', 'tests/data/cube.off']);
const cylinder = () => studied('cylinder', ['cylinder:r=1,h=1,at=0:0:2', 'box:half=4:4:1']);
function stream() {
  const drawn = ['boxes_aligned', 'crossed_fans', 'contact_edge_edge'].map((family) => fathom(['cases', '--family', family, '--count', '2'])).join('');
  const shapes = cases('docs/gallery/cases.jsonl').map((line) => JSON.stringify(line)).filter((line) => line.includes('"cylinder"')).join('\n');
  return studied('stream', [made('stream.jsonl', `${drawn}${shapes}\n`)]);
}

const spoken = (name) => name.replaceAll('_', ' ').replace(/ of ([ab])$/, (_, body) => ` of ${body.toUpperCase()}`);
const present = ({ coincidences }) => Object.entries(coincidences).filter(([, { count }]) => count > 0);
const where = (page) => page.evaluate(() => [location.hash, Math.abs(document.getElementById('coincided').getBoundingClientRect().top)]);

for (const [name, make] of Object.entries({ meshes, capsule, cylinder }))
  onPage(`a study of ${name} opens at what coincided`, () => make().page, {}, async (page) => {
    const [study] = make().studies, section = page.locator('#coincided');
    const [hash, top] = await where(page);
    assert.equal(hash, '#section=4');
    assert.ok(top < 2, `law: the section is at the top of the window (${top})`);
    const shown = await section.locator('.kind h3').evaluateAll((all) => all.map((e) => [e.firstChild.textContent, Number(e.querySelector('.count').textContent)]));
    const kinds = [...present(study), ...(study.cores ? present(study.cores) : [])];
    assert.deepEqual(shown, kinds.map(([kind, { count }]) => [spoken(kind), count]), 'law: the counts are those of study --json');
    const rows = await section.locator('table tbody tr').evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent).slice(0, 4)));
    const asked = (study.cores ?? study).predicates ?? {};
    assert.deepEqual(rows, Object.entries(asked).map(([predicate, { calls, exact, zero }]) => [spoken(predicate), `${calls}`, `${exact}`, `${zero}`]));
    for (const [, { listed }] of present(study))
      for (const { a } of listed.filter(({ a: { direction } }) => direction).slice(0, 3))
        assert.ok((await section.textContent()).includes(`${a.feature} (${a.direction.join(', ')})`), 'law: features of shapes are named');
  });

onPage('a study: the address says otherwise', () => meshes().page, { hash: '#section=1' }, async (page) => assert.equal((await where(page))[0], '#section=1'));

inBothLooks('studies', () => stream().page, async (page, width) => {
  await fits(page);
  await accessible(page);
  assert.ok((await shadows(page)) || width > 390, 'law: on a phone the tables scroll');
});

onPage('studies without scripts', () => stream().page, { javaScriptEnabled: false }, async (page) => {
  const rows = await page.locator('#list > tr').evaluateAll((all) => all.map((row) => row.textContent));
  assert.equal(rows.length, stream().studies.length, 'law: each case has a row');
  for (const [i, study] of stream().studies.entries())
    for (const text of [study.id, study.status, ...present(study).map(([kind, { count }]) => `; ${spoken(kind)}: ${count}`)])
      assert.ok(rows[i].includes(text), `law: ${text} is in ${rows[i]}`);
});

onPage('studies: the filter leaves what it is asked for', () => stream().page, {}, async (page) => {
  const shown = () => page.evaluate(() => [...document.querySelectorAll('#list > tr')].filter((e) => e.offsetParent).map((e) => e.textContent));
  const all = (await shown()).length;
  await page.locator('main input[type=search]').fill('crossed_fans');
  assert.ok((await shown()).length < all && (await shown()).every((text) => text.includes('crossed_fans')), 'law: those that have the text');
  const total = page.locator('a[data-find]').first(), kind = await total.textContent();
  await total.click();
  assert.ok((await shown()).length > 0 && (await shown()).every((text) => text.includes(`; ${kind}:`)), 'law: a total leads to its cases');
});

onPage('studies in print', () => stream().page, { colorScheme: 'dark' }, async (page) => {
  await prints(page);
  await page.emulateMedia({ media: 'print' });
  const ground = await page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/[\d.]+/g).map(Number));
  assert.ok(ground[3] === 0 || Math.min(...ground.slice(0, 3)) > 200, `law: print is light (${ground})`);
});
