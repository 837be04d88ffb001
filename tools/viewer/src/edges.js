// SPDX-License-Identifier: BSD-3-Clause
// Edges of a triangle mesh by positions, and which of them are seams. Halfedge h goes from corner h to the next
// corner of its triangle.
import { none } from './page_data.js';

export const next = (h) => (h % 3 === 2 ? h - 2 : h + 1);

/** The corner of h at the smaller position index, and the one at the larger. */
function corners(position, h) {
  const n = next(h);
  return position[h] < position[n] ? [h, n] : [n, h];
}

/**
 * {count, edgeOf: per halfedge, first: per edge its first halfedge, faces: per edge their number}
 * An open hash table: linear in the number of triangles, whatever the mesh looks like.
 */
export function findEdges(position) {
  const size = 1 << Math.ceil(Math.log2(2 * position.length + 2));
  const table = new Int32Array(size).fill(-1);
  const edgeOf = new Uint32Array(position.length);
  const first = new Uint32Array(position.length);
  const faces = new Uint32Array(position.length);
  let count = 0;
  for (let h = 0; h < position.length; ++h) {
    const n = next(h);
    const low = Math.min(position[h], position[n]);
    const high = Math.max(position[h], position[n]);
    let slot = (Math.imul(low, 0x9e3779b1) ^ Math.imul(high, 0x85ebca6b)) >>> 0;
    for (slot = (slot ^ (slot >>> 15)) & (size - 1); table[slot] >= 0; slot = (slot + 1) & (size - 1)) {
      const [a, b] = corners(position, first[table[slot]]);
      if (position[a] === low && position[b] === high) break;
    }
    if (table[slot] < 0) {
      first[count] = h;
      table[slot] = count++;
    }
    edgeOf[h] = table[slot];
    ++faces[edgeOf[h]];
  }
  return { count, edgeOf, first: first.slice(0, count), faces: faces.slice(0, count) };
}

function sameTexcoord(mesh, a, b) {
  const s = mesh.texcoord[a], t = mesh.texcoord[b];
  if (s === t) return true;
  if (s === none || t === none) return false;
  // By value, as the program decides: a coordinate that a file has twice is no seam.
  return mesh.texcoords[2 * s] === mesh.texcoords[2 * t] && mesh.texcoords[2 * s + 1] === mesh.texcoords[2 * t + 1];
}

/** Per edge 1 if the texture is cut open there, or the surface ends. */
export function findSeams(mesh, edges) {
  const seam = new Uint8Array(edges.count);
  for (let e = 0; e < edges.count; ++e) seam[e] = edges.faces[e] === 2 ? 0 : 1;
  if (mesh.texcoord.length === 0) return seam;
  for (let h = 0; h < edges.edgeOf.length; ++h) {
    const e = edges.edgeOf[h];
    if (seam[e] || edges.first[e] === h) continue;
    const [a, b] = corners(mesh.position, h);
    const [c, d] = corners(mesh.position, edges.first[e]);
    if (!sameTexcoord(mesh, a, c) || !sameTexcoord(mesh, b, d)) seam[e] = 1;
  }
  return seam;
}
