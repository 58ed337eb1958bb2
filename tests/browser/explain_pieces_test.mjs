// SPDX-License-Identifier: GPL-3.0-or-later
// The page of `fathom explain --pieces`, of unions, and `--solid`: it shows, turns, moves A until pieces touch, steps through optima, lights pieces, fits, prints,
// can be read by all, and every number is one of `depth --pieces --patch --json`.
import assert from 'node:assert/strict';
import { statSync } from 'node:fs';
import test from 'node:test';
import { numbersOfPatches } from './explained.mjs';
import { accessible, colours, fathom, fits, inBothLooks, made, onPage, prints, withoutWebGl } from './lib.mjs';

const faces = [[1, 3, 4, 2], [5, 6, 8, 7], [1, 2, 6, 5], [3, 7, 8, 4], [1, 5, 7, 3], [2, 4, 8, 6]];
const box = (low, high) => [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [0, 1, 2].map((axis) => (i >> axis & 1 ? high : low)[axis]));
const obj = (...boxes) => boxes.map(([low, high], k) => [`o piece_${k}`, ...box(low, high).map((p) => `v ${p.join(' ')}`),
  ...faces.map((face) => `f ${face.map((v) => v + 8 * k).join(' ')}`)].join('\n')).join('\n') + '\n';
const row = (count) => obj(...Array.from({ length: count }, (_, i) => [[i, -2, -2], [i + 1, 3, 3]]));

const known = new Map();

/** {page, depth, stages} of two files, or of two texts of OBJ. Made once. */
function explained(name, a, b, words = ['--pieces']) {
  if (!known.has(name)) {
    const file = (text, end) => (text.includes('\n') ? made(`${name}-${end}.obj`, text) : text);
    const [of_a, of_b] = [file(a, 'a'), file(b, 'b')], page = made(`${name}.html`);
    fathom(['explain', ...words, of_a, of_b, '-o', page]);
    known.set(name, { page, depth: JSON.parse(fathom(['depth', ...words, '--patch', '--json', of_a, of_b])) });
  }
  return known.get(name);
}

const all = {
  key: () => explained('key', 'tests/data/key.obj', 'tests/data/comb.obj'),
  ties: () => explained('ties', obj([[-1, -1, -1], [1, 1, 1]]), obj([[-9, -9, -2], [9, 9, 0]], [[-9, -9, 0], [9, 9, 2]])),
  fit: () => explained('fit', obj([[0.75, -1, -1], [1.75, 1, 1]]), obj([[-9, -5, -5], [0, 5, 5]], [[1, -5, -5], [10, 5, 5]])),
  touching: () => explained('touching', obj([[0, 0, 0], [1, 1, 1]], [[1, 0, 0], [2, 1, 1]]), obj([[2, 0, 0], [3, 1, 1]])),
  apart: () => explained('apart', obj([[0, 0, 0], [1, 1, 1]]), obj([[9, 0, 0], [10, 1, 1]], [[3, 0, 0], [4, 1, 1]])),
  many: () => explained('many', obj([[0, 0, 0], [1, 1, 1]], [[1, 0, 0], [2, 1, 1]]), row(60)),
};

/** Closed meshes of the gallery. */
const solid = (name, a, b, pose) => () =>
  explained(name, `docs/gallery/${a}.off`, `docs/gallery/${b}.off`, ['--solid', '--exact-decimals', '--pose-a', pose]);
const meshes = {
  rings: solid('rings', 'ring', 'ring', 'xyz=6.5,0,0.25 rpy=80,0,0deg'),
  mug: solid('mug', 'spoon', 'mug', 'xyz=-1.25,1.9,0 rpy=0,0,55deg'),
  sponge: solid('sponge', 'sponge', 'sponge', 'xyz=4/3,1,3/2'),
};
for (const [name, make] of Object.entries(meshes))
  test(`the page of the ${name} is small`, () => assert.ok(statSync(make().page).size < 1e6, 'law: a megabyte holds a small scene'));

async function started(page) {
  assert.equal(await page.evaluate(() => document.documentElement.dataset.ready), 'yes', 'law: the page starts');
  assert.deepEqual(await page.getByText('could not start').allTextContents(), [], 'law: every part of the page starts');
}

for (const [name, make] of Object.entries({ ...all, ...meshes }))
  inBothLooks(`pieces ${name}`, () => make().page, async (page) => {
    await started(page);
    await fits(page);
    await accessible(page);
    assert.match(await page.locator('#left-out').innerText(), /stages of the algorithm/, 'law: what is left out is said');
  });

onPage('pieces: the case is there to take along, and has the same answer', () => all.key().page, {}, async (page) => {
  assert.equal(await page.getByRole('button', { name: 'Copy this case' }).count(), 1);
  const taken = made('taken.jsonl', await page.locator('#case').textContent());
  assert.deepEqual(JSON.parse(fathom(['depth', '--json', taken])).optima, all.key().depth.optima);
});

onPage('pieces: the canvas shows a picture, and turns', () => all.key().page, {}, async (page) => {
  for (const scene of ['#what .scene canvas', '#why .scene canvas']) {
    await page.locator(scene).scrollIntoViewIfNeeded();
    const before = await colours(page, scene);
    assert.ok(before.count > 40, `law: ${scene} has many colours (${before.count})`);
    const { x, y, width, height } = await page.locator(scene).boundingBox();
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + width / 2 + 80, y + height / 2 + 30, { steps: 4 });
    await page.mouse.up();
    await page.mouse.move(1, 1);
    assert.ok(!before.picture.equals((await colours(page, scene)).picture), `law: ${scene} turns under the pointer`);
  }
});

for (const name of ['key', 'ties', 'fit', 'apart'])
  onPage(`pieces ${name}: where A has moved, what touches coincides, at every optimum`, () => all[name]().page, {}, async (page) => {
    const { optima, apart } = all[name]().depth;
    for (let i = 0; i < Math.max(1, optima.length); ++i) {
      const gaps = (moved) => page.evaluate(([optimum, share]) => {
        globalThis.fathom.select({ optimum, moved: share });
        return globalThis.fathom.contact().gaps;
      }, [i, moved]);
      const after = await gaps(1), scale = 1e-9 * 20;
      assert.equal(after.length, apart ? 1 : optima[i].contacts.length, 'law: each pair of pieces that touches has its features');
      for (const gap of after) assert.ok(Math.abs(gap) < scale, `law: at 1 the features of A lie on those of B (${after})`);
      assert.ok((await gaps(0)).some((gap) => Math.abs(gap) > 1e-3), 'law: at 0 they do not');
    }
  });

onPage('pieces: the stepper goes through the optima', () => all.ties().page, {}, async (page) => {
  const { optima } = all.ties().depth, decimals = (optimum) => `(${optimum.translation.map((x) => `${Number(x)}`).join(', ')})`;
  const shown = () => page.locator('#facts [data-field=translation]').textContent();
  const first = await shown();
  await page.getByRole('button', { name: 'next optimum' }).click();
  assert.equal(await shown(), decimals(optima[1]), 'law: the facts are those of the second optimum');
  assert.equal(await page.locator('#contacts [data-contact]').count(), optima[1].contacts.length);
  assert.match(page.url(), /optimum=1/, 'law: the choice stands in the address');
  await page.reload();
  assert.equal(await shown(), decimals(optima[1]), 'law: the address restores it');
  await page.keyboard.press('ArrowLeft');
  assert.equal(await shown(), first, 'law: and back');
});

onPage('pieces: a pair lights its two pieces and its differences', () => all.key().page, {}, async (page) => {
  const found = await page.evaluate(() => globalThis.fathom.data.pairs.map((pair, i) => {
    globalThis.fathom.select({ pair: i });
    const { bodies, blocks } = globalThis.fathom.lit();
    return { bodies: bodies.map(([body, edge]) => `${body}${edge}`).sort(), expected: [...pair.a.map((e) => `a${e}`), ...pair.b.map((e) => `b${e}`)].sort(), blocks };
  }));
  assert.ok(found.length > 2);
  for (const { bodies, expected, blocks } of found) {
    assert.deepEqual(bodies, expected, 'law: the edges of both pieces are lit, and no others');
    assert.equal(blocks, 1, 'law: their differences are lit');
  }
  await page.evaluate(() => globalThis.fathom.select({ pair: null }));
  const button = page.locator('#sums tr[data-pair] button').nth(1);
  await button.click();
  assert.equal(await button.getAttribute('aria-pressed'), 'true');
  assert.equal(await page.evaluate(() => globalThis.fathom.selection().pair), 1, 'law: a row chooses its pair');
  await page.keyboard.press('Escape');
  assert.equal(await page.evaluate(() => globalThis.fathom.selection().pair), null);
});

const numbers = (text) => text.match(/(?<![\w.])-?\d+(?:\.\d+)?(?:e[+-]?\d+)?(?![\w])/g) ?? [];

for (const [name, make] of Object.entries(all))
  for (const javaScriptEnabled of [true, false])
    onPage(`pieces ${name}: numbers, scripts ${javaScriptEnabled ? 'on' : 'off'}`, () => make().page, { javaScriptEnabled, flags: withoutWebGl }, async (page) => {
      const { depth } = make(), answers = new Set(numbers(JSON.stringify(depth)).map(Number)), value = (x) => x.split('/').reduce((p, q) => p / q);
      for (const text of JSON.stringify(depth).match(/"-?\d+(\/\d+)?"/g) ?? []) answers.add(Number(value(JSON.parse(text))));
      const { pieces } = await page.evaluate(() => ({ pieces: JSON.parse(document.getElementById('stages').textContent) })).then(({ pieces: s }) => ({ pieces: [s.a.length, s.b.length] }));
      for (const each of [...pieces, depth.optima.length, ...depth.optima.keys(), ...depth.optima.map((o) => o.contacts.length), ...numbersOfPatches(depth)]) answers.add(each);
      for (const part of ['#answer', '#facts', '#contacts']) {
        const text = await page.locator(part).evaluate((e) => [...e.querySelectorAll('*'), e].filter((x) => !x.children.length).map((x) => x.textContent).join(' ') || e.textContent);
        const foreign = numbers(text).filter((each) => !answers.has(Number(each)) && !answers.has(-Number(each)));
        assert.deepEqual(foreign, [], `law: every number in ${part} is one of depth --pieces --patch --json`);
      }
      if (depth.status !== 'penetrating') return;
      for (const [field, length] of [['depth', depth.depth], ['deepest_pair', depth.deepest_pair.depth], ['hulls', depth.hulls]])
        assert.equal(Number(await page.locator(`#facts [data-field=${field}]`).textContent()), length.value, `law: ${field} is that of depth --pieces --json`);
    });

for (const [what, options] of Object.entries({ WebGL: { flags: withoutWebGl }, scripts: { javaScriptEnabled: false } }))
  for (const width of [390, 1280])
    onPage(`pieces without ${what} at ${width} pixels`, () => all.key().page, { width, ...options }, async (page) => {
      assert.ok(await page.locator('#what .scene svg').first().isVisible(), `law: without ${what} a picture of the bodies remains`);
      assert.ok((await page.locator('#facts').innerText()).length > 60, `law: without ${what} the facts remain`);
      assert.equal(await page.locator('#sums table').count(), what === 'WebGL' ? 1 : 0, 'law: tables are painted by the script');
      assert.equal(await page.locator('#why').isVisible(), what === 'WebGL', 'law: without scripts a section that they fill is not seen');
      assert.equal(await page.locator('.scene canvas').count(), 0, 'law: no empty canvas is left');
      await fits(page);
    });

for (const [name, make] of Object.entries(all))
  onPage(`pieces ${name}: what touches, and the differences of pieces, are listed`, () => make().page, { flags: withoutWebGl }, async (page) => {
    const { depth } = make(), { sums } = await page.evaluate(() => globalThis.fathom.data.stages);
    assert.equal(await page.locator('#contacts tr[data-contact]').count(), depth.apart ? 1 : depth.optima[0].contacts.length,
      'law: a row for each pair of pieces that touches');
    const rows = await page.locator('#sums tr[data-pair]').evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
    assert.deepEqual(rows.map(([a, b, where]) => [Number(a), Number(b), where]),
      sums.slice(0, 200).map(({ pieces, inside, distance_squared: d }) => [...pieces, inside ? 'inside' : d === '0' ? 'on it' : 'outside']),
      'law: a row for each difference, deepest first');
  });

onPage('pieces: many pieces take a bounded number of draw calls', () => all.many().page, {}, async (page) => {
  await started(page);
  const calls = await page.evaluate(() => globalThis.fathom.drawCalls());
  assert.ok(calls > 0 && calls <= 100, `law: a bounded number of draw calls (${calls})`);
});

onPage('pieces in print', () => all.key().page, { colorScheme: 'dark' }, async (page) => {
  await prints(page);
  await page.emulateMedia({ media: 'print' });
  const ground = await page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/[\d.]+/g).map(Number));
  assert.ok(ground[3] === 0 || Math.min(...ground.slice(0, 3)) > 200, `law: print is light (${ground})`);
});
