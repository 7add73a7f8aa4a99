// The box that stands for a bare rigid body has the body's mass, moments and principal axes.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load } from '../bundle_for_test.mjs';

const { drawnShape, principalAxes } = await load('shared/scene3d/stand_in.ts');
const { rotate } = await load('shared/scene3d/vectors.ts');

const body = (inertia, mass = 1.7) => ({ name: 'a', mass, inertia, shape: undefined });
const diagonal = (a, b, c) => [a, 0, 0, 0, b, 0, 0, 0, c];

/** R diag(m) R^T, with the columns of R the turned axes. */
function tensor(moments, turn) {
  const axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((e) => rotate(turn, e));
  return [0, 1, 2].flatMap((i) => [0, 1, 2].map((j) => moments.reduce((sum, m, k) => sum + m * axes[k][i] * axes[k][j], 0)));
}

test('a tensor is what its moments and axes make of it', () => {
  const turns = [[1, 0, 0, 0], [0.5, 0.5, -0.5, 0.5], [0.8, 0, 0.6, 0], [0.36, 0.48, 0.48, 0.64], [0.1, -0.7, 0.1, 0.7]];
  for (const q of turns) {
    const norm = Math.hypot(...q);
    const inertia = tensor([1.25, 2.5, 3.5], q.map((x) => x / norm));
    const found = principalAxes(inertia);
    tensor(found.moments, found.turn).forEach((x, i) => assert.ok(Math.abs(x - inertia[i]) < 1e-12, `${q}: ${i}`));
  }
});

test('the box has the moments of the body', () => {
  const { half_extents: h, type } = drawnShape(body(diagonal(1.25, 2.5, 3.5)));
  assert.equal(type, 'box');
  const moment = (b, c) => (1.7 / 3) * (b * b + c * c);
  [[h[1], h[2], 1.25], [h[2], h[0], 2.5], [h[0], h[1], 3.5]].forEach(([b, c, want]) => assert.ok(Math.abs(moment(b, c) - want) < 1e-12));
});

test('a flat body has a little thickness', () => {
  const { half_extents: h } = drawnShape(body(diagonal(1, 2, 3)));
  assert.equal(h[2], 0.04 * Math.max(...h));
});

test('a body that lies askew is a part that is turned', () => {
  const shape = drawnShape(body(tensor([1.25, 2.5, 3.5], [0.8, 0, 0.6, 0])));
  assert.equal(shape.type, 'compound');
  assert.equal(shape.parts.length, 1);
});

test('where the inertia says nothing, nothing is made up', () => {
  for (const inertia of [diagonal(1, 1, 1), diagonal(0, 0, 0), diagonal(NaN, 1, 1)]) assert.equal(drawnShape(body(inertia)), null);
  const own = { type: 'sphere', radius: 0.5 };
  assert.equal(drawnShape({ ...body(diagonal(1, 2, 3)), shape: own }), own);
});
