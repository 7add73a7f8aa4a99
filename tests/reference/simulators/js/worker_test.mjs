// The worker of engines in JavaScript against requests that are not what the protocol says, long runs and states that are
// not finite; of each engine that is here.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {test} from 'node:test';
import {body, engines, load, load as any_load, root, run, scene, talk} from './conversation.mjs';

const spring = {body: 'a', anchor: [0, 0, 0], pin: [0, 0, 0], stiffness: 3, rest_length: 0, damping: 0};
const hinge = {type: 'hinge', body: 'a', point: [0, 0, 0], axis: [0, 1, 0]};
const acts = {
  which: 'first', start: 0, restitution: 0, force: 1, stiffness: 0, damping: 0, quadratic_damping: 0, friction: 0, armature: 0, target: 0,
  target_amplitude: 0, target_frequency: 0, target_phase: 0};
const without = (object, key) => Object.fromEntries(Object.entries(object).filter(([k]) => k !== key));

// A line, and what its answer says.
const garbage = [
  ['', /no JSON on the line/],
  ['garbage', /no JSON on the line/],
  ['{"cmd":"load"', /no JSON on the line/],
  ['null', /cmd: expected hello, load, run, quit/],
  ['[1,2]', /cmd: expected/],
  ['{"cmd":"dance"}', /cmd: expected/],
  ['{"cmd":"__proto__"}', /cmd: expected/],
  [{cmd: 'hello'}, /^protocol: expected a value/],
  [without(load(), 'dt'), /^dt: expected a value/],
  [load({dt: 0}), /^dt: expected a finite number above 0/],
  [load({dt: -1e-3}), /^dt: expected a finite number above 0/],
  [load({dt: null}), /^dt: expected a finite number above 0/],
  [JSON.stringify(load()).replace('"dt":0.001', '"dt":1e999'), /^dt: expected a finite number above 0/],
  [JSON.stringify(load()).replace('"dt":0.001', '"dt":NaN'), /no JSON on the line/],
  [load({dt: '1e-3'}), /^dt: expected/],
  [load({speed: 1}), /^speed: unknown key/],
  [load({options: {gyro: 1}}), /^options.gyro: expected a string/],
  [load({options: []}), /^options: expected an object/],
  [load({tolerance: -1}), /^tolerance: expected a finite number above 0/],
  [load({scene: 7}), /^scene: expected an object/],
  [load({scene: without(scene(), 'drag')}), /^scene.drag: expected a value/],
  [load({scene: scene({magnet: []})}), /^scene.magnet: unknown key/],
  [load({scene: scene({body: [body({mass: null})]})}), /^scene.body\[0\].mass: expected a finite number/],
  [JSON.stringify(load()).replace('"mass":1.7', '"mass":1e999'), /^scene.body\[0\].mass: expected a finite number/],
  [load({scene: scene({body: [body({position: [1, 2]})]})}), /^scene.body\[0\].position: expected 3 finite numbers/],
  [load({scene: scene({body: [body(), body()]})}), /^scene.body\[1\].name: .*two bodies are named 'a'/],
  [load({scene: scene({body: [body({shape: {type: 'blob'}})]})}), /^scene.body\[0\].shape.type: expected sphere/],
  [load({scene: scene({body: [body({shape: {type: 'sphere', radius: 1, edge: 2}})]})}), /^scene.body\[0\].shape.edge: unknown key/],
  [load({scene: scene({spring: [{...spring, body: 'b'}]})}), /^scene.spring\[0\].body: expected a body; none is named 'b'/],
  [load({scene: scene({joint: [{...hinge, angle: [{...acts, which: 'fourth'}]}]})}), /^scene.joint\[0\].angle\[0\].which: expected first, second or third/],
  [load({scene: scene({joint: [{...hinge, angle: [without(acts, 'force')]}]})}), /^scene.joint\[0\].angle\[0\].force: expected a value/],
  [load({scene: scene({joint: [{...hinge, angle: [{...acts, spring: 1}]}]})}), /^scene.joint\[0\].angle\[0\].spring: unknown key/],
  [run(), /^cmd: each run needs a load before it/],
  [run({steps: -1}), /^steps: expected a whole number from 0/],
  [run({steps: 1.5}), /^steps: expected a whole number from 0/],
  [run({every: 0}), /^every: expected a whole number from 1/],
  [run({at: [3, 3]}), /^at: expected ascending steps in 1..steps/],
  [run({at: [11]}), /^at: expected ascending steps in 1..steps/],
  [run({watch: [{body: 0, other: -1, plane: 0}]}), /^watch: expected an empty list/],
  [run({continue: true}), /^continue: unknown key/],
];

// Settings that cannot be, and what is said of them.
const impossible = [
  [{path: 'as-shiped'}, /no path 'as-shiped', did you mean 'as-shipped'\? \(valid: (plain, )?(stand-in, )?as-shipped\)/],
  [{integrator: 'rk5'}, /no integrator 'rk5'.*valid: /],
  [{options: {sleping: 'off'}}, /no option 'sleping'.*valid: /],
  [{options: {constructor: '1'}}, /no option 'constructor'/],
  [{tolerance: 1e-6}, /^tolerance: .* has no integrator that takes one/],
];

// Paths on which an engine takes the tests' scenes: bodies that tumble, springs.
const paths = {'havok': 'stand-in', 'cannon-es': 'stand-in'};

for (const engine of engines) {
  const load = (members) => any_load({path: paths[engine] ?? '', ...members});

  test(`${engine} names what is wrong with a request, and goes on`, () => {
    const told = talk(engine, [...garbage.map(([line]) => line), load(), run({steps: 1}), {cmd: 'quit'}]);
    assert.equal(told.code, 0, told.stderr);
    garbage.forEach(([line, says], i) => assert.match(told.messages[i].error, says, JSON.stringify(line)));
    assert.deepEqual(told.messages.slice(garbage.length).map((m) => m.ok ?? Object.keys(m)[0]), ['load', 'frame', 'frame', 'run']);
  });

  test(`${engine} refuses settings that cannot be`, () => {
    const {messages} = talk(engine, impossible.map(([members]) => load(members)));
    impossible.forEach(([, says], i) => assert.match(messages[i].error, says));
  });

  test(`${engine} takes each option within its range, and refuses what is outside`, () => {
    const [hello] = talk(engine, [{cmd: 'hello', protocol: 1}]).messages;
    const numbers = hello.options.filter((option) => option.values.length === 0);
    // One worker takes them all, as it starts for longer than it answers.
    const values = ({engine_default}) => [engine_default, 'nan', 'inf', '1e999', '-1', '', '0x10', 'two'];
    const answers = talk(engine, numbers.flatMap((one) => values(one).map((value) => load({options: {[one.name]: value}}))))
      .messages.filter((message) => !message.frame);
    assert.equal(answers.length, 8 * numbers.length);
    numbers.forEach(({name, engine_default}, i) => {
      const [taken, ...refused] = answers.slice(8 * i, 8 * i + 8);
      assert.equal(taken.ok, 'load', `${name}=${engine_default}`);
      for (const {error} of refused) assert.match(error, new RegExp(`option ${name} = '.*' is not a (whole |finite )number`));
    });
  });

  test(`${engine} sends the states of a long run, in frames as the protocol has them`, () => {
    const steps = 20011, every = 7, at = [1, 2, 3, 500, 501, 20010];
    const {code, messages} = talk(engine, [load({scene: scene({spring: [spring]})}), run({steps, every, at})]);
    assert.equal(code, 0);
    const [answer, start, ...frames] = messages, done = frames.pop();
    assert.equal(answer.ok, 'load');
    assert.deepEqual([start.frame.first, start.frame.states.length], [0, 1]);
    assert.equal(done.ok, 'run');
    assert.equal(done.frames, frames.length);
    const sent = frames.flatMap(({frame}) => frame.states.map((_, i) => frame.first + i * frame.stride));
    const wanted = Array.from({length: steps}, (_, i) => i + 1).filter((s) => s % every === 0 || at.includes(s) || s === steps);
    assert.deepEqual(sent, wanted);
    for (const {frame} of frames) {
      assert.ok(frame.size <= 262144);
      for (const state of frame.states) {
        assert.equal(state.length, 13);
        assert.ok(Math.abs(Math.hypot(...state.slice(3, 7)) - 1) < 1e-5);
      }
    }
    assert.ok(done.step_ns > 0 && done.load_ns > 0);
  });

  test(`${engine} gives the same bits after other scenes, and in another process`, () => {
    const tumble = [load(), run({steps: 300, every: 300})];
    const states = (told) => told.messages.filter((m) => m.frame && m.frame.first > 0).map((m) => m.frame.states[0]);
    const [first] = states(talk(engine, tumble));
    const other = [load({scene: scene({gravity: [0, 0, 0], spring: [spring]})}), run()];
    const after = states(talk(engine, [...tumble, ...other, ...tumble])).at(-1);
    assert.deepEqual(after, first);
  });

  // Two bodies at one place attract each other without bound.
  test(`${engine} shows states that are not finite as they are, and goes on`, () => {
    const pair = scene({body: [body(), body({name: 'b'})], attraction: [{body: 'a', to: 'b', strength: 1}]});
    const {code, messages} = talk(engine, [load({scene: pair}), run(), load(), run()]);
    assert.equal(code, 0);
    const [wild, tame] = messages.filter((m) => m.ok === 'run').map((done) => messages[messages.indexOf(done) - 1].frame.states);
    for (const state of wild) assert.ok([0, 1, 2, 7, 8, 9, 13, 14, 15].every((k) => !Number.isFinite(state[k])), `${state}`);
    for (const state of tame) assert.ok(state.every(Number.isFinite), `${state}`);
  });

  test(`${engine} takes a compound that touches a plane`, () => {
    const part = (x) => ({shape: {type: 'sphere', radius: 0.2}, mass: 0.5, position: [x, 0, 0], orientation: [1, 0, 0, 0]});
    const dumbbell = body({position: [0, 0.2, 0], velocity: [0, 0, 0], angular_velocity: [0, 0, 0], collide: true,
      shape: {type: 'compound', parts: [part(0.4), part(-0.4)]}});
    const floor = {plane: [{name: 'floor', normal: [0, 1, 0], offset: 0}], material: [{between: ['*', '*'], restitution: 0, friction: 0}]};
    const {messages} = talk(engine, [load({scene: scene({body: [dumbbell], gravity: [0, -9.81, 0], ...floor})}), run({steps: 100, every: 100})]);
    assert.equal(messages.at(-1).ok, 'run', JSON.stringify(messages.at(-1)));
    assert.ok(Math.abs(messages.at(-2).frame.states[0][1] - 0.2) < 0.02);  // it rests, by contacts that may be soft
  });

  test(`${engine} ends where its input ends, also within a line`, () => {
    assert.equal(talk(engine, []).code, 0);
    assert.equal(talk(engine, [load()]).code, 0);
  });

  test(`${engine} says whose costs its costs are`, () => {
    const [hello, answer] = talk(engine, [{cmd: 'hello', protocol: 1}, load()]).messages;
    assert.match(hello.version, /^\S+ \((WebAssembly|JavaScript) in Node \d+\.\d+\.\d+\)$/);
    const build = answer.settings.find((row) => row.name === 'build');
    assert.match(build.reason, /costs/);
    assert.ok(hello.version.includes(build.value));
  });
}

const unit = [1, 0, 0, 0, 1, 0, 0, 0, 1];

// v' = v + g h, x' = x + v' h with h = dt/n: a step of n parts from rest falls g dt^2 (1 + 1/n)/2.
const parts = [
  ...engines.map((engine) => [engine, {}, {rapier: 4, 'rapier-deterministic': 4, 'rapier-simd': 4, havok: 4}[engine] ?? 1]),
  ['rapier', {options: {'solver-iterations': '1'}}, 1], ['rapier', {options: {'solver-iterations': '7'}}, 7],
  ['rapier', {path: 'as-shipped'}, 4],
  ...[[1 / 30, 8], [1 / 60, 4], [1 / 90, 3], [1 / 120, 2], [1 / 240, 1], [1 / 512, 1]].map(([dt, n]) => ['havok', {path: 'as-shipped', dt}, n]),
  ['havok', {path: 'as-shipped', options: {'ideal-step': '0'}, dt: 1 / 120}, 4],
];
for (const [engine, asked, substeps] of parts.filter(([name]) => engines.includes(name)))
  test(`${engine} tells ${substeps} substeps ${JSON.stringify(asked)}, and makes them`, () => {
    const falls = scene({body: [body({velocity: [0, 0, 0], angular_velocity: [0, 0, 0]})], gravity: [0, -97, 0]}), dt = asked.dt ?? 0.2;
    const [told, start, end] = talk(engine, [load({scene: falls, ...asked, dt}), run({steps: 1})]).messages;
    assert.equal(told.substeps, substeps);
    const fallen = (start.frame.states[0][1] - end.frame.states[0][1]) / (97 * dt * dt);
    assert.ok(Math.abs(fallen - (1 + 1 / substeps) / 2) < 1e-5, `${fallen}`);
  });

test('havok tells what it cuts off a step', {skip: !engines.includes('havok')}, () => {
  const went = (dt) => {
    const messages = talk('havok', [load({scene: scene({body: [body({mass: 1, velocity: [10, 0, 0], angular_velocity: [0, 0, 0], inertia: unit})]}), path: 'as-shipped', dt}), run({steps: 1})]).messages;
    return [(messages.at(-2).frame.states[0][0] - messages.at(-3).frame.states[0][0]) / (10 * dt), messages.at(-1).remarks];
  };
  const [whole, silent] = went(2.5 / 60), [part, [told]] = went(0.1);
  assert.ok(Math.abs(whole - 1) < 1e-3, `${whole}`);
  assert.deepEqual(silent, []);
  assert.ok(Math.abs(part - 2.582 / 6) < 1e-3, `${part}`);
  assert.equal(told, 'In a step of 0.1 s Havok moves bodies for 0.0430 s: what is longer than 2.58 ideal steps is cut off.');
});

test('rapier tells what it holds a motion to', {skip: !engines.includes('rapier')}, () => {
  const fast = body({velocity: [0, 500, 0]}), spinning = body({name: 'b', angular_velocity: [0, 0, 90], inertia: [1, 0, 0, 0, 1, 0, 0, 0, 1]});
  const {remarks} = talk('rapier', [load({scene: scene({body: [fast, spinning]}), dt: 0.01}), run()]).messages.at(-1);
  assert.deepEqual(remarks, [
    "'a', step 1: Rapier holds speeds to 400 m/s, and it is there.",
    "'b', step 1: Rapier holds angular speeds to 78.5398 rad/s, a quarter of pi in a step, and it is there."]);
  assert.deepEqual(talk('rapier', [load(), run()]).messages.at(-1).remarks, []);
});

test('the cap of speeds on rapier goes with its unit of length', {skip: !engines.includes('rapier')}, () => {
  const speed = (unit) => {
    const messages = talk('rapier', [load({scene: scene({body: [body({velocity: [0, 1000, 0], angular_velocity: [0, 0, 0]})]}), dt: 0.01, options: {'length-unit': unit}}), run({steps: 1})]).messages;
    return (messages.at(-2).frame.states[0][1] - messages.at(-3).frame.states[0][1]) / 0.01;
  };
  assert.ok(Math.abs(speed('1') - 400) < 0.1, `${speed('1')}`);
  assert.ok(Math.abs(speed('10') - 1000) < 0.1, `${speed('10')}`);
});

test('the builds of rapier have the same bits, and names of their own', {skip: !['rapier', 'rapier-deterministic'].every((e) => engines.includes(e))}, () => {
  const floor = {plane: [{name: 'floor', normal: [0, 1, 0], offset: -1}], material: [{between: ['*', '*'], restitution: 0.4, friction: 0.3}]};
  const box = (name, x) => body({name, collide: true, position: [x, 0.2, 0], shape: {type: 'box', half_extents: [0.3, 0.2, 0.4]}});
  const touching = load({scene: scene({body: [box('a', 0), box('b', 1)], joint: [{type: 'hinge', body: 'a', to: 'b', point: [0.5, 0, 0], axis: [0, 1, 0]}], ...floor})});
  const [plain, deterministic] = ['rapier', 'rapier-deterministic'].map((engine) =>
    talk(engine, [{cmd: 'hello', protocol: 1}, touching, run({steps: 600, every: 1})]).messages);
  assert.deepEqual(deterministic.filter((m) => m.frame), plain.filter((m) => m.frame));
  assert.equal(plain.filter((m) => m.frame).at(-1).frame.states.at(-1).every(Number.isFinite), true);
  assert.deepEqual([plain[0].engine, deterministic[0].engine], ['rapier', 'rapier-deterministic']);
  const feature = (answer) => answer.settings.find((row) => row.name === 'features of the Rust crate')?.value;
  assert.deepEqual([feature(plain[1]), feature(deterministic[1])], [undefined, 'with enhanced-determinism']);
});

test('crashcat leaves out turns of less than 1e-6 rad in a step, as it says', {skip: !engines.includes('crashcat')}, () => {
  const turned = (spin) => talk('crashcat', [load({scene: scene({body: [body({angular_velocity: [spin, 0, 0]})]})}), run({steps: 1000, every: 1000})])
    .messages.at(-2).frame.states[0][4];
  assert.equal(turned(0.9e-3), 0);
  assert.ok(Math.abs(turned(1.1e-3) - 0.55e-3) < 1e-6);  // sin of half of 1.1e-3 rad
});

test('havok tells the mass that it holds, and who is past the edge of a plane', {skip: !engines.includes('havok')}, () => {
  const remarks = (members, rest) => talk('havok', [load({scene: scene({body: [body({inertia: unit, ...members})], ...rest})}), run()]).messages.at(-1).remarks;
  const [rounded] = remarks({mass: 3});
  assert.match(rounded, /^'a': .* its mass of 3 kg is held as 2\.994\d* kg, 0\.20 % off\.$/);
  assert.deepEqual(remarks({mass: 4}), []);
  const ball = {mass: 1, shape: {type: 'sphere', radius: 0.5}, collide: true};
  const floor = {plane: [{name: 'floor', normal: [0, 1, 0], offset: -9}], material: [{between: ['*', '*'], restitution: 0, friction: 0}]};
  assert.deepEqual(remarks({...ball, position: [99, 0, 0]}, floor), []);
  assert.deepEqual(remarks({...ball, position: [0, 0, 101]}, floor), ["'a', step 0: it is past the edge of the box that stands for 'floor'."]);
});

// A folder with the sources and without the packages.
test('a package that is missing is no failure', () => {
  const bare = fs.mkdtempSync(path.join(os.tmpdir(), 'cylon-js-'));
  const sources = path.join(root, 'reference/simulators/js');
  for (const file of fs.readdirSync(sources).filter((name) => name.endsWith('.mjs') || name === 'package.json'))
    fs.copyFileSync(path.join(sources, file), path.join(bare, file));
  const told = ['jolt', 'rapier-deterministic', 'rapier-simd'].map((engine) => talk(engine, [{cmd: 'hello', protocol: 1}], bare).messages[0]);
  fs.rmSync(bare, {recursive: true});
  for (const {unsupported} of told) assert.match(unsupported, /`\.\/run engines` installs it/);
});

test('mujoco3 leaves out contacts between what is fixed to the world', {skip: !engines.includes('mujoco3')}, () => {
  const ball = (name, members) => body({name, collide: true, shape: {type: 'sphere', radius: 0.3}, velocity: [0, 0, 0], angular_velocity: [0, 0, 0], ...members});
  const bodies = [ball('a', {position: [0, 0, 0], locked: true}), ball('b', {position: [0.1, 0, 0]}),
    ball('c', {position: [9, 0, 0], collision_groups: ['own'], collision_mask: ['own']})];  // so that pairs are listed
  const joint = [{type: 'fixed', body: 'b', point: [0, 0, 0]}], material = [{between: ['*', '*'], restitution: 0, friction: 0.3}];
  const {messages} = talk('mujoco3', [load({scene: scene({body: bodies, joint, material})}), run()]);
  assert.equal(messages.at(-1).ok, 'run', JSON.stringify(messages.at(-1)));
});
