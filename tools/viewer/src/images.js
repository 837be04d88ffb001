// SPDX-License-Identifier: BSD-3-Clause
// Texture images of the page.

/** No side longer than this: graphics processors have limits, and a picture of a mesh needs no more. */
const largestSide = 8192;

function shrunk(image) {
  const factor = largestSide / Math.max(image.naturalWidth, image.naturalHeight);
  if (factor >= 1) return image;
  const canvas = document.createElement('canvas');
  canvas.width = Math.max(1, Math.round(factor * image.naturalWidth));
  canvas.height = Math.max(1, Math.round(factor * image.naturalHeight));
  canvas.getContext('2d').drawImage(image, 0, 0, canvas.width, canvas.height);
  return canvas;
}

/** An image or canvas per texture; null where there is none. What cannot be decoded adds a note. */
export async function loadImages(textures, notes) {
  const load = async ({ name, uri }) => {
    if (!uri) return null; // C++ has written a note
    const image = new Image();
    image.src = uri;
    try {
      await image.decode();
      return shrunk(image);
    } catch {
      notes.push(`texture ${name}: the image cannot be decoded; a checker pattern is shown instead`);
      return null;
    }
  };
  return Promise.all(textures.map(load));
}
