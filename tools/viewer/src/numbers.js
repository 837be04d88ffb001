// SPDX-License-Identifier: BSD-3-Clause
// The report's numbers: key figures, a table of before and after, tables of all else.
import { element } from './element.js';
import { formatNumber, formatPercent, formatValue, label } from './number_format.js';

const isObject = (x) => x !== null && typeof x === 'object' && !Array.isArray(x);

/** Nested objects as [{group, key, value}]; the group is the path above the key. */
function flatten(object, path = []) {
  return Object.entries(object ?? {}).flatMap(([key, value]) =>
    isObject(value) ? flatten(value, [...path, key]) : [{ group: path.map(label).join(' · '), key, value }]);
}

/** A heading per group; what has no group comes first. */
function groupedRows(entries, columns, row) {
  const groups = new Map([['', []]]);
  for (const entry of entries) {
    if (!groups.has(entry.group)) groups.set(entry.group, []);
    groups.get(entry.group).push(row(entry));
  }
  const head = (group) =>
    element('tr', { class: 'group' }, element('th', { colspan: columns, scope: 'colgroup' }, group));
  return [...groups].flatMap(([group, rows]) => (group ? [head(group), ...rows] : rows));
}

const number = (text) => element('td', { class: 'number' }, text);
const heading = (text, more = {}) => element('th', { scope: 'col', ...more }, text);

function change(before, after) {
  if (typeof before !== 'number' || typeof after !== 'number') return '';
  if (before === after) return '=';
  if (before === 0) return `+${formatNumber(after)}`;
  const percent = 100 * (after / before - 1);
  return `${percent > 0 ? '+' : '−'}${Number(Math.abs(percent).toPrecision(3))} %`;
}

function beforeAfterTable(before, after) {
  const afterOf = new Map(flatten(after).map((e) => [`${e.group}/${e.key}`, e.value]));
  const entries = flatten(before).filter((e) => afterOf.has(`${e.group}/${e.key}`));
  if (entries.length === 0) return null;
  const row = ({ group, key, value }) => {
    const other = afterOf.get(`${group}/${key}`);
    return element('tr', {}, element('th', { scope: 'row' }, label(key)), number(formatValue(value)),
      number(formatValue(other)), number(change(value, other)));
  };
  const columns = ['Before', 'After', 'Change'].map((text) => heading(text, { class: 'number' }));
  const head = element('tr', {}, heading('Quantity'), ...columns);
  return table('Before and after', head, groupedRows(entries, 4, row));
}

function valueTable(caption, object) {
  const entries = flatten(object);
  if (entries.length === 0) return null;
  const row = ({ key, value }) =>
    element('tr', {}, element('th', { scope: 'row' }, label(key)),
      element('td', { class: typeof value === 'string' ? 'text' : 'number' }, formatValue(value)));
  const head = element('tr', {}, heading('Quantity'), heading('Value', { class: 'number' }));
  return table(caption, head, groupedRows(entries, 2, row));
}

function table(caption, head, rows) {
  return element('div', { class: 'scroll' },
    element('table', {}, element('caption', {}, caption), element('thead', {}, head), element('tbody', {}, ...rows)));
}

/** All tables that the numbers make. */
export function numberTables(numbers) {
  const { before, after, comparison, warnings: _, ...rest } = numbers;
  return [
    isObject(before) && isObject(after) ? beforeAfterTable(before, after) : null,
    valueTable('Comparison', isObject(comparison) ? comparison : {}),
    valueTable('Run', rest),
  ].filter(Boolean);
}

function tile(name, value, more = '') {
  const words = value.length > 16 ? 'words' : 'figure';
  return element('div', { class: 'tile' }, element('dt', {}, name), element('dd', { class: words }, value),
    ...(more ? [element('dd', { class: 'more' }, more)] : []));
}

/** `5 856 → 586`, or one number if it is the same. */
function pairTile(name, before, after) {
  if (typeof after !== 'number') return null;
  if (typeof before !== 'number') return tile(name, formatNumber(after));
  if (before === after) return tile(name, formatNumber(after), 'unchanged');
  return tile(name, `${formatNumber(before)} → ${formatNumber(after)}`, change(before, after));
}

/** The figures to be seen first. `scales`: of the errors, see legend.js. */
export function keyFigures(page, scales) {
  const { before, after, seconds, stopped_by: stop } = page.numbers;
  const triangles = (name) => page.meshes[name]?.triangles;
  return [
    pairTile('Faces', before?.surface?.faces ?? triangles('before'), after?.surface?.faces ?? triangles('after')),
    pairTile('Vertices', before?.surface?.vertices, after?.surface?.vertices),
    pairTile('Charts', before?.texture?.charts, after?.texture?.charts),
    pairTile('Seam edges', before?.seams?.edges, after?.seams?.edges),
    ...scales.map(({ name, largest }) => tile(`Largest ${name.toLowerCase()}`, formatPercent(largest), 'of the diagonal, at vertices')),
    typeof seconds === 'number' ? tile('Time', `${formatNumber(Number(seconds.toPrecision(3)))} s`) : null,
    typeof stop === 'string' ? tile('Stopped by', stop) : null,
  ].filter(Boolean);
}
