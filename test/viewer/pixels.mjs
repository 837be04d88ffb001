// SPDX-License-Identifier: BSD-3-Clause
// What is to be seen in a part of a page. Pictures are those of png.mjs.
import { readPng } from './png.mjs';

/** A screenshot of an element, after what was asked for is drawn. */
export async function pixels(page, selector) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  return readPng(await page.locator(selector).screenshot({ animations: 'disabled' }));
}

/** A screenshot once nothing moves any more. */
export async function still(page, selector) {
  let last = await pixels(page, selector);
  for (let tries = 0; tries < 50; ++tries) {
    await page.waitForTimeout(100);
    const next = await pixels(page, selector);
    if (next.data.equals(last.data)) return next;
    last = next;
  }
  throw new Error(`${selector} does not come to rest`);
}

const distance = (a, i, b, j) =>
  Math.abs(a[i] - b[j]) + Math.abs(a[i + 1] - b[j + 1]) + Math.abs(a[i + 2] - b[j + 2]);

/** Number of pixels for which holds(red, green, blue). */
export function countIf({ data }, holds) {
  let found = 0;
  for (let i = 0; i < data.length; i += 3) found += holds(data[i], data[i + 1], data[i + 2]) ? 1 : 0;
  return found;
}

/** Number of pixels of about this colour. */
export const count = (picture, color, tolerance = 40) =>
  countIf(picture, (...rgb) => distance(rgb, 0, color, 0) <= tolerance);

/** Share of the pixels that are not the same in both. */
export function difference(a, b, tolerance = 24) {
  if (a.width !== b.width || a.height !== b.height) return 1;
  let different = 0;
  for (let i = 0; i < a.data.length; i += 3) different += distance(a.data, i, b.data, i) > tolerance ? 1 : 0;
  return (3 * different) / a.data.length;
}

/** Distinct colours, four bits per channel: 1 for an area of one colour. */
export function colors(picture) {
  const seen = new Set();
  countIf(picture, (r, g, b) => seen.add(((r >> 4) << 8) | ((g >> 4) << 4) | (b >> 4)));
  return seen.size;
}
