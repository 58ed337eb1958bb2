// SPDX-License-Identifier: GPL-3.0-or-later
// Photographs pages of `fathom explain`: node shoot.mjs PAGES PICTURES [ID...], two folders and which to take (all). What is chosen on each
// page, and which part of it is shown, stands in shots.json; the picture is PICTURES/<id>.png.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const [, , pages, pictures, ...only] = process.argv;
const here = dirname(fileURLToPath(import.meta.url));
const { chromium } = createRequire(join(process.env.FATHOM_WORK, 'node_modules/'))('playwright-core');
const args = ['--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync',
  '--use-angle=swiftshader', '--enable-unsafe-swiftshader', ...(process.getuid() === 0 ? ['--no-sandbox'] : [])];
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args });
const page = await browser.newPage({ viewport: { width: 1280, height: 900 }, reducedMotion: 'reduce', colorScheme: 'light' });
page.setDefaultTimeout(0); // however busy the machine is

for (const { id, hash = '', show } of JSON.parse(readFileSync(join(here, 'shots.json'), 'utf8'))) {
  if (only.length && !only.includes(id)) continue;
  await page.goto('about:blank');
  await page.goto(pathToFileURL(join(pages, `${id}.${show.endsWith('.svg') ? 'svg' : 'html'}`)) + hash);
  await page.waitForTimeout(500); // a frame or two of the pictures
  const shown = show.endsWith('.svg') ? page.locator('svg').first() : page.locator(show).first();
  await shown.screenshot({ path: join(pictures, `${id}.png`) });
  console.error(`${id}.png`);
}
await browser.close();
