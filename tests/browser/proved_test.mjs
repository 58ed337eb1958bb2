// SPDX-License-Identifier: GPL-3.0-or-later
// The proved checker as a page (proofs/coq/page): about every certificate of the tests, and more than a thousand forgeries, it shows the lines of
// the program.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import test from 'node:test';
import { accessible, colours, fathom, fits, inBothLooks, made, onPage, prints, root } from './lib.mjs';

const page = process.env.FATHOM_CHECK_PROVED_PAGE, program = process.env.FATHOM_CHECK_PROVED;
const folders = ['tests/data/certificates', 'proofs/coq/examples'];
const certificates = folders.flatMap((folder) => readdirSync(join(root, folder), { recursive: true }).filter((name) => name.endsWith('.cert'))
  .map((name) => join(root, folder, name)));
const certificate = (name) => certificates.find((path) => basename(path) === `${name}.cert`);

/** The lines of the program: it is run in each folder once. */
function linesOf(paths, ...words) {
  const runs = paths.reduce((found, path) => {
    if (found.at(-1)?.cwd !== dirname(path)) found.push({ cwd: dirname(path), names: [] });
    found.at(-1).names.push(basename(path));
    return found;
  }, []);
  return runs.map(({ cwd, names }) => spawnSync(program, [...words, '--', ...names], { cwd, encoding: 'utf8', maxBuffer: 1 << 28 }).stdout).join('');
}

/** The known forgeries as files. */
function known() {
  const folder = dirname(made('forgeries/x'));
  const done = spawnSync(process.env.PYTHON, ['-B', join(root, 'verify/check/score.py'), '--files', folder], { encoding: 'utf8' });
  assert.equal(done.status, 0, done.stderr);
  return readdirSync(folder).filter((name) => name.endsWith('.cert')).sort().map((name) => join(folder, name));
}

/** That many files, each a certificate with one change: a number, a line, the end. */
function random(count) {
  let state = 1;
  const below = (n) => {
    state = (state * 48271) % 2147483647;
    return state % n;
  };
  return Array.from({ length: count }, (_, k) => {
    const lines = readFileSync(certificates[below(certificates.length)], 'latin1').split('\n'), at = below(lines.length);
    const words = lines[at].split(' '), word = below(words.length);
    const changes = [
      () => words.splice(word, 1, ['0', '-1', '7', '1/2', '-3/7', '2147483648', '99999999999999999999', '1/0', 'x'][below(9)]),
      () => words.splice(word, 1, words[word].replace(/\d/, (digit) => (Number(digit) + 1) % 10)),
      () => words.splice(word, below(2), words[below(words.length)]),
    ];
    const others = [() => lines.splice(at, 1), () => lines.splice(at, 0, lines[below(lines.length)]), () => lines.splice(at)];
    const which = below(9);
    if (which < 6) {
      changes[which % 3]();
      lines[at] = words.join(' ');
    } else {
      others[which % 3]();
    }
    return made(`mutant_${k}.cert`, Buffer.from(lines.join('\n'), 'latin1'));
  });
}

/** Does what makes the page judge its files anew, and waits until all of them are judged. */
async function judged(open, act) {
  await open.evaluate(() => document.getElementById('said').replaceChildren());
  await act();
  await open.waitForFunction(() => document.getElementById('said').textContent.startsWith('All is checked'));
}
async function choose(open, files) {
  await open.setInputFiles('#files', []);  // the same files again are no change
  await judged(open, () => open.setInputFiles('#files', files));
}
const shownLines = (open) => open.evaluate(() => [...document.querySelectorAll('.verdict > summary')].map((e) => `${e.textContent}\n`).join(''));

onPage('proved: the lines of every certificate of the tests', page, {}, async (open) => {
  assert.ok(certificates.length > 60, `law: the certificates are found (${certificates.length})`);
  await choose(open, certificates);
  assert.equal(await shownLines(open), linesOf(certificates), 'law: the lines are those of the program');
  await judged(open, () => open.check('#width'));
  assert.equal(await shownLines(open), linesOf(certificates, '--width'), 'law: with --width too');
  await judged(open, () => open.uncheck('#width'));
  await open.evaluate(() => document.querySelectorAll('.verdict.accepted').forEach((e) => { e.open = true; }));
  await open.waitForFunction(() => [...document.querySelectorAll('.verdict.accepted')].every((e) => e.querySelector('svg')));
  const unsaid = await open.evaluate(() => [...document.querySelectorAll('.verdict.accepted')].filter((e) =>
    !/^[A-Z].*\.$/.test(e.querySelector('p').textContent) || /no words|undefined|NaN/.test(e.textContent + e.innerHTML) ||
    !e.querySelector('.outline, .edges')).map((e) => e.textContent.slice(0, 200)));
  assert.deepEqual(unsaid, [], 'law: each accepted line has words and a picture');
});

onPage('proved: more than a thousand forgeries', page, {}, async (open) => {
  const forgeries = [...known(), ...random(700)];
  assert.ok(forgeries.length > 1100, `law: there are more than a thousand (${forgeries.length})`);
  const expected = linesOf(forgeries);
  assert.ok((expected.match(/^s (REFUSED|MALFORMED)/gm) ?? []).length > 1000, 'law: more than a thousand are false');
  await choose(open, forgeries);
  assert.equal(await shownLines(open), expected, 'law: the lines are those of the program');
  const colour = await open.evaluate(() => [...document.querySelectorAll('.verdict')].filter((e) =>
    e.classList.contains('accepted') !== e.textContent.startsWith('s VERIFIED ')).length);
  assert.equal(colour, 0, 'law: what is not verified is not marked as accepted');
});

onPage('proved: a file that is dropped, a long one, and one that replaces it', page, {}, async (open) => {
  const drop = (file, bytes) => open.evaluate(([name, text]) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([text], name));
    document.body.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
  }, [file, bytes]);
  const box = certificate('proved_width'), name = 'a box, größer.cert', nameless = readFileSync(box, 'utf8').replace(/^id .*\n/m, '');
  await judged(open, () => drop(name, nameless));
  assert.equal(await shownLines(open), linesOf([made(name, nameless)]), 'law: a name is written as the program writes it');
  assert.ok(await open.locator('.verdict svg').isVisible(), 'law: one answer alone is open');

  // 100,000 doubled points, and a line of a megabyte: what walks along them runs in constant stack space in the browser too
  const points = (word) => `${word} 100008\n0 0 0\n3 0 0\n0 2 0\n3 2 0\n0 0 1\n3 0 1\n0 2 1\n3 2 1\n${'1/3 1/2 5/7\n'.repeat(100000)}`;
  const long = `fathom-certificate 1\n${points('a')}${points('b')}claim depth 1\ndirections 2 all\n0 0 -1\n0 0 1\nvertices 8\n` +
    '0 7\n1 6\n2 5\n3 4\n4 3\n5 2\n6 1\n7 0\nfacets 6\n4 1 3 7 5\n4 0 4 6 2\n4 2 6 7 3\n4 0 1 5 4\n4 4 5 7 6\n4 0 2 3 1\nend 100008 100008 2 8 6\n';
  const files = [made('long.cert', long), made('wide.cert', `fathom-certificate 1\na 1\n${'1'.repeat(1 << 20)} 0 0\n`)];
  await choose(open, files);
  assert.equal(await shownLines(open), linesOf(files), 'law: the lines of long files are those of the program');
  await open.setInputFiles('#files', files);  // is left while it is being checked
  await choose(open, [box]);
  assert.equal(await shownLines(open), linesOf([box]), 'law: new files replace old ones');
});

test('proved: the theorems that the page names are there', () => {
  const named = [...readFileSync(join(root, 'proofs/coq/page/words.js'), 'utf8').matchAll(/\['(\w+)', '(\S+\.v)', '(\w+)'\]/g)];
  assert.equal(named.length, 11, 'law: the theorems are found');
  for (const [, theorem, file, definition] of named) {
    assert.match(readFileSync(join(root, 'proofs/coq', file), 'utf8'), new RegExp(`^Theorem ${theorem}\\b`, 'm'), `law: ${theorem} is in ${file}`);
    assert.match(readFileSync(join(root, 'proofs/coq/printed.v'), 'utf8'), new RegExp(`^Definition ${definition}\\b`, 'm'), `law: ${definition}`);
  }
});

test('proved: the colours are those of all pages', () => {
  const picture = made('colours.svg');
  fathom(['depth', 'tests/data/cube.off', 'tests/data/icosahedron.off', '--svg', picture]);
  const rules = (path) => readFileSync(path, 'utf8').match(/:root\{color-scheme:[^]*?@media print\{[^]*?\}\}/)[0];
  assert.equal(rules(page), rules(picture), 'law: the colours are those of view/picture');
});

inBothLooks('proved', page, async (open) => {
  await choose(open, [certificate('proved_unions')]);
  await open.locator('.verdict.accepted > summary').first().click();
  await open.locator('.verdict svg').first().waitFor();
  await fits(open);
  await accessible(open);
});

onPage('proved: a picture that turns; the page prints, and sends nothing', page, {}, async (open) => {
  await choose(open, [certificate('penetrating_cubes')]);
  const before = await colours(open, '.verdict svg');
  assert.ok(before.count > 5, `law: the bodies are drawn (${before.count} colours)`);
  await open.locator('.verdict svg').focus();
  await open.keyboard.press('ArrowLeft');
  assert.ok(!(await colours(open, '.verdict svg')).picture.equals(before.picture), 'law: arrow keys turn them');
  await prints(open);
  const policy = await open.evaluate(() => document.querySelector('meta[http-equiv="Content-Security-Policy"]').content);
  assert.match(policy, /^default-src 'none';/, 'law: the policy allows no connection');
  assert.doesNotMatch(policy, /unsafe|https?:|connect-src/, 'law: and nothing that undoes this');
});

onPage('proved: bodies of the plane are seen from above, and do not turn', page, {}, async (open) => {
  await choose(open, [certificate('squares')]);
  await open.locator('.verdict svg').waitFor();
  const text = await open.locator('.verdict').textContent();
  assert.match(text, /bodies of the plane.*plane_verdict_sound.*y up/s, 'law: the words and the theorem are those of the plane');
  const boxes = () => open.evaluate(() => ['a', 'b'].map((name) => {
    const { x, y, width, height } = document.querySelector(`.outline.of-${name}`).getBBox();
    return { x, y, width, height };
  }));
  const near = (x, y) => Math.abs(x - y) < 1e-3, [a, b] = await boxes();
  assert.ok(near(a.width, a.height) && near(b.width, b.height), 'law: squares are squares');
  assert.ok(near(b.x - a.x, a.width / 2) && near(a.y, b.y), 'law: B is half a side to the right');
  assert.equal(await open.locator('.verdict svg[tabindex]').count(), 0, 'law: no key turns them');

  await choose(open, [certificate('half_plane_apart')]);
  await open.locator('.verdict svg').waitFor();
  const inside = await open.evaluate(() => [[-1, 1], [0, 0]].map(([x, y]) => document.querySelector('.outline.of-a').isPointInFill({ x, y })));
  assert.deepEqual(inside, [true, false], 'law: the half-plane fills the lower left corner, and its boundary is in the picture');
  const [, { x, y, width, height }] = await boxes();
  assert.ok(x > -1.05 && y > -1.05 && x + width < 1.05 && y + height < 1.05, 'law: the body beside it is in the picture');
});
