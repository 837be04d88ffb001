// SPDX-License-Identifier: BSD-3-Clause
// Pages in headless Chromium. Whatever the page says on its console, and any request, is a failure.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';

const names = ['modules', 'program', 'make-page', 'data', 'work', 'artifacts'];
export const { values: settings } = parseArgs({
  options: Object.fromEntries(names.map((name) => [name, { type: 'string' }])),
});

function skip(reason) {
  console.log(`skipped: ${reason}`);
  process.exit(77);
}

function chromiumPath() {
  const places = [process.env.CHROMIUM, '/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'];
  return places.find((path) => path && existsSync(path)) ?? skip('no Chromium; scripts/setup-debian.sh installs it');
}

function playwright() {
  const modules = settings.modules;
  if (!existsSync(join(modules, 'playwright-core'))) skip('no playwright-core; is there a network?');
  return createRequire(join(modules, 'any.cjs'))('playwright-core');
}

/** WebGL on the processor; and nothing in the background that would look for hosts. */
const flags = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-quic',
  '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'];

/** Calls test(browser); closes the browser whatever happens. */
export async function withBrowser(test) {
  rmSync(settings.work, { recursive: true, force: true });
  mkdirSync(settings.work, { recursive: true });
  mkdirSync(settings.artifacts, { recursive: true });
  const browser = await playwright().chromium.launch({
    executablePath: chromiumPath(),
    args: flags,
    chromiumSandbox: process.getuid() !== 0, // which root cannot have
  });
  try {
    await test(browser);
  } finally {
    await browser.close();
  }
}

/** Runs one of our programs in the directory of the test. */
export function run(program, ...args) {
  execFileSync(settings[program], args, { cwd: settings.work, stdio: ['ignore', 'inherit', 'inherit'] });
}

/** Opens a file of the work directory, waits until it has drawn, calls test(page), and checks that it was silent. */
export async function withPage(browser, file, test, options = {}) {
  const context = await browser.newContext({ viewport: { width: 960, height: 640 }, ...options });
  const page = await context.newPage();
  const url = pathToFileURL(join(settings.work, file)).href;
  const said = [];
  page.on('console', (message) => said.push(`${message.type()}: ${message.text()}`));
  page.on('pageerror', (error) => said.push(`exception: ${error.stack}`));
  page.on('request', (request) => {
    if (request.url() !== url && !request.url().startsWith('data:')) said.push(`request: ${request.url()}`);
  });
  await page.goto(url);
  await page.waitForSelector('html[data-ready="1"]', { state: 'attached', timeout: 120000 }).catch((error) => {
    throw new Error(`${file} did not become ready: ${error.message}\n${said.join('\n')}`);
  });
  await test(page);
  // What software rendering makes Chromium say is not ours.
  const ours = said.filter((line) => !line.includes('GPU stall due to ReadPixels'));
  assert.deepEqual(ours, [], `${file} says nothing and asks for nothing`);
  await context.close();
}
