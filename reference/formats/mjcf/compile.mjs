#!/usr/bin/env node
// cylon-import-mujoco3 FILE [KEYFRAME]: what main.cc prints, of MuJoCo 3 in WebAssembly, which reads newer files.
import fs from 'node:fs';
import path from 'node:path';
import {createRequire} from 'node:module';
import {pathToFileURL} from 'node:url';

// The npm packages of the engines in JavaScript are those of this program too.
const require = createRequire(new URL('../../simulators/js/package.json', import.meta.url));
const {default: load_mujoco} = await import(pathToFileURL(require.resolve('@mujoco/mujoco')));

const needed = /^(body_|jnt_|dof_|geom_|mesh_|pair_|exclude_|eq_|site_(bodyid|pos|quat)|tendon_|actuator_|qpos|key_)/;
const large = /_user$|^geom_rgba$|^geom_aabb$|^body_bvh|^mesh_(normal|texcoord|face|poly|bvh|oct|extrema|path|scale)/;
const kinds = {
  body: 'nbody', jnt: 'njnt', geom: 'ngeom', mesh: 'nmesh', pair: 'npair', eq: 'neq', tendon: 'ntendon',
  actuator: 'nactuator', sensor: 'nsensor', site: 'nsite', cam: 'ncam', light: 'nlight', key: 'nkey', skin: 'nskin',
  flex: 'nflex', plugin: 'nplugin',
};
const words = {jnt: 'joint', eq: 'equality', cam: 'camera'};
const bits = ['constraint', 'equality', 'frictionloss', 'limit', 'contact', 'passive', 'spring', 'damper', 'gravity', 'filterparent', 'actuation', 'clampctrl'];

class Refused extends Error {}

// A white pixel.  Nothing in a scene follows from a picture: this stands for those that are not there.
const white = Buffer.from('iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP4//8/AAX+Av4N70a4AAAAAElFTkSuQmCC', 'base64');

/**
 * The machine's files are not MuJoCo's in WebAssembly: those that a message misses are copied, and it tries again.
 * `absent`: names of pictures that no file of the machine is.
 */
function compile(M, file, absent) {
  const copy = (name) => {
    M.FS.mkdirTree(path.dirname(name));
    M.FS.writeFile(name, fs.readFileSync(name));
  };
  const whole = path.resolve(file);
  for (const beside of fs.readdirSync(path.dirname(whole), {withFileTypes: true}))
    if (beside.isFile() && /\.(xml|mjcf|stl|obj|msh|png|bin|txt)$/i.test(beside.name)) copy(path.join(path.dirname(whole), beside.name));
  copy(whole);
  for (const tried = new Set();;) try {
    return M.MjModel.from_xml_path(whole);
  } catch (error) {
    const message = error.message ?? String(M.getExceptionMessage ? M.getExceptionMessage(error) : error);
    const named = [...message.matchAll(/'([^']+)'|\[([^\]]+)\]/g)].map((m) => path.resolve(path.dirname(whole), m[1] ?? m[2]))
      .filter((name) => !tried.has(name));
    const here = named.find((name) => fs.existsSync(name) && fs.statSync(name).isFile());
    const picture = message.includes('Error opening file') && named.find((name) => /\.png$/i.test(name));
    if (!here && !picture)
      throw new Refused(absent.length ? `${message} (and '${absent.join("', '")}' is not there)` : message);
    tried.add(here ?? picture);
    if (here) {
      copy(here);
    } else {
      absent.push(path.relative(path.dirname(whole), picture));
      M.FS.mkdirTree(path.dirname(picture));
      M.FS.writeFile(picture, white);
    }
  }
}

// Arrays of bytes have no view in these bindings; their elements have, but for two: there a range stands for its flag.
const has_range = (ranges, i) => ranges[2 * i] !== 0 || ranges[2 * i + 1] !== 0;
const flags = {
  jnt_limited: ['njnt', (m, i) => m.jnt(i).limited], jnt_actfrclimited: ['njnt', (m, i) => has_range(m.jnt_actfrcrange, i)],
  actuator_forcelimited: ['nactuator', (m, i) => m.actuator(i).forcelimited],
  actuator_ctrllimited: ['nactuator', (m, i) => m.actuator(i).ctrllimited], actuator_actlimited: ['nactuator', (m, i) => m.actuator(i).actlimited], eq_active0: ['neq', (m, i) => m.eq(i).active0],
  tendon_limited: ['ntendon', (m, i) => has_range(m.tendon_range, i)],
};
function array_of(model, name) {
  try {
    return model[name];
  } catch {
    return null;
  }
}

const list = (numbers) => Array.from(numbers, Number);

function names_of(model) {
  const bytes = model.names, text = typeof bytes === 'string' ? Buffer.from(bytes, 'latin1') : Buffer.from(bytes);
  const name_at = (at) => text.toString('utf8', at, text.indexOf(0, at));
  return Object.fromEntries(Object.entries(kinds).map(([kind, size]) => {
    const starts = model[`name_${kind}adr`] ?? [];
    return [words[kind] ?? kind, Array.from({length: model[size] ?? 0}, (_, i) => name_at(Number(starts[i])))];
  }));
}

/**
 * Whether actuators, and not passive forces, compensate gravity along a joint (actuatorgravcomp): nothing in these
 * bindings says so, but then the passive force of a body at rest lacks the compensation.  Gravity along each axis finds it
 * in any pose.
 */
function actuated_gravcomp(M, model) {
  const actuated = Array(model.njnt).fill(0);
  if (model.ngravcomp === 0) return actuated;
  const own = list(model.opt.gravity), flags = model.opt.disableflags, data = new M.MjData(model);
  model.opt.disableflags = 0;
  for (const axis of [[1, 0, 0], [0, 1, 0], [0, 0, 1]]) {
    model.opt.gravity.set(axis);  // a view, which ends where memory grows
    M.mj_forward(model, data);
    const {qfrc_gravcomp: all, qfrc_passive: passive, qfrc_spring: spring} = data;
    for (let i = 0; i < model.nv; ++i)
      if (Math.abs(all[i]) > 1e-9 && Math.abs(passive[i] - spring[i]) < Math.abs(all[i]) / 2) actuated[model.dof_jntid[i]] = 1;
  }
  model.opt.gravity.set(own);
  model.opt.disableflags = flags;
  return actuated;
}

// Whether bodies fall asleep, and how many trees of them begin so.
function asleep(M, {opt, tree_sleep_policy: policies}) {
  if (!(opt.enableflags & M.mjtEnableBit.mjENBL_SLEEP.value)) return {};
  return {sleep: 1, asleep: list(policies).filter((policy) => policy === M.mjtSleepPolicy.mjSLEEP_INIT.value).length};
}

// Options that are read, or that act on nothing here; the others are the solver's.
const read_options = /^(timestep|gravity|density|viscosity|wind|magnetic|disable.*|enableflags|o_.*|sleep_tolerance)$/;
const read_flags = new Set([...bits.map((name) => `mjDSBL_${name.toUpperCase()}`), 'mjDSBL_SENSOR', 'mjENBL_OVERRIDE', 'mjENBL_ENERGY', 'mjENBL_FWDINV', 'mjENBL_SLEEP']);

/** The names of those that are not MuJoCo's own. */
function solver_of(M, opt) {
  const usual = new M.MjOption();
  const named = Object.getOwnPropertyNames(Object.getPrototypeOf(usual)).filter((name) => typeof usual[name] === 'number' && !read_options.test(name) && opt[name] !== usual[name]);
  const set = (flags, all, prefix) => Object.keys(all).filter((name) => name.startsWith(prefix) && !read_flags.has(name) && (flags & all[name].value) !== 0);
  return [...named, ...set(opt.disableflags & ~usual.disableflags, M.mjtDisableBit, 'mjDSBL_'), ...set(opt.enableflags & ~usual.enableflags, M.mjtEnableBit, 'mjENBL_')];
}

function told(M, model, data) {
  const arrays = {}, sizes = {};
  for (const name of Object.getOwnPropertyNames(Object.getPrototypeOf(model))) {
    if (/^n[a-z]/.test(name) && typeof model[name] === 'number') sizes[name] = model[name];
    if (!needed.test(name) || large.test(name)) continue;
    const array = array_of(model, name);
    if (ArrayBuffer.isView(array)) arrays[name] = list(array);
  }
  for (const [name, [size, of]] of Object.entries(flags))
    arrays[name] = Array.from({length: model[size] ?? 0}, (_, i) => Number(of(model, i)));
  arrays.jnt_actgravcomp = actuated_gravcomp(M, model);
  const {opt} = model;
  const disabled = bits.filter((name) => {
    const bit = M.mjtDisableBit[`mjDSBL_${name.toUpperCase()}`];
    return bit && (opt.disableflags & bit.value) !== 0;
  });
  if (disabled.includes('passive')) disabled.push('spring', 'damper');
  const velocities = [];
  const room = new M.DoubleBuffer(6);
  for (let i = 0; i < model.nbody; ++i) {
    M.mj_objectVelocity(model, data, M.mjtObj.mjOBJ_BODY.value, i, room, 0);
    velocities.push(...list(room.GetView()));
  }
  const start = {velocities};
  for (const name of ['qpos', 'ctrl', 'act', 'xpos', 'xquat', 'xipos', 'xanchor', 'xaxis', 'ten_length']) start[name] = list(data[name]);
  return {
    library: `MuJoCo ${M.mj_versionString()}`, version: M.mj_version(), sizes, names: names_of(model), arrays,
    option: {timestep: opt.timestep, gravity: list(opt.gravity), density: opt.density, viscosity: opt.viscosity, solver: solver_of(M, opt), disabled, disabled_groups: opt.disableactuator,
      ...asleep(M, model),
      ...(opt.enableflags & M.mjtEnableBit.mjENBL_OVERRIDE.value ? {contact_override: {friction: list(opt.o_friction), margin: opt.o_margin}} : {})}, start,
  };
}

/** How many bodies hang from each other.  Some 125 fill the stack, which nothing guards: what comes out then is not the file. */
function depth(parents) {
  const depths = [0];
  for (let i = 1; i < parents.length; ++i) depths.push(depths[parents[i]] + 1);
  return Math.max(...depths);
}

async function main([file, key]) {
  if (!file) throw new Refused('usage: cylon-import-mujoco3 FILE [KEYFRAME]');
  const warnings = [];
  const say = (line) => {
    console.error(line);
    if (/warning/i.test(line)) warnings.push(line);
  };
  const M = await load_mujoco({print: say, printErr: say});
  const absent = [];
  const model = compile(M, file, absent);
  const bodies = depth(list(model.body_parentid)), most = 110;
  if (bodies > most) throw new Refused(`${bodies} bodies hang from each other, with what it includes; MuJoCo 3 in WebAssembly has a stack for ${most}`);
  const data = new M.MjData(model);
  if (key !== undefined) {
    const number = names_of(model).key.indexOf(key);
    if (number < 0) throw new Refused(`no keyframe is called '${key}'`);
    M.mj_resetDataKeyframe(model, data, number);
  }
  M.mj_kinematics(model, data);
  M.mj_comPos(model, data);
  M.mj_comVel(model, data);
  M.mj_tendon(model, data);
  return JSON.stringify({...told(M, model, data), absent, warnings});
}

let code = 0;
try {
  const text = Buffer.from(await main(process.argv.slice(2)));
  for (let at = 0; at < text.length;) try {
    at += fs.writeSync(1, text, at);
  } catch (error) {
    if (error.code !== 'EAGAIN') throw error;
  }
} catch (error) {
  console.error(error instanceof Refused ? error.message : `MuJoCo: ${error.message ?? error}`);
  code = 2;
}
process.exit(code);
