// SPDX-License-Identifier: BSD-3-Clause
// Reads the PNG files that Chromium writes as screenshots: 8 bits, RGB or RGBA, not interlaced.
import assert from 'node:assert/strict';
import { inflateSync } from 'node:zlib';

function paeth(a, b, c) {
  const pa = Math.abs(b - c), pb = Math.abs(a - c), pc = Math.abs(a + b - 2 * c);
  return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
}

/** Undoes the filters, row by row. */
function unfilter(raw, height, stride, step) {
  const out = Buffer.alloc(height * stride);
  for (let y = 0; y < height; ++y) {
    const filter = raw[y * (stride + 1)];
    for (let x = 0; x < stride; ++x) {
      const at = y * stride + x;
      const left = x >= step ? out[at - step] : 0;
      const up = y > 0 ? out[at - stride] : 0;
      const corner = x >= step && y > 0 ? out[at - stride - step] : 0;
      const guess = [0, left, up, (left + up) >> 1, filter === 4 ? paeth(left, up, corner) : 0][filter];
      out[at] = raw[y * (stride + 1) + 1 + x] + guess;
    }
  }
  return out;
}

/** {width, height, data}: three bytes per pixel, RGB. */
export function readPng(file) {
  const chunks = [];
  for (let at = 8; at < file.length; at += 12 + file.readUInt32BE(at))
    if (file.toString('latin1', at + 4, at + 8) === 'IDAT') chunks.push(file.subarray(at + 8, at + 8 + file.readUInt32BE(at)));
  const [width, height, bits, kind] = [file.readUInt32BE(16), file.readUInt32BE(20), file[24], file[25]];
  assert.ok(bits === 8 && (kind === 2 || kind === 6) && file[28] === 0, 'a PNG as Chromium writes them');
  const step = kind === 2 ? 3 : 4;
  const pixels = unfilter(inflateSync(Buffer.concat(chunks)), height, step * width, step);
  if (step === 3) return { width, height, data: pixels };
  const data = Buffer.alloc(3 * width * height);
  for (let i = 0; i < width * height; ++i) pixels.copy(data, 3 * i, 4 * i, 4 * i + 3);
  return { width, height, data };
}
