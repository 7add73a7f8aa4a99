// The filter's language: what rows a query finds, which columns it shows, and what it says of a query that is
// none.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load } from '../bundle_for_test.mjs';
import { verdict } from './verdicts.mjs';

const { parse, QueryError } = await load('report/query/parse.ts');
const { glob, matcher, requireKnown, shownColumns } = await load('report/query/match.ts');
const { withColumns } = await load('report/query/columns.ts');
const { fold } = await load('report/fold.ts');

const row = (scenario, engine, change) => verdict({ scenario, engine, ...change });
const pass = { status: 'pass', expected: 'pass', measured: 0.00013 };
const matrix = fold([
  row('heavy_top', 'in-house', pass),
  row('heavy_top', 'bullet', { status: 'fail', expected: 'fail', measured: 2.6 }),
  row('heavy_top', 'ode', {}),
  row('kepler', 'in-house', pass),
  row('kepler', 'bullet', pass),
  row('kepler', 'bullet', {
    claim: 'energy conserved',
    observable: 'energy',
    status: 'low-quality',
    expected: 'pass',
  }),
  row('kepler', 'ode', pass),
  row('domino', 'in-house', pass),
  row('domino', 'bullet/gyro=none', { status: 'crash', expected: 'crash', measured: null }),
]);
const views = new Map([
  ['heavy_top', { title: 'Heavy top let go', tags: ['top', 'joint'] }],
  ['kepler', { title: 'Two bodies (Kepler)', tags: ['orbit'] }],
]);

function found(query) {
  return matrix.rows
    .filter(matcher(parse(query).query, matrix.columns, views))
    .map((r) => r.scenario)
    .join(' ');
}

const cases = [
  ['', 'heavy_top kepler domino'],
  ['bullet:fail', 'heavy_top'],
  ['BULLET:FAIL', 'heavy_top'],
  ['bullet:fail and ode:low-quality', 'heavy_top'],
  ['bullet:fail ode:pass', ''],
  ['bullet:fail or ode:pass', 'heavy_top kepler'],
  ['not bullet:fail', 'kepler domino'],
  ['not bullet:fail kepler', 'kepler'], // 'not' takes the one term
  ['bullet:none', 'domino'],
  ['bullet:pass', ''], // one claim of kepler does not pass
  ['bullet:low-quality', 'kepler'], // and this is that claim
  ['any:crash', 'domino'],
  ['*:differs', 'kepler'],
  ['bullet*:crash', 'domino'],
  ['bullet/gyro=none:crash', 'domino'],
  ['bullet:expected', 'heavy_top'],
  ['digits<-3', 'heavy_top'],
  ['ode:digits<0', 'heavy_top'],
  ['ode:digits>=1', 'kepler'],
  ['tag:jo*', 'heavy_top'],
  ['claim:energy*', 'kepler'],
  ['scenario:?epler', 'kepler'],
  ['scenario:epler', ''], // a glob is the whole name
  ['let', 'heavy_top'],
  ['"two bodies (k"', 'kepler'],
  ['kepler or domino and any:fail', 'kepler'], // 'and' before 'or'
  ['(kepler or domino) any:crash', 'domino'],
  ['not (kepler or domino)', 'heavy_top'],
  ['"and"', ''], // a quoted word is a word
];
for (const [query, expected] of cases) test(`finds '${query}'`, () => assert.equal(found(query), expected));

const faults = [
  ['bullet:fial', 7, /did you mean 'fail'/],
  ['ode:pass bullet:qqqqqqqq', 16, /there are pass, /],
  ['(ode:pass', 0, /never closed/],
  ['ode:pass)', 8, /closes nothing/],
  ['ode:pass or', 11, /term is missing/],
  ['and ode:pass', 0, /missing before 'and'/],
  ['"heavy', 0, /never closed/],
  ['digits<many', 7, /a number must follow/],
  ['tag:', 0, /nothing stands after/],
  [':fail', 0, /engine is missing/],
  ['ode:pass or columns:ode', 12, /cannot stand within/],
  ['columns:ode or ode:pass', 0, /cannot stand within/],
  ['not columns:ode', 4, /cannot stand within/],
  ['('.repeat(20000), 100, /nested deeper than 100/],
  ['not '.repeat(20000), 400, /nested deeper than 100/],
];
for (const [query, at, message] of faults)
  test(`refuses '${query.slice(0, 40)}'`, () =>
    assert.throws(
      () => parse(query),
      (error) => {
        assert.ok(error instanceof QueryError);
        assert.equal(error.at, at);
        assert.match(error.message, message);
        return true;
      },
    ));

for (const [query, at, message] of [
  ['bulet:fail', 0, /no engine of this report is called 'bulet', did you mean 'bullet'\?/],
  ['kepler not jolt:pass', 11, /called 'jolt'$/],
  ['bullet:fail or simbody*:digits<0', 15, /called 'simbody\*'$/],
  [`${'x'.repeat(100000)}:fail`, 0, /no engine of this report/],
])
  test(`knows no engine of '${query.slice(0, 40)}'`, () =>
    assert.throws(() => requireKnown(parse(query).engines, matrix.columns), { at, message }));
for (const query of ['', 'bullet:fail', 'BULLET*:pass', 'any:crash *:differs digits<0', 'ode:digits>3', 'bullet/gyro=none:crash', 'jolt'])
  test(`knows each engine of '${query}'`, () =>
    assert.doesNotThrow(() => requireKnown(parse(query).engines, matrix.columns)));

for (const [pattern, text, expected] of [
  ['', '', true],
  ['', 'a', false],
  ['*', '', true],
  ['a?c', 'ABC', true],
  ['a?c', 'ac', false],
  ['*bc', 'abcbc', true], // the first 'bc' is not the last
  ['a*b*c', 'aXbYbZc', true],
  ['a*b*c', 'aXcYb', false],
  ['a.c', 'abc', false],
  ['**a', 'ba', true],
])
  test(`'${pattern}' and '${text}'`, () => assert.equal(glob(pattern)(text), expected));

test('a glob of many stars takes no time worth speaking of', () => {
  const started = performance.now();
  assert.equal(glob('*a'.repeat(500) + 'b')('a'.repeat(5000)), false);
  assert.ok(performance.now() - started < 1000); // by backtracking it would not end
});

const columns = [
  ['in-house', 'auto'],
  ['bullet', 'euler'],
  ['bullet-float', 'euler'],
  ['ode', 'rk4'],
  ['ode', 'euler'],
].map(([engine, integrator], i) => ({
  engine,
  integrator,
  label: i < 3 ? engine : `${engine} ${integrator}`,
}));

for (const [query, expected] of [
  ['', '11111'],
  ['columns:bullet', '01000'],
  ['columns:bullet*', '01100'],
  ['columns:-bullet*', '10011'],
  ['columns:bullet*,-bullet', '00100'],
  ['columns:ode', '00011'],
  ['columns:ode?rk4 any:fail', '00010'],
])
  test(`shows the columns of '${query}'`, () =>
    assert.equal(shownColumns(parse(query).columns, columns).map(Number).join(''), expected));

test('a choice of columns written into the query is read back, and the rest of the query stays', () => {
  for (let choice = 1; choice < 32; ++choice) {
    const shown = columns.map((_, j) => ((choice >> j) & 1) === 1);
    const query = withColumns('any:fail columns:bullet "a columns:x word"', columns, shown);
    const parsed = parse(query);
    assert.deepEqual(shownColumns(parsed.columns, columns), shown, query);
    assert.deepEqual(parsed.query, parse('any:fail "a columns:x word"').query, query);
  }
});
