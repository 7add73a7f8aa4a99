// The report in a real browser: what it says is what the verdicts say, and it does what its words promise.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import test, { before } from 'node:test';
import { gunzipSync } from 'node:zlib';
import { accessibilityFaults, open, run, scratch } from './browser.mjs';

const folder = scratch();
const url = (name, hash = '') => `file://${join(folder, name)}${hash}`;
let verdicts;

before(() => {
  run(folder, ['run', 'dzhanibekov', 'heavy_top', 'bouncing_sphere', 'spring_orbit', '--engine', 'in-house', '--engine',
    'bullet', '--engine', 'ode', '--html', 'r.html', '--json', 'v.json', '--traces', 't.jsonl']);
  ({ verdicts } = JSON.parse(readFileSync(join(folder, 'v.json'), 'utf8')));
});

/** The header of a cell's trace, from the file of `--traces`. */
function trace(scenario, engine) {
  for (const line of readFileSync(join(folder, 't.jsonl'), 'utf8').trim().split('\n')) {
    const row = JSON.parse(line);
    if (row.format !== 'cylon-trace/1' || row.scenario !== scenario || row.engine !== engine) continue;
    const bytes = gunzipSync(Buffer.from(row.block, 'base64'));
    return JSON.parse(bytes.subarray(4, 4 + bytes.readUInt32LE(0)).toString());
  }
  throw new Error(`no trace of ${scenario} on ${engine}`);
}

const cell = (page, scenario, engine) => page.locator(`table.matrix a[aria-label^="${scenario}, ${engine}:"]`);
const scenarios = (page) => page.locator('table.matrix tbody th .name').allTextContents();
const cursorTime = async (page) => Number(await page.getByRole('slider', { name: 'time' }).inputValue());

async function openCell(page, scenario, engine) {
  await cell(page, scenario, engine).click();
  await page.locator('.pane-picture canvas').nth(1).waitFor();
}

/** Whether what a picture shows changes while `change` is done. */
async function pictureChanges(page, nth, change) {
  const picture = page.locator('.pane-picture').nth(nth);
  const look = async () => {
    // Below the bar that stays at the top.
    await picture.evaluate((e) => e.scrollIntoView({ block: 'center' }));
    await page.evaluate(() => new Promise((r) => requestAnimationFrame(() => requestAnimationFrame(r))));
    return picture.screenshot();
  };
  const before = await look();
  await change();
  return !before.equals(await look());
}

test('the matrix has a cell per scenario and engine, with the digits of its worst claim', async () => {
  const page = await open(url('r.html'));
  assert.deepEqual(await scenarios(page), [...new Set(verdicts.map((v) => v.scenario))]);
  for (const scenario of ['dzhanibekov', 'spring_orbit'])
    for (const engine of ['in-house', 'bullet', 'ode']) {
      const rows = verdicts.filter((v) => v.scenario === scenario && v.engine === engine);
      const digits = Math.min(...rows.map((v) => Math.log10(v.allowed / v.measured)));
      const text = await cell(page, scenario, engine).textContent();
      assert.ok(text.includes(Math.abs(digits).toFixed(1)), `${scenario} on ${engine}: ${text}, not ${digits}`);
    }
  assert.deepEqual(page.faults, []);
});

test('the filter keeps the rows that its query names, and the address keeps the query', async () => {
  const page = await open(url('r.html'));
  await page.getByRole('searchbox').or(page.locator('input[type=search], .filter input')).first().fill('bullet:fail and in-house:pass');
  const failing = new Set(verdicts.filter((v) => v.engine === 'bullet' && v.status === 'fail').map((v) => v.scenario));
  const expected = [...new Set(verdicts.map((v) => v.scenario))].filter((s) => failing.has(s));
  assert.ok(expected.length > 0 && expected.length < 4, 'the query divides the scenarios');
  await page.waitForFunction((n) => document.querySelectorAll('table.matrix tbody tr').length === n, expected.length);
  assert.deepEqual(await scenarios(page), expected);
  const again = await open(page.url());
  assert.deepEqual(await scenarios(again), expected);
});

test('a query that is none says where, and hides nothing', async () => {
  const page = await open(url('r.html'));
  await page.locator('.filter input').first().fill('bullet:fail and (ode:');
  await page.locator('.query-fault').waitFor();
  assert.equal((await scenarios(page)).length, 4);
});

test('the keyboard alone finds a failing cell, opens it and comes back', async () => {
  const page = await open(url('r.html'));
  await page.locator('.filter input').first().waitFor(); // the page unpacks after it has loaded: before, keys go nowhere
  await page.keyboard.press('/');
  await page.keyboard.type('dzhanibekov');
  await page.waitForFunction(() => document.querySelectorAll('table.matrix tbody tr').length === 1);
  const onCell = () => page.evaluate(() => Boolean(document.activeElement?.matches('table.matrix .cell')));
  for (let i = 0; i < 30 && !(await onCell()); ++i) await page.keyboard.press('Tab');
  assert.ok(await onCell(), 'Tab reaches a cell');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  await page.locator('#cell-heading').waitFor();
  assert.match(await page.locator('#cell-heading').textContent(), /dzhanibekov.*bullet/);
  await page.keyboard.press('Escape');
  await page.locator('table.matrix').waitFor();
  assert.ok(await page.evaluate(() => document.activeElement?.matches('table.matrix .cell')), 'the focus is back');
  assert.deepEqual(page.faults, []);
});

test('a cell says what was measured, allowed and why, and how to have it again', async () => {
  const page = await open(url('r.html'));
  await openCell(page, 'dzhanibekov', 'bullet');
  const text = await page.locator('.cell-page').innerText();
  for (const v of verdicts.filter((row) => row.scenario === 'dzhanibekov' && row.engine === 'bullet')) {
    for (const words of [v.claim, v.reason, v.reproduce, v.expected_reason].filter(Boolean))
      assert.ok(text.replace(/\s+/g, ' ').includes(words.replace(/\s+/g, ' ')), words);
    for (const number of [v.measured, v.allowed])
      assert.ok(text.includes(String(Number(number.toPrecision(3)))) || text.includes(number.toPrecision(4)), String(number));
    for (const sentence of v.unforceable) assert.ok(text.includes(sentence), sentence);
  }
});

test('one cursor moves plots, tables and both pictures', async () => {
  const page = await open(url('r.html'));
  await openCell(page, 'heavy_top', 'ode');
  const reading = page.locator('.curves').first();
  const before = await reading.innerText();
  assert.ok(
    await pictureChanges(page, 0, () =>
      page.getByRole('slider', { name: 'time' }).evaluate((slider) => {
        slider.value = String(0.4 * Number(slider.max));
        slider.dispatchEvent(new Event('input', { bubbles: true }));
      })),
    'the picture of the engine follows',
  );
  await page.waitForFunction((text) => document.querySelector('.curves').innerText !== text, before); // the numbers at the cursor
  assert.ok(await pictureChanges(page, 1, () => page.getByRole('button', { name: '+1 frame' }).click()),
    'the picture beside it follows');
  await page.waitForFunction(() => Number(document.querySelector('.timeline input[type=range]').value) > 0);
  const still = await cursorTime(page);
  await page.getByRole('button', { name: 'play' }).click();
  await page.waitForFunction((t) => Number(document.querySelector('.timeline input[type=range]').value) > t, still);
  await page.getByRole('button', { name: 'pause' }).click();
});

test('the jump to the first divergence goes to the first violation of the worst claim', async () => {
  const page = await open(url('r.html'));
  await openCell(page, 'dzhanibekov', 'bullet');
  await page.getByRole('button', { name: 'jump to the first divergence' }).click();
  const worst = verdicts
    .filter((v) => v.scenario === 'dzhanibekov' && v.engine === 'bullet' && v.status === 'fail')
    .sort((a, b) => a.allowed / a.measured - b.allowed / b.measured)
    .map((v) => trace('dzhanibekov', 'bullet').errors.find((e) => e.claim === v.claim))
    .find((e) => e?.first_violation);
  const step = Number(await page.getByRole('slider', { name: 'time' }).getAttribute('step'));
  await page.waitForFunction(
    ([time, near]) => Math.abs(Number(document.querySelector('.timeline input[type=range]').value) - time) <= near,
    [worst.first_violation.time, step],
  );
  assert.match(await page.locator('.jump').innerText(), new RegExp(`step ${worst.first_violation.step}\\b`));
});

test('cameras are linked until that is switched off', async () => {
  const page = await open(url('r.html'));
  await openCell(page, 'spring_orbit', 'ode');
  const turn = async () => {
    await page.locator('.pane-picture [tabindex]').first().focus();
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('+');
  };
  assert.ok(await pictureChanges(page, 1, turn), 'linked');
  await page.getByLabel('cameras linked').uncheck();
  assert.ok(!(await pictureChanges(page, 1, turn)), 'not linked');
});

test('a link opens the cell and the moment', async () => {
  const page = await open(url('r.html'));
  await openCell(page, 'bouncing_sphere', 'ode');
  await page.getByRole('button', { name: 'jump to the first divergence' }).click();
  await page.waitForFunction(() => /[#&]t=/.test(location.hash));
  const time = await cursorTime(page);
  const again = await open(page.url());
  await again.waitForFunction((t) => Number(document.querySelector('.timeline input[type=range]')?.value) === t, time);
});

test('without WebGL pictures are drawn flat, and say so', async () => {
  const page = await open(url('r.html', '#webgl=off'));
  await openCell(page, 'spring_orbit', 'bullet');
  await page.getByText('No WebGL here').first().waitFor();
  assert.ok(await pictureChanges(page, 0, () => page.getByRole('button', { name: '+1 frame' }).click()));
  assert.deepEqual(page.faults, []);
});

test('without script the matrix stands there as a table', async () => {
  const page = await open(url('r.html'), { javaScriptEnabled: false });
  const text = await page.locator('table').innerText();
  for (const v of verdicts) assert.ok(text.includes(v.scenario) && text.includes(v.engine));
});

test('names, stories and stderr that would be markup show as text', async () => {
  const markup = '<img src=x onerror=alert(1)></script><script>alert(2)</script>';
  const source = `title = ${JSON.stringify(markup)}
story = ${JSON.stringify(`${markup} \\u0007 end of story`).replace('\\\\u', '\\u')}
duration = 1.0
step = 0.01
gravity = [0, -9.81, 0]
[[body]]
name = "<b>stone</b>"
mass = 1.0
velocity = [1, 2, 3]
[[claim]]
conserves = "energy"
tolerance = { relative = 1e-3, reason = ${JSON.stringify(markup)} }
`;
  writeFileSync(join(folder, '<script>alert(3)<_script>.toml'), source);
  writeFileSync(join(folder, 'shouts.sh'),
    `#!/bin/sh\nhead -c 2000000 /dev/zero | tr '\\0' '<' >&2\nprintf '\\033[2J</script><script>alert(4)</script>\\n' >&2\nexit 3\n`, { mode: 0o755 });
  run(folder, ['run', './<script>alert(3)<_script>.toml', '--engine', 'in-house', '--engine', 'shouts', '--worker',
    `shouts=${join(folder, 'shouts.sh')}`, '--html', 'hostile.html'], 5);
  const page = await open(url('hostile.html'));
  await page.locator('table.matrix').waitFor();
  assert.ok((await page.locator('body').innerText()).includes('<script>alert(3)'));
  await page.locator('table.matrix .cell').nth(0).click();
  await page.getByText('end of story').waitFor();
  assert.ok((await page.locator('.cell-page').innerText()).includes('<img src=x onerror=alert(1)></script>'));
  await page.keyboard.press('Escape');
  await page.locator('table.matrix .cell').nth(1).click();
  await page.locator('#output-heading').waitFor();
  assert.ok((await page.locator('.cell-page').innerText()).includes('alert(4)'));
  assert.equal(await page.locator('img').count(), 0);
  assert.deepEqual(page.faults, []);
});

test('what an engine says of its run stands in the cell, hostile or not', async () => {
  run(folder, ['run', 'bouncing_sphere', '--engine', 'in-house/path=stepping', '--html', 'said.html']);
  const page = await open(url('said.html'));
  await page.locator('table.matrix .cell').nth(0).click();
  await page.locator('#diagnostics-heading').waitFor();
  const row = await page.getByRole('region', { name: 'Diagnostics of this run' }).innerText();
  for (const part of ['error-not-controlled', 'ball', 'fixed steps with impulses, order 1', 'the error is not controlled'])
    assert.ok(row.includes(part), part);
  assert.deepEqual(page.faults, []);
});

for (const scheme of ['light', 'dark'])
  test(`axe-core finds no serious fault, ${scheme}`, async () => {
    const page = await open(url('r.html'), { scheme });
    await page.locator('table.matrix').waitFor();
    assert.deepEqual(await accessibilityFaults(page), [], 'matrix');
    const parts = await page.getByRole('navigation', { name: 'Parts of the report' }).getByRole('link').count();
    assert.equal(parts, 8);
    for (let i = 1; i < parts; ++i) {
      await page.getByRole('navigation', { name: 'Parts of the report' }).getByRole('link').nth(i).click();
      assert.deepEqual(await accessibilityFaults(page), [], `part ${i}`);
    }
    await page.goto(url('r.html'));
    await openCell(page, 'dzhanibekov', 'ode');
    assert.deepEqual(await accessibilityFaults(page), [], 'cell');
  });

test('on paper there are no controls, and the matrix is whole', async () => {
  const page = await open(url('r.html'));
  await page.emulateMedia({ media: 'print' });
  assert.ok(!(await page.locator('.filter').isVisible()));
  const box = await page.locator('table.matrix').boundingBox();
  assert.ok(box.width <= 1280, `${box.width}`);
  assert.equal((await scenarios(page)).length, 4);
});

/** Texts of what `selector` finds that take more than one line. */
const broken = (page, selector) =>
  page.locator(selector).evaluateAll((found) => found.filter((e) => e.getClientRects().length > 1).map((e) => e.textContent));

test('on a narrow screen badges and numbers with their units stay whole, and names break between words', async () => {
  run(folder, ['run', 'box_edge_rough', '--engine', 'in-house/path=stepping', '--html', 'narrow.html'], 1);
  const page = await open(url('narrow.html'), { width: 500, height: 800 });
  const name = page.locator('table.matrix tbody th .name').first();
  await name.waitFor();
  assert.equal(await name.innerHTML(), 'box_<wbr>edge_<wbr>rough');
  assert.ok((await page.locator('.differs').count()) > 1);
  assert.deepEqual(await broken(page, '.cell .differs'), []);
  await page.locator('table.matrix .cell').first().click();
  await page.locator('#run-heading').waitFor();
  assert.ok((await page.locator('.notes .unbroken').allTextContents()).some((text) => /e-\d+ m\/s$|e-\d+ m$|e-\d+ s$/.test(text)));
  assert.deepEqual(await broken(page, '.differs, .unbroken'), []);
});

test('a refused cell has no allowance, no violation and no integrator', async () => {
  run(folder, ['run', 'bouncing_sphere', '--engine', 'mujoco', '--html', 'refused.html']);
  const page = await open(url('refused.html'));
  await page.locator('table.matrix .cell').first().click();
  const row = page.locator('section[aria-labelledby="claims-heading"] tbody tr').first();
  await row.waitFor();
  const [, , measured, allowed, digits, violation] = await row.locator('td').allInnerTexts();
  assert.deepEqual([measured, allowed, digits, violation], ['', '', '', '']);
  assert.equal(await page.locator('#cell-heading').innerText(), 'bouncing_sphere / mujoco step 1 ms');
  assert.deepEqual(page.faults, []);
});

test('an address of no part, with a filter, opens the verdicts', async () => {
  const page = await open(url('r.html', '#section=nonsense&q=ode:pass'));
  await page.locator('table.matrix').waitFor();
  assert.equal(await page.locator('nav [aria-current]').innerText(), `Verdicts (${verdicts.length})`);
});

test('a report without a hunt says so', async () => {
  const page = await open(url('r.html', '#section=faults'));
  assert.match(await page.locator('section[aria-labelledby="faults-heading"]').innerText(), /This report holds no hunt\./);
  assert.equal(await page.locator('nav [aria-current]').innerText(), 'Faults');
});

test('the run of a cell counts one body as one, and prints its step once', async () => {
  const page = await open(url('r.html'));
  await openCell(page, 'dzhanibekov', 'ode');
  const text = await page.locator('section[aria-labelledby="run-heading"]').innerText();
  assert.match(text, /\b1 body, tags/);
  assert.match(text, /step\n1 ms\n/);
});

test('sentences about costs are apart', async () => {
  const page = await open(url('r.html', '#section=performance'));
  await page.locator('#costs-heading').waitFor();
  assert.match(await page.locator('main').innerText(), /cost more than steps\. To decide/);
});

test('on a narrow screen nothing but tables scrolls sideways', async () => {
  const page = await open(url('r.html'), { width: 400, height: 800 });
  await page.locator('table.matrix').waitFor();
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth + 1), 'matrix');
  await openCell(page, 'heavy_top', 'bullet');
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth + 1));
});
