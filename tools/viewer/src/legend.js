// SPDX-License-Identifier: BSD-3-Clause
// The scale of the error colours.
import { cssRamp } from './color_ramp.js';
import { element } from './element.js';
import { formatPercent } from './number_format.js';

/**
 * {largest, scale}: the largest error, and the one at the end of the colours: that which 99 % of the vertices do
 * not exceed, so that a single one does not make all others dark. Null without errors.
 */
export function errorScale(error) {
  if (error.length === 0) return null;
  const sorted = error.slice().sort();
  const largest = sorted[sorted.length - 1];
  const scale = sorted[Math.floor(0.99 * (sorted.length - 1))] || largest || 1;
  return { largest, scale };
}

export function fillLegend(legend, { largest, scale }) {
  const bar = element('div', { class: 'ramp', 'aria-hidden': 'true' });
  bar.style.background = `linear-gradient(90deg, ${cssRamp().join(', ')})`;
  const ticks = element('div', { class: 'ticks' });
  for (const t of [0, 0.25, 0.5, 0.75, 1])
    ticks.append(element('span', {}, (t === 1 && largest > scale ? '≥ ' : '') + formatPercent(t * scale)));
  legend.replaceChildren(
    element('p', {}, 'Error at each vertex, in percent of the bounding-box diagonal'),
    bar, ticks, element('p', {}, `Largest: ${formatPercent(largest)}`));
}
