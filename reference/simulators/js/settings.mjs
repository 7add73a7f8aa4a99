// Options, paths and the tables of settings that a run is made with; the messages for those that cannot be.
// An option is {name, setting, engine_default, meaning} with `values` (words), or `least` and `most` (a number; `above`:
// least itself is not allowed; `whole`).  A path is {name, summary, set}: the options that it sets, by name.

import {known_joints} from './joints.mjs';

/** The user's mistake: an answer `error`. */
export class Impossible extends Error {}

function edit_distance(a, b) {
  let row = Array.from({length: b.length + 1}, (_, j) => j);
  for (let i = 1; i <= a.length; ++i) {
    const next = [i];
    for (let j = 1; j <= b.length; ++j)
      next.push(Math.min(row[j] + 1, next[j - 1] + 1, row[j - 1] + (a[i - 1] === b[j - 1] ? 0 : 1)));
    row = next;
  }
  return row[b.length];
}

/** ", did you mean 'x'?" for the nearest candidate, at most a third of the longer word away (two letters at least). */
function did_you_mean(word, candidates) {
  let best = '', least = Infinity;
  for (const candidate of candidates) {
    const distance = edit_distance(word, candidate);
    if (distance <= Math.max(2, Math.floor(Math.max(word.length, candidate.length) / 3)) && distance < least)
      best = candidate, least = distance;
  }
  return best ? `, did you mean '${best}'?` : '';
}

function require_one(engine, kind, word, valid) {
  if (!valid.includes(word))
    throw new Impossible(`${engine}: no ${kind} '${word}'${did_you_mean(word, valid)} (valid: ${valid.join(', ')})`);
}

function number(engine, option, given) {
  const x = /^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$/.test(given) ? Number(given) : NaN;
  const inside = Number.isFinite(x) && (option.above ? x > option.least : x >= option.least) && x <= option.most;
  if (inside && (!option.whole || Number.isInteger(x))) return x;
  const range = option.most === Infinity || option.most === undefined
    ? `${option.above ? 'above' : 'from'} ${option.least}` : `in ${option.above ? '(' : '['}${option.least}, ${option.most}]`;
  throw new Impossible(
    `${engine}: option ${option.name} = '${given}' is not a ${option.whole ? 'whole ' : 'finite '}number ${range}`);
}

const asked_for = 'asked for by the run';

/** The values of all options, and why each that differs from the engine's own does: {path, integrator, values, reasons}. */
export function choose(about, request) {
  const path = request.path || about.paths[0].name, scheme = request.integrator || about.schemes[0].name;
  require_one(about.name, 'path', path, about.paths.map((p) => p.name));
  require_one(about.name, 'integrator', scheme, about.schemes.map((s) => s.name));
  const values = {}, reasons = {};
  for (const option of about.options) values[option.name] = option.engine_default;
  for (const [name, [value, reason]] of Object.entries(about.paths.find((p) => p.name === path).set))
    values[name] = value, reasons[name] = reason;
  for (const [name, given] of Object.entries(request.options)) {
    require_one(about.name, 'option', name, about.options.map((o) => o.name));
    const option = about.options.find((o) => o.name === name);
    if (option.values) require_one(about.name, `value of option ${name}`, given, option.values);
    values[name] = option.values ? given : number(about.name, option, given);
    reasons[name] = asked_for;
  }
  return {path, integrator: scheme, values, reasons};
}

/** A number as reports show it: all its digits, and 1e18 as that. */
const text = (value) => (typeof value === 'number' && Math.abs(value) >= 1e6 ? value.toExponential().replace('e+', 'e') : String(value));

const row = (option, value, reason) =>
  ({name: option.setting, value: text(value), engine_default: text(option.engine_default), reason});

/** Costs are those of this: not to be taken for costs of the native library. */
const runs_as = (about) => `${about.build} in Node ${process.versions.node}`;
const build = (about) => ({
  name: 'build', value: runs_as(about), engine_default: about.native ?? about.build,
  reason: `as the npm registry ships it; its costs are those of ${about.build}`,
});

/** The rows of a run: what holds on every path, and what is set. */
export function settings_of(about, chosen) {
  const set = about.options.filter((o) => o.name in chosen.reasons)
    .map((o) => row(o, chosen.values[o.name], chosen.reasons[o.name]));
  return [build(about), ...about.of_the_scene, ...set];
}

/** The answer to hello. */
export function hello(about, version) {
  const paths = about.paths.map((path) => ({
    name: path.name, summary: path.summary, unforceable: about.unforceable,
    settings: settings_of(about, choose(about, {path: path.name, integrator: '', options: {}})),
  }));
  const options = about.options.map((o) =>
    ({name: o.name, values: o.values ?? [], engine_default: text(o.engine_default), meaning: o.meaning}));
  return {
    ok: 'hello', protocol: 1, engine: about.name, version: `${version} (${runs_as(about)})`, precision: about.precision, events: false,
    knows: ['collision_filters', 'body_gravity', 'frame_acceleration', ...known_joints(about.joints)], paths, default_path_rule: `always '${about.paths[0].name}'`, schemes: about.schemes, options,
  };
}
