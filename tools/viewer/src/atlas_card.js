// SPDX-License-Identifier: BSD-3-Clause
// The atlases, with a choice of the material where there are several.
import { bounds, drawAtlas, trianglesOf, unitSquare } from './atlas.js';
import { byId, element } from './element.js';
import { none } from './page_data.js';
import { isDark, onThemeChange, themeColor } from './theme.js';

const all = -1;

/** Names of the materials of triangles with texture coordinates, the one with most of them first. */
function materialNames(meshes) {
  const counts = new Map();
  for (const { mesh, hasTexcoords } of meshes)
    for (let t = 0; hasTexcoords && t < mesh.position.length / 3; ++t) {
      if (mesh.texcoord[3 * t] === none) continue;
      const { name } = mesh.materials[mesh.material[t] ?? 0];
      counts.set(name, (counts.get(name) ?? 0) + 1);
    }
  return [...counts.keys()].sort((a, b) => counts.get(b) - counts.get(a));
}

export class AtlasCard {
  constructor(meshes, images) {
    this.meshes = meshes.filter((each) => each.hasTexcoords);
    this.images = images;
    this.names = materialNames(this.meshes);
    this.select = byId('material');
    byId('atlas-card').hidden = this.names.length === 0;
    byId('material-choice').hidden = this.names.length < 2;
    this.names.forEach((name, i) => this.select.append(element('option', { value: i }, name || '(no name)')));
    this.select.append(element('option', { value: all }, 'All materials'));
    for (const name of ['before', 'after'])
      byId(`atlas-${name}`).parentElement.hidden = !this.meshes.some((each) => each.name === name);
    this.select.addEventListener('change', () => this.draw());
    onThemeChange(() => this.draw());
    let timer = 0;
    window.addEventListener('resize', () => {
      clearTimeout(timer);
      timer = setTimeout(() => this.draw(), 150);
    });
  }

  draw() {
    const theme = {
      dark: isDark(),
      fill: themeColor('--atlas-fill'),
      frame: themeColor('--faint'),
      seam: themeColor('--seam'),
    };
    const name = this.names[this.names.length === 1 ? 0 : Number(this.select.value)];
    const shown = this.meshes.map((each) => ({ ...each, ...this.choose(each.mesh, name) }));
    // One box for both: what was not moved is at the same place.
    const box = shown.reduce((grown, each) => bounds(each.mesh, each.triangles, grown), unitSquare);
    for (const each of shown) drawAtlas(byId(`atlas-${each.name}`), { ...each, box, theme });
  }

  /** Triangles and image of the material of that name; undefined: all materials. */
  choose(mesh, name) {
    if (name === undefined) return { triangles: trianglesOf(mesh, all), image: null };
    const material = mesh.materials.findIndex((m) => m.name === name);
    if (material < 0) return { triangles: [], image: null };
    const { texture } = mesh.materials[material];
    return { triangles: trianglesOf(mesh, material), image: texture === null ? null : this.images[texture] };
  }
}
