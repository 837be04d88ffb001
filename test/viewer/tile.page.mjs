// SPDX-License-Identifier: BSD-3-Clause
// The page of a periodic tile: it is repeated, its sides have colours, and there is a histogram.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { run, settings, withBrowser, withPage } from './browser.mjs';
import { colors, countIf, pixels } from './pixels.mjs';

const at = (name) => join(settings.work, name);

/** A square tile of n x n squares, with its inner vertices shaken. */
function square(n) {
  const lines = [];
  const shake = (i, j) => (i % n && j % n ? (0.3 * (((7 * i + 5 * j) % 5) - 2)) / 2 : 0);
  for (let i = 0; i <= n; ++i)
    for (let j = 0; j <= n; ++j) lines.push(`v ${(i + shake(i, j)) / n} ${(j + shake(j, i)) / n} 0`);
  const v = (i, j) => i * (n + 1) + j + 1;
  for (let i = 0; i < n; ++i)
    for (let j = 0; j < n; ++j)
      lines.push(`f ${v(i, j)} ${v(i + 1, j)} ${v(i + 1, j + 1)}`, `f ${v(i, j)} ${v(i + 1, j + 1)} ${v(i, j + 1)}`);
  return lines.join('\n') + '\n';
}

// The colours of the sides are hues; those of regions are nearly grey.
const coloured = (picture) => countIf(picture, (r, g, b) => Math.max(r, g, b) - Math.min(r, g, b) > 45);

async function tile(page) {
  const pane = () => pixels(page, '#pane-after');
  const choose = (name) => page.locator('#toolbar').getByText(name, { exact: true }).click();
  const single = await pane();
  assert.ok(colors(single) > 5, 'something is drawn');
  assert.ok(coloured(single) > 200, `sides have colours: ${coloured(single)}`);

  await choose('Sides');
  assert.ok(coloured(await pane()) < coloured(single) / 4, 'sides can be hidden');
  await choose('Sides');

  await choose('Repeated');
  const repeated = await pane();
  assert.ok(coloured(repeated) > 200 && colors(repeated) > 5, 'the tile is drawn again');
  await page.screenshot({ path: join(settings.artifacts, 'report-tile.png'), fullPage: true });
  await choose('Repeated');

  assert.equal(await page.locator('#histogram-card').isVisible(), true);
  assert.equal(await page.locator('.bin').count(), 12);
  const heights = await page.locator('.bar.after').evaluateAll((bars) => bars.map((b) => parseFloat(b.style.height)));
  assert.ok(Math.max(...heights) <= 100 && heights.some((h) => h > 30), `${heights}`);
}

async function noTile(page) {
  assert.equal(await page.locator('#histogram-card').isVisible(), false);
  assert.equal(await page.locator('#toolbar').getByText('Repeated').isVisible(), false);
}

await withBrowser(async (browser) => {
  writeFileSync(at('tile.obj'), square(12));
  run('program', 'decimate', 'tile.obj', '-o', 'coarse.msh', '--ratio', '0.5', '--periodic', 'xy', '--quiet',
    '--report-html', 'tile.html');
  await withPage(browser, 'tile.html', tile);
  run('make-page', 'plain.html', 'tile.obj', 'tile.obj');
  await withPage(browser, 'plain.html', noTile);
});
