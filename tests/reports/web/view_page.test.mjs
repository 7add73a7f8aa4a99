// The live viewer in a real browser, with the real server: keys, parameters, lanes, an engine that cannot.
import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { accessibilityFaults, open, patience, scratch } from './browser.mjs';
import { view as start } from './viewer.mjs';

const folder = scratch();
const view = (t, ...args) => start(t, folder, args);

const clock = async (page) => Number(/t = ([\d.]+) s/.exec(await page.locator('.clock').innerText())[1]);
const total = async (page, lane, name) => {
  const names = await page.locator('.readout thead th').allInnerTexts();
  const column = names.findIndex((text) => text.startsWith(name));
  return Number(await page.locator('.readout tbody tr').nth(lane).locator('th, td').nth(column).innerText());
};
const until = (page, what, condition) =>
  assert.doesNotReject(async () => {
    for (let i = 0; i < patience / 100; ++i, await page.waitForTimeout(100)) if (await condition()) return;
    throw new Error(`waited in vain: ${what}`);
  });

test('steps, kicks, parameters and lanes, by keys and fields', async (t) => {
  const { url } = await view(t, 'seed_bouncing_balls', '--engine', 'in-house', '--engine', 'bullet', '--paused');
  const page = await open(url, { width: 1400 });
  await page.locator('.lane canvas').nth(3).waitFor(); // two of each lane
  assert.equal(await clock(page), 0);
  await page.keyboard.press('.');
  await until(page, 'a step', async () => (await clock(page)) > 0);
  assert.ok((await clock(page)) < 0.01); // and only one

  const before = await total(page, 0, 'p y');
  await page.keyboard.press('1');
  // Mass 1 kg by 1 m/s, of which 1/sqrt(1.09) upwards; a step of gravity is far less.
  await until(page, 'a kick', async () => Math.abs((await total(page, 0, 'p y')) - before - 1 / Math.sqrt(1.09)) < 1e-3);
  await until(page, 'in both lanes', async () => Math.abs((await total(page, 1, 'p y')) - before - 1 / Math.sqrt(1.09)) < 1e-3);
  await page.keyboard.press('Shift+Digit1');
  await until(page, 'the kick back', async () => Math.abs((await total(page, 0, 'p y')) - before) < 1e-3);

  const stiffness = page.getByLabel(/^spring .*: stiffness$/);
  await stiffness.fill('-3');
  assert.equal(await stiffness.getAttribute('aria-invalid'), 'true');
  assert.match(await page.locator('.refused').innerText(), /at least 0/);
  await stiffness.fill('2.5');
  await stiffness.press('Enter');
  await until(page, 'the new stiffness', async () => {
    const other = await open(url); // another page sees what the server has
    await other.locator('.lane').first().waitFor();
    const value = await other.getByLabel(/^spring .*: stiffness$/).inputValue();
    await other.context().close();
    return value === '2.5';
  });

  await page.getByRole('button', { name: 'Add a lane' }).click();
  await page.locator('.lane').nth(2).waitFor();
  await page.getByRole('button', { name: 'remove lane 3' }).click();
  await until(page, 'two lanes', async () => (await page.locator('.lane').count()) === 2);

  await page.locator('body').press(' ');
  await until(page, 'playing', async () => (await clock(page)) > 0.3);
  const { frames, seconds } = await page.evaluate(() => globalThis.cylonFrames);
  assert.ok(frames > 2 && seconds > 0);
  assert.deepEqual(await accessibilityFaults(page), []);
  assert.deepEqual(page.faults, []);
});

test('dragging a body pulls it in every lane, until it is let go', async (t) => {
  const { url } = await view(t, 'projectile', '--engine', 'in-house', '--engine', 'bullet', '--paused');
  const page = await open(url, { width: 1400 });
  const sent = [];
  page.on('request', (request) => request.method() === 'POST' && sent.push(JSON.parse(request.postData())));
  const box = await page.locator('.lane canvas').first().boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2]; // the only body is in the middle
  await page.waitForTimeout(500);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y - 40, { steps: 30 });
  await page.mouse.up();
  await until(page, 'the release', () => sent.some((command) => command.do === 'release'));
  const pulls = sent.filter((command) => command.do === 'pull');
  assert.ok(pulls.length >= 1 && pulls.length <= 31, `${pulls.length} pulls`);
  assert.ok(pulls.at(-1).pin[1] > pulls[0].pin[1] && pulls.at(-1).stiffness > 0);
  assert.equal(sent.at(-1).do, 'release');
});

test('an engine that cannot says why in its place, and the page says when the server has gone', async (t) => {
  const { stop, url } = await view(t, 'spherical_pendulum', '--engine', 'in-house', '--engine', 'bullet');
  const page = await open(url, { scheme: 'dark' });
  await until(page, 'the reason', async () => (await page.locator('.lane').nth(1).innerText()).includes('Bullet has no joint that keeps a distance'));
  assert.match(await page.locator('.readout tbody tr').nth(1).innerText(), /–/); // and no numbers
  await until(page, 'time to pass', async () => (await clock(page)) > 0);
  await stop();
  await page.getByText(/No connection to the server/).waitFor();
  // Another server at the same place has other secrets, and the page says what to do.
  await view(t, 'spherical_pendulum', '--port', new URL(url).port);
  await page.getByText(/another server answers here/).waitFor();
  assert.deepEqual(await accessibilityFaults(page), []);
});

test('the secret leaves the address bar, stays for a reload, and no other page has it', async (t) => {
  const { url } = await view(t, 'projectile', '--engine', 'in-house', '--paused');
  const [bare, token] = url.split('#token=');
  const page = await open(url);
  await page.locator('.lane').first().waitFor();
  assert.equal(page.url(), bare);
  assert.ok(!(await page.content()).includes(token));
  await page.reload();
  await page.locator('.lane').first().waitFor();

  const stranger = await open(bare);
  await stranger.getByText(/Open the address that cylon view printed/).waitFor();
  assert.equal(await stranger.locator('.lane').count(), 0);
  assert.deepEqual(await accessibilityFaults(stranger), []);
  await stranger.goto(url); // only what is behind the '#' is another: no new page is loaded by that alone
  await stranger.locator('.lane').first().waitFor();
  assert.equal(stranger.url(), bare);
  assert.deepEqual([...page.faults, ...stranger.faults], []);
});

test('a recording keeps pictures of simulated time', async (t) => {
  const { stop, url } = await view(t, 'spring_orbit', '--record', 'film');
  const page = await open(url, { width: 900, height: 700 });
  await page.locator('.lane').first().waitFor();
  const film = join(folder, 'film');
  const files = () => (existsSync(film) ? readdirSync(film).filter((name) => name.endsWith('.png')) : []);
  await until(page, 'five pictures', () => files().length >= 5);
  await stop();
  for (const name of files()) assert.equal(readFileSync(join(film, name)).subarray(1, 4).toString(), 'PNG');
});
