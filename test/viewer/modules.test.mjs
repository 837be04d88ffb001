// SPDX-License-Identifier: BSD-3-Clause
// Modules of the page that need no browser.
import assert from 'node:assert/strict';
import test from 'node:test';
import { bundleSource } from '../../tools/viewer/bundle_source.mjs';
import { cssRamp, ramp } from '../../tools/viewer/src/color_ramp.js';
import { findEdges, findSeams } from '../../tools/viewer/src/edges.js';
import { shares } from '../../tools/viewer/src/histogram.js';
import { errorScale } from '../../tools/viewer/src/legend.js';
import { formatNumber, formatPercent, formatValue, label } from '../../tools/viewer/src/number_format.js';
import { none } from '../../tools/viewer/src/page_data.js';

//  2---3   Two triangles, 0 1 2 and 2 1 3.
//  | \ |
//  0---1
const position = new Uint32Array([0, 1, 2, 2, 1, 3]);
const texcoords = new Float32Array([0, 0, 1, 0, 0, 1, 1, 1, 0, 1, 5, 5]);
const seams = (texcoord) => {
  const mesh = { position, texcoords, texcoord: new Uint32Array(texcoord) };
  const edges = findEdges(position);
  return { edges, seam: findSeams(mesh, edges), middle: edges.edgeOf[1] };
};

test('edges are found once, with their faces', () => {
  const { edges, middle } = seams([]);
  assert.equal(edges.count, 5);
  assert.equal(edges.edgeOf[1], edges.edgeOf[3]);
  assert.deepEqual([...edges.faces].sort(), [1, 1, 1, 1, 2]);
  assert.equal(edges.first[middle], 1);
});

test('edges of many triangles around one vertex', () => {
  const n = 20000;
  const fan = new Uint32Array(3 * n);
  for (let t = 0; t < n; ++t) fan.set([0, 1 + t, 1 + ((t + 1) % n)], 3 * t);
  const edges = findEdges(fan);
  assert.equal(edges.count, 2 * n);
  assert.equal(edges.faces.reduce((a, b) => a + b), 3 * n);
});

test('a seam is where texture coordinates have other values', () => {
  const of = (texcoord) => {
    const { seam, middle } = seams(texcoord);
    return seam[middle];
  };
  assert.equal(of([0, 1, 2, 2, 1, 3]), 0);
  assert.equal(of([0, 1, 2, 4, 1, 3]), 0, 'the same value, written twice');
  assert.equal(of([0, 1, 2, 5, 1, 3]), 1);
  assert.equal(of([0, 1, 2, none, none, none]), 1);
  assert.equal(of([]), 0);
});

test('a border is drawn as a seam is', () => {
  assert.equal(seams([0, 1, 2, 2, 1, 3]).seam.reduce((a, b) => a + b), 4);
});

test('the colour ramp grows lighter in even steps', () => {
  const luminance = ([r, g, b]) => 0.2126 * r ** 2.2 + 0.7152 * g ** 2.2 + 0.0722 * b ** 2.2;
  const lightness = Array.from({ length: 21 }, (_, i) => Math.cbrt(luminance(ramp(i / 20))));
  const steps = lightness.slice(1).map((l, i) => l - lightness[i]);
  assert.ok(Math.min(...steps) > 0.015 && Math.max(...steps) < 0.05, `${steps}`);
  assert.equal(cssRamp(4).length, 5);
});

test('the scale of errors leaves the last percent of the vertices out', () => {
  const of = (values) => errorScale({ name: 'Distance', values });
  assert.deepEqual(of(new Float32Array([0, 0])), { name: 'Distance', largest: 0, scale: 1 });
  const errors = new Float32Array(1000).map((_, i) => i / 1024);
  errors[17] = 8;
  const { largest, scale } = of(errors);
  assert.equal(largest, 8);
  assert.ok(scale > 0.95 && scale < 1);
});

test('numbers for people', () => {
  assert.equal(formatNumber(5856), '5\u202f856');
  assert.equal(formatNumber(0.0123456), '0.01235');
  assert.equal(formatNumber(1.234e-7), '1.23e-7');
  assert.equal(formatNumber(0), '0');
  assert.equal(formatPercent(0.00461), '0.461 %');
  assert.equal(formatValue(null), 'none');
  assert.equal(formatValue(true), 'yes');
  assert.equal(formatValue([1, 'a']), '1, a');
  assert.equal(label('boundary_loops'), 'Boundary loops');
});

test('text becomes a C++ string', () => {
  const source = bundleSource({ page: 'a"b\\c\n\u00a9??/7', script: '', style: 'x'.repeat(20000) });
  assert.ok(source.includes(String.raw`"a\"b\\c\n\302\251\?\?/7"sv,`));
  assert.equal(source.match(/"x+"sv/g).length, 3);
});

test('a histogram shows shares, also of nothing', () => {
  assert.deepEqual(shares([1, 3, 0]), [0.25, 0.75, 0]);
  assert.deepEqual(shares([0, 0]), [0, 0]);
});
