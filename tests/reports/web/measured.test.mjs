// The page of data sets in a real browser: facts, scores before and after a fit, lengths, curves with bands, the ghost.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test, { before } from 'node:test';
import { accessibilityFaults, open, run, scratch } from './browser.mjs';

const folder = scratch();
const url = `file://${join(folder, 'r.html')}#section=measured`;
const scenarios = join(import.meta.dirname, '../../../scenarios/measured');
const pendulum = join(scenarios, 'pendulum_single/swings.toml');
const cubes = join(scenarios, 'cube_tosses/tosses.toml');
let own;
let fitted;
let fit;
let tosses;

before(() => {
  const read = (file) => JSON.parse(readFileSync(join(folder, file), 'utf8'));
  run(folder, ['fit', pendulum, '--engine', 'ode', '--parameters', 'inertia 1', '--dt', '1/1000', '--json', 'fit.json']);
  run(folder, ['predict', pendulum, '--engine', 'ode', '--engine', 'bullet', '--dt', '1/1000', '--members', '5', '--json',
    'own.json', '--curves', '2']);
  run(folder, ['predict', pendulum, '--fit', 'fit.json', '--dt', '1/1000', '--members', '5', '--json', 'fitted.json']);
  run(folder, ['predict', cubes, '--engine', 'ode', '--members', '0', '--json', 'tosses.json', '--curves', '1']);
  run(folder, ['report', 'tosses.json', 'own.json', 'fitted.json', 'fit.json', '--html', 'r.html']);
  [own, fitted, fit, tosses] = ['own.json', 'fitted.json', 'fit.json', 'tosses.json'].map(read);
});

const choose = async (page, title) => page.getByLabel('data set').selectOption({ label: title });

test('a data set has its facts, and a row of scores for each engine before and after its fit', async () => {
  const page = await open(url);
  const article = page.getByRole('article');
  await article.waitFor();
  const text = await article.innerText();
  for (const fact of [tosses.source, tosses.licence, tosses.instrument, ...tosses.known]) assert.ok(text.includes(fact), fact);
  await choose(page, own.title);
  const rows = article.locator('table').first().locator('tbody tr');
  // ode and bullet with the model's own values, ode after its fit, and ode before and after on the runs that judge the fit
  assert.equal(await rows.count(), 5);
  const after = await rows.filter({ hasText: 'after the fit' }).first().innerText();
  assert.ok(after.includes(`${fitted.engines[0].to_the_end} of ${fitted.engines[0].runs}`), after);
  assert.ok(after.includes(fitted.engines[0].band), after);
  const value = await article.getByRole('region', { name: /^Fits to/ }).innerText();
  assert.ok(value.includes(`${Number(fit.fits[0].parameters[0].value.toPrecision(4))} [`), value);
  assert.deepEqual(page.faults, []);
});

test('the data say what is wrong with their lengths', async () => {
  const page = await open(url);
  const lengths = page.getByRole('region', { name: 'Heights at rest by side' });
  assert.equal(await lengths.locator('tbody tr').count(), new Set(tosses.lengths.each.map(({ side }) => side).filter(Boolean)).size);
  const said = await page.getByText('Free flight:').innerText();
  assert.ok(said.includes((tosses.lengths.flight.value * 9.81).toFixed(3)), said);
  assert.ok(said.includes('1 is outside the interval'), said);
  const dots = page.getByRole('img', { name: /^Lengths of/ }).locator('circle');
  const counted = tosses.lengths.each.reduce((n, { flight, height }) => n + (flight !== null) + (height !== null), 0);
  assert.equal(await dots.count(), counted);
});

test('a run is drawn with its band, what is left, and the measured bodies as a ghost', async () => {
  const page = await open(url);
  await choose(page, own.title);
  const { drawn } = own.engines[1];
  await page.getByLabel('band and picture of').selectOption({ label: 'bullet' });
  await page.getByRole('combobox', { name: 'run', exact: true }).selectOption({ label: drawn[1].run });
  const names = await page.getByRole('img').evaluateAll((all) => all.map((e) => e.getAttribute('aria-label')));
  const greatest = Math.max(...drawn[1].predicted[0]);
  assert.ok(names.some((n) => n?.includes('measured and predicted') && n.includes(`bullet: greatest ${Number(greatest.toPrecision(4))} rad`)), names.join('\n'));
  assert.ok(names.some((n) => n?.includes('measured less predicted')));
  await page.locator('.pane-picture canvas').first().waitFor();
  assert.ok((await page.getByText('Shaded: the range of 5').innerText()).includes('bullet'));
  await page.getByRole('button', { name: '+1 frame' }).click();
  await page.getByRole('group', { name: 'Time cursor' }).getByText(/frame 2 of/).waitFor();
  await page.getByLabel('values').selectOption({ label: 'after the fit' });
  await page.getByText(/Shaded: the range of 5.*fitted parameters/).waitFor();
  assert.deepEqual(page.faults, []);
});

test('without script the scores are plain tables', async () => {
  const page = await open(url, { javaScriptEnabled: false });
  const text = await page.locator('#app').innerText();
  for (const title of [own.title, tosses.title]) assert.ok(text.includes(title));
  assert.ok((await page.locator('#app table').count()) >= 4);
});

for (const scheme of ['light', 'dark'])
  test(`axe-core finds no serious fault, ${scheme}`, async () => {
    const page = await open(url, { scheme });
    for (const title of [tosses.title, own.title]) {
      await choose(page, title);
      await page.locator('.pane-picture canvas').first().waitFor();
      assert.deepEqual(await accessibilityFaults(page), []);
    }
  });
