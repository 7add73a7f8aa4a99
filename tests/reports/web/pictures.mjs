// The pictures of README.md (docs/pictures.sh): no test, and run like one.
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { open, run, scratch } from './browser.mjs';
import { view } from './viewer.mjs';

const pictures = join(import.meta.dirname, '../../../docs/pictures');
mkdirSync(pictures, { recursive: true });
const folder = scratch();

test('report', async () => {
  run(folder, ['run', '--html', 'r.html']);
  const page = await open(`file://${folder}/r.html`, { width: 1340, height: 620 });
  await page.locator('.filter input').first().fill('bullet:fail or ode:fail');
  await page.locator('table.matrix .cell').nth(6).focus();
  await page.waitForTimeout(500);
  await page.screenshot({ path: join(pictures, 'report-matrix.png') });
  await page.locator('table.matrix a[aria-label^="dzhanibekov, bullet:"]').click();
  await page.locator('.pane-picture canvas').nth(1).waitFor();
  await page.setViewportSize({ width: 1340, height: 1150 });
  await page.getByRole('slider', { name: 'time' }).evaluate((slider) => {
    slider.value = '47.4'; // long after the first violation: it lies the other way up
    slider.dispatchEvent(new Event('input', { bubbles: true }));
  });
  await page.locator('#side-heading').evaluate((e) => (e.scrollIntoView(), scrollBy(0, -110)));
  await page.waitForTimeout(1000);
  await page.screenshot({ path: join(pictures, 'report-cell.png') });
});

test('speed', async () => {
  run(folder, ['trade', 'heavy_top', '--engine', 'in-house', '--engine', 'bullet', '--engine', 'ode', '--work', '65536', '--html', 't.html']);
  const page = await open(`file://${folder}/t.html`, { width: 1340, height: 1000 });
  await page.getByRole('link', { name: 'Speed against accuracy' }).click();
  await page.waitForTimeout(1000);
  await page.screenshot({ path: join(pictures, 'report-speed.png') });
});

test('viewer', async (t) => {
  const { url } = await view(t, folder, ['seed_bouncing_balls', '--engine', 'in-house', '--engine', 'ode']);
  const page = await open(url, { width: 1280, height: 900 });
  await page.keyboard.press('t');
  await page.waitForTimeout(6000);
  await page.keyboard.press('1');
  await page.waitForTimeout(3000);
  await page.screenshot({ path: join(pictures, 'viewer.png') });
  const tops = await view(t, folder, ['heavy_top', '--engine', 'in-house', '--engine', 'bullet-multibody', '--dt', '0.002']);
  const dark = await open(tops.url, { width: 1280, height: 900, scheme: 'dark' });
  await dark.keyboard.press('t');
  await dark.waitForTimeout(5000);
  await dark.screenshot({ path: join(pictures, 'viewer-dark.png') });
});
