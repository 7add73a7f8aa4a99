// Many columns: families in the head, the choice of columns, and what the browser remembers of it.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import test, { before } from 'node:test';
import { accessibilityFaults, open, run, scratch } from './browser.mjs';

const folder = scratch();
const url = (name, hash = '') => `file://${join(folder, name)}${hash}`;
const engines = ['ode', 'in-house', 'bullet', 'ode-quick', 'bullet-multibody', 'bullet/gyro=none', 'in-house/integrator=rk4'];

before(() => {
  const chosen = (list) => list.flatMap((engine) => ['--engine', engine]);
  // Exits with 1: no numbers are published for the variants, so that their failures differ.
  run(folder, ['run', 'dzhanibekov', 'projectile', ...chosen(engines), '--html', 'many.html'], 1);
  run(folder, ['run', 'projectile', ...chosen(['in-house', 'bullet', 'ode']), '--html', 'few.html']);
});

const heads = (page, scope) => page.locator(`table.matrix thead th[scope=${scope}]`).allTextContents();
const group = (page, name) => page.getByRole('group', { name });
const box = (page, name) => page.getByRole('checkbox', { name, exact: true });
const shown = (page, n) =>
  page.waitForFunction((k) => document.querySelector('.matrix-section .count').textContent.includes(`, ${k} of `), n);

async function chooser(page) {
  await page.locator('.column-choice summary').click();
  return group(page, 'Columns to show');
}

test('columns stand by family under a head of their own', async () => {
  const page = await open(url('many.html'));
  await page.locator('table.matrix').waitFor();
  assert.deepEqual(await heads(page, 'colgroup'), ['ode', 'in-house', 'bullet']);
  assert.deepEqual(await heads(page, 'col'), ['scenario', 'ode', 'ode-quick', 'in-house', 'in-house/integrator=rk4',
    'bullet', 'bullet-multibody', 'bullet/gyro=none']);
  const spans = await page.locator('table.matrix colgroup').evaluateAll((list) => list.map((e) => e.span));
  assert.deepEqual(spans, [1, 2, 2, 3]);
  const row = page.locator('table.matrix tbody tr').first();
  assert.deepEqual(await row.getAttribute('aria-rowindex'), '3');
  const labels = await row.locator('.cell').evaluateAll((list) => list.map((e) => e.getAttribute('aria-label').split(/, |: /)[1]));
  assert.deepEqual(labels, (await heads(page, 'col')).slice(1));
  await row.locator('.cell').first().focus();
  await page.keyboard.press('ArrowRight');
  assert.match(await page.evaluate(() => document.activeElement.getAttribute('aria-label')), /, ode-quick:/);
  assert.deepEqual(page.faults, []);
});

test('a family of one column is named once, and few columns have no families above', async () => {
  const page = await open(url('many.html', `#q=${encodeURIComponent('columns:-in-house/*')}`));
  await shown(page, 6);
  assert.deepEqual(await heads(page, 'colgroup'), ['ode', 'bullet']);
  assert.equal(await page.locator('table.matrix thead th', { hasText: 'in-house' }).getAttribute('rowspan'), '2');
  await page.goto(url('few.html'));
  await page.locator('table.matrix').waitFor();
  assert.deepEqual(await heads(page, 'colgroup'), []);
  assert.equal(await page.locator('table.matrix thead tr').count(), 1);
});

test('heads and names stay in view where the matrix scrolls', async () => {
  const page = await open(url('many.html'), { width: 700, height: 500 });
  const frame = page.locator('.matrix-scroll');
  await frame.waitFor();
  const scrolled = await frame.evaluate((e) => {
    e.style.maxHeight = '9rem'; // two rows are less than a screen
    e.scrollTo(300, 60);
    const { left, top } = e.getBoundingClientRect();
    const place = (selector) => e.querySelector(selector).getBoundingClientRect();
    const [head, name] = [place('thead'), place('tbody th')];
    return { by: [e.scrollLeft > 100, e.scrollTop > 20], head: head.top - top, name: name.left - left, corner: place('.corner').left - left };
  });
  assert.deepEqual(scrolled.by, [true, true]);
  for (const part of ['head', 'name', 'corner']) assert.ok(Math.abs(scrolled[part]) < 2, `${part}: ${scrolled[part]}`);
});

test('a box hides a family, and says where only some of its columns are shown', async () => {
  const page = await open(url('many.html'));
  await chooser(page);
  const all = group(page, /^bullet/).getByRole('checkbox').first();
  await all.focus();
  await page.keyboard.press('Space');
  await shown(page, 4);
  assert.deepEqual(await heads(page, 'colgroup'), ['ode', 'in-house']);
  await box(page, 'bullet/gyro=none').check();
  await shown(page, 5);
  assert.ok(await all.evaluate((e) => e.indeterminate && !e.checked));
  await all.check();
  await shown(page, 7);
  assert.deepEqual(await accessibilityFaults(page), []);
  assert.deepEqual(page.faults, []);
});

test('the next visit has the same columns, in this and in other reports, until all are shown again', async () => {
  const page = await open(url('many.html'));
  await chooser(page);
  await box(page, 'ode').uncheck();
  await box(page, 'ode-quick').uncheck();
  await shown(page, 5);
  const again = async (name, hash) => {
    await page.goto('about:blank');
    await page.goto(url(name, hash));
    await page.locator('table.matrix').waitFor({ state: 'attached' });
  };
  await again('many.html');
  await shown(page, 5);
  assert.match(page.url(), /columns/, 'a link from here shows the same');
  await again('few.html');
  await shown(page, 2);
  await again('many.html', '#q=projectile'); // the query of an address has the last word,
  await shown(page, 7);
  await page.locator('.filter input').fill('dzhanibekov'); // and is not remembered
  await again('many.html', '#section=provenance');
  assert.equal(await page.locator('[aria-current=page]').textContent(), 'Provenance');
  await shown(page, 5);
  await again('many.html');
  await chooser(page);
  await page.getByRole('button', { name: 'show all columns' }).click();
  await shown(page, 7);
  await again('few.html');
  await shown(page, 3);
  assert.deepEqual(page.faults, []);
});

test('a choice that would leave no column of a report is left out there', async () => {
  const page = await open(url('many.html'));
  await page.locator('.filter input').fill('columns:ode-quick');
  await shown(page, 1);
  await page.goto('about:blank');
  await page.goto(url('few.html'));
  await shown(page, 3);
});

test('without storage a choice holds for the visit', async () => {
  const page = await open(url('many.html'));
  await page.addInitScript(() => Object.defineProperty(window, 'localStorage', { get() { throw new DOMException('no', 'SecurityError'); } }));
  await page.reload();
  await chooser(page);
  await box(page, 'ode').uncheck();
  await shown(page, 6);
  assert.deepEqual(page.faults, []);
});
