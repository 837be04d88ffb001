// SPDX-License-Identifier: BSD-3-Clause
// Pages of files with several materials, hostile names, images that are missing, and no texture coordinates.
import assert from 'node:assert/strict';
import { copyFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { run, settings, withBrowser, withPage } from './browser.mjs';
import { colors, count, countIf, pixels } from './pixels.mjs';

const at = (name) => join(settings.work, name);
const hostile = '</script><b>&amp;"\'';

/** Squares side by side in x, one per material; texture coordinates from 0 to `repeat`. */
function squares(names, repeat) {
  const lines = ['mtllib m.mtl', `vt 0 0\nvt ${repeat} 0\nvt ${repeat} ${repeat}\nvt 0 ${repeat}`];
  names.forEach((name, i) => {
    const x = 1.1 * i;
    lines.push(`v ${x} 0 0\nv ${x + 1} 0 0\nv ${x + 1} 1 0\nv ${x} 1 0\nusemtl ${name}`);
    lines.push('f -4/1 -3/2 -2/3 -1/4');
  });
  return lines.join('\n') + '\n';
}

function writeMaterials() {
  copyFileSync(join(settings.data, 'spot/spot_texture.png'), at('cow.png'));
  writeFileSync(at('broken.png'), Buffer.from('89504e470d0a1a0a00000000', 'hex'));
  writeFileSync(at('image.tga'), Buffer.from('000002', 'hex'));
  writeFileSync(at('m.mtl'), `newmtl red\nKd 0.9 0.05 0.05\nnewmtl ${hostile}\nKd 0.05 0.6 0.1\n` +
    'newmtl cow\nKd 0 0 0\nmap_Kd cow.png\nnewmtl gone\nmap_Kd nowhere.png\n' +
    'newmtl broken\nmap_Kd broken.png\nnewmtl targa\nmap_Kd image.tga\n');
  writeFileSync(at('a.obj'), squares(['red', hostile, 'cow', 'gone', 'broken', 'targa'], 2));
  writeFileSync(at(`${hostile.replace('/', '')}.obj`), squares(['cow', hostile], 1));
}

// Light makes colours darker, and keeps their hue.
const reddish = (picture) => countIf(picture, (r, g, b) => r > 90 && g < r / 2 && b < r / 2);
const greenish = (picture) => countIf(picture, (r, g, b) => g > 60 && r < g / 2 && b < g / 2);
const imagePixels = (picture) => count(picture, [0xff, 0xee, 0xe4], 30); // the ground of the cow's texture

async function manyMaterials(page) {
  const [before, after] = [await pixels(page, '#pane-before'), await pixels(page, '#pane-after')];
  assert.ok(reddish(before) > 60, 'the red square');
  assert.ok(greenish(before) > 60, 'the green square');
  assert.ok(reddish(after) < 10, 'which the other file does not have');
  assert.ok(greenish(after) > 60);

  const notes = await page.locator('#notes li').allInnerTexts();
  for (const name of ['nowhere.png', 'broken.png', 'image.tga'])
    assert.equal(notes.filter((note) => note.includes(name)).length, 1, `one note on ${name}: ${notes}`);

  const options = await page.locator('#material option').allInnerTexts();
  assert.equal(options.length, 7, `${options}`);
  assert.ok(options.includes(hostile), 'the name as it is');
  assert.equal(await page.locator('b').count(), 0, 'no markup from names');
  assert.ok((await page.title()).includes('<script><b>'));
  await page.selectOption('#material', { label: 'cow' });
  const withImage = imagePixels(await pixels(page, '#atlas-before'));
  assert.ok(withImage > 3000, `that of the chosen material: ${withImage}`);
  await page.selectOption('#material', { label: hostile });
  const without = imagePixels(await pixels(page, '#atlas-before'));
  assert.ok(without < withImage / 5, `${without} of ${withImage}`); // soft edges of lines can have its colour
}

async function noTextureCoordinates(page) {
  assert.ok(colors(await pixels(page, '#pane-after')) > 5);
  assert.equal(await page.locator('#atlas-card').isVisible(), false);
  assert.equal(await page.locator('input[value=checker]').isDisabled(), true);
  await page.locator('#toolbar').getByText('Seams').click();
  await page.locator('#toolbar').getByText('Wireframe').click();
  assert.ok(count(await pixels(page, '#pane-after'), [0xf0, 0x3e, 0x00]) > 50, 'the border of the surface');
}

await withBrowser(async (browser) => {
  writeMaterials();
  run('make-page', 'materials.html', 'a.obj', `${hostile.replace('/', '')}.obj`);
  await withPage(browser, 'materials.html', async (page) => {
    await page.screenshot({ path: join(settings.artifacts, 'report-materials.png'), fullPage: true });
    await manyMaterials(page);
  });
  writeFileSync(at('plain.obj'), 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.5\nf 1 2 3\nf 2 4 3\n');
  run('make-page', 'plain.html', 'plain.obj', 'plain.obj');
  await withPage(browser, 'plain.html', noTextureCoordinates);
});
