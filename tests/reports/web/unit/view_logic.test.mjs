// What the viewer's page decides without a page: keys of parameters, kicks, what is sent, what is kept.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load } from '../bundle_for_test.mjs';

const { parametersOf, readValue, seen } = await load('view/parameters.ts');
const { kick, pullStiffness, spin } = await load('view/kick.ts');
const { Commands } = await load('view/commands.ts');
const { History, digits, roomy } = await load('view/history.ts');
const { TrailRecorder } = await load('view/trail_recorder.ts');
const { LanePose, ArrowScale } = await load('view/poses.ts');
const { Reach } = await load('view/reach.ts');
const { goodStep } = await load('view/lane_panel.tsx');
const { slide, speedAt } = await load('view/transport.tsx');
const { wantsPictures } = await load('view/film.ts');
const { hasSecret, secret } = await load('view/secret.ts');

const body = (name, more = {}) => ({
  name,
  mass: 2,
  inertia: [0.1, 0, 0, 0, 0.2, 0, 0, 0, 0.3],
  position: [0, 0, 0],
  orientation: [1, 0, 0, 0],
  velocity: [0, 0, 0],
  locked: false,
  color: '',
  ...more,
});
const scene = {
  gravity: [0, -9.81, 0],
  body: [body('ball.1'), body('wall', { locked: true })],
  joint: [],
  spring: [{ body: 'ball.1', anchor: [0, 0, 0], pin: [0, 1, 0], stiffness: 5, rest_length: 1, damping: 0 }],
  drag: [{ body: 'ball.1', linear: 0.1, angular: 0, momentum: 0 }],
  plane: [],
  water: [{ level: 1, wave: 0.1, speed: 1, buoyancy: 2, drag: 3, mode: 'volume' }],
  material: [{ between: ['*', 'floor'], restitution: 0.5, friction: 0.1 }],
};

test('the keys of parameters are those that the server knows', () => {
  assert.deepEqual(
    parametersOf(scene).map((parameter) => parameter.key),
    [
      'gravity',
      'spring.0.stiffness', 'spring.0.rest_length', 'spring.0.damping',
      'drag.0.linear', 'drag.0.angular', 'drag.0.momentum',
      'water.0.level', 'water.0.buoyancy', 'water.0.drag',
      'material.0.restitution', 'material.0.friction',
      'body.ball.1.mass', // and not that of a locked body, which has none
    ],
  );
});

test('values outside the domain are refused before they are sent', () => {
  const find = (key) => parametersOf(scene).find((parameter) => parameter.key === key);
  for (const [key, typed, value] of [
    ['spring.0.stiffness', ' 1e3 ', 1000],
    ['material.0.restitution', '1', 1],
    ['water.0.level', '-3', -3],
    ['gravity', '-9.8', -9.8],
  ])
    assert.deepEqual(readValue(find(key), typed), { value });
  for (const [key, typed] of [
    ['spring.0.stiffness', '-1'], ['material.0.restitution', '1.01'], ['body.ball.1.mass', '0'], ['water.0.level', ''], ['gravity', 'x'], ['gravity', 'Infinity'],
  ])
    assert.ok(readValue(find(key), typed).error, `${key} = ${typed}`);
});

test('a stiffness does not change what one sees, a colour does', () => {
  const stiffer = structuredClone(scene);
  stiffer.spring[0].stiffness = 9;
  stiffer.body[0].mass = 7;
  assert.equal(seen(stiffer), seen(scene));
  const red = structuredClone(scene);
  red.body[0].color = '#ff0000';
  assert.notEqual(seen(red), seen(scene));
});

test('a kick changes the velocity by as much as it says, upwards, and back with shift', () => {
  const impulse = kick(scene, 0, 1.5);
  assert.ok(Math.abs(Math.hypot(...impulse) / 2 - 1.5) < 1e-12);
  assert.ok(impulse[1] > 2 * Math.abs(impulse[0]) && impulse[0] !== 0);
  assert.deepEqual(kick(scene, 0, -1.5), impulse.map((x) => (x === 0 ? 0 : -x)));
  assert.equal(kick(scene, 1, 1), null); // locked
  assert.equal(kick(scene, 2, 1), null); // not there
  // (0.1 + 0.2 + 0.3)/3 kg m^2
  assert.ok(Math.abs(spin(scene, 0, 5)[2] - 1) < 1e-12 && spin(scene, 0, 5)[0] === 0);
  assert.equal(spin(scene, 0, 0), null); // none
  assert.equal(spin(scene, 1, 1), null); // locked
  // k = m (2 pi f)^2
  assert.ok(Math.abs(pullStiffness(3, 0.5) - 3 * Math.PI ** 2) < 1e-12);
});

test('one request at a time, and of many pulls only the last', async () => {
  const posted = [];
  let answer;
  const commands = new Commands((command) => new Promise((resolve) => (posted.push(command), (answer = resolve))), assert.fail);
  const pull = (x) => ({ do: 'pull', body: 0, anchor: [0, 0, 0], pin: [x, 0, 0], stiffness: 1 });
  commands.put(pull(1));
  commands.flush();
  for (const x of [2, 3, 4]) commands.put(pull(x));
  commands.put({ do: 'release' });
  for (const value of [1, 2]) commands.put({ do: 'set', key: 'a', value });
  commands.put({ do: 'set', key: 'b', value: 3 });
  commands.put({ do: 'step' });
  commands.put({ do: 'step' });
  commands.flush();
  assert.equal(posted.length, 1); // no answer yet
  for (let i = 0; i < 10; ++i) {
    answer();
    await new Promise(setImmediate);
    commands.flush();
  }
  assert.deepEqual(posted, [pull(1), pull(4), { do: 'release' }, { do: 'set', key: 'a', value: 2 }, { do: 'set', key: 'b', value: 3 }, { do: 'step' }, { do: 'step' }]);
});

test('a refusal is told, and the next command goes on', async () => {
  const told = [];
  const posted = [];
  const commands = new Commands(async (command) => {
    posted.push(command.do);
    if (command.do === 'kick') throw new Error('no such body');
  }, (why) => told.push(why));
  commands.put({ do: 'kick', body: 9, impulse: [0, 0, 0] });
  commands.put({ do: 'reset' });
  for (let i = 0; i < 3; ++i) {
    commands.flush();
    await new Promise(setImmediate);
  }
  assert.deepEqual([posted, told], [['kick', 'reset'], ['no such body']]);
});

const lane = (energy, momentum = [0, 3, 4]) => ({ status: 'running', reason: '', energy, momentum, angular_momentum: [1, 0, 0], contacts: [{}], cpu_per_second: null });

test('totals are kept in bounded memory and start over with time', () => {
  const history = new History(100);
  for (let i = 0; i < 1000; ++i) history.add(i / 10, [lane(i)]);
  assert.ok(history.samples.length <= 100);
  assert.equal(history.times().at(-1), 99.9);
  assert.equal(history.first.lanes[0].energy, 0);
  assert.equal(history.samples[0].lanes[0].contacts, undefined); // as many as there may be, none is kept
  history.add(99.9, [lane(7)]); // a change while time stands still
  assert.deepEqual([history.series(0, 'energy', 'size').at(-1), history.series(0, 'energy', 'size').at(-2)], [7, 998]);
  assert.equal(history.series(0, 'momentum', 'size').at(-1), 5);
  assert.equal(history.series(0, 'momentum', 'z').at(-1), 4);
  history.add(0, [lane(1), { ...lane(2), status: 'failed' }]);
  assert.equal(history.samples.length, 1);
  assert.deepEqual(history.series(1, 'energy', 'size'), [null]);
  history.add(1, [lane(null, [null, 1, 2]), lane(2)]);
  assert.deepEqual([history.series(0, 'energy', 'size')[1], history.series(0, 'momentum', 'size')[1]], [null, null]);
});

test('numbers have six digits', () => {
  for (const [x, text] of [[1.23456789, '1.23457'], [0, '0.00000'], [-12345678, '-1.23457e+7'], [1.5e-9, '1.50000e-9'], [null, 'not finite'], [NaN, 'not finite']])
    assert.equal(digits(x), text);
});

test('a lane of a state is read from its place', () => {
  const pose = new LanePose(2);
  const payload = Float32Array.from({ length: 52 }, (_, i) => i);
  assert.ok(pose.read(payload, 1));
  assert.deepEqual([...pose.position], [26, 27, 28, 39, 40, 41]);
  assert.deepEqual([...pose.orientation.subarray(4)], [42, 43, 44, 45]);
  assert.deepEqual(pose.vector(pose.velocity, 1), [46, 47, 48]);
  assert.deepEqual(pose.vector(pose.spin, 1), [49, 50, 51]);
  assert.equal(pose.read(payload, 2), false);
});

test('angular momentum turns with the body: L = R I R^T w', () => {
  const pose = new LanePose(1);
  const half = Math.SQRT1_2;
  pose.read(Float32Array.from([0, 0, 0, half, 0, 0, half, 0, 0, 0, 1, 1, 1]), 0); // a quarter turn about z
  const l = pose.angularMomentum(scene, 0);
  [0.2, 0.1, 0.3].forEach((x, i) => assert.ok(Math.abs(l[i] - x) < 1e-6));
});

test('the largest arrow is as long as it may be, the others in proportion; locked bodies have none', () => {
  const pose = new LanePose(2);
  const state = (v) => [0, 0, 0, 1, 0, 0, 0, v, 0, 0, 0, 0, 0];
  const scale = new ArrowScale();
  pose.read(Float32Array.from([...state(4), ...state(9)]), 0);
  assert.deepEqual(scale.arrows(scene, pose, ['velocity'], 2).map((arrow) => arrow.along), [[2, 0, 0]]);
  pose.read(Float32Array.from([...state(1), ...state(0)]), 0);
  assert.deepEqual(scale.arrows(scene, pose, ['velocity'], 2).map((arrow) => arrow.along[0]), [0.5]);
  pose.read(Float32Array.from([...state(NaN), ...state(0)]), 0);
  assert.deepEqual(scale.arrows(scene, pose, ['velocity', 'momentum'], 2), []);
});

test('impulses have one scale for all lanes, until time starts over', () => {
  const scale = new ArrowScale();
  const contact = (impulse) => ({ body: 0, other: -1, point: [0, 0, 0], normal: [0, 1, 0], impulse });
  scale.see([contact(2), contact(null), contact(0.5)]);
  scale.see([contact(1), contact(Infinity)]);
  assert.equal(scale.impulse, 2);
  scale.clear();
  assert.equal(scale.impulse, 0);
});

test('a trail forgets its older half, in another array', () => {
  const trail = new TrailRecorder(1, 100);
  for (let i = 0; i < 100; ++i) trail.add([i, 0, 0]);
  const full = trail.positions;
  trail.add([100, 0, 0]);
  assert.notEqual(trail.positions, full);
  assert.equal(trail.frames, 51);
  assert.deepEqual([trail.positions[0], trail.positions[3 * 50]], [50, 100]);
});

test('the camera holds what moves, and lets go what flies away', () => {
  // Three equal moments say nothing of a shape: points, which reach no farther than their centres.
  const point = (b) => ({ ...b, inertia: [1, 0, 0, 0, 1, 0, 0, 0, 1] });
  const reach = new Reach({ ...scene, body: scene.body.map(point) }, 2);
  const { max } = reach.bounds;
  assert.equal(reach.include([0, max[1] / 2, 0, 0, 0, 0]), false);
  assert.equal(reach.include([0, max[1] + 0.5, 0, 0, 0, 0]), true);
  assert.ok(reach.bounds.max[1] > max[1] + 0.5);
  assert.equal(reach.include([1e6, 0, 0, NaN, 0, 0]), false);
  // Farther than a few sizes of the scene, yet no farther than ten free falls in the scenario's time: 10 g t^2/2.
  const small = { ...scene, spring: [], body: [point(body('point'))] };
  assert.equal(new Reach(small, 10).include([0, -490, 0]), true);
  assert.equal(new Reach(small, 3).include([0, -490, 0]), false);
});

test('steps and speeds as the server reads them', () => {
  for (const text of ['1/240', '0.001', ' 1 / 60 ', '1e-3']) assert.ok(goodStep(text), text);
  for (const text of ['', '0', '1/0', '-1', 'x', '1/2/3', '0/5']) assert.ok(!goodStep(text), text);
  for (const speed of [0.01, 0.5, 1, 100]) assert.equal(speedAt(slide(speed)), speed);
});

test('plots leave room about their lines, also about one that lies still', () => {
  for (const [least, most] of [[1, 2], [-3, -3], [0, 0], [5e-9, 5e-9], [null, null]]) {
    const [low, high] = roomy(least, most);
    assert.ok(low < high && (least === null || (low < least && high > most)), `${least} … ${most}`);
  }
});

test('pictures go to a folder, not to a scenario', () => {
  for (const [recording, is] of [['', false], ['a.toml', false], ['A.TOML', false], ['film', true]]) assert.equal(wantsPictures({ recording }), is);
});

test('the secret is taken out of the address and kept by the tab', () => {
  const kept = new Map();
  const shown = [];
  const place = (hash, storage = { getItem: (key) => kept.get(key) ?? null, setItem: (key, value) => kept.set(key, value) }) => ({
    location: { pathname: '/', search: '?a=1', hash },
    history: { state: null, replaceState: (state, title, url) => shown.push(url) },
    get sessionStorage() {
      if (storage) return storage;
      throw new Error('denied');
    },
  });
  assert.equal(secret(place('')), '');
  assert.deepEqual(shown, []);
  assert.equal(secret(place('#token=ab12')), 'ab12');
  assert.equal(secret(place('')), 'ab12'); // a reload
  assert.equal(secret(place('#webgl=off&token=cd')), 'cd');
  assert.equal(secret(place('#webgl=off')), 'cd');
  assert.equal(secret(place('#token=ef', null)), 'ef');
  assert.equal(secret(place('', null)), '');
  assert.deepEqual(shown, ['/?a=1', '/?a=1#webgl=off', '/?a=1']);
  assert.deepEqual(['', '#webgl=off', '#token=a', '#b&token=a'].map(hasSecret), [false, false, true, true]);
});
