// SPDX-License-Identifier: BSD-3-Clause
// A mesh of the page as geometries of three.js.
import { BufferAttribute, BufferGeometry } from 'three';
import { next } from './edges.js';
import { none } from './page_data.js';

/** One vertex per distinct pair of position and texture coordinate: [vertex of each corner, a corner of each]. */
function joinCorners({ position, texcoord, positions }) {
  const head = new Int32Array(positions.length / 3).fill(-1);
  const following = new Int32Array(position.length);
  const corner = new Uint32Array(position.length);
  const vertex = new Uint32Array(position.length);
  let count = 0;
  for (let c = 0; c < position.length; ++c) {
    let v = head[position[c]];
    while (v >= 0 && texcoord.length > 0 && texcoord[corner[v]] !== texcoord[c]) v = following[v];
    if (v < 0) {
      v = count++;
      corner[v] = c;
      following[v] = head[position[c]];
      head[position[c]] = v;
    }
    vertex[c] = v;
  }
  return [vertex, corner.slice(0, count)];
}

/** Per position the mean of the normals around it, weighted by area: shading does not show the seams. */
function normalsByPosition({ position, positions }) {
  const sum = new Float32Array(positions.length);
  const p = positions;
  for (let c = 0; c < position.length; c += 3) {
    const a = 3 * position[c], b = 3 * position[c + 1], d = 3 * position[c + 2];
    const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
    const vx = p[d] - p[a], vy = p[d + 1] - p[a + 1], vz = p[d + 2] - p[a + 2];
    for (const i of [a, b, d]) {
      sum[i] += uy * vz - uz * vy;
      sum[i + 1] += uz * vx - ux * vz;
      sum[i + 2] += ux * vy - uy * vx;
    }
  }
  for (let i = 0; i < sum.length; i += 3) {
    const length = Math.hypot(sum[i], sum[i + 1], sum[i + 2]) || 1;
    for (let k = 0; k < 3; ++k) sum[i + k] /= length;
  }
  return sum;
}

/** Values per position or texture coordinate, as values per vertex. */
function gather(values, width, index, corner) {
  const result = new Float32Array(width * corner.length);
  for (let v = 0; v < corner.length; ++v) {
    const from = index[corner[v]];
    if (from === none) continue;
    for (let k = 0; k < width; ++k) result[width * v + k] = values[width * from + k];
  }
  return result;
}

/** Triangles in runs of one material: [order of the triangles, [{material, hasTexcoords, begin, count}]]. */
function sortByMaterial({ position, texcoord, material, materials }) {
  const key = (t) => 2 * (material[t] ?? 0) + (texcoord.length > 0 && texcoord[3 * t] !== none ? 1 : 0);
  const begin = new Uint32Array(2 * materials.length + 1);
  const triangles = position.length / 3;
  for (let t = 0; t < triangles; ++t) ++begin[key(t) + 1];
  for (let k = 1; k < begin.length; ++k) begin[k] += begin[k - 1];
  const runs = materials
    .flatMap((_, m) => [0, 1].map((has) => ({ material: m, hasTexcoords: has === 1, key: 2 * m + has })))
    .map((run) => ({ ...run, begin: begin[run.key], count: begin[run.key + 1] - begin[run.key] }))
    .filter((run) => run.count > 0);
  const order = new Uint32Array(triangles);
  const at = begin.slice();
  for (let t = 0; t < triangles; ++t) order[at[key(t)]++] = t;
  return [order, runs];
}

/** Places of errors on the colour map, as texture coordinates per vertex. `scale`: the error at its end. */
function errorPlaces(values, scale, position, corner) {
  const places = new Float32Array(2 * values.length).fill(0.5);
  values.forEach((error, i) => (places[2 * i] = Math.min(1, error / scale)));
  return new BufferAttribute(gather(places, 2, position, corner), 2);
}

/**
 * {geometry, runs, errors}: group i of the geometry is runs[i]; errors are attributes for the colour map, one for
 * each error of the mesh. `scales`: as of legend.js, one for each error.
 */
export function surfaceGeometry(mesh, scales) {
  const [vertex, corner] = joinCorners(mesh);
  const [order, runs] = sortByMaterial(mesh);
  const index = new Uint32Array(vertex.length);
  order.forEach((t, i) => index.set(vertex.subarray(3 * t, 3 * t + 3), 3 * i));

  const geometry = new BufferGeometry();
  const set = (name, values, width) => geometry.setAttribute(name, new BufferAttribute(values, width));
  geometry.setIndex(new BufferAttribute(index, 1));
  set('position', gather(mesh.positions, 3, mesh.position, corner), 3);
  set('normal', gather(normalsByPosition(mesh), 3, mesh.position, corner), 3);
  if (mesh.texcoord.length > 0) set('uv', gather(mesh.texcoords, 2, mesh.texcoord, corner), 2);
  runs.forEach((run, i) => geometry.addGroup(3 * run.begin, 3 * run.count, i));
  const errors = mesh.errors.map(({ values }, i) => errorPlaces(values, scales[i].scale, mesh.position, corner));
  return { geometry, runs, errors };
}

/** The ends of the edges for which wanted(edge) holds: six coordinates for each. */
export function segments(mesh, edges, wanted) {
  let count = 0;
  for (let e = 0; e < edges.count; ++e) count += wanted(e) ? 1 : 0;
  const ends = new Float32Array(6 * count);
  let at = 0;
  for (let e = 0; e < edges.count; ++e) {
    if (!wanted(e)) continue;
    const h = edges.first[e];
    for (const p of [mesh.position[h], mesh.position[next(h)]])
      for (let k = 0; k < 3; ++k) ends[at++] = mesh.positions[3 * p + k];
  }
  return ends;
}
