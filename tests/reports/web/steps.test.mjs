// The matrix of steps in a real browser: other people's engines first, ours by one click, digits by another.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test, { before } from 'node:test';
import { accessibilityFaults, open, run, scratch } from './browser.mjs';

const folder = scratch();
const url = `file://${join(folder, 'm.html')}`;
let table;

before(() => {
  run(folder, ['matrix', 'projectile', '--engine', 'in-house', '--engine', 'ode', '--rounds', '1', '--html', 'm.html',
    '--json', 'm.json']);
  [table] = JSON.parse(readFileSync(join(folder, 'm.json'), 'utf8')).tables;
});

const heads = (page) => page.locator('table.steps > thead th').allTextContents();

test('the in-house engine is left out until it is asked for, and its closed form has no step', async () => {
  const page = await open(url);
  assert.deepEqual(await heads(page), ['scenario', 'ode']);
  await page.getByRole('checkbox', { name: 'with the in-house engine' }).check();
  assert.deepEqual(await heads(page), ['scenario', 'in-house', 'ode']);
  const text = await page.locator('table.steps > tbody > tr > td').first().innerText();
  assert.match(text, /no steps/);
  assert.match(text, /closed form/);
  assert.doesNotMatch(text, /\bms\b/);
  assert.deepEqual(page.faults, []);
});

test('a cell says the step that the sweep found, or why there is none', async () => {
  const page = await open(url);
  const text = await page.locator('table.steps > tbody > tr > td').first().innerText();
  const cell = table.cells.find(({ series }) => table.series[series].engine === 'ode');
  const { points } = table.series[cell.series];
  const time = / [\d.e+-]+ s\b/; // printed with a prefix
  for (const { point, why } of cell.reach)
    for (const words of point === null ? why.split(time) : [`${1e4 * points[point].dt >= 1 ? 1000 * points[point].dt : 1e6 * points[point].dt}`])
      assert.ok(text.includes(words), text);
  assert.doesNotMatch(text, /e-\d+ s\b/);
});

test('one choice shows digits at a step', async () => {
  const page = await open(url);
  await page.getByLabel('show').selectOption('0.001');
  const text = await page.locator('table.steps > tbody > tr > td').first().innerText();
  const { points } = table.series.find(({ engine }) => engine === 'ode');
  const digits = -Math.log10(points.find(({ dt }) => dt <= 0.001 * (1 + 1e-9)).errors.trajectory);
  assert.ok(text.startsWith(digits.toFixed(1)), text);
});

test('a run of a sweep that ended is no pass', async () => {
  const page = await open(`${url}#section=trade`);
  await page.locator('#trade-heading').waitFor();
  const text = await page.locator('main').innerText();
  assert.match(text, /\bran\b/);
  assert.doesNotMatch(text, /\u2713|\bpass\b/);
});

test('two sweeps of one scenario say what made them, and are one scenario', async () => {
  run(folder, ['trade', 'projectile', '--engine', 'ode', '--rounds', '1', '--json', 'tr.json']);
  run(folder, ['report', 'm.json', 'tr.json', '--html', 'both.html']);
  const page = await open(`file://${join(folder, 'both.html')}`);
  assert.match(await page.locator('section[aria-labelledby="steps-heading"] .count').innerText(), /^1 scenario, /);
  const rows = page.locator('table.steps > tbody > tr > th');
  assert.match((await rows.allInnerTexts()).join('\n'), /^projectile\s+of cylon matrix\s[^]*^projectile\s+of cylon trade\s/m);
  await rows.nth(1).getByRole('link').click();
  assert.equal(await page.locator('section[aria-labelledby="trade-heading"] select').first().inputValue(), 'projectile (2)');
  assert.deepEqual(page.faults, []);
});

test('a report opens with the steps; the digits of the verdicts are one click away', async () => {
  run(folder, ['run', 'projectile', '--engine', 'in-house', '--engine', 'ode', '--json', 'v.json', '--traces', 't.jsonl']);
  run(folder, ['report', 'v.json', 't.jsonl', 'm.json', '--html', 'r.html']);
  const report = `file://${join(folder, 'r.html')}`;
  const page = await open(report);
  assert.deepEqual(await heads(page), ['scenario', 'ode']);
  await page.getByRole('link', { name: /^Verdicts/ }).click();
  await page.locator('table.matrix a[aria-label^="projectile, ode:"]').click();
  assert.match(await page.locator('dl.facts').first().innerText(), /body-steps \(not verified\)/); // 0.8 s of 1 ms
  await page.keyboard.press('Escape');
  assert.ok(await page.locator('table.matrix').isVisible());
  // A filter is one of verdicts.
  const filtered = await open(`${report}#q=ode:pass`);
  assert.ok(await filtered.locator('table.matrix').isVisible());
  assert.deepEqual(page.faults, []);
});

for (const scheme of ['light', 'dark'])
  test(`axe-core finds no serious fault, ${scheme}`, async () => {
    const page = await open(url, { scheme });
    assert.deepEqual(await accessibilityFaults(page), []);
  });
