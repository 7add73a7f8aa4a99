// The cards of `cylon hunt` in a real browser.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test, { before } from 'node:test';
import { accessibilityFaults, open, run, scratch } from './browser.mjs';

const folder = scratch();
const url = `file://${join(folder, 'r.html')}#section=faults`;
let cards;

before(() => {
  run(folder, ['hunt', '--engine', 'bullet/gyro=none', '--scenes', 'free_symmetric_top', '--count', '1', '--json',
    'hunt.json'], 1);
  run(folder, ['report', 'hunt.json', '--html', 'r.html']);
  ({ cards } = JSON.parse(readFileSync(join(folder, 'hunt.json'), 'utf8')));
});

test('each card has its fault, its errors and its least scene', async () => {
  assert.ok(cards.length > 0);
  const page = await open(url);
  const articles = page.getByRole('article');
  await articles.first().waitFor();
  assert.equal(await articles.count(), cards.length);
  for (const [i, card] of cards.entries()) {
    const article = articles.nth(i);
    assert.match(await article.getByRole('heading').innerText(), new RegExp(card.engine.replace('/', '.')));
    assert.equal(await article.locator('tbody tr').count(), card.measured.length);
    await article.getByText('The least scene').click();
    assert.ok((await article.innerText()).includes('[[body]]'), card.name);
  }
  assert.deepEqual(page.faults, []);
});

test('a hunt without a fault says what was asked, and opens the report', async () => {
  run(folder, ['hunt', '--engine', 'in-house', '--count', '2', '--json', 'none.json']);
  run(folder, ['report', 'none.json', '--html', 'none.html']);
  const page = await open(`file://${join(folder, 'none.html')}`);
  const said = page.locator('section[aria-labelledby="faults-heading"]');
  await said.waitFor();
  assert.match(await said.innerText(), /in-house: 2 scenes, 0 refused, no fault/);
  await page.getByRole('link', { name: 'Provenance' }).click();
  await page.getByText('Hunt, file 1').waitFor();
  assert.match(await page.locator('main').innerText(), /Hunt, file 1\s+asked\s+in-house in 2 scenes/);
});

for (const scheme of ['light', 'dark'])
  test(`axe-core finds no serious fault, ${scheme}`, async () => {
    const page = await open(url, { scheme });
    await page.getByRole('article').first().waitFor();
    for (const summary of await page.locator('article summary').all()) await summary.click();
    assert.deepEqual(await accessibilityFaults(page), []);
  });
