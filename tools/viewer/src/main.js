// SPDX-License-Identifier: BSD-3-Clause
// Fills the page. Every part works without the others: without WebGL there are still the atlases and the numbers.
import { AtlasCard } from './atlas_card.js';
import { findEdges, findSeams } from './edges.js';
import { byId, element } from './element.js';
import { histogram } from './histogram.js';
import { loadImages } from './images.js';
import { errorScale } from './legend.js';
import { formatNumber } from './number_format.js';
import { keyFigures, numberTables } from './numbers.js';
import { readPage } from './page_data.js';
import { SurfaceCard } from './surface_card.js';

const sides = { before: 'Before', after: 'After' };

/** The meshes that are in the page, with what is derived from them. */
function readMeshes(page) {
  return Object.keys(sides)
    .filter((name) => page[name])
    .map((name) => {
      const mesh = page[name];
      const edges = findEdges(mesh.position);
      return { name, mesh, edges, seam: findSeams(mesh, edges), hasTexcoords: mesh.texcoord.length > 0 };
    });
}

function fillCaptions(page) {
  for (const name of Object.keys(sides)) {
    if (!page.meshes[name]) {  // there is one mesh only
      byId(`pane-${name}`).hidden = true;
      byId('stage').classList.add('single');
      continue;
    }
    const { caption, triangles, included } = page.meshes[name];
    const side = page.meshes.before ? sides[name] : 'Mesh';
    const faces = element('span', { class: 'more' }, ` ${caption} · ${formatNumber(triangles)} faces`);
    byId(`pane-${name}`).querySelector('figcaption').append(element('strong', {}, side), faces);
    byId(`atlas-${name}`).previousElementSibling.append(element('strong', {}, side), faces.cloneNode(true));
    byId(`atlas-${name}`).setAttribute('aria-label', `${side}: the triangles in the texture plane`);
    if (!included)
      byId(`pane-${name}`).append(element('p', { class: 'left-out' }, 'Not in this page, see the notes.'));
  }
}

function fillNumbers(page, scales) {
  byId('figures').append(...keyFigures(page, scales));
  byId('numbers').append(...numberTables(page.numbers));
}

function fillHistograms(histograms) {
  byId('histogram-card').hidden = histograms.length === 0;
  byId('histograms').append(...histograms.map(histogram));
}

function fillNotes(notes) {
  byId('notices').hidden = notes.length === 0;
  byId('notes').replaceChildren(...notes.map((note) => element('li', {}, note)));
}

async function main() {
  const page = readPage();
  const notes = [...page.notes, ...(page.numbers.warnings ?? []).map(String)];
  const scales = (page.after?.errors ?? []).map(errorScale);
  byId('title').textContent = page.title;
  byId('generator').textContent = page.generator;
  fillCaptions(page);
  fillNumbers(page, scales);
  fillHistograms(page.histograms);
  fillNotes(notes);

  const meshes = readMeshes(page);
  const images = await loadImages(page.textures, notes);
  const atlas = new AtlasCard(meshes, images);
  try {
    new SurfaceCard(meshes, images, scales, page.periods).start();
  } catch (error) {
    notes.push(`No 3D views: ${error.message}`);
  }
  atlas.draw();
  fillNotes(notes);
  // Two frames later what was asked for is on the screen.
  requestAnimationFrame(() => requestAnimationFrame(() => (document.documentElement.dataset.ready = '1')));
}

main();
