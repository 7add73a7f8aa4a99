// The matrix of steps: which engines it shows, costs joined to their steps, digits at a step.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load } from '../bundle_for_test.mjs';

const { buildOf, buildsNote } = await load('report/builds.tsx');
const { withSubsteps } = await load('report/substeps.ts');
const { digitsAt, foldSteps, isInHouse } = await load('report/steps/fold_steps.ts');

const series = (engine, errors, change = {}) => ({
  engine,
  integrator: 'semi-implicit-euler',
  version: '3.24',
  observed_order: 1.02,
  adaptive: false,
  closed_form: false,
  points: errors.map((error, i) => ({ dt: 0.032 / 2 ** i, dt_text: `s${i}`, tolerance: null, errors: { trajectory: error } })),
  ...change,
});

const trade = {
  tables: [
    {
      scenario: 'throw',
      by: 'trajectory',
      measures: [{ name: 'trajectory', against: 'projectile' }],
      series: [series('bullet', [0.03, 0.014, 0.006, 0.003]), series('in-house', [], { closed_form: true })],
      cells: [
        { series: 0, refusal: '', avoidable: '', reach: [{ error: 1e-2, point: 2, coarsest_tried: false, why: '' }, { error: 1e-3, point: null, coarsest_tried: false, why: 'order 1.0' }] },
        { series: 1, refusal: 'too heavy', avoidable: 'bullet', reach: [] },
      ],
    },
    { scenario: 'from an older program', by: 'trajectory', measures: [], series: [] },
  ],
  times: [
    { scenario: 'throw', engine: 'bullet', integrator: 'semi-implicit-euler', dt_text: 's2', tolerance: null, cpu_seconds_per_second: 0.0025 },
    { scenario: 'other', engine: 'bullet', integrator: 'semi-implicit-euler', dt_text: 's2', tolerance: null, cpu_seconds_per_second: 7 },
  ],
};

test('a step stands with its own cost, and what is not reached with its reason', () => {
  const { engines, rows } = foldSteps([trade]);
  assert.deepEqual(engines, ['bullet', 'in-house']);
  assert.equal(rows.length, 1);
  const { reach, order } = rows[0].cells.get('bullet');
  assert.equal(order, 1.02);
  assert.deepEqual(reach[0], { error: 0.01, step: 0.008, tolerance: null, cost: 0.0025, coarsestTried: false, why: '' });
  assert.deepEqual([reach[1].step, reach[1].cost, reach[1].why], [null, null, 'order 1.0']);
  assert.equal(rows[0].cells.get('in-house').avoidable, 'bullet');
});

const of = (command_line) => ({ ...trade, provenance: { command_line } });

for (const [what, trades, sources] of [
  ['one sweep', [of('cylon matrix throw')], ['']],
  ['a matrix and a trade', [of('/trade/cylon matrix throw'), of('cylon trade throw --engine ode')], ['cylon matrix', 'cylon trade']],
  ['two of one command', [of('cylon matrix throw'), of('cylon matrix throw')], ['cylon matrix (1)', 'cylon matrix (2)']],
  ['sweeps that do not say', [trade, of('')], ['file (1)', 'file (2)']],
])
  test(`${what}: rows of one scenario say which sweep they are of, and count once`, () => {
    const { rows, scenarios } = foldSteps(trades);
    assert.deepEqual(rows.map(({ source }) => source), sources);
    assert.deepEqual(rows.map(({ sweep }) => sweep), trades.length > 1 ? ['throw (1)', 'throw (2)'] : ['throw']);
    assert.equal(scenarios, 1);
  });

test('digits are of the coarsest tried step that is not coarser', () => {
  const cell = foldSteps([trade]).rows[0].cells.get('bullet');
  assert.equal(digitsAt(cell, 0.01).dt, 0.008);
  assert.ok(Math.abs(digitsAt(cell, 0.01).digits + Math.log10(0.006)) < 1e-12);
  assert.equal(digitsAt(cell, 0.008).dt, 0.008);
  assert.equal(digitsAt(cell, 1e-5), null);
});

for (const [version, build] of [
  ['3.24', ''],
  ['1.1.0 (WebAssembly in Node 20.20.2)', 'WebAssembly in Node 20.20.2'],
  ['0.0.3 (JavaScript in Node 20.20.2)', 'JavaScript in Node 20.20.2'],
  ['', ''],
])
  test(`'${version}' is ${build || 'native code'}, and its column says so`, () => {
    const [table] = trade.tables;
    const [bullet, ours] = table.series;
    const { builds } = foldSteps([{ ...trade, tables: [{ ...table, series: [{ ...bullet, version }, ours] }] }]);
    assert.equal(buildOf(version), build);
    assert.equal(builds.get('bullet') ?? '', build);
    assert.equal(builds.get('in-house'), '');
    assert.equal(buildsNote([...builds.values()]).includes(build || 'Costs'), build !== '');
  });

for (const [step, substeps, text] of [
  ['16 ms', 4, '16 ms (4 substeps)'],
  ['16 ms', 1, '16 ms'],
  ['16 ms', undefined, '16 ms'], // an older report
  ['', 4, '4 substeps'],
  ['', 1, ''],
])
  test(`a step '${step}' of ${substeps} parts is '${text}'`, () => {
    assert.equal(withSubsteps(step, substeps), text);
    const [table] = trade.tables;
    const [bullet, ours] = table.series;
    const cell = foldSteps([{ ...trade, tables: [{ ...table, series: [{ ...bullet, substeps }, ours] }] }]).rows[0].cells.get('bullet');
    assert.equal(cell.substeps, substeps ?? 1);
  });

for (const [engine, ours] of [
  ['in-house', true],
  ['in-house-float', true],
  ['in-house/integrator=rk4', true],
  ['in-house-of-somebody', false],
  ['bullet', false],
])
  test(`${engine} is ${ours ? '' : 'not '}the in-house engine`, () => assert.equal(isInHouse(engine), ours));
