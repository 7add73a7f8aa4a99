// Curves for plots, the parting of two motions, work-precision points.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load } from '../bundle_for_test.mjs';

const { aligned, extremes, floorOf, nearest } = await load('shared/plot_data.ts');
const { boundsOf, extent, framed, parting } = await load('report/cell/divergence.ts');
const { buildsOf, join, isDrawn } = await load('report/trade/join.ts');
const { logAxis } = await load('report/trade/axis.ts');
const { fittingSpeed } = await load('report/cell/player.ts');
const { TimeCursor } = await load('shared/plot_cursor.ts');

const curve = (time, value, more = {}) => ({ label: 'x', style: 0, time, value, ...more });

test('curves over different times are put over their union', () => {
  const [times, a, b] = aligned([curve([0, 1, 3], [5, 6, 7]), curve([0, 2], [8, NaN])], null);
  assert.deepEqual(times, [0, 1, 2, 3]);
  assert.deepEqual(a, [5, 6, undefined, 7]); // drawn on over
  assert.deepEqual(b, [8, undefined, null, undefined]); // a gap
});

test('of samples at one time the largest magnitude stays; zeros lie on the floor', () => {
  assert.deepEqual(aligned([curve([0, 1, 1], [0, 2, -3])], null)[1], [0, -3]);
  assert.deepEqual(aligned([curve([0, 1], [0, 0.5])], 1e-4)[1], [1e-4, 0.5]);
  assert.equal(floorOf([curve([0, 1], [0, 0.03], { allowed: 2e-5 })]), 1e-6);
  assert.equal(floorOf([curve([0], [0])]), 1e-16);
});

test('extremes count what a plot cannot show', () => {
  const e = extremes(curve([0, 1, 2, 3], [0, -4, Infinity, 2]));
  assert.deepEqual(e, { least: -4, leastAt: 1, greatest: 2, greatestAt: 3, zeros: 1, lost: 1, lostAt: 2 });
  assert.equal(extremes(curve([0], [NaN])), null);
});

for (const [at, expected] of [
  [-1, 0],
  [0.4, 0],
  [0.6, 1],
  [1.5, 1],
  [2.6, 2],
  [9, 2],
])
  test(`nearest to ${at}`, () => assert.equal(nearest([0, 1, 3], at), expected));

function frames(time, place) {
  const position = Float32Array.from(time.flatMap(place));
  return { time: Float32Array.from(time), position, orientation: new Float32Array() };
}
const still = (t) => [0.3 * t, 1, -2, 4, 5, 6];

test('motions part at the first frame beyond the limit, whatever frames the other has', () => {
  const a = frames([0, 0.5, 1, 1.5, 2], still);
  const coarse = frames([0, 2], still); // on the straight line between its frames it is the same motion
  assert.equal(parting(a, coarse, 1e-6), null);
  const off = frames([0, 0.5, 1, 1.5, 2], (t) => [0.3 * t, 1, -2, 4, 5 + Math.max(0, t - 0.5), 6]);
  assert.deepEqual(parting(a, off, 0.75), { time: 1.5, body: 1, distance: 1 });
  assert.equal(parting(a, off, 10), null);
  const lost = frames([0, 0.5, 1, 1.5, 2], (t) => (t < 1 ? still(t) : [NaN, 1, -2, 4, 5, 6]));
  assert.deepEqual(parting(lost, a, 0.75), { time: 1, body: 0, distance: Infinity });
});

test('a truth that is known at one time is a place in the picture, and not all of it', () => {
  const path = frames([0, 1], (t) => [-2 + 5 * t, t, 0]);
  const place = frames([1], () => [5, -0.5, 0]);
  assert.deepEqual(framed(place, [path, null]), { min: [-2, -0.5, 0], max: [5, 1, 0] });
  assert.deepEqual(framed(place, [null]), { min: [5, -0.5, 0], max: [5, -0.5, 0] });
});

test('cameras hold the truth, else the smaller motion', () => {
  const near = frames([0, 1], still);
  const far = frames([0, 1], (t) => still(t).map((x) => x + 1000 * t));
  assert.equal(framed(null, [far, near]).max[0], 4);
  assert.ok(framed(far, [near]).max[0] > 1000);
  assert.equal(framed(null, [null]), null);
  assert.equal(boundsOf(Float32Array.from([NaN, NaN, NaN])), null);
  assert.equal(extent({ min: [0, 0, 0], max: [2, 3, 6] }), 7);
});

const table = {
  scenario: 'kepler',
  by: 'trajectory',
  series: [
    {
      engine: 'a',
      version: '2.1',
      integrator: 'rk4',
      points: [
        {
          dt: 0.1,
          dt_text: '1/10',
          tolerance: null,
          status: 'ran',
          reason: '',
          errors: { trajectory: 0.1, energy: 0.3 },
        },
        {
          dt: 0.05,
          dt_text: '1/20',
          tolerance: null,
          status: 'ran',
          reason: '',
          errors: { trajectory: 0.01, energy: 0.2 },
        },
      ],
    },
    {
      engine: 'b',
      version: '0.9',
      integrator: 'rk4',
      points: [
        {
          dt: 0.1,
          dt_text: '1/10',
          tolerance: 1e-3,
          status: 'ran',
          reason: '',
          errors: { trajectory: 0.02, energy: 0.4 },
        },
        {
          dt: 0.1,
          dt_text: '1/10',
          tolerance: 1e-6,
          status: 'crash',
          reason: 'signal',
          errors: { trajectory: null },
        },
      ],
    },
  ],
};
const times = [
  ['a', '1/10', null, 1, true, ''],
  ['a', '1/20', null, 2, true, ''],
  ['b', '1/10', 1e-3, 3, false, 'a at 1/20 s'],
].map(([engine, dt_text, tolerance, cost, on_front, dominated_by]) => ({
  scenario: 'kepler',
  engine,
  integrator: 'rk4',
  dt_text,
  tolerance,
  cpu_seconds_per_second: cost,
  seconds_per_body_step: 1e-9,
  on_front,
  dominated_by,
}));

test('points get their own costs, and keep the front of the measure that the sweep was judged by', () => {
  const [a, b] = join({ times }, table, 'trajectory');
  assert.deepEqual(
    a.points.map((p) => [p.error, p.cost, p.onFront]),
    [
      [0.1, 1, true],
      [0.01, 2, true],
    ],
  );
  assert.equal(b.points[0].dominatedBy, 'a at 1/20 s');
  assert.deepEqual(b.points.map(isDrawn), [true, false]);
});

test('by another measure the front is found anew', () => {
  const moved = structuredClone(table);
  moved.series[1].points[0].errors.energy = 0.01;
  moved.series[0].points[1].errors.energy = 0.35;
  const [a, b] = join({ times }, moved, 'energy');
  assert.deepEqual(
    a.points.map((p) => p.onFront),
    [true, false],
  );
  assert.equal(b.points[0].onFront, true);
});

test('what another build runs is on a front of its own', () => {
  const moved = structuredClone(table);
  moved.series[1].version = '0.9 (WebAssembly in Node 20.20.2)';
  const list = join({ times }, moved, 'energy');
  assert.deepEqual(buildsOf(list), ['', 'WebAssembly in Node 20.20.2']);
  assert.deepEqual(
    list.map((s) => s.points.map((p) => p.onFront)),
    [
      [true, true],
      [true, false],
    ],
  );
});

test('a logarithmic axis ends at decades that hold all values', () => {
  const axis = logAxis([3e-5, 0.2], 0, 500);
  assert.deepEqual([axis.ticks[0].value, axis.ticks.at(-1).value].map(Math.log10).map(Math.round), [-5, 0]);
  assert.ok(Math.abs(axis.place(1e-5)) < 1e-9 && Math.abs(axis.place(1) - 500) < 1e-9);
  assert.ok(logAxis([1e-15, 1e5], 0, 500).ticks.length <= 13);
  assert.equal(logAxis([], 0, 100).ticks.length, 2);
});

for (const [seconds, speed] of [
  [5, 1],
  [0.03, 0.001],
  [600, 100],
  [60, 1],
])
  test(`a motion of ${seconds} s plays ${speed} times as fast`, () =>
    assert.equal(fittingSpeed(seconds), speed));

test('the cursor stays within the motion, and looking closer keeps it in sight', () => {
  const cursor = new TimeCursor([0, 8], 99);
  assert.equal(cursor.time, 8);
  cursor.lookCloser();
  assert.deepEqual(cursor.window, [4, 8]);
  cursor.pin = 5.5;
  cursor.lookCloser();
  assert.deepEqual(cursor.window, [4.5, 6.5]);
  cursor.window = [-1, 9];
  assert.equal(cursor.window, null);
});

test('a pointer shows another time only while it is there, and never while the motion runs', () => {
  const cursor = new TimeCursor([0, 8], 2);
  let told = 0;
  cursor.listen(() => ++told);
  cursor.hover(3);
  assert.deepEqual([cursor.time, cursor.pin, told], [3, 2, 1]);
  cursor.hover(null);
  assert.deepEqual([cursor.time, told], [2, 2]);
  cursor.running = true;
  cursor.hover(4);
  assert.deepEqual([cursor.time, told], [2, 2]);
});
