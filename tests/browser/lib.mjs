// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of pages share: fathom, Chromium, and what every page owes its reader.
//
// The environment says where things are: FATHOM_EXECUTABLE, FATHOM_ROOT, CHROMIUM (the browser's path), and FATHOM_WORK, a folder with
// node_modules (which node.sh installs), where pages, and pictures of the pages that failed, are kept.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { basename, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import test, { after } from 'node:test';

export const root = process.env.FATHOM_ROOT;
export const work = process.env.FATHOM_WORK;
const require = createRequire(join(work, 'node_modules/'));
const { chromium } = require('playwright-core');

/** Runs fathom in the root; `ends` are the exit codes that are expected. */
export function fathom(words, { input = '', ends = [0] } = {}) {
  const done = spawnSync(process.env.FATHOM_EXECUTABLE, words, { cwd: root, input, encoding: 'utf8', maxBuffer: 1 << 30 });
  assert.ok(ends.includes(done.status), `fathom ${words.join(' ')} ended with ${done.status}: ${done.stderr}`);
  return done.stdout;
}

/** Whether this fathom has a command or an option: `has('explain')`, `has('depth', '--svg')`. */
export function has(command, option = '') {
  const done = spawnSync(process.env.FATHOM_EXECUTABLE, ['help', command], { encoding: 'utf8' });
  return done.status === 0 && done.stdout.includes(option);
}

/** The path of a file in the folder of this test program. */
export function made(name, text) {
  const folder = join(work, basename(process.argv[1], '.mjs'));
  mkdirSync(folder, { recursive: true });
  const path = join(folder, name);
  if (text !== undefined) writeFileSync(path, text);
  else rmSync(path, { force: true });
  return path;
}

export const cases = (file) => readFileSync(join(root, file), 'utf8').trim().split('\n').map((line) => JSON.parse(line));

// One browser for each set of flags, closed at the end.
const browsers = new Map();
const flags = ['--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'];

async function browser(more) {
  const key = more.join(' ');
  if (!browsers.has(key)) {
    const args = [...flags, ...more];
    if (process.getuid() === 0) args.push('--no-sandbox');
    browsers.set(key, await chromium.launch({ executablePath: process.env.CHROMIUM, args }));
  }
  return browsers.get(key);
}
after(async () => {
  for (const each of browsers.values()) await each.close();
});

const patience = 600_000; // milliseconds until a hung page is given up; no test depends on how long anything takes

export const withoutWebGl = ['--disable-3d-apis'];
const software = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

/**
 * A test of one page: `check(page)` runs with the page open. Afterwards the page may not have written an error to the console, nor asked for
 * anything but files and what it made itself (a worker). If something is wrong, a picture of the page is kept beside it.
 * Options: width, height, flags of the browser, hash (of the address), and those of a Playwright context (colorScheme, javaScriptEnabled, …).
 */
export function onPage(name, file, options, check) {
  test(name, async () => {
    const { width = 1280, height = 900, flags: more = software, hash = '', ...context } = options;
    const open = await (await browser(more)).newContext({ viewport: { width, height }, reducedMotion: 'reduce', ...context });
    const page = await open.newPage();
    page.setDefaultTimeout(patience);
    const wrong = [];
    page.on('console', (message) => message.type() === 'error' && wrong.push(`console: ${message.text()}`));
    page.on('pageerror', (error) => wrong.push(`exception: ${error.stack}`));
    page.on('request', (request) => /^(file|blob):/.test(request.url()) || wrong.push(`request: ${request.url().slice(0, 200)}`));
    try {
      await page.goto(pathToFileURL(typeof file === 'function' ? file() : file) + hash);
      await check(page);
      assert.deepEqual(wrong, [], 'law: no error on the console, no request but for files');
    } catch (error) {
      const picture = made(`${name.replace(/\W+/g, '_')}.png`);
      await page.screenshot({ path: picture }).catch(() => {});
      error.message += `\n(the page looked like ${picture}${wrong.length ? `; ${wrong.join('; ')}` : ''})`;
      throw error;
    } finally {
      await open.close();
    }
  });
}

/** A test of a page on a phone in the dark and on a desk in the light: opened once, as that takes seconds. `check` gets the width too. */
export function inBothLooks(name, file, check) {
  onPage(`${name} on a phone in the dark and on a desk in the light`, file, { width: 390, colorScheme: 'dark' }, async (page) => {
    await check(page, 390);
    await page.setViewportSize({ width: 1280, height: 900 });
    await page.emulateMedia({ colorScheme: 'light' });
    await page.evaluate(() => new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); }));
    await check(page, 1280);
  });
}

/** Law: nothing is wider than the window, except what scrolls by itself. */
export async function fits(page) {
  const { wide, inner, wider } = await page.evaluate(() => {
    const scrolls = (e) => e && (['auto', 'scroll', 'hidden', 'clip'].includes(getComputedStyle(e).overflowX) || scrolls(e.parentElement));
    const width = document.documentElement.clientWidth;
    const beyond = [...document.body.querySelectorAll('*')].filter((e) => e.getBoundingClientRect().right > width + 1 && !scrolls(e));
    return { wide: document.documentElement.scrollWidth, inner: width, wider: beyond.slice(0, 5).map((e) => e.outerHTML.slice(0, 120)) };
  });
  assert.ok(wide <= inner, `law: no horizontal overflow; ${wide} > ${inner} pixels: ${wider.join(' ')}`);
}

/** Law: what scrolls sideways says so by a shadow at its edge, which what lies there uncovers. Returns how many do. */
export async function shadows(page) {
  const backgrounds = await page.evaluate(() => [...document.querySelectorAll('.wide')].filter((e) => e.scrollWidth > e.clientWidth)
    .map((e) => getComputedStyle(e)).map((style) => `${style.backgroundAttachment} ${style.backgroundImage}`));
  for (const shown of backgrounds) assert.match(shown, /^local, local, scroll, scroll linear-gradient/, 'law: a table that scrolls has a shadow');
  return backgrounds.length;
}

const axe = readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');

/** Law: axe-core finds nothing serious. It is injected by evaluate, since the page's policy forbids scripts of others. */
export async function accessible(page) {
  await page.evaluate(axe);
  const found = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ['violations'] }));
  const serious = found.violations.filter((each) => ['serious', 'critical'].includes(each.impact));
  const text = serious.map(({ id, help, nodes }) => `${id} (${help}): ${nodes.slice(0, 3).map((n) => `${n.html} ${n.failureSummary}`).join('\n')}`);
  assert.deepEqual(text, [], 'law: axe-core without serious findings');
}

/** Law: the page prints. */
export async function prints(page) {
  const pdf = await page.pdf({ printBackground: true });
  assert.equal(pdf.subarray(0, 5).toString(), '%PDF-', 'law: the page prints to PDF');
  assert.ok(pdf.length > 5000, `law: the printed page is not empty (${pdf.length} bytes)`);
  return pdf;
}

/** The colours of an element as it is drawn, by a picture of it: how many, and the picture. */
export async function colours(page, selector) {
  const picture = await page.locator(selector).first().screenshot();
  const count = await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const canvas = new OffscreenCanvas(image.width, image.height);
    const paint = canvas.getContext('2d');
    paint.drawImage(image, 0, 0);
    return new Set(new Uint32Array(paint.getImageData(0, 0, image.width, image.height).data.buffer)).size;
  }, picture.toString('base64'));
  return { count, picture };
}
