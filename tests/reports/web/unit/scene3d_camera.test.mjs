// The orbit camera: what it projects, what it frames, what a pointer meets.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load } from '../bundle_for_test.mjs';

const orbit = await load('shared/scene3d/orbit.ts');
const { meetBall, meetBox } = await load('shared/scene3d/picking.ts');
const { round125, sceneBounds } = await load('shared/scene3d/bounds.ts');
const { metres } = await load('shared/scene3d/over.ts');
const { support } = await load('shared/scene3d/support.ts');
const { turned, shifted } = await load('shared/scene3d/controls.ts');

const size = { width: 800, height: 500, ratio: 1 };
const camera = { target: [0.3, -1.2, 2.5], distance: 7, azimuth: 0.8, elevation: -0.4 };
const near = (a, b, tolerance, what) => assert.ok(Math.abs(a - b) <= tolerance, `${what}: ${a}, not ${b}`);

test('azimuth 0 looks along -z, y is up on the screen', () => {
  const view = orbit.viewOf({ target: [0, 3.5, 0], distance: 10, azimuth: 0, elevation: 0 }, size, 5);
  assert.deepEqual(view.eye, [0, 3.5, 10]);
  const middle = orbit.project(view, [0, 3.5, 0]);
  assert.deepEqual([middle.x, middle.y, middle.depth], [400, 250, 10]);
  assert.ok(orbit.project(view, [1, 3.5, 0]).x > 400);
  assert.ok(orbit.project(view, [0, 4.5, 0]).y < 250);
  assert.equal(orbit.project(view, [0, 3.5, 11]), null); // behind the eye
});

test('the ray through a projected point meets that point, in perspective and in parallel', () => {
  const view = orbit.viewOf(camera, size, 4);
  for (const p of [[0.1, -0.7, 3.1], [1.9, -2.2, 1.4], [-0.8, 0.3, 2.2]])
    for (const [project, ray] of [[orbit.project, orbit.rayThrough], [orbit.projectParallel, orbit.parallelRay]]) {
      const { x, y, depth } = project(view, p);
      const { from, along } = ray(view, x, y);
      for (let i = 0; i < 3; ++i) near(from[i] + depth * along[i], p[i], 1e-12, 'the point');
    }
});

test('both cameras show the target at the same size', () => {
  const view = orbit.viewOf(camera, size, 4);
  const [right] = orbit.axes(camera);
  const p = camera.target.map((x, i) => x + 0.01 * right[i]);
  near(orbit.project(view, p).x, orbit.projectParallel(view, p).x, 1e-9, 'x');
  near((orbit.project(view, p).x - 400) * orbit.metresPerPixel(view), 0.01, 1e-12, 'metres per pixel');
});

test('framing has all corners of a box in the picture, whatever its form', () => {
  for (const bounds of [
    { min: [-1, 0, -0.01], max: [9, 2, 0.01] },
    { min: [-0.1, -30, -0.2], max: [0.3, 5, 0.1] },
    { min: [100, 200, 300], max: [101, 203, 304] },
  ])
    for (const [width, height] of [[900, 300], [300, 900]]) {
      const view = orbit.viewOf(orbit.frame(bounds, width / height), { width, height, ratio: 1 }, 10);
      let widest = 0;
      for (let corner = 0; corner < 8; ++corner) {
        const p = orbit.project(view, [0, 1, 2].map((i) => (corner >> i & 1 ? bounds.max[i] : bounds.min[i])));
        assert.ok(p.x >= 0 && p.x <= width && p.y >= 0 && p.y <= height, `corner ${corner} at ${p.x}, ${p.y}`);
        widest = Math.max(widest, Math.abs(2 * p.x / width - 1), Math.abs(2 * p.y / height - 1));
      }
      assert.ok(widest > 0.75, `and not as a speck: ${widest} of the half`);
    }
});

test('a camera never turns over, and moving it keeps its distance', () => {
  assert.ok(orbit.clampCamera(turned(camera, 0.3, 5)).elevation < Math.PI / 2);
  assert.ok(orbit.clampCamera(turned(camera, 0.3, -5)).elevation > -Math.PI / 2);
  const moved = shifted(camera, 0.6, -0.8);
  near(Math.hypot(...moved.target.map((x, i) => x - camera.target[i])), 1, 1e-12, 'the way');
  assert.equal(moved.distance, camera.distance);
});

test('rays meet balls and boxes where they should', () => {
  const ray = { from: [0, 0, 5], along: [0, 0, -2] };
  near(meetBall(ray, 1), 2, 1e-12, 'ball');
  assert.equal(meetBall({ ...ray, from: [1.01, 0, 5] }, 1), null);
  assert.equal(meetBall({ from: [0, 0, -5], along: [0, 0, -1] }, 1), null); // behind
  near(meetBox(ray, [1, 1, 0.5]), 2.25, 1e-12, 'box');
  assert.equal(meetBox({ ...ray, from: [1.01, 0, 5] }, [1, 1, 1]), null);
  assert.equal(meetBox({ from: [0, 0, -5], along: [0, 0, -1] }, [1, 1, 1]), null);
  near(meetBox({ from: [3, 2, 1], along: [-1, -0.5, -0.25] }, [1, 1, 1]), 2, 1e-12, 'a slanting ray');
});

test('lengths of scale bars and grids', () => {
  for (const [x, rounded] of [[0.0072, 0.005], [1, 1], [4.99, 2], [73, 50], [0, 1], [NaN, 1]]) near(round125(x), rounded, 1e-15, `${x}`);
  for (const [x, text] of [[0.5, '50 cm'], [20, '20 m'], [2e-3, '2 mm'], [5e6, '5 Mm'], [1e-9, '1 nm']]) assert.equal(metres(x), text);
});

test('the bounds of a motion hold the bodies and not their centres alone, and a locked one where it stands', () => {
  const body = (position, radius, locked = false) => ({ position, orientation: [1, 0, 0, 0], locked, shape: { type: 'sphere', radius } });
  const scene = { joint: [{ point: [0, 9, 0] }], spring: [], plane: [], water: [], body: [body([0, 0, 0], 0.5), body([-4, 0, 0], 2, true)] };
  const { min, max } = sceneBounds(scene, { min: [-1, -1, -1], max: [7, 1, 1] });
  assert.deepEqual([min, max], [[-6, -2, -2], [7.5, 9, 2]]);
});

test('the bounds of a scene hold its bodies, and what is not finite does not spoil them', () => {
  const scene = { joint: [], spring: [], plane: [], water: [] };
  const body = (position, radius) => ({ position, orientation: [1, 0, 0, 0], shape: { type: 'sphere', radius } });
  const { min, max } = sceneBounds({ ...scene, body: [body([1, 2, 3], 0.5), body([4, 2, 3], 0.25), body([NaN, 0, 0], 1)] });
  assert.deepEqual([min[0], max[0]], [0.5, 4.25]);
  for (const bodies of [[], [body([Infinity, 0, 0], 1)], [body([1e-3, 0, 0], 0)]]) {
    const bounds = sceneBounds({ ...scene, body: bodies });
    for (let i = 0; i < 3; ++i) assert.ok(bounds.max[i] > bounds.min[i]);
  }
});

test('how far shapes reach, in a slanting direction', () => {
  const d = [0.48, -0.6, 0.64]; // radial part 0.8
  const corners = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].map((z) => [x, 2 * y, 3 * z])));
  const half = Math.SQRT1_2;
  for (const [shape, reach] of [
    [undefined, 0],
    [{ type: 'sphere', radius: 2 }, 2],
    [{ type: 'box', half_extents: [1, 2, 3] }, 0.48 + 1.2 + 1.92],
    [{ type: 'hull', vertices: corners }, 0.48 + 1.2 + 1.92],
    [{ type: 'capsule', radius: 2, length: 5 }, 2 + 1.5],
    [{ type: 'cylinder', radius: 2, length: 5 }, 1.6 + 1.5],
    [{ type: 'cone', radius: 2, length: 4 }, 1.6 + 0.6], // its base, since d points down
    [{ type: 'rod', length: 5 }, 1.5],
    [{ type: 'disc', radius: 2 }, 1.6],
    // A rod turned from y to -x, 1 m to the right: its two ends are at x = -1.5 and 3.5.
    [{ type: 'compound', parts: [{ shape: { type: 'rod', length: 5 }, mass: 1, position: [1, 0, 0], orientation: [half, 0, 0, half] }] }, 3.5 * 0.48],
  ])
    near(support(shape, d), reach, 1e-12, shape?.type ?? 'a point');
});

test('a motion in a plane is framed with the depth of its bodies and not with their length', () => {
  const plank = { position: [0, 0, 0], orientation: [1, 0, 0, 0], shape: { type: 'box', half_extents: [0.5, 0.1, 0.02] } };
  const scene = { joint: [], spring: [], plane: [], water: [], body: [plank] };
  const { min, max } = sceneBounds(scene, { min: [-2, -1, 0], max: [2, 1, 0] });
  const radius = Math.hypot(0.5, 0.1, 0.02);
  near(max[0], 2 + radius, 1e-12, 'across');
  near(max[2] - min[2], 0.04 * Math.hypot(4 + 2 * radius, 2 + 2 * radius, 0.04), 1e-12, 'deep, no less than a picture needs');
});
