// Numbers and foreign text as the report prints them, and the address that keeps what is shown.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load } from '../bundle_for_test.mjs';

const { digitsText, short, withUnit, wonInWords, wonText } = await load('report/numbers.ts');
const { duration, stepInWords } = await load('shared/durations.ts');
const { visible, visibleLines } = await load('report/visible.ts');
const { stepText } = await load('report/cell/settings.tsx');
const { sentence } = await load('report/text.tsx');
const { parseAddress, addressText } = await load('report/address.ts');

for (const [value, text] of [
  [1, '+1.0'],
  [-0.04, '+0.0'],
  [-0.06, '-0.1'],
  [12.25, '+12.3'],
  [-36.71, '-36.7'],
  [99, '+99.0'],
])
  test(`digits ${value}`, () => assert.equal(digitsText(value), text));

for (const [value, text] of [
  [0, '0'],
  [1, '1'],
  [0.0025, '0.0025'],
  [1.5543122344752192e-15, '1.554e-15'],
  [12345678, '1.235e7'],
  [9999.6, '1e4'],
  [-0.5, '-0.5'],
  [0.00009999, '9.999e-5'],
  [1234, '1234'],
  [null, 'not finite'],
  [Infinity, 'inf'],
  [-Infinity, '-inf'],
  [NaN, 'NaN'],
  [100, '100'],
  [2000, '2000'],
])
  test(`number ${value}`, () => assert.equal(short(value), text));

test('units follow their numbers', () => {
  assert.equal(withUnit(0.25, 'm'), '0.25 m');
  assert.equal(withUnit(0.25, ''), '0.25');
});

for (const [seconds, text] of [
  [0, '0 s'],
  [2.5e-9, '2.5 ns'],
  [0.0123, '12.3 ms'],
  [0.000125, '0.125 ms'],
  [0.00009, '90 \u00b5s'],
  [1234.4, '1234 s'],
  [75, '75 s'],
  [null, 'not measured'],
  [3.4e-13, '0.34 ps'],
])
  test(`duration ${seconds}`, () => assert.equal(duration(seconds), text));

for (const [asked, text] of [
  ['1/240', '1/240 s'],
  ['5/1248', '5/1248 s'],
  ['0.001', '1 ms'],
  ['1/500', '2 ms'],
  ['0.8/25', '32 ms'],
  ['1/0', '1/0'],
  ['5e-04', '0.5 ms'],
  ['1.25e-4', '0.125 ms'],
  ['0.0166667', '0.0166667 s'],
  ['rk4', 'rk4'],
  ['1/x', '1/x'],
  ['', ''],
])
  test(`a step '${asked}' is '${text}'`, () => assert.equal(stepInWords(asked), text));

for (const [value, text, words] of [
  [99, 'exact', 'exact'],
  [98.9, '+98.9', '+98.9 digits'],
  [-99, '-99.0', '-99.0 digits'],
  [3, '+3.0', '+3.0 digits'],
])
  test(`digits ${value} of a verdict`, () => assert.deepEqual([wonText(value), wonInWords(value)], [text, words]));

for (const [dt_text, dt, text] of [
  ['0.001', 0.001, '1 ms'],
  ['1/60', 1 / 60, '1/60 s (16.7 ms)'],
  ['0.003', 0.003, '3 ms'],
])
  test(`a step of ${dt_text} s is printed as '${text}'`, () => assert.equal(stepText({ dt, dt_text }), text));

test('what is invisible is written out', () => {
  assert.equal(visible('\u001b[31m a\u202eb\u200b\u0000\n'), '\\u001b[31m a\\u202eb\\u200b\\u0000\\u000a');
  assert.equal(
    visible('lone \ud800, whole \u{1f600}, \u00e4 \u03b1 \u4e2d'),
    'lone \\ud800, whole \u{1f600}, \u00e4 \u03b1 \u4e2d',
  );
  assert.equal(visible('</script><b>&amp;'), '</script><b>&amp;'); // markup is text; the page never reads it as markup
  assert.equal(visibleLines('a\r\nb\tc\rd\u0007'), 'a\nb\tc\\u000dd\\u0007');
});

test('a sentence ends once', () => {
  assert.equal(sentence("did you mean 'fail'?"), "did you mean 'fail'?");
  assert.equal(sentence("nothing stands after ':'"), "nothing stands after ':'.");
});

test('the address gives back what was put into it', () => {
  const address = {
    section: 'matrix',
    q: 'any:fail & "x y"#=',
    cell: '<script>/%&\u00e4',
    engine: 'bullet/gyro=none',
    dt: '1/60',
  };
  const text = addressText(address);
  assert.match(text, /^#[\w=&%.*+-]*$/);
  assert.deepEqual(parseAddress(text), address);
  assert.equal(addressText({ q: '', section: 'x' }), '#section=x');
});
