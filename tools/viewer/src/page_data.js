// SPDX-License-Identifier: BSD-3-Clause
// What C++ put into the page: one JSON text, and binary blocks in base64.

/** A texture coordinate index that means: none. */
export const none = 0xffffffff;

function text(id) {
  const block = document.getElementById(id);
  return block ? block.textContent : '';
}

function bytes(base64) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(base64);
  const binary = atob(base64);
  const result = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) result[i] = binary.charCodeAt(i);
  return result;
}

/** The block as little-endian numbers of four bytes, which all machines with a browser have. */
function numbers(id, Type) {
  const block = bytes(text(id));
  // The text is a third larger than the numbers, and is not needed again.
  document.getElementById(id)?.remove();
  return new Type(block.buffer, block.byteOffset, block.byteLength / 4);
}

function readMesh(name, header) {
  return {
    ...header,
    name,
    positions: numbers(`${name}-positions`, Float32Array), // #V x 3, centred, bounding-box diagonal 1
    texcoords: numbers(`${name}-texcoords`, Float32Array), // #VT x 2
    position: numbers(`${name}-position`, Uint32Array), // per corner
    texcoord: numbers(`${name}-texcoord`, Uint32Array), // per corner; empty: no texture coordinates
    material: numbers(`${name}-material`, Uint32Array), // per triangle; empty: all of the first material
  };
}

/**
 * {title, notes, numbers, textures: [{name, uri}], before, after}; a mesh that was left out is null. The mesh after
 * has errors: [{name, values: per position}], that before has none.
 */
export function readPage() {
  const report = JSON.parse(text('report'));
  const mesh = (name) => (report.meshes[name]?.included ? readMesh(name, report.meshes[name]) : null);
  const textures = report.textures.map((texture, i) => ({ ...texture, uri: text(`texture-${i}`) }));
  const errors = report.errors.map((name, i) => ({ name, values: numbers(`after-error-${i}`, Float32Array) }));
  const [before, after] = [mesh('before'), mesh('after')];
  return {
    ...report,
    textures,
    before: before && { ...before, errors: [] },
    after: after && { ...after, errors },
  };
}
