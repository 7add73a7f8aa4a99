// The parts of the worker that know no engine: requests, materials of pairs, principal axes; and whether the defaults that
// an adapter states are those of its engine.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {body, engines, scene} from './conversation.mjs';
import {Unsupported, prepare} from '../../../../reference/simulators/js/scene.mjs';
import {principal_axes, quaternion_of, rotate, turn_of_y, world_times} from '../../../../reference/simulators/js/vectors.mjs';

const near = (a, b, bound) => a.forEach((x, i) => assert.ok(Math.abs(x - b[i]) <= bound, `${a} is not ${b}`));

test('principal axes and moments give the tensor back', () => {
  const tensor = [0.9, 0.13, -0.21, 0.13, 0.7, 0.08, -0.21, 0.08, 1.1];
  const {moments, axes} = principal_axes(tensor);
  const diagonal = [moments[0], 0, 0, 0, moments[1], 0, 0, 0, moments[2]];
  for (const v of [[1, 0, 0], [0.3, -0.7, 0.2]])
    near(world_times(diagonal, axes, v), world_times(tensor, [1, 0, 0, 0], v), 4e-16 * 8);
  assert.deepEqual(principal_axes([3, 0, 0, 0, 1, 0, 0, 0, 2]), {moments: [3, 1, 2], axes: [1, 0, 0, 0]});
});

test('rotations turn as their matrices say', () => {
  for (const n of [[0, 1, 0], [0, -1, 0], [1, 0, 0], [2 / 3, -1 / 3, 2 / 3]]) near(rotate(turn_of_y(n), [0, 1, 0]), n, 1e-15);
  near(rotate(quaternion_of([0, 0, 1], [1, 0, 0], [0, 1, 0]), [1, 2, 3]), [2, 3, 1], 1e-15);
});

const ball = (name, members) => body({name, collide: true, shape: {type: 'sphere', radius: 0.1}, ...members});
const row = (a, b, restitution, friction = 0) => ({between: [a, b], restitution, friction});
const with_materials = (material, members) =>
  prepare(scene({body: [ball('a'), ball('b'), ball('c')], material, ...members})).contacts;

test('an exact pair wins over a pattern, and the first of equals', () => {
  const contacts = with_materials([row('*', '*', 0.1), row('a', '*', 0.2), row('*', 'a', 0.3), row('b', 'a', 0.4)]);
  assert.equal(contacts.material(0, 1).restitution, 0.4);
  assert.equal(contacts.material(2, 0).restitution, 0.2);
  assert.equal(contacts.material(1, 2).restitution, 0.1);
  assert.equal(contacts.uniform('restitution'), undefined);
  assert.equal(contacts.uniform('friction'), 0);
});

test('numbers of single bodies give those of each pair, or the scene is refused', () => {
  const least = with_materials([row('a', 'b', 0.5), row('a', 'c', 0.2), row('b', 'c', 0.2)]).of_things('restitution', 'It');
  assert.equal(least.rule, 'min');
  assert.deepEqual([0, 1, 2].map(least.of), [0.5, 0.5, 0.2]);
  const largest = with_materials([row('a', 'b', 0.2), row('a', 'c', 0.5), row('b', 'c', 0.5)]).of_things('restitution', 'It');
  assert.equal(largest.rule, 'max');
  const four = [ball('a'), ball('b'), ball('c'), ball('d')];
  const none = with_materials([row('*', '*', 0.5), row('a', 'b', 0.1), row('c', 'd', 0.9)], {body: four});
  assert.throws(() => none.of_things('restitution', 'It'), Unsupported);
});

test('a pair without a material is refused, unless it cannot touch', () => {
  assert.throws(() => with_materials([row('a', '*', 0.5)]), /'b' may touch 'c', but the scene has no material for them/);
  const joint = {type: 'ball', body: 'b', to: 'c', point: [0, 0, 0]};
  assert.doesNotThrow(() => with_materials([row('a', '*', 0.5)], {joint: [joint]}));
  const apart = [ball('a'), ball('b', {collision_mask: ['x']}), ball('c')];
  assert.doesNotThrow(() => with_materials([row('a', '*', 0.5)], {body: apart}));
});

// What an adapter calls the engine's own value is the engine's own value.
for (const engine of engines) test(`the defaults stated for ${engine} are its own`, async () => {
  const {about, start} = await import(`../../../../reference/simulators/js/${engine}.mjs`);
  const {defaults} = await start();
  for (const {name, engine_default, values} of about.options) {
    const own = defaults()[name];
    assert.notEqual(own, undefined, name);
    if (own === null) continue;  // the engine does not tell it
    if (values) assert.equal(own, engine_default, name);
    else assert.ok(Math.abs(own - engine_default) <= 1e-6 * Math.abs(engine_default), `${name}: ${own}, not ${engine_default}`);
  }
});
