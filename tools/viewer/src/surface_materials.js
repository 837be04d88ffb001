// SPDX-License-Identifier: BSD-3-Clause
// How a surface looks in each mode: a material of three.js per run of triangles.
import {
  CanvasTexture,
  ClampToEdgeWrapping,
  Color,
  DataTexture,
  DoubleSide,
  LinearFilter,
  MeshLambertMaterial,
  RepeatWrapping,
  SRGBColorSpace,
  Texture,
} from 'three';
import { checkerCanvas } from './checker.js';
import { ramp } from './color_ramp.js';

const plainColor = 0xb9bec9;

function repeating(texture, anisotropy) {
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.colorSpace = SRGBColorSpace;
  texture.anisotropy = anisotropy;
  texture.needsUpdate = true;
  return texture;
}

function rampTexture() {
  const width = 256;
  const data = new Uint8Array(4 * width);
  for (let i = 0; i < width; ++i) data.set([...ramp(i / (width - 1)).map((c) => Math.round(255 * c)), 255], 4 * i);
  const texture = new DataTexture(data, width, 1);
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.wrapS = texture.wrapT = ClampToEdgeWrapping;
  texture.colorSpace = SRGBColorSpace;
  texture.channel = 1; // its coordinates are the attribute uv1
  texture.needsUpdate = true;
  return texture;
}

/** Shared by both views; `images` is one image or null per texture of the page. */
export class SurfaceMaterials {
  constructor(images, anisotropy) {
    this.textures = images.map((image) => image && repeating(new Texture(image), anisotropy));
    this.checker = repeating(new CanvasTexture(checkerCanvas()), anisotropy);
    this.ramp = rampTexture();
    this.flat = false;
    this.made = [];
  }

  /** The materials of a mesh in a mode, one per run. Modes: `textured`, `plain`, `checker`, `error`. */
  of(mesh, runs, mode) {
    return runs.map((run) => this.make(this.appearance(mesh, run, mode)));
  }

  setFlat(flat) {
    this.flat = flat;
    for (const material of this.made) {
      material.flatShading = flat;
      material.needsUpdate = true;
    }
  }

  appearance(mesh, run, mode) {
    const plain = { color: new Color(plainColor) };
    const checker = run.hasTexcoords ? { map: this.checker } : plain;
    if (mode === 'checker') return checker;
    // Light alone would change what the colours mean; none would hide the shape.
    if (mode === 'error' && mesh.errors.length > 0)
      return { color: new Color(0.35, 0.35, 0.35), map: this.ramp, emissive: new Color(0.65, 0.65, 0.65),
        emissiveMap: this.ramp };
    if (mode !== 'textured') return plain;
    const { texture, color } = mesh.materials[run.material];
    if (texture === null || !run.hasTexcoords)
      return { color: new Color().setRGB(color[0], color[1], color[2], SRGBColorSpace) };
    return this.textures[texture] ? { map: this.textures[texture] } : checker;
  }

  make(appearance) {
    const material = new MeshLambertMaterial({
      ...appearance,
      side: DoubleSide,
      flatShading: this.flat,
      polygonOffset: true, // lines on the surface are in front of it
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    });
    this.made.push(material);
    return material;
  }
}
