// SPDX-License-Identifier: BSD-3-Clause
// Histograms of before and after, side by side in each bin.
import { element } from './element.js';
import { formatNumber } from './number_format.js';

/** Each count as a share of its own sum: the meshes have different sizes. */
export function shares(counts) {
  const sum = counts.reduce((a, b) => a + b, 0) || 1;
  return counts.map((n) => n / sum);
}

function bar(side, share, largest, title) {
  const made = element('div', { class: `bar ${side}`, title });
  made.style.height = `${(100 * share) / largest}%`;
  return made;
}

/** `bounds`: of the bins, one more than there are. */
export function histogram({ name, bounds, before, after }) {
  const [was, is] = [shares(before), shares(after)];
  const largest = Math.max(...was, ...is) || 1;
  const bins = element('div', { class: 'bins', role: 'img', 'aria-label': name });
  was.forEach((share, i) => {
    const range = `${formatNumber(bounds[i])} to ${formatNumber(bounds[i + 1])}`;
    bins.append(element('div', { class: 'bin' },
      bar('before', share, largest, `Before, ${range}: ${formatNumber(before[i])}`),
      bar('after', is[i], largest, `After, ${range}: ${formatNumber(after[i])}`)));
  });
  const ticks = element('div', { class: 'ticks' });
  const step = Math.ceil((bounds.length - 1) / 5);
  for (let i = 0; i < bounds.length; i += step) ticks.append(element('span', {}, formatNumber(bounds[i])));
  const key = element('p', { class: 'key' }, element('span', { class: 'swatch before' }), 'Before',
    element('span', { class: 'swatch after' }), 'After');
  return element('figure', { class: 'histogram' }, element('figcaption', {}, name), bins, ticks, key);
}
