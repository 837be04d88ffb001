// SPDX-License-Identifier: BSD-3-Clause
// The 3D views with their controls.
import { byId, element } from './element.js';
import { fillLegend } from './legend.js';
import { SceneView } from './scene_view.js';
import { Stage } from './stage.js';
import { SurfaceMaterials } from './surface_materials.js';
import { onThemeChange, themeColor } from './theme.js';

/** Of all vertices, around the origin. */
function radius(meshes) {
  let square = 0;
  for (const { mesh } of meshes)
    for (let i = 0; i < mesh.positions.length; i += 3)
      square = Math.max(square, mesh.positions[i] ** 2 + mesh.positions[i + 1] ** 2 + mesh.positions[i + 2] ** 2);
  return Math.sqrt(square) || 1;
}

/** Where the tile lies when it is repeated, two along each period, centred. */
export function cells(periods) {
  return periods.reduce(
    (places, period) => [-0.5, 0.5].flatMap((n) => places.map((p) => p.map((x, k) => x + n * period[k]))),
    [[0, 0, 0]]);
}

export class SurfaceCard {
  /**
   * `scales`: of the errors, see legend.js. `periods`: of tiles; none: the meshes are no tiles.
   * \throw Error where there is no WebGL
   */
  constructor(meshes, images, scales, periods) {
    this.scales = scales;
    this.periods = periods;
    this.isRepeated = false;
    for (const choice of document.querySelectorAll('.tile-only')) choice.hidden = periods.length === 0;
    this.form = byId('toolbar');
    this.stage = new Stage(byId('stage'), byId('canvas'), radius(meshes));
    this.materials = new SurfaceMaterials(images, this.stage.anisotropy);
    for (const each of meshes)
      this.stage.add(new SceneView({
        ...each,
        pane: byId(`pane-${each.name}`),
        scales,
        materials: this.materials,
      }));
    scales.forEach(({ name }, i) => byId('modes').append(this.errorChoice(name, i)));
    this.form.querySelector('input[value=checker]').disabled = !meshes.some((each) => each.hasTexcoords);
  }

  start() {
    this.form.reset(); // browsers keep the state of forms when a page is loaded again
    this.form.addEventListener('change', () => this.apply());
    this.form.addEventListener('submit', (event) => event.preventDefault());
    byId('reset-view').addEventListener('click', () => this.stage.reset());
    onThemeChange(() => this.apply());
    this.apply();
    this.stage.resize();
    this.stage.reset();
    this.stage.draw();
  }

  errorChoice(name, i) {
    const input = element('input', { type: 'radio', name: 'mode', value: 'error', 'data-error': i });
    return element('label', {}, input, element('span', {}, name));
  }

  repeat() {
    this.isRepeated = !this.isRepeated;
    for (const view of this.stage.views) view.places = this.isRepeated ? cells(this.periods) : [[0, 0, 0]];
    this.stage.radius *= this.isRepeated ? 2 : 0.5;
    this.stage.reset();
  }

  apply() {
    const { value: mode, dataset } = this.form.querySelector('input[name=mode]:checked');
    const error = Number(dataset.error ?? 0);
    if (this.materials.flat !== byId('flat').checked) this.materials.setFlat(byId('flat').checked);
    byId('legend').hidden = mode !== 'error';
    if (mode === 'error') fillLegend(byId('legend'), this.scales[error]);
    if (byId('repeat').checked !== this.isRepeated) this.repeat();
    for (const view of this.stage.views) {
      view.showSides(byId('sides').checked);
      view.setMode(mode, error);
      view.showWireframe(byId('wireframe').checked);
      view.showSeams(byId('seams').checked, themeColor('--seam'));
    }
    this.stage.redraw();
  }
}
