// What the pages cost (bench/web_bench.sh): no test, and run like one.
import { readFileSync, statSync, writeFileSync } from 'node:fs';
import { loadavg } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';
import { open, run, scratch } from './browser.mjs';
import { view } from './viewer.mjs';

const folder = scratch();
const load = () => `load ${loadavg()[0].toFixed(1)}`;

/** n^3 balls on a lattice, in a slow fall on a floor. */
const balls = (n) => `title = "${n ** 3} balls"
story = "Balls fall on a floor."
duration = 10.0
step = "1/240"
gravity = [0, -9.81, 0]
[[lattice]]
name = "ball"
count = [${n}, ${n}, ${n}]
spacing = [1.1, 1.1, 1.1]
position = [0, 2, 0]
mass = 1.0
shape = { type = "sphere", radius = 0.5 }
collide = true
[[plane]]
name = "floor"
normal = [0, 1, 0]
offset = 0
[[material]]
between = ["*", "*"]
restitution = 0.2
friction = 0.5
[[claim]]
conserves = "normal_gap"
tolerance = { absolute = 1, reason = "nothing is judged here" }
`;

for (const [n, engine] of [[1, 'bullet'], [5, 'bullet'], [10, 'bullet'], [10, 'ode']])
  test(`viewer ${n} ${engine}`, async (t) => {
    writeFileSync(join(folder, 'balls.toml'), balls(n));
    const { url } = await view(t, folder, ['balls.toml', '--engine', engine]);
    const page = await open(url, { width: 900, height: 700 });
    await page.locator('.lane canvas').first().waitFor();
    await page.waitForTimeout(2000);
    const begin = await page.evaluate(() => ({ ...globalThis.cylonFrames }));
    await page.waitForTimeout(5000);
    const end = await page.evaluate(() => ({ ...globalThis.cylonFrames }));
    const fps = (end.frames - begin.frames) / (end.seconds - begin.seconds);
    const clock = await page.locator('.clock').innerText();
    console.log(`viewer, ${n ** 3} bodies on ${engine}, 900 x 700: ${fps.toFixed(0)} frames/s (${clock.replace(/\s+/g, ' ')} after 7 s; ${load()})`);
  });

test('report', async () => {
  const names = run(folder, ['list', '--names']).stdout.trim().split('\n').slice(0, 60);
  const engines = ['in-house', 'in-house-float', 'bullet', 'bullet-float', 'bullet-multibody', 'bullet-multibody-float', 'ode', 'ode-quick'];
  run(folder, ['run', ...names, ...engines.flatMap((e) => ['--engine', e]), '--html', 'r.html', '--json', 'v.json'], 1);
  const { verdicts } = JSON.parse(readFileSync(join(folder, 'v.json'), 'utf8'));
  const times = [];
  for (let i = 0; i < 5; ++i) {
    const page = await open(`file://${folder}/r.html`);
    await page.locator('table.matrix .cell').first().waitFor();
    times.push(await page.evaluate(() => performance.now()));
    await page.close();
  }
  console.log(`report of ${names.length} scenarios x ${engines.length} engines, ${verdicts.length} verdicts: ${(statSync(join(folder, 'r.html')).size / 1e6).toFixed(1)} MB, ` +
    `open in ${Math.min(...times).toFixed(0)} … ${Math.max(...times).toFixed(0)} ms (${load()})`);
});
