// Chromium for the tests: a page that must not complain, and what axe-core says of it.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, afterEach } from 'node:test';
import assert from 'node:assert/strict';
import { chromium } from 'playwright-core';

const axeSource = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
export const cylon = join(process.env.CYLON_BINARY_DIR, 'cylon');

/** A folder that is gone after the tests of the file. */
export function scratch() {
  const folder = mkdtempSync(join(tmpdir(), 'cylon-web-'));
  after(() => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

/** Runs cylon; fails the test unless it exits with `code`. */
export function run(folder, args, code = 0) {
  const ran = spawnSync(cylon, args, { cwd: folder, encoding: 'utf8', maxBuffer: 1 << 28 });
  assert.equal(ran.status, code, `cylon ${args.join(' ')}: ${ran.stderr}`);
  return ran;
}

/** How long a page may take for anything [ms]: a machine may be busy, and no test is about speed. */
export const patience = 180_000;

let browser;
after(async () => browser?.close());

// A page that is left open would go on drawing, in software, beside the tests after it.
const places = new Set();
afterEach(async () => {
  const open = [...places];
  places.clear();
  await Promise.all(open.map((place) => place.close()));
});

/** A page in a context of its own, open until the test ends.  `page.faults` gathers script errors, console errors, dialogs
 * and every request that is not for the page itself. */
export async function open(url, { width = 1280, height = 900, scheme = 'light', ...context } = {}) {
  browser ??= await chromium.launch({
    executablePath: process.env.CHROMIUM ?? spawnSync('sh', ['-c', 'command -v chromium'], { encoding: 'utf8' }).stdout.trim(),
    args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });
  const place = await browser.newContext({ viewport: { width, height }, colorScheme: scheme, ...context });
  places.add(place);
  const page = await place.newPage();
  page.setDefaultTimeout(patience);
  page.faults = [];
  page.on('pageerror', (error) => page.faults.push(`error: ${error.message}`));
  page.on('console', (message) => message.type() === 'error' && page.faults.push(`console: ${message.text()}`));
  page.on('dialog', (dialog) => {
    page.faults.push(`dialog: ${dialog.message()}`);
    dialog.dismiss();
  });
  const origin = url.startsWith('file:') ? 'file:' : new URL(url).origin;
  page.on('request', (request) => {
    if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(origin))
      page.faults.push(`request: ${request.url()}`);
  });
  await page.goto(url);
  return page;
}

/** Serious and critical faults of accessibility, a line each. */
export async function accessibilityFaults(page) {
  // The page's own policy forbids foreign scripts; evaluate() is not bound by it.
  await page.evaluate(axeSource);
  const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ['violations'] }));
  return violations
    .filter((v) => v.impact === 'serious' || v.impact === 'critical')
    .map((v) => `${v.id} (${v.impact}): ${v.nodes.slice(0, 3).map((n) => n.html.slice(0, 160)).join(' | ')}`);
}
