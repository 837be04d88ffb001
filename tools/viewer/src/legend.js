// SPDX-License-Identifier: BSD-3-Clause
// The scale of the error colours.
import { cssRamp } from './color_ramp.js';
import { element } from './element.js';
import { formatPercent } from './number_format.js';

/**
 * {name, largest, scale}: the largest value of an error, and that at the end of the colours, which 99 % of the
 * vertices do not exceed, so that a single one does not make all others dark.
 */
export function errorScale({ name, values }) {
  const sorted = values.slice().sort();
  const largest = sorted[sorted.length - 1] ?? 0;
  const scale = sorted[Math.floor(0.99 * (sorted.length - 1))] || largest || 1;
  return { name, largest, scale };
}

export function fillLegend(legend, { name, largest, scale }) {
  const bar = element('div', { class: 'ramp', 'aria-hidden': 'true' });
  bar.style.background = `linear-gradient(90deg, ${cssRamp().join(', ')})`;
  const ticks = element('div', { class: 'ticks' });
  for (const t of [0, 0.25, 0.5, 0.75, 1])
    ticks.append(element('span', {}, (t === 1 && largest > scale ? '≥ ' : '') + formatPercent(t * scale)));
  legend.replaceChildren(
    element('p', {}, `${name} at each vertex, in percent of the bounding-box diagonal`),
    bar, ticks, element('p', {}, `Largest: ${formatPercent(largest)}`));
}
