// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures that fathom writes by --svg, opened as they are: well-formed, named for those who do not see them, with nothing cut off, light
// and dark.
import assert from 'node:assert/strict';
import { cases, colours, fathom, has, made, onPage } from './lib.mjs';

const gallery = 'docs/gallery/cases.jsonl';

/** The path of what a command draws; with a case of the gallery as its input if there is one. */
function drawn(id, command, words, line) {
  const picture = made(`${id}.svg`);
  const input = line ? ['--case', line.id, made(`${id}.jsonl`, `${JSON.stringify(line)}\n`)] : [];  // alone: a stream fills a folder
  fathom([command, ...input, ...words, '--svg', picture]);
  return picture;
}

const pictures = new Map();
if (has('depth', '--svg')) {
  for (const line of cases(gallery)) pictures.set(line.id, () => drawn(line.id, 'depth', [], line));
  pictures.set('apart', () => drawn('apart', 'depth', [], cases('examples/data/cases.jsonl').find(({ id }) => id === 'apart')));
  pictures.set('unions', () => drawn('unions', 'depth', ['--pieces', 'tests/data/key.obj', 'tests/data/comb.obj']));
  pictures.set('curved', () => drawn('curved', 'depth', ['cylinder:radius=1,half_length=2', 'cone:radius=2,half_length=1,at=1.5:0.2:1']));
  pictures.set('meshes', () => drawn('meshes', 'depth', ['tests/data/cube.off', 'tests/data/icosahedron.off']));
}
if (has('depth', '--along')) {
  const sliding = cases(gallery).find(({ id }) => id === 'sliding-cylinders');
  pictures.set('along', () => drawn('along', 'depth', ['--along', '-1,0,0', '--steps', '20'], sliding));
}
if (has('study', '--sweep')) pictures.set('sweep', () => drawn('sweep', 'study', ['--sweep', 'crossed_fans', '--sizes', '10..100']));
if (has('stages', '--svg')) pictures.set('stages', () => drawn('stages', 'stages', [], cases(gallery)[0]));

for (const [name, draw] of pictures)
  onPage(`picture ${name}`, draw, { width: 800 }, async (page) => {
    const { root, title, label, empty, outside, font } = await page.evaluate(() => {
      const svg = document.documentElement;
      const text = [...svg.querySelectorAll('text')].filter((e) => e.textContent.trim());
      const whole = svg.getBoundingClientRect();
      const inside = (e) => {
        const { left, right, top, bottom } = e.getBoundingClientRect();
        return left >= whole.left - 1 && right <= whole.right + 1 && top >= whole.top - 1 && bottom <= whole.bottom + 1;
      };
      return { root: svg.localName, title: svg.querySelector('title')?.textContent ?? '', label: svg.getAttribute('role') ?? '',
        empty: !svg.getBBox().width || !svg.getBBox().height, outside: text.filter((e) => !inside(e)).map((e) => e.textContent),
        font: Math.min(...text.map((e) => parseFloat(getComputedStyle(e).fontSize)), 99) };
    });
    assert.equal(root, 'svg', 'law: a picture is well-formed SVG');
    assert.ok(title.length > 0 && label === 'img', `law: a picture is named (title '${title}', role '${label}')`);
    assert.ok(!empty, 'law: a picture is not empty');
    assert.deepEqual(outside, [], 'law: no text is cut off');
    assert.ok(font >= 9, `law: text can be read (${font} pixels)`);
    const light = await colours(page, 'svg');
    assert.ok(light.count > 5, `law: a picture has several colours (${light.count})`);
    await page.emulateMedia({ colorScheme: 'dark' });
    const dark = await colours(page, 'svg');
    assert.ok(!light.picture.equals(dark.picture), 'law: dark mode has colours of its own');
  });
