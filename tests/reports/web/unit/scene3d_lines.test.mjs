// Springs, planes, water and trails as lines and numbers.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load } from '../bundle_for_test.mjs';

const { makeCoil, drawCoil } = await load('shared/scene3d/coil.ts');
const { Segments, stride } = await load('shared/scene3d/segments.ts');
const { planeInBox, chord, cut } = await load('shared/scene3d/planes.ts');
const { surface, cellsOfWater, cells } = await load('shared/scene3d/water.ts');
const { makeTrail, extend } = await load('shared/scene3d/trail.ts');
const { tangents, rotate } = await load('shared/scene3d/vectors.ts');
const { hexColour, bodyColour } = await load('shared/scene3d/colours.ts');

const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const close = (a, b, tolerance = 1e-5) => a.forEach((x, i) => assert.ok(Math.abs(x - b[i]) <= tolerance, `${a}, not ${b}`));

test('a coil runs from end to end without gaps and stays within its radius', () => {
  const lines = new Segments();
  const [a, b, radius] = [[0.3, -1.1, 2.2], [1.7, 0.4, -0.6], 0.05];
  drawCoil(lines, makeCoil(8, 10), a, b, radius, [0, 0, 0], 1);
  const end = (i, k) => [...lines.data.subarray(i * stride + 3 * k, i * stride + 3 * k + 3)];
  close(end(0, 0), a);
  close(end(lines.count - 1, 1), b);
  const l = Math.hypot(...b.map((x, i) => x - a[i]));
  const axis = b.map((x, i) => (x - a[i]) / l);
  for (let i = 0; i < lines.count; ++i) {
    if (i > 0) close(end(i, 0), end(i - 1, 1));
    const d = end(i, 1).map((x, k) => x - a[k]);
    const aside = Math.hypot(...d.map((x, k) => x - dot(d, axis) * axis[k]));
    assert.ok(aside <= radius + 1e-5);
  }
  const turns = lines.count;
  drawCoil(lines, makeCoil(8, 10), a, a, radius, [0, 0, 0], 1); // no length: no direction either
  assert.equal(lines.count, 2 * turns);
  assert.ok(lines.data.subarray(0, lines.count * stride).every(Number.isFinite));
});

test('lines are kept while their array grows', () => {
  const lines = new Segments();
  for (let i = 0; i < 1000; ++i) lines.add([i, 0, 0], [0, i, 0], [0.5, 0, 1], 2, 3, 1);
  assert.equal(lines.count, 1000);
  for (const i of [0, 255, 256, 999])
    assert.deepEqual([...lines.data.subarray(i * stride, (i + 1) * stride)], [i, 0, 0, 0, i, 0, 0.5, 0, 1, 2, 3, 1]);
});

test('tangents complete a normal to a right-handed frame', () => {
  for (const n of [[1, 0, 0], [0, -1, 0], [0, 0, 1], [0.36, 0.48, -0.8]]) {
    const [u, v] = tangents(n);
    close([dot(u, u), dot(v, v), dot(u, v), dot(u, n), dot(v, n)], [1, 1, 0, 0, 0], 1e-12);
    close([u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]], n, 1e-12);
  }
});

test('a plane is cut by a box to the polygon of both', () => {
  const box = { min: [-1, -2, -3], max: [1, 2, 3] };
  const area = (polygon, n) => {
    let sum = [0, 0, 0];
    polygon.forEach((p, i) => {
      const q = polygon[(i + 1) % polygon.length];
      sum = sum.map((s, k) => s + (p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3]) / 2);
    });
    return Math.abs(dot(sum, n));
  };
  for (const [n, offset, exact] of [
    [[0, 1, 0], 0.5, 12],
    [[0, 0, 1], -2.9, 8],
    [[Math.SQRT1_2, Math.SQRT1_2, 0], 0, 2 * Math.SQRT2 * 6],
    [[0, 1, 0], 2.1, 0],
  ]) {
    const polygon = planeInBox(n, offset, box);
    assert.ok(Math.abs((polygon.length ? area(polygon, n) : 0) - exact) < 1e-9, `${n} at ${offset}`);
    for (const p of polygon) assert.ok(Math.abs(dot(p, n) - offset) < 1e-12);
  }
  const floor = planeInBox([0, 1, 0], 0, box);
  assert.ok(Math.abs(area(cut(floor, [1, 0, 0], 0.5), [0, 1, 0]) - 9) < 1e-12); // a wall at x = 0.5
  assert.deepEqual(cut(floor, [1, 0, 0], -1.5), []);
  const line = chord(floor, [1, 0, 0], 0.25);
  close(line.map((p) => p[0]), [0.25, 0.25], 1e-12);
  assert.ok(Math.abs(line[0][2] - line[1][2]) === 6);
  assert.equal(chord(floor, [1, 0, 0], 1.25), null);
});

test('water is where the protocol says', () => {
  const wave = { level: 3, wave: 0.2, speed: 0.7, mode: 'volume' };
  assert.equal(surface(wave, 1.3, 9, 2.1), 3 + 0.2 * Math.sin(1.3 - 0.7 * 2.1));
  const step = { ...wave, mode: 'step' };
  // Cells of 0.25 m from -5 m on: x = 0.6 is in cell 22, z = -1.1 in cell 15; beyond the table the last goes on.
  const at = (i, j, t) => 3 + 0.1 * (Math.sin(0.7 * t + i) + Math.sin((i * j) / 2));
  for (const [x, z, i, j] of [[0.6, -1.1, 22, 15], [-99, 99, 0, 40], [-5.1, -4.99, 0, 0]])
    assert.equal(surface(step, x, z, 2.1), at(i, j, 2.1));
  const { place, index } = cellsOfWater();
  assert.equal(index.length, 6 * (cells * cells + 2 * cells * (cells - 1)));
  assert.equal(Math.max(...index) + 1, place.length / 4);
});

test('trails follow the frames as they come, and bodies without a finite place draw nothing', () => {
  const bodies = 2;
  const source = new Float32Array(3 * bodies * 4).fill(9);
  source.set([1, 2, 3, NaN, 0, 0], 0);
  source.set([2, 2, 3, 5, 6, 7], 6);
  const trail = makeTrail(source, bodies);
  extend(trail, 1);
  assert.deepEqual([...trail.positions.subarray(0, 12)], [1, 2, 3, 5, 6, 7, 2, 2, 3, 5, 6, 7]);
  source.set([3, 2, 3, Infinity, 0, 0], 12); // later frames are read later
  extend(trail, 2);
  assert.deepEqual([...trail.positions.subarray(12, 18)], [3, 2, 3, 5, 6, 7]);
  assert.equal(trail.filled, 3);
  extend(trail, 0);
  assert.deepEqual([trail.upTo, trail.filled], [0, 3]); // back in time: nothing is read anew
  extend(trail, 99);
  assert.equal(trail.upTo, 3);
});

test('long trails are thinned', () => {
  const trail = makeTrail(new Float32Array(3 * 1000 * 600), 1000);
  extend(trail, 599);
  assert.ok(trail.positions.length / 3 <= 160000 && trail.every === 4);
  assert.equal(trail.upTo, Math.floor(599 / 4));
});

test('colours: the scene says them, else the palette by place; locked bodies are darker', () => {
  assert.deepEqual(hexColour('#ff8000'), [1, 128 / 255, 0]);
  assert.equal(hexColour('red"><script>'), null);
  assert.deepEqual(bodyColour({ color: '#ff8000', locked: false }, 3), hexColour('#ff8000'));
  assert.notDeepEqual(bodyColour({ color: '', locked: false }, 0), bodyColour({ color: '', locked: false }, 1));
  const [free, locked] = [false, true].map((is) => bodyColour({ color: '#808080', locked: is }, 0));
  assert.ok(locked.every((x, i) => x < free[i]));
});

test('turning is active, from body to world', () => {
  const half = Math.SQRT1_2;
  close(rotate([half, 0, 0, half], [1, 0, 0]), [0, 1, 0], 1e-15);
});
