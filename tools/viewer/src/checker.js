// SPDX-License-Identifier: BSD-3-Clause
// A checker pattern with a name on each square: shows stretch, turns and mirror images of a parametrization.

const squares = 16;

export function checkerCanvas(size = 2048) {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = size;
  const context = canvas.getContext('2d');
  const step = size / squares;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.font = `600 ${Math.round(0.36 * step)}px system-ui, sans-serif`;
  for (let row = 0; row < squares; ++row)
    for (let column = 0; column < squares; ++column) {
      const hue = (360 * column) / squares;
      const light = (row + column) % 2 === 0;
      context.fillStyle = `hsl(${hue} ${light ? '35% 86%' : `45% ${38 + 1.5 * row}%`})`;
      context.fillRect(column * step, row * step, step, step);
      context.fillStyle = light ? 'rgb(40 44 60 / 0.75)' : 'rgb(255 255 255 / 0.85)';
      // Rows from below, as v counts.
      const name = String.fromCharCode(65 + column) + (squares - row);
      context.fillText(name, (column + 0.5) * step, (row + 0.54) * step);
    }
  return canvas;
}
