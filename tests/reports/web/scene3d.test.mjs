// Pictures in a real browser, by WebGL and without: areas that shapes cover, ghosts, what is not finite.
import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import test, { before } from 'node:test';
import { open, scratch } from './browser.mjs';

const folder = scratch();
const web = join(import.meta.dirname, '../../../reports/web');

before(async () => {
  const { build } = createRequire(join(web, 'package.json'))('esbuild');
  mkdirSync(folder, { recursive: true });
  await build({
    stdin: { contents: "import { createScene3D } from './src/shared/scene3d/index'; window.create = createScene3D;", resolveDir: web },
    outfile: join(folder, 'page.js'),
    bundle: true,
    format: 'iife',
    logLevel: 'error',
  });
  writeFileSync(
    join(folder, 'page.html'),
    '<!doctype html><link rel="stylesheet" href="page.css"><style>:root{--ground:#ffffff;--ink:#000000}body{margin:0}' +
      '#host{width:400px;height:400px}</style><div id="host"></div><script src="page.js"></script>',
  );
});

const half = Math.SQRT1_2;
const upright = [1, 0, 0, 0];
const body = (name, shape, more = {}) => ({
  name, mass: 1, inertia: [1, 0, 0, 0, 1, 0, 0, 0, 1], position: [0, 0, 0], orientation: upright, velocity: [0, 0, 0],
  angular_velocity: [0, 0, 0], locked: false, collide: true, color: '', shape, ...more,
});
const scene = (bodies, more = {}) => ({ gravity: [0, 0, 0], body: bodies, joint: [], spring: [], plane: [], water: [], ...more });
const far = { target: [0, 0, 0], distance: 60, azimuth: 0, elevation: 0 }; // as good as parallel: 1 % at 0.6 m of depth

async function pictures(way) {
  const page = await open(`file://${join(folder, 'page.html')}${way}`);
  /** Draws anew; the luminances 0 … 255 of the middle 240 x 240 pixels, and the note. */
  page.draw = (what, layers, camera) =>
    page.evaluate(async ([what, layers, camera]) => {
      globalThis.picture?.dispose();
      const made = (globalThis.picture = globalThis.create(document.getElementById('host'), what, { label: 'a test' }));
      made.camera = camera;
      const numbers = (list) => list.map((x) => (x === 'NaN' ? NaN : x));
      const pose = (p) => p && { position: numbers(p.position), orientation: numbers(p.orientation) };
      for (const [layer, p] of Object.entries(layers)) made.show(layer, pose(p), 0);
      made.render();
      const image = await createImageBitmap(await made.png());
      const canvas = new OffscreenCanvas(400, 400).getContext('2d');
      canvas.drawImage(image, 0, 0);
      const { data } = canvas.getImageData(80, 80, 240, 240);
      const light = [];
      for (let i = 0; i < data.length; i += 4) light.push(Math.round(0.3 * data[i] + 0.6 * data[i + 1] + 0.1 * data[i + 2]));
      return { light, webgl: made.webgl, note: document.querySelector('.scene3d-note').textContent };
    }, [what, layers, camera]);
  return page;
}

// A pixel at distance 60 with a field of view of 40 degrees in 400 pixels.
const metre = 400 / (2 * 60 * Math.tan(Math.PI / 9));
const covered = ({ light }) => light.filter((x) => x < 250).length / metre ** 2;

const cube = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].map((z) => [4 * x, 3 * y, 2 * z])));
// Shapes of metres, so that they are many pixels wide; seen along -z, with the area that they cover [m^2].
const shapes = [
  ['sphere', { type: 'sphere', radius: 6 }, upright, Math.PI * 36],
  ['box', { type: 'box', half_extents: [5, 3, 1] }, upright, 60],
  ['a turned box', { type: 'box', half_extents: [5, 3, 1] }, [half, 0, half, 0], 12],
  ['capsule', { type: 'capsule', radius: 2, length: 6 }, upright, 24 + 4 * Math.PI],
  ['cylinder', { type: 'cylinder', radius: 3, length: 8 }, upright, 48],
  ['a cylinder from its end', { type: 'cylinder', radius: 3, length: 8 }, [half, half, 0, 0], 9 * Math.PI],
  ['cone', { type: 'cone', radius: 4, length: 9 }, upright, 36],
  ['a disc', { type: 'disc', radius: 5 }, [half, half, 0, 0], 25 * Math.PI],
  ['a disc from behind', { type: 'disc', radius: 5 }, [half, -half, 0, 0], 25 * Math.PI],
  ['hull', { type: 'hull', vertices: [...cube, [0, 0, 0]] }, upright, 48],
  ['mesh', { type: 'mesh', vertices: [[-6, -4, 0], [6, -4, 0], [0, 5, 0], [0, 0, -3]], faces: [[0, 1, 2], [1, 0, 3], [2, 1, 3], [0, 2, 3]] }, upright, 54],
  ['compound', { type: 'compound', parts: [
    { shape: { type: 'box', half_extents: [2, 1, 1] }, mass: 1, position: [-3, 0, 0], orientation: upright },
    { shape: { type: 'box', half_extents: [2, 1, 1] }, mass: 1, position: [4, 0, 0], orientation: [half, 0, 0, half] },
  ] }, upright, 16],
];

for (const [name, way, webgl] of [['WebGL', '', true], ['a 2D canvas', '#webgl=off', false]]) {
  test(`${name}: every shape covers its area`, async () => {
    const page = await pictures(way);
    for (const [what, shape, orientation, area] of shapes) {
      const drawn = await page.draw(scene([body('b', shape, { orientation })]), {}, far);
      assert.equal(drawn.webgl, webgl);
      // Perspective: a face 6 m nearer than the middle is drawn 1/0.9 as wide; borders of a pixel; 24 corners for a circle.
      const ratio = covered(drawn) / area;
      assert.ok(ratio > 0.94 && ratio < 1.25, `${what} covers ${ratio} of its area`);
    }
    assert.deepEqual(page.faults, []);
  });

  test(`${name}: a body moves where its pose says, and shows that it turns`, async () => {
    const page = await pictures(way);
    const ball = scene([body('b', { type: 'sphere', radius: 4 })]);
    const middle = ({ light }) => {
      let [sum, count] = [0, 0];
      light.forEach((x, i) => x < 250 && ((sum += i % 240), ++count));
      return (sum / count - 119.5) / metre;
    };
    for (const x of [-5, 3]) {
      const drawn = await page.draw(ball, { bodies: { position: [x, 0, 0], orientation: upright } }, far);
      assert.ok(Math.abs(middle(drawn) - x) < 0.2, `at ${middle(drawn)}, not ${x}`);
    }
    const [a, b] = [0, 0.7].map((t) => [Math.cos(t / 2), 0, Math.sin(t / 2), 0]);
    const still = await page.draw(ball, { bodies: { position: [0, 0, 0], orientation: a } }, far);
    const turned = await page.draw(ball, { bodies: { position: [0, 0, 0], orientation: b } }, far);
    const changed = still.light.filter((x, i) => Math.abs(x - turned.light[i]) > 5).length;
    assert.ok(changed > 0.02 * still.light.filter((x) => x < 250).length, `${changed} pixels changed`);
  });

  test(`${name}: a ghost is an outline and no body, told apart without colour`, async () => {
    const page = await pictures(way);
    const box = scene([body('b', { type: 'box', half_extents: [6, 5, 4] })]);
    const pose = { position: [0, 0, 0], orientation: upright };
    const ghost = await page.draw(box, { bodies: null, ghost: pose }, far);
    const solid = await page.draw(box, { bodies: pose }, far);
    const [dark, inside] = [(d) => d.light.filter((x) => x < 100).length, (d) => d.light.filter((x) => x < 250).length];
    assert.ok(dark(ghost) > 0, 'it has lines of ink');
    assert.ok(dark(ghost) < 0.3 * inside(solid), 'and one looks through it');
    assert.equal(inside(await page.draw(box, { bodies: null }, far)), 0); // nothing is drawn where nothing is shown
  });

  test(`${name}: poses that are not finite hide their bodies and are told`, async () => {
    const page = await pictures(way);
    const two = scene([body('<b>good', { type: 'sphere', radius: 2 }), body('<i>bad', { type: 'sphere', radius: 2 })], {
      spring: [{ body: '<b>good', anchor: [0, 0, 0], to: '<i>bad', to_anchor: [0, 0, 0], stiffness: 1, rest_length: 1, damping: 0 }],
    });
    const drawn = await page.draw(two, { bodies: { position: [0, 0, 0, 'NaN', 0, 0], orientation: [...upright, ...upright] } }, far);
    assert.equal(drawn.note, 'not finite: <i>bad');
    assert.ok(Math.abs(covered(drawn) / (4 * Math.PI) - 1) < 0.2, 'the other one is there, alone');
    const none = await page.draw(two, { bodies: { position: [0, 0, 0, 6, 0, 0], orientation: [...upright, ...upright] } }, far);
    assert.equal(none.note, '');
    assert.deepEqual(page.faults, []);
  });

  test(`${name}: pictures come and go without end`, async () => {
    const page = await pictures(way);
    const ball = scene([body('b', { type: 'sphere', radius: 5 })]);
    for (let i = 0; i < 40; ++i) await page.draw(ball, {}, far); // browsers keep at most 16 contexts
    const drawn = await page.draw(ball, {}, far);
    assert.equal(drawn.webgl, webgl);
    assert.ok(covered(drawn) > 70);
    assert.equal(await page.locator('canvas').count(), 2);
    assert.deepEqual(page.faults, []);
  });
}

test('arrow keys turn the camera, dragging a body pulls it', async () => {
  const page = await pictures('');
  await page.draw(scene([body('b', { type: 'sphere', radius: 5 })]), {}, far);
  const told = await page.evaluate(() => {
    const told = (globalThis.told = { cameras: [], grabs: [], pulls: [], released: 0 });
    const { picture } = globalThis;
    picture.onCamera = (state) => told.cameras.push(state);
    picture.onGrab = (grab) => told.grabs.push(grab);
    picture.onPull = (point) => told.pulls.push(point);
    picture.onRelease = () => ++told.released;
    picture.element.focus();
    return told;
  });
  assert.equal(told.released, 0);
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('+');
  await page.mouse.move(200, 200);
  await page.mouse.down();
  await page.mouse.move(260, 200, { steps: 3 });
  await page.mouse.up();
  const { cameras, grabs, pulls, released } = await page.evaluate(() => globalThis.told);
  assert.equal(cameras.length, 2); // and none from the drag, which held the body
  assert.ok(cameras[0].azimuth !== 0 && cameras[1].distance < 60);
  assert.deepEqual([grabs.length, grabs[0].body, released], [1, 0, 1]);
  assert.ok(Math.abs(Math.hypot(...grabs[0].point) - 5) < 1e-6, 'on the surface');
  // 60 pixels in the plane through the grab, which is nearer to the eye than the target by the radius.
  const { distance } = cameras[1];
  const way = (60 * 2 * (distance - 5) * Math.tan(Math.PI / 9)) / 400;
  const pulled = Math.hypot(...pulls.at(-1).map((x, i) => x - grabs[0].point[i]));
  assert.ok(Math.abs(pulled / way - 1) < 0.01, `pulled by ${pulled}, not ${way}`);
});
