// The matrix, the digits, the verdict line and what changed since a baseline.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load } from '../bundle_for_test.mjs';
import { verdict } from './verdicts.mjs';

const { fold, find, badness, severalSteps, supported } = await load('report/fold.ts');
const { digits, statuses } = await load('report/status.ts');
const { summary, warnings } = await load('report/summary.ts');
const { changes } = await load('report/changes.ts');
const { withInterval } = await load('report/numbers.ts');

test('statuses go from best to worst', () => {
  const order = [
    'pass',
    'unsupported',
    'undecided',
    'low-quality',
    'fail',
    'non-finite',
    'timeout',
    'crash',
    'protocol',
  ];
  assert.deepEqual(statuses, order);
});

for (const [measured, allowed, expected] of [
  [0.002, 0.2, 2],
  [0.2, 0.002, -2],
  [0, 0.002, 99],
  [0, 0, 99],
  [0.3, 0, -99],
  [null, 0.1, -99],
  [0.1, null, -99],
  [Infinity, 0.1, -99],
  [1e-300, 1, 99],
])
  test(`digits of ${measured} within ${allowed}`, () =>
    assert.ok(Math.abs(digits(measured, allowed) - expected) < 1e-12));

test('a cell is the worst of its claims, with the least digits of those measured', () => {
  const { rows } = fold([
    verdict({ status: 'pass', expected: 'pass', measured: 0.0007 }),
    verdict({ claim: 'b', status: 'fail', expected: 'fail', measured: 0.9 }),
    verdict({ claim: 'c', status: 'non-finite', expected: 'pass', measured: null, first_bad_step: 7 }),
    verdict({ claim: 'd', status: 'low-quality', measured: 0.003 }),
  ]);
  const [cell] = rows[0].cells;
  assert.equal(cell.worst, 'non-finite');
  assert.ok(Math.abs(cell.digits - Math.log10(0.0021 / 0.9)) < 1e-12);
  assert.equal(cell.differs, true);
  assert.equal(cell.verdicts.length, 4);
});

test('steps and schemes are named only where there are several', () => {
  const { rows, columns } = fold([
    verdict({}),
    verdict({ dt_text: '1/60' }),
    verdict({ scenario: 'kepler' }),
    verdict({ engine: 'in-house', integrator: 'rk4' }),
    verdict({ engine: 'in-house', integrator: 'auto' }),
  ]);
  assert.deepEqual(
    rows.map((r) => r.label),
    ['heavy_top 1 ms', 'heavy_top 1/60 s', 'kepler'],
  );
  assert.deepEqual(
    columns.map((c) => c.label),
    ['ode', 'in-house rk4', 'in-house auto'],
  );
  assert.equal(rows[2].cells[1], null);
});

test('a column says the most substeps that its engine made of a step', () => {
  const { columns } = fold([
    verdict({ engine: 'rapier', substeps: 4 }),
    verdict({ engine: 'rapier', scenario: 'kepler', status: 'unsupported', substeps: 1 }),
    verdict({ substeps: 1 }),
    verdict({ engine: 'of an older report' }),
  ]);
  assert.deepEqual(columns.map((c) => c.substeps), [4, 1, 1]);
});

test('a run without a scheme stands with the first scheme of its engine, and is found by its own name', () => {
  const refused = {
    scenario: 'gas',
    integrator: '',
    status: 'unsupported',
    expected: 'unsupported',
    measured: null,
  };
  const matrix = fold([verdict(refused), verdict({}), verdict({ ...refused, engine: 'other' })]);
  assert.deepEqual(
    matrix.columns.map((c) => c.label),
    ['ode', 'other'],
  );
  const name = { scenario: 'gas', engine: 'ode', integrator: '', dt: '0.001' };
  assert.equal(find(matrix, name), matrix.rows[0].cells[0]);
});

test('a cell is found by all four words of its name', () => {
  const matrix = fold([verdict({}), verdict({ dt_text: '1/60', claim: 'x' })]);
  const name = { scenario: 'heavy_top', engine: 'ode', integrator: 'semi-implicit-euler', dt: '1/60' };
  assert.equal(find(matrix, name).verdicts[0].claim, 'x');
  for (const key of Object.keys(name)) assert.equal(find(matrix, { ...name, [key]: 'other' }), null);
});

test('rows that differ are the worst, then severity, then digits', () => {
  const { rows } = fold([
    verdict({ scenario: 'mild', measured: 0.003 }),
    verdict({ scenario: 'strong', measured: 0.02 }),
    verdict({ scenario: 'broken', status: 'crash', expected: 'crash', measured: null }),
    verdict({ scenario: 'surprise', status: 'pass', expected: 'fail', measured: 0.0001 }),
  ]);
  const worse = (a, b) =>
    badness(b)[0] - badness(a)[0] || badness(b)[1] - badness(a)[1] || badness(b)[2] - badness(a)[2];
  assert.deepEqual(
    [...rows].sort(worse).map((r) => r.scenario),
    ['surprise', 'broken', 'strong', 'mild'],
  );
});

test('an undecided verdict is counted by itself, and differs from nothing that was measured', () => {
  const open = { status: 'undecided', measured: 0.002, interval: [0.001, 0.003] };
  const line = summary([verdict({}), verdict({ ...open, expected: 'pass', as_expected: true })]);
  assert.equal(line.differText, '0 differ');
  assert.equal(line.expectedText, '1 as expected (1 low-quality), 1 undecided');
  assert.equal(line.passText, '0 pass');
  assert.equal(withInterval(verdict(open)), '0.002 [0.001, 0.003] rad');
  assert.equal(withInterval(verdict({ measured: 0.002 })), '0.002 rad');
});

test('the verdict line counts an unexpected pass as a difference', () => {
  const line = summary([
    verdict({}),
    verdict({ status: 'crash', expected: 'crash' }),
    verdict({ status: 'pass', expected: 'fail' }),
    verdict({ status: 'pass', expected: 'pass' }),
    verdict({ status: 'timeout', expected: 'pass' }),
  ]);
  assert.equal(line.differText, '2 differ (1 timeout, 1 pass)');
  assert.equal(line.expectedText, '2 as expected (1 crash, 1 low-quality)');
  assert.equal(line.passText, '1 pass');
});

test('scaled tolerances and unlisted versions are warned of', () => {
  const results = (list, scale = 1) => ({ provenance: { tolerance_scale: scale }, verdicts: list });
  assert.deepEqual(warnings(results([verdict({})])), []);
  assert.match(warnings(results([verdict({})], 0.5))[0], /multiplied by 0.5/);
  assert.match(warnings(results([verdict({ tolerance_scale: 3 })]))[0], /multiplied by 3/);
  const unlisted = verdict({ version_listed: false });
  const explained = verdict({ version_listed: false, expected_reason: 'drift: first order' });
  const warned = (...list) => warnings(results(list))[0];
  assert.equal(warned(unlisted, unlisted), 'expected.toml has no row for ode 0.16.2: a pass is expected.');
  assert.match(warned(explained, explained), /2 verdicts are compared with the expectations for other versions\.$/);
  assert.match(warned(explained, unlisted), /1 verdict is compared [^,]*, of the others a pass is expected\.$/);
});

test('a scene at several steps is one scene, and its rows name their steps', () => {
  const at = (dt, change = {}) => verdict({ dt, dt_text: String(dt), ...change });
  const matrix = fold([at(0.01), at(0.001), at(0.001, { engine: 'bullet' }), at(0.01, { engine: 'bullet', status: 'unsupported' })]);
  assert.equal(matrix.rows.length, 2);
  assert.deepEqual(supported(matrix, 0), { run: 1, asked: 1 });
  assert.deepEqual(supported(matrix, 1), { run: 0, asked: 1 });
  const other = at(0.1, { scenario: 'kepler' });
  assert.deepEqual([...severalSteps([at(0.01), other, at(0.001)])], ['heavy_top']);
  assert.deepEqual([...severalSteps([verdict({ dt: 0.001, dt_text: '1/1000' }), at(0.001), other])], []);
});

test('a step that is written in another way is the same step of the baseline', () => {
  assert.deepEqual(changes([verdict({ dt_text: '0.001' })], [verdict({ dt_text: '1/1000' })]), []);
});

test('changes since the baseline, worst first', () => {
  const of = (claim, change) => verdict({ claim, ...change });
  const before = [
    of('same'),
    of('near', { measured: 0.003 }),
    of('worse', { measured: 0.003 }),
    of('better', { measured: 0.003 }),
    of('broke', { status: 'pass', measured: 0.001 }),
    of('healed', { status: 'fail', measured: 0.5 }),
    of('left'),
    of('other'),
  ];
  const now = [
    of('same'),
    of('near', { measured: 0.0032 }),
    of('worse', { measured: 0.006 }),
    of('better', { measured: 0.001 }),
    of('broke', { status: 'crash', measured: null }),
    of('healed', { status: 'pass', measured: 0.001 }),
    of('came'),
    of('other', { scenario_hash: 'another', measured: 0.9 }),
  ];
  const list = changes(now, before);
  assert.deepEqual(
    list.map((c) => `${c.kind} ${c.verdict.claim}`),
    [
      'status broke',
      'status healed',
      'error worse',
      'error better',
      'gone left',
      'new came',
      'scenario other',
    ],
  );
  assert.ok(Math.abs(list[2].weight - Math.log10(2)) < 1e-12);
  assert.deepEqual(changes(before, before), []);
});

test('claims with the same words are told apart by their order', () => {
  const twice = (a, b) => [verdict({ measured: a }), verdict({ measured: b })];
  assert.equal(changes(twice(0.003, 0.008), twice(0.003, 0.008)).length, 0);
  assert.equal(changes(twice(0.003, 0.009), twice(0.003, 0.004)).length, 1);
});

test('a refusal of a row that another column passes is avoidable, and counts as a failure', () => {
  const of = (engine, status) => verdict({ engine, status, expected: status });
  const matrix = fold([of('bullet', 'unsupported'), of('ode', 'pass'), of('in-house', 'fail')]);
  const [refused, passed, failed] = matrix.rows[0].cells;
  assert.deepEqual([refused.passedBy, passed.passedBy, failed.passedBy], [['ode'], [], []]);
  assert.deepEqual(supported(matrix, 0), { run: 0, asked: 1 });
  assert.deepEqual(supported(matrix, 1), { run: 1, asked: 1 });
  const alone = fold([of('bullet', 'unsupported'), of('ode', 'fail')]);
  assert.deepEqual(alone.rows[0].cells[0].passedBy, []);
  const unavoidable = fold([of('bullet', 'unsupported'), of('ode', 'low-quality')]);
  const avoidable = fold([of('bullet', 'unsupported'), of('ode', 'pass')]);
  assert.ok(badness(avoidable.rows[0])[1] > badness(unavoidable.rows[0])[1]);
});

test('one verdict differs, two differ', () => {
  const differing = verdict({ status: 'fail', expected: 'pass' });
  assert.equal(summary([differing]).differText, '1 differs (1 fail)');
  assert.equal(summary([differing, differing]).differText, '2 differ (2 fail)');
});
