// SPDX-License-Identifier: GPL-3.0-or-later
// A pair with 21,000 edges: the page starts, draws each picture in a few calls, and shows a choice.
import assert from 'node:assert/strict';
import { drawn, explained } from './explained.mjs';
import { fits, onPage } from './lib.mjs';

const most = 100; // draw calls of all pictures together; one a body, a colour or a kind of line, never one an edge
const page = () => explained(drawn('random_sphere', 3502)).page;

onPage('explain 21,000 edges', page, {}, async (open) => {
  const { edges, pairs, calls } = await open.evaluate(() => ({
    edges: globalThis.fathom.data.bodies.a.edges.length + globalThis.fathom.data.bodies.b.edges.length,
    pairs: globalThis.fathom.data.pairs.length, calls: globalThis.fathom.drawCalls() }));
  assert.ok(edges > 20900, `${edges} edges`);
  assert.ok(calls > 0 && calls <= most, `law: a bounded number of draw calls (${calls})`);
  assert.deepEqual(await open.getByText('could not start').allTextContents(), [], 'law: every part of the page starts');
  const { lit, pair } = await open.evaluate((i) => {
    globalThis.fathom.select({ pair: i });
    return { lit: globalThis.fathom.lit(), pair: globalThis.fathom.data.pairs[i] };
  }, Math.floor(pairs / 2));
  assert.equal(lit.sphere.length, pair.a.length + pair.b.length, 'law: a pair lights its arcs');
  assert.ok((await open.evaluate(() => globalThis.fathom.drawCalls())) <= most, 'law: a bounded number of draw calls, with a choice');
  assert.ok((await open.locator('main').innerText()).match(/left out|not drawn|too many/i), 'law: what is left out is said');
  await fits(open);
});
