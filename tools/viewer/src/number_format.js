// SPDX-License-Identifier: BSD-3-Clause
// Numbers and names of the reports, for people.

const whole = new Intl.NumberFormat('en', { useGrouping: true });

/** 5 856; 0.0123; 1.23e-7. With four digits that count. */
export function formatNumber(x) {
  if (Number.isInteger(x) && Math.abs(x) < 1e15) return whole.format(x).replaceAll(',', '\u202f');
  const size = Math.abs(x);
  if (size !== 0 && (size < 1e-3 || size >= 1e7)) return x.toExponential(2);
  return String(Number(x.toPrecision(4)));
}

/** A part of a whole in percent, as errors relative to the diagonal are. */
export const formatPercent = (x) => `${x === 0 ? 0 : Number((100 * x).toPrecision(3))} %`;

export function formatValue(value) {
  if (value === null || value === undefined) return 'none';
  if (value === true) return 'yes';
  if (value === false) return 'no';
  if (typeof value === 'number') return formatNumber(value);
  if (Array.isArray(value)) return value.length === 0 ? 'none' : value.map(formatValue).join(', ');
  return String(value);
}

/** `boundary_loops` → `Boundary loops`. */
export function label(key) {
  const words = key.replaceAll('_', ' ');
  return words.charAt(0).toUpperCase() + words.slice(1);
}
