// Meshes of shapes: closed, counter-clockwise from outside, of the right size.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load } from '../bundle_for_test.mjs';

const { makeMold, hullTriangles, faceted, faceTone } = await load('shared/scene3d/molds.ts');
const { solidsOf } = await load('shared/scene3d/solids.ts');

const subtract = (a, b) => a.map((x, i) => x - b[i]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);

/** Triangles of a mold, its halves lifted apart by `lift`. */
function triangles(mold, lift = 0) {
  const list = [];
  for (let i = 0; i < mold.tone.length; i += 3)
    list.push([0, 1, 2].map((k) => {
      const at = 3 * (i + k);
      const p = mold.position.slice(at, at + 3);
      return [p[0], p[1] + lift * mold.lift[i + k], p[2]];
    }));
  return list;
}

/** Of the solid within: sum of a . (b x c) / 6; negative where triangles wind the wrong way. */
const volume = (list) => list.reduce((sum, [a, b, c]) => sum + dot(a, cross(b, c)) / 6, 0);

// A mesh within a round body lacks some of it: at most this part with the triangles that a few bodies get.
const lack = 0.03;
const { PI } = Math;
for (const [kind, lift, exact, least] of [
  ['sphere', 0, (4 / 3) * PI, 1 - lack],
  ['box', 0, 8, 1],
  ['cylinder', 0, 2 * PI, 1 - lack],
  ['cone', 0, PI / 3, 1 - lack],
  ['capsule', 1.5, (4 / 3) * PI + 3 * PI, 1 - lack],
])
  test(`${kind}: outward and of the right volume`, () => {
    const ratio = volume(triangles(makeMold(kind, 1), lift)) / exact;
    assert.ok(ratio <= 1 + 1e-12 && ratio >= least - 1e-12, `volume is ${ratio} of the exact one`);
  });

test('normals point out of every face', () => {
  for (const kind of ['sphere', 'box', 'cylinder', 'cone', 'capsule', 'cross']) {
    const mold = makeMold(kind, 1000);
    triangles(mold, 0.7).forEach(([a, b, c], i) => {
      const n = cross(subtract(b, a), subtract(c, a));
      if (Math.hypot(...n) < 1e-12) return;
      for (let k = 0; k < 3; ++k)
        assert.ok(dot(n, mold.normal.slice(9 * i + 3 * k, 9 * i + 3 * k + 3)) > 0, `${kind}: face ${i}`);
    });
  }
});

test('a cone has its tip three quarters of its length above the centre of mass', () => {
  const y = triangles(makeMold('cone', 1)).flat().map((p) => p[1]);
  assert.equal(Math.max(...y), 0.75);
  assert.equal(Math.min(...y), -0.25);
});

test('a hull is that of its points: inner points and points on edges change nothing', () => {
  const box = [];
  for (const x of [-0.3, 0.5]) for (const y of [-0.7, 0.2]) for (const z of [-0.11, 0.9]) box.push([x, y, z]);
  const exact = 0.8 * 0.9 * 1.01;
  for (const [name, points] of [
    ['corners', box],
    ['a point within', [...box, [0.1, -0.2, 0.3]]],
    ['points on edges and faces', [...box, [0.1, 0.2, 0.9], [0.5, -0.1, 0.3], [-0.3, -0.7, 0.4]]],
    ['points told twice', [...box, ...box]],
  ])
    assert.ok(Math.abs(volume(hullTriangles(points)) / exact - 1) < 1e-9, name);
});

test('a hull of points on a ball holds them all', () => {
  const points = [];
  for (let i = 0; i < 60; ++i) {
    const z = 1 - (2 * i + 1) / 60;
    const r = Math.sqrt(1 - z * z);
    points.push([r * Math.cos(2.4 * i), r * Math.sin(2.4 * i), z]);
  }
  const hull = hullTriangles(points);
  assert.equal(hull.length, 2 * 60 - 4); // Euler: all points are corners, all faces triangles
  for (const [a, b, c] of hull) {
    const n = cross(subtract(b, a), subtract(c, a));
    for (const p of points) assert.ok(dot(n, subtract(p, a)) <= 1e-9);
  }
});

test('points in a plane have no hull; the body is then drawn as a cross', () => {
  assert.deepEqual(hullTriangles([[0, 0, 0], [1, 0, 0], [0, 1, 0]]), []);
  const body = { name: 'flat', shape: { type: 'hull', vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0]] } };
  assert.deepEqual(solidsOf({ body: [body] }, 0.1).pieces.map((piece) => piece.mold), ['cross']);
});

test('faces have six tones, and edges are where faces meet at an angle', () => {
  const tones = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]].map(faceTone);
  assert.equal(new Set(tones).size, 6);
  assert.equal(makeMold('box', 1).edges.length / 8, 12);
  const quad = [[[0, 0, 0], [1, 0, 0], [1, 1, 0]], [[0, 0, 0], [1, 1, 0], [0, 1, 0]]];
  assert.equal(faceted(quad).edges.length / 8, 4); // the border, and not the diagonal
});

test('a compound carries its parts, turned', () => {
  const half = Math.SQRT1_2;
  const shape = {
    type: 'compound',
    parts: [
      { shape: { type: 'sphere', radius: 0.2 }, mass: 1, position: [0.3, 0.4, 0], orientation: [1, 0, 0, 0] },
      { shape: null, mass: 1, position: [0, 1, 0], orientation: [1, 0, 0, 0] },
      {
        shape: { type: 'compound', parts: [{ shape: { type: 'rod', length: 2 }, mass: 1, position: [1, 0, 0], orientation: [1, 0, 0, 0] }] },
        mass: 1,
        position: [0, 0, 2],
        orientation: [half, 0, 0, half], // a quarter turn about z: x becomes y
      },
    ],
  };
  const { pieces, radius } = solidsOf({ body: [{ name: 'c', shape }] }, 0.1);
  assert.deepEqual(pieces.map((piece) => piece.mold), ['sphere', 'cross', 'cylinder']);
  for (const [i, x] of [0, 1, 2].entries()) assert.ok(Math.abs(pieces[2].position[i] - x) < 1e-12);
  assert.ok(radius[0] >= Math.hypot(0, 1, 2) + 1);
});
