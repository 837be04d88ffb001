// SPDX-License-Identifier: BSD-3-Clause
// The texture plane of a mesh, drawn on a canvas: image, triangles, chart boundaries.
import { next } from './edges.js';
import { none } from './page_data.js';

const margin = 0.03;
/** Segments per stroke: one path of a million is slow, a million paths are too. */
const batch = 20000;

export const unitSquare = { left: 0, right: 1, bottom: 0, top: 1 };

/** The box, grown to hold the texture coordinates of the triangles. */
export function bounds(mesh, triangles, start = unitSquare) {
  const box = { ...start };
  for (const t of triangles)
    for (let c = 3 * t; c < 3 * t + 3; ++c) {
      const u = mesh.texcoords[2 * mesh.texcoord[c]], v = mesh.texcoords[2 * mesh.texcoord[c] + 1];
      if (u < box.left) box.left = u;
      if (u > box.right) box.right = u;
      if (v < box.bottom) box.bottom = v;
      if (v > box.top) box.top = v;
    }
  return box;
}

/** Those with texture coordinates, of one material, or of all if it is -1. */
export function trianglesOf(mesh, material) {
  const list = [];
  for (let t = 0; t < mesh.position.length / 3; ++t)
    if (mesh.texcoord[3 * t] !== none && (material < 0 || (mesh.material[t] ?? 0) === material)) list.push(t);
  return list;
}

/** Where texture coordinates are on the canvas, in CSS pixels. */
function placement(box, width, height) {
  const scale = Math.min(width / (box.right - box.left), height / (box.top - box.bottom)) * (1 - 2 * margin);
  const left = (width - scale * (box.right - box.left)) / 2;
  const top = (height - scale * (box.top - box.bottom)) / 2;
  return { scale, x: (u) => left + scale * (u - box.left), y: (v) => top + scale * (box.top - v) };
}

function strokeSegments(context, mesh, at, halfedges) {
  const { texcoords, texcoord } = mesh;
  for (let i = 0; i < halfedges.length; i += batch) {
    context.beginPath();
    for (let j = i; j < Math.min(halfedges.length, i + batch); ++j) {
      const a = 2 * texcoord[halfedges[j]], b = 2 * texcoord[next(halfedges[j])];
      context.moveTo(at.x(texcoords[a]), at.y(texcoords[a + 1]));
      context.lineTo(at.x(texcoords[b]), at.y(texcoords[b + 1]));
    }
    context.stroke();
  }
}

function fillTriangles(context, mesh, at, triangles) {
  const { texcoords, texcoord } = mesh;
  for (const t of triangles) {
    context.beginPath();
    for (let c = 3 * t; c < 3 * t + 3; ++c)
      context.lineTo(at.x(texcoords[2 * texcoord[c]]), at.y(texcoords[2 * texcoord[c] + 1]));
    context.fill();
  }
}

/** The image on every unit square in sight, paler outside the first. */
function drawImages(context, image, box, at) {
  const tiles = (Math.ceil(box.right) - Math.floor(box.left)) * (Math.ceil(box.top) - Math.floor(box.bottom));
  const all = tiles <= 400;
  const draw = (u, v) => context.drawImage(image, at.x(u), at.y(v + 1), at.scale, at.scale);
  context.save();
  context.globalAlpha = 0.35;
  for (let u = Math.floor(box.left); all && u < Math.ceil(box.right); ++u)
    for (let v = Math.floor(box.bottom); v < Math.ceil(box.top); ++v) if (u !== 0 || v !== 0) draw(u, v);
  context.globalAlpha = 1;
  draw(0, 0);
  context.restore();
}

/** Lines that can be seen on a light or a dark ground. */
const inks = {
  light: { line: 'rgb(20 26 46 / 0.65)', halo: 'rgb(255 255 255 / 0.75)' },
  dark: { line: 'rgb(222 229 255 / 0.6)', halo: 'rgb(0 0 0 / 0.65)' },
};

/** Whether an image is light or dark, seen from afar. */
function ground(image) {
  const canvas = new OffscreenCanvas(8, 8);
  const context = canvas.getContext('2d');
  context.drawImage(image, 0, 0, 8, 8);
  const { data } = context.getImageData(0, 0, 8, 8);
  let sum = 0;
  for (let i = 0; i < data.length; i += 4) sum += 0.3 * data[i] + 0.6 * data[i + 1] + 0.1 * data[i + 2];
  return sum / (data.length / 4) > 110 ? 'light' : 'dark';
}

/** Halfedges at which two charts meet or one ends, and one of each other edge. */
function sortHalfedges(triangles, edges, seam) {
  const inner = [], outer = [];
  for (const t of triangles)
    for (let h = 3 * t; h < 3 * t + 3; ++h) {
      const e = edges.edgeOf[h];
      if (seam[e]) outer.push(h);
      else if (edges.first[e] === h) inner.push(h);
    }
  return { inner, outer };
}

function prepared(canvas) {
  const ratio = Math.min(2, window.devicePixelRatio);
  const { width, height } = canvas.getBoundingClientRect();
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const context = canvas.getContext('2d');
  context.scale(ratio, ratio);
  context.lineCap = context.lineJoin = 'round';
  return { context, width, height };
}

/** `image`: under the triangles, or null. `box`: what is to be seen. `theme`: {dark, fill, frame, seam}. */
export function drawAtlas(canvas, { mesh, edges, seam, triangles, box, image, theme }) {
  const { context, width, height } = prepared(canvas);
  const at = placement(box, width, height);
  const ink = inks[image ? ground(image) : theme.dark ? 'dark' : 'light'];
  context.fillStyle = theme.fill;
  if (image) drawImages(context, image, box, at);
  else fillTriangles(context, mesh, at, triangles);

  const stroke = (color, lineWidth, halfedges) => {
    Object.assign(context, { strokeStyle: color, lineWidth });
    strokeSegments(context, mesh, at, halfedges);
  };
  const { inner, outer } = sortHalfedges(triangles, edges, seam);
  // Lines of a fine mesh would become a solid area.
  context.globalAlpha = Math.max(0.15, Math.min(1, 60 / Math.sqrt(triangles.length || 1)));
  stroke(ink.line, 0.75, inner);
  context.globalAlpha = 1;
  Object.assign(context, { strokeStyle: theme.frame, lineWidth: 1 });
  context.strokeRect(at.x(0), at.y(1), at.scale, at.scale);
  stroke(ink.halo, 3.5, outer);
  stroke(theme.seam, 1.5, outer);
}
