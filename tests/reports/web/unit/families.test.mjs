// Which columns of the matrix belong together, and when the head names their families.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load } from '../bundle_for_test.mjs';
import { verdict } from './verdicts.mjs';

const { families, grouped, hasFamilyRow } = await load('report/families.ts');
const { fold } = await load('report/fold.ts');

for (const [what, versions, expected] of [
  ['variants stand with their engine', { 'bullet/gyro=none': '3.24', bullet: '3.24' }, 'bullet bullet'],
  ['and so does a build in single precision', { 'cannon-es-float': '0.20.0', 'cannon-es': '0.20.1' }, 'cannon-es cannon-es'],
  ['also alone', { 'bullet-float/gyro=none': '3.24' }, 'bullet'],
  ['and one of the same version whose name continues', { 'bullet-multibody-float': '3.24', 'bullet-float': '3.24' }, 'bullet bullet'],
  ['but not of another version', { bullet: '3.24', 'bullet-multibody': '3.25' }, 'bullet bullet-multibody'],
  ['nor one whose name only begins alike', { mujoco: '3.2', mujoco3: '3.2' }, 'mujoco mujoco3'],
  ['nor a name that is no engine of the report', { 'cannon-es': '1.0', 'cannon-ts': '1.0' }, 'cannon-es cannon-ts'],
  ['the shortest name is the family', { 'a-b-c': '1', 'a-b': '1', a: '1' }, 'a a a'],
  ['a variant that crashed at once has the version of the others', { 'ode-quick/x=1': '', ode: '0.16', 'ode-quick': '0.16' }, 'ode ode ode'],
  ['a name may be nothing but a suffix', { '-float': '1' }, '-float'],
])
  test(`families: ${what}`, () =>
    assert.equal([...families(new Map(Object.entries(versions))).values()].join(' '), expected));

test('the matrix knows the family of a column, whose first runs may have said no version', () => {
  const { columns } = fold([
    verdict({ engine: 'ode-quick', version: '', status: 'crash', measured: null }),
    verdict({ engine: 'ode-quick', scenario: 'kepler' }),
    verdict({ engine: 'ode' }),
  ]);
  assert.deepEqual(columns.map(({ label, family }) => [label, family]), [['ode-quick', 'ode'], ['ode', 'ode']]);
});

const columns = ['a', 'b', 'a', 'c', 'b', 'a'].map((family) => ({ family }));

test('columns of a family stand together, families in order of appearance; none without a column', () => {
  assert.deepEqual(grouped(columns, [true, true, false, false, true, true]), [
    { name: 'a', columns: [0, 5] },
    { name: 'b', columns: [1, 4] },
  ]);
  assert.deepEqual(grouped(columns, columns.map(() => false)), []);
});

for (const [sizes, expected] of [
  [[1, 1, 1], false],
  [[4, 1, 1], false],
  [[2, 2], true],
  [[1, 1, 1, 1, 1, 1], false],
  [[1, 1, 1, 1, 1, 1, 1], true],
  [[7], true],
])
  test(`families of ${sizes} columns ${expected ? 'have a' : 'need no'} row of their own`, () =>
    assert.equal(hasFamilyRow(sizes.map((n) => ({ name: 'x', columns: Array(n).fill(0) }))), expected));
