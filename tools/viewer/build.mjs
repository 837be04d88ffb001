// SPDX-License-Identifier: BSD-3-Clause
// Bundles src/ into viewer.js, viewer.css and page.html, and those into viewer_bundle.cpp.
//
//   node build.mjs [--modules DIR] [--out DIR]      default: node_modules and dist, here
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { bundleSource } from './bundle_source.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const { values } = parseArgs({ options: { modules: { type: 'string' }, out: { type: 'string' } } });
const modules = resolve(values.modules ?? join(here, 'node_modules'));
const out = resolve(values.out ?? join(here, 'dist'));
// node_modules may be elsewhere: the build of CMake writes nothing into the source tree.
const esbuild = createRequire(join(modules, 'any.cjs'))('esbuild');

// The licence asks that its text goes with every copy; esbuild alone keeps the line that names it.
const licence = readFileSync(join(modules, 'three/LICENSE'), 'utf8').trim();
const banner = `/*! three.js (https://threejs.org)\n\n${licence}\n*/`;

const common = { bundle: true, minify: true, charset: 'ascii', outdir: out, logLevel: 'warning' };
await esbuild.build({
  ...common,
  entryPoints: { viewer: join(here, 'src/main.js') },
  format: 'iife',
  target: ['chrome100', 'firefox100', 'safari15'],
  legalComments: 'inline',
  banner: { js: banner },
  nodePaths: [modules],
});
await esbuild.build({ ...common, entryPoints: { viewer: join(here, 'src/page.css') } });

mkdirSync(out, { recursive: true });
const page = readFileSync(join(here, 'src/page.html'), 'utf8');
const script = readFileSync(join(out, 'viewer.js'), 'utf8');
const style = readFileSync(join(out, 'viewer.css'), 'utf8');
writeFileSync(join(out, 'viewer_bundle.cpp'), bundleSource({ page, script, style }));
