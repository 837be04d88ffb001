// SPDX-License-Identifier: BSD-3-Clause
// One mesh with its light, its lines, and the part of the page that it is drawn into.
import {
  BufferAttribute,
  BufferGeometry,
  DirectionalLight,
  Group,
  HemisphereLight,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  Scene,
} from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { segments, surfaceGeometry } from './geometry.js';

export class SceneView {
  /** `edges` and `seam` as of edges.js, `scales` of the errors as of legend.js. */
  constructor({ mesh, pane, edges, seam, scales, materials }) {
    this.mesh = mesh;
    this.pane = pane;
    this.edges = edges;
    this.seam = seam;
    this.materials = materials;
    this.scene = new Scene();
    this.light = new DirectionalLight(0xffffff, 1.9);
    this.scene.add(new HemisphereLight(0xffffff, 0x8d8f99, 1.7), this.light);
    const { geometry, runs, errors } = surfaceGeometry(mesh, scales);
    this.runs = runs;
    this.errors = errors;
    this.surface = new Mesh(geometry);
    this.tile = new Group();
    this.tile.add(this.surface);
    this.scene.add(this.tile);
    this.places = [[0, 0, 0]];
    this.byMode = new Map();
    this.lines = new Map();
  }

  /** A mode of surface_materials.js; `error`: which, in that mode. */
  setMode(mode, error) {
    if (mode === 'error' && this.errors.length > 0) this.surface.geometry.setAttribute('uv1', this.errors[error]);
    if (!this.byMode.has(mode)) this.byMode.set(mode, this.materials.of(this.mesh, this.runs, mode));
    this.surface.material = this.byMode.get(mode);
  }

  /** Triangles of a material whose name says that it is that of a side of a tile. */
  showSides(show) {
    const { geometry } = this.surface;
    geometry.clearGroups();
    this.runs.forEach((run, i) => {
      if (show || !this.mesh.materials[run.material].name.startsWith('side '))
        geometry.addGroup(3 * run.begin, 3 * run.count, i);
    });
  }

  showWireframe(show) {
    this.show('wireframe', show, () => {
      const geometry = new BufferGeometry();
      const ends = segments(this.mesh, this.edges, () => true);
      geometry.setAttribute('position', new BufferAttribute(ends, 3));
      return new LineSegments(geometry, new LineBasicMaterial({ color: 0x10131c, transparent: true, opacity: 0.55 }));
    });
  }

  showSeams(show, color) {
    this.show('seams', show, () => {
      // Wider than one pixel, which WebGL's own lines cannot be.
      const geometry = new LineSegmentsGeometry();
      geometry.setPositions(segments(this.mesh, this.edges, (e) => this.seam[e] === 1));
      const lines = new LineSegments2(geometry, new LineMaterial({ linewidth: 2.5 }));
      lines.renderOrder = 1;
      return lines;
    });
    this.lines.get('seams')?.material.color.set(color);
  }

  /** Lines are made when they are first asked for. */
  show(name, visible, make) {
    if (visible && !this.lines.has(name)) {
      this.lines.set(name, make());
      this.tile.add(this.lines.get(name));
    }
    if (this.lines.has(name)) this.lines.get(name).visible = visible;
  }

  /** Into the part of the canvas that lies over the pane. */
  draw(renderer, camera, canvasBox) {
    const box = this.pane.getBoundingClientRect();
    if (box.width < 1 || box.height < 1) return;
    const left = box.left - canvasBox.left;
    const bottom = canvasBox.bottom - box.bottom;
    renderer.setViewport(left, bottom, box.width, box.height);
    renderer.setScissor(left, bottom, box.width, box.height);
    this.light.position.copy(camera.position).add(camera.up);
    this.places.forEach((place, i) => {
      this.tile.position.set(...place);
      renderer.autoClear = i === 0;
      renderer.render(this.scene, camera);
    });
    renderer.autoClear = true;
  }
}
