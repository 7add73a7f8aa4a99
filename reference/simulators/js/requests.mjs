// Strict reading of the harness' requests (docs/protocol.md): a missing, unknown or mistyped key is an error that names it.
// A type is a function (value, place) that throws Malformed; rows of keys below, a "?" after those that may be left out.

/** A request that is not what the protocol says: an answer `error`. */
export class Malformed extends Error {}

const must = (holds, place, expected) => { if (!holds) throw new Malformed(`${place}: expected ${expected}`); };

// ---- Types --------------------------------------------------------------------------------------------

const number = (x, place) => must(Number.isFinite(x), place, 'a finite number');
const text = (x, place) => must(typeof x === 'string', place, 'a string');
const flag = (x, place) => must(typeof x === 'boolean', place, 'true or false');
const whole = (least) => (x, place) => must(Number.isSafeInteger(x) && x >= least, place, `a whole number from ${least}`);
const above_zero = (x, place) => must(Number.isFinite(x) && x > 0, place, 'a finite number above 0');
const list = (type) => (x, place) => {
  must(Array.isArray(x), place, 'a list');
  x.forEach((one, i) => type(one, `${place}[${i}]`));
};
const numbers = (count) => (x, place) => {
  must(Array.isArray(x) && x.length === count && x.every(Number.isFinite), place, `${count} finite numbers`);
};
const vector = numbers(3);
const texts = (x, place) => {
  must(x !== null && typeof x === 'object' && !Array.isArray(x), place, 'an object');
  for (const [key, value] of Object.entries(x)) text(value, `${place}.${key}`);
};
const any = () => {};

const object = (rows) => {
  const types = Object.entries(rows).map(([key, type]) => [key.replace('?', ''), type, key.endsWith('?')]);
  const known = new Set(types.map(([key]) => key));
  return (x, place) => {
    must(x !== null && typeof x === 'object' && !Array.isArray(x), place || 'the line', 'an object');
    const path = (key) => (place ? `${place}.${key}` : key);
    for (const [key, type, optional] of types)
      if (Object.hasOwn(x, key)) type(x[key], path(key));
      else must(optional, path(key), 'a value, and there is none');
    for (const key of Object.keys(x)) if (!known.has(key)) throw new Malformed(`${path(key)}: unknown key`);
  };
};

// ---- The scene ----------------------------------------------------------------------------------------

const shapes = {
  sphere: {radius: number}, box: {half_extents: vector}, disc: {radius: number}, rod: {length: number},
  capsule: {radius: number, length: number}, cylinder: {radius: number, length: number}, cone: {radius: number, length: number},
  hull: {vertices: list(vector)}, mesh: {vertices: list(vector), faces: list(numbers(3))},
};
const type_of = new Map(Object.entries(shapes).map(([type, rows]) => [type, object({type: text, ...rows})]));
function shape(x, place) {
  must(type_of.has(x?.type), `${place}.type`, [...type_of.keys()].join(', '));
  type_of.get(x.type)(x, place);
}
const part = object({
  shape: (x, place) => { if (x !== null) shape(x, place); }, mass: number, position: vector, orientation: numbers(4)});
type_of.set('compound', object({type: text, parts: list(part)}));

const coordinate = object({
  which: (x, place) => must(['first', 'second', 'third'].includes(x), place, 'first, second or third'), start: number, 'lower?': number,
  'upper?': number, restitution: number, force: number, stiffness: number, damping: number, quadratic_damping: number,
  friction: number, armature: number, target: number, target_amplitude: number, target_frequency: number, target_phase: number,
  'target_times?': list(number), 'target_values?': list(number)});
const filters = {'collision_groups?': list(text), 'collision_mask?': list(text)};
const scene = object({
  body: list(object({
    name: text, position: vector, velocity: vector, angular_velocity: vector, orientation: numbers(4), 'gravity?': vector,
    mass: number, inertia: numbers(9), 'shape?': shape, locked: flag, collide: flag, color: text, ...filters})),
  spring: list(object({
    body: text, anchor: vector, 'to?': text, 'pin?': vector, 'to_anchor?': vector, stiffness: number, rest_length: number,
    damping: number})),
  drag: list(object({body: text, linear: number, angular: number, momentum: number})),
  thrust: list(object({
    body: text, 'force?': vector, 'mass_rate?': number, 'exhaust_velocity?': vector, 'exchanged_velocity?': vector})),
  drive: list(object({body: text, force: vector, frequency: number})),
  attraction: list(object({body: text, to: text, strength: number})),
  water: list(object({level: number, wave: number, speed: number, buoyancy: number, drag: number, mode: text})),
  joint: list(object({
    type: text, 'name?': text, body: text, 'to?': text, 'point?': vector, 'axis?': vector, 'axis_2?': vector, 'length?': number,
    'pitch?': number, 'displacement?': list(coordinate), 'angle?': list(coordinate)})),
  plane: list(object({name: text, normal: vector, offset: number, ...filters})),
  material: list(object({between: list(text), restitution: number, friction: number})),
  gravity: vector, 'frame?': object({velocity: vector, angular_velocity: vector, 'acceleration?': vector, 'frequency?': number, 'angular_acceleration?': vector}), impacts: text,
});

// ---- Requests -----------------------------------------------------------------------------------------

const commands = new Map(Object.entries({
  hello: object({cmd: text, protocol: number}),
  load: object({
    cmd: text, scene, dt: above_zero, path: text, integrator: text, options: texts, 'tolerance?': above_zero, 'force?': flag}),
  run: object({cmd: text, steps: whole(0), every: whole(1), 'at?': list(whole(1)), 'watch?': list(any)}),
  quit: object({cmd: text}),
}));

/** References to bodies by name, which must be there. */
function require_bodies(scene) {
  const names = new Set();
  scene.body.forEach(({name}, i) => {
    must(!names.has(name), `scene.body[${i}].name`, `a name of its own; two bodies are named '${name}'`);
    names.add(name);
  });
  for (const [key, rows] of Object.entries(scene))
    if (Array.isArray(rows) && key !== 'body' && key !== 'gravity') rows.forEach((row, i) => {
      for (const end of ['body', 'to'])
        if (row[end] !== undefined) must(names.has(row[end]), `scene.${key}[${i}].${end}`, `a body; none is named '${row[end]}'`);
    });
}

/** The request of a line; throws Malformed. */
export function read_request(line) {
  let request;
  try {
    request = JSON.parse(line);
  } catch (error) {
    throw new Malformed(`no JSON on the line: ${error.message}`);
  }
  must(commands.has(request?.cmd), 'cmd', [...commands.keys()].join(', '));
  commands.get(request.cmd)(request, '');
  if (request.cmd === 'load') require_bodies(request.scene);
  if (request.cmd === 'run') {
    const at = request.at ?? [];
    must(at.every((step, i) => step > (at[i - 1] ?? 0) && step <= request.steps), 'at', 'ascending steps in 1..steps');
    must((request.watch ?? []).length === 0, 'watch', 'an empty list: this worker finds no events');
  }
  return request;
}
