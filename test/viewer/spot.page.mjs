// SPDX-License-Identifier: BSD-3-Clause
// The bundled cow before and after decimation: every control of the page does what it says.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { run, settings, withBrowser, withPage } from './browser.mjs';
import { colors, count, difference, pixels, still } from './pixels.mjs';

const seam = [0xf0, 0x3e, 0x00]; // --seam of the light theme
const spot = join(settings.data, 'spot/spot.obj');

async function choose(page, name) {
  await page.locator('#toolbar').getByText(name, { exact: true }).click();
}

/** What changes in the views when it is chosen. */
async function changes(page, name, selector = '#stage') {
  const before = await pixels(page, selector);
  await choose(page, name);
  return difference(before, await pixels(page, selector));
}

async function viewsAreDrawn(page) {
  const [before, after] = [await pixels(page, '#pane-before'), await pixels(page, '#pane-after')];
  for (const pane of [before, after]) {
    assert.ok(colors(pane) > 50, `a pane has ${colors(pane)} colours`);
    assert.ok(count(pane, [70, 66, 66], 120) > 500, 'the dark spots of the texture');
  }
  const share = difference(before, after);
  assert.ok(share > 0.005 && share < 0.5, `like each other, but not the same: ${share}`);
}

async function controlsChangeTheViews(page) {
  assert.ok((await changes(page, 'Wireframe')) > 0.02);
  assert.ok((await changes(page, 'Wireframe')) > 0.02, 'and back');
  assert.ok((await changes(page, 'Flat shading', '#pane-after')) > 0.005);
  await choose(page, 'Flat shading');
  assert.ok(count(await pixels(page, '#stage'), seam) < 50);
  await choose(page, 'Seams');
  for (const pane of ['#pane-before', '#pane-after'])
    assert.ok(count(await pixels(page, pane), seam) > 100, 'seams in the views');
  await choose(page, 'Seams');
  for (const mode of ['Plain', 'UV checker', 'Distance', 'Texture deviation', 'Textured']) {
    assert.ok((await changes(page, mode, '#pane-after')) > 0.05, mode);
    assert.equal(await page.locator('#legend').isVisible(), mode === 'Distance' || mode === 'Texture deviation');
  }
}

async function errorHasAScale(page) {
  await choose(page, 'Distance');
  const legend = await page.locator('#legend').innerText();
  assert.match(legend, /^Distance .* percent of the bounding-box diagonal/);
  assert.match(legend, /Largest: [\d.]+ %/);
  assert.ok(colors(await pixels(page, '.ramp')) > 20);
  await choose(page, 'Textured');
}

async function dragTurnsBoth(page) {
  const panes = ['#pane-before', '#pane-after'];
  const before = await Promise.all(panes.map((pane) => pixels(page, pane)));
  const box = await page.locator('#pane-before').boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 120, box.y + box.height / 2 + 10, { steps: 6 });
  await page.mouse.up();
  for (const [i, pane] of panes.entries())
    assert.ok(difference(before[i], await still(page, pane)) > 0.05, `${pane} turned`);
  await page.getByRole('button', { name: 'Reset view' }).click();
  for (const [i, pane] of panes.entries())
    assert.ok(difference(before[i], await still(page, pane)) < 0.01, `${pane} is as it was`);
}

async function keysTurnToo(page) {
  const before = await pixels(page, '#pane-after');
  await page.locator('#stage').focus();
  for (let i = 0; i < 10; ++i) await page.keyboard.press('ArrowRight');
  await page.keyboard.press('+');
  assert.ok(difference(before, await pixels(page, '#pane-after')) > 0.05);
}

async function atlasesAreDrawn(page) {
  for (const name of ['before', 'after']) {
    const atlas = await pixels(page, `#atlas-${name}`);
    assert.ok(colors(atlas) > 30);
    assert.ok(count(atlas, seam) > 500, `seams in the atlas ${name}`);
    assert.ok(count(atlas, [0xff, 0xee, 0xe4], 30) > 1000, 'the image is under it');
  }
}

async function numbersAreThere(page) {
  const figures = await page.locator('#figures').innerText();
  for (const part of ['5\u202f856 → 586', 'Charts', '13', 'Seam edges', 'Largest distance', 'Largest texture deviation', 'Stopped by'])
    assert.ok(figures.includes(part), `${part} in ${figures}`);
  const numbers = await page.locator('#numbers').innerText();
  for (const part of ['Before and after', 'Euler characteristic', 'Junctions', 'target number of faces', 'Max cost'])
    assert.ok(numbers.includes(part), `${part} in ${numbers}`);
  assert.equal(await page.locator('#notices').isVisible(), false, 'nothing to be warned of');
}

await withBrowser(async (browser) => {
  run('program', 'decimate', spot, '-o', 'small.obj', '--ratio', '0.1', '--report', 'report.json', '--quiet');
  run('make-page', 'report.html', spot, 'small.obj', 'report.json');
  await withPage(browser, 'report.html', async (page) => {
    await viewsAreDrawn(page);
    await controlsChangeTheViews(page);
    await errorHasAScale(page);
    await dragTurnsBoth(page);
    await keysTurnToo(page);
    await atlasesAreDrawn(page);
    await numbersAreThere(page);
    await page.setViewportSize({ width: 1280, height: 900 });
    await still(page, '#stage');
    await page.screenshot({ path: join(settings.artifacts, 'report.png'), fullPage: true });
  });
  const dark = { colorScheme: 'dark', viewport: { width: 390, height: 800 }, deviceScaleFactor: 2 };
  await withPage(browser, 'report.html', async (page) => {
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(width <= 390, `on a telephone nothing sticks out: ${width}`);
    assert.ok(colors(await pixels(page, '#pane-after')) > 50);
    await page.screenshot({ path: join(settings.artifacts, 'report-dark-narrow.png'), fullPage: true });
  }, dark);
});
