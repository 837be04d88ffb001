// SPDX-License-Identifier: BSD-3-Clause
// The 3D views: one canvas behind both panes, one camera, one set of controls.
import { MathUtils, PerspectiveCamera, Spherical, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const start = new Spherical(1, MathUtils.degToRad(72), MathUtils.degToRad(35));
const keyStep = MathUtils.degToRad(10);

export class Stage {
  /** \throw Error where there is no WebGL */
  constructor(element, canvas, radius) {
    this.element = element;
    this.canvas = canvas;
    this.radius = radius;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.setScissorTest(true);
    this.camera = new PerspectiveCamera(35, 1, 0.005, 100);
    this.controls = new OrbitControls(this.camera, element);
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.2;
    this.controls.minDistance = 0.02;
    this.controls.maxDistance = 20;
    this.controls.addEventListener('change', () => this.redraw());
    this.views = [];
    element.addEventListener('keydown', (event) => this.key(event));
    new ResizeObserver(() => this.resize()).observe(element);
  }

  get anisotropy() {
    return this.renderer.capabilities.getMaxAnisotropy();
  }

  add(view) {
    this.views.push(view);
  }

  /** The mesh of the given radius fills a pane, seen from the front, a little from above. */
  reset() {
    const half = MathUtils.degToRad(this.camera.fov / 2);
    const narrow = Math.min(1, this.camera.aspect);
    this.controls.enableDamping = false; // ends a turn that still goes on
    this.controls.update();
    this.controls.enableDamping = true;
    this.controls.target.set(0, 0, 0);
    this.camera.position.setFromSpherical(start).multiplyScalar((1.06 * this.radius) / Math.sin(half) / narrow);
    this.controls.update();
    this.redraw();
  }

  resize() {
    const { width, height } = this.element.getBoundingClientRect();
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.renderer.setSize(width, height, false);
    const pane = this.views[0]?.pane.getBoundingClientRect();
    if (pane?.height > 0) {
      this.camera.aspect = pane.width / pane.height;
      this.camera.updateProjectionMatrix();
    }
    this.draw(); // at once: a canvas that changed its size is empty
  }

  /** Draws with the next frame. */
  redraw() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      if (this.controls.update()) this.redraw(); // until damping has ended
      this.draw();
    });
  }

  draw() {
    const box = this.canvas.getBoundingClientRect();
    for (const view of this.views) view.draw(this.renderer, this.camera, box);
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const turns = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const zooms = { '+': 0.87, '=': 0.87, '-': 1.15 };
    if (event.key in turns) this.turn(...turns[event.key]);
    else if (event.key in zooms) this.zoom(zooms[event.key]);
    else if (event.key === '0' || event.key === 'Home') this.reset();
    else return;
    event.preventDefault();
  }

  turn(right, down) {
    const offset = new Vector3().subVectors(this.camera.position, this.controls.target);
    const at = new Spherical().setFromVector3(offset);
    at.theta += right * keyStep;
    at.phi += down * keyStep;
    offset.setFromSpherical(at.makeSafe());
    this.camera.position.addVectors(this.controls.target, offset);
    this.redraw();
  }

  zoom(factor) {
    this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    this.redraw();
  }
}
