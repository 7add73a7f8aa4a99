// A scene of the protocol, prepared for the engines: bodies by index, principal axes, who may touch whom and with what
// material.  Knows no engine.
import {laws, unmapped} from './forces.mjs';
import {Unsupported} from './unsupported.mjs';
import {principal_axes} from './vectors.mjs';

export {Unsupported};

const known = ['body', 'joint', 'plane', 'material', 'gravity', 'frame', 'impacts', ...laws];

/** The scene with bodies by index in place of names (-1: the world).  Throws Unsupported. */
export function prepare(json) {
  for (const key of Object.keys(json))
    if (!known.includes(key)) throw new Unsupported(`The scene has '${key}', which this worker does not know.`);
  const index = new Map(json.body.map((body, i) => [body.name, i]));
  const by_index = (one) => ({...one, body: index.get(one.body), to: 'to' in one ? index.get(one.to) : -1});
  const scene = {gravity: json.gravity, frame: json.frame};
  scene.bodies = json.body.map((body, i) => ({
    ...body, index: i, spin: body.angular_velocity, touches: body.collide && body.shape !== undefined,
    principal: principal_axes(body.inertia),
  }));
  for (const kind of laws) scene[kind] = json[kind].map(by_index);
  for (const spring of scene.spring) if (spring.to < 0) spring.to_anchor = spring.pin;
  scene.joints = json.joint.map(by_index);
  scene.planes = json.plane.map((plane, i) => ({...plane, index: i}));
  const reason = unmapped(scene);
  if (reason) throw new Unsupported(reason);
  scene.contacts = new Contacts(scene, json.material);
  return scene;
}

/** Throws Unsupported where a moving body has a mass or a moment that the engine's numbers cannot hold. */
export function require_masses(about, scene) {
  const holds = about.precision === 'float' ? Math.fround : (x) => x;
  const usable = (x) => x > 0 && holds(x) > 0 && Number.isFinite(holds(x)) && Number.isFinite(holds(1 / x)) && holds(1 / x) > 0;
  for (const body of scene.bodies) {
    if (body.locked) continue;
    if (!usable(body.mass))
      throw new Unsupported(`${about.title} needs a mass above zero that ${about.precision} precision holds; '${body.name}' has ${body.mass} kg.`);
    const bad = body.principal.moments.find((moment) => !usable(moment));
    if (bad !== undefined)
      throw new Unsupported(
        `${about.title} needs principal moments above zero that ${about.precision} precision holds; '${body.name}' has one of ${bad} kg m^2.`);
  }
}

// ---- Who touches whom ---------------------------------------------------------------------------------

/** Bodies and planes that may touch; a thing is a body's index, or the number of bodies plus a plane's. */
class Contacts {
  constructor(scene, materials) {
    this.bodies = scene.bodies.length;
    this.things = [...scene.bodies.filter((b) => b.touches), ...scene.planes]
      .map((thing) => this.#thing(thing, thing.mass !== undefined));
    this.tied = new Set(scene.joints.filter((j) => j.to >= 0).map((j) => this.key(j.body, j.to)));
    this.#materials(materials);
  }

  #thing(of, is_body) {
    return {
      id: is_body ? of.index : this.bodies + of.index, name: of.name, still: !is_body || of.locked,
      groups: new Set(of.collision_groups ?? ['default']), mask: of.collision_mask && new Set(of.collision_mask),
    };
  }

  key(a, b) { return a < b ? `${a},${b}` : `${b},${a}`; }

  /** Whether groups and masks let two things meet. */
  meet(a, b) {
    const wants = (x, y) => !x.mask || [...y.groups].some((group) => x.mask.has(group));
    return wants(a, b) && wants(b, a);
  }

  // Things that nothing tells apart are one kind: materials and masks are asked of kinds, not of each pair.
  #materials(rows) {
    const named = new Set(rows.flatMap((row) => row.between));
    const kinds = new Map();
    for (const thing of this.things) {
      const word = named.has(thing.name) ? thing.name : '*';
      const filter = [[...thing.groups].sort(), thing.mask && [...thing.mask].sort()];
      thing.kind = JSON.stringify([word, thing.still, filter]);
      if (!kinds.has(thing.kind)) kinds.set(thing.kind, {thing, word, count: 0});
      const kind = kinds.get(thing.kind);
      if (++kind.count === 2) kind.second = thing;
    }
    this.kinds = kinds;
    this.kind_of = new Map(this.things.map((thing) => [thing.id, thing.kind]));
    const tied = new Map();  // pairs of kinds: how many of their pairs joints tie
    for (const [a, b] of [...this.tied].map((key) => key.split(',').map((id) => this.kind_of.get(Number(id)))))
      for (const key of new Set([`${a}|${b}`, `${b}|${a}`])) tied.set(key, (tied.get(key) ?? 0) + 1);
    /** Materials of the pairs of kinds that may touch: [kind, kind, row]. */
    this.rows = [];
    this.filtered = false;
    const all = [...kinds.values()];
    for (let i = 0; i < all.length; ++i)
      for (let j = i; j < all.length; ++j) {
        const a = all[i], b = all[j];
        const pairs = i === j ? a.count * (a.count - 1) / 2 : a.count * b.count;
        if (pairs === 0 || (a.thing.still && b.thing.still)) continue;
        if (!this.meet(a.thing, b.thing)) {
          this.filtered = true;
          continue;
        }
        if (pairs > (tied.get(`${a.thing.kind}|${b.thing.kind}`) ?? 0)) this.rows.push([a.thing.kind, b.thing.kind, this.#row(rows, a, b)]);
      }
  }

  // Both names win over one name and "*", that over two; the first of equals.
  #row(rows, a, b) {
    const matches = (pattern, word) => (pattern === '*' ? 0 : pattern === word ? 1 : -3);
    let best = null, most = -1;
    for (const row of rows)
      for (const [i, j] of [[0, 1], [1, 0]]) {
        const m = matches(row.between[i], a.word) + matches(row.between[j], b.word);
        if (m > most) best = row, most = m;
      }
    const other = a === b ? a.second : b.thing;
    if (!best) throw new Unsupported(`'${a.thing.name}' may touch '${other.name}', but the scene has no material for them.`);
    return best;
  }

  /** The one value of all pairs that may touch, or undefined where they differ (0 where nothing touches). */
  uniform(quantity) {
    const values = new Set(this.rows.map((row) => row[2][quantity]));
    return values.size > 1 ? undefined : values.size === 1 ? [...values][0] : 0;
  }

  /** Numbers of single things, by id, and the rule ("min" or "max") by which they combine to those of every pair; throws
   *  Unsupported where there are none. */
  of_things(quantity, title) {
    const same = this.uniform(quantity);
    if (same !== undefined) return {rule: 'min', of: () => same};
    for (const [rule, own, unbound] of [['min', Math.max, -Infinity], ['max', Math.min, Infinity]]) {
      const of_kind = new Map([...this.kinds.keys()].map((kind) => [kind, unbound]));
      for (const [a, b, row] of this.rows)
        for (const kind of [a, b]) of_kind.set(kind, own(of_kind.get(kind), row[quantity]));
      const combine = rule === 'min' ? Math.min : Math.max;
      if (!this.rows.every(([a, b, row]) => combine(of_kind.get(a), of_kind.get(b)) === row[quantity])) continue;
      return {rule, of: (id) => { const x = of_kind.get(this.kind_of.get(id)); return Number.isFinite(x) ? x : 0; }};
    }
    throw new Unsupported(
      `${title} combines the ${quantity}s of two bodies; no numbers of single bodies have this scene's for each pair as their least or their largest.`);
  }

  /** Of a pair of things that may touch, by id: its material. */
  material(a, b) {
    if (!this.by_kinds) {
      this.by_kinds = new Map();
      for (const [x, y, row] of this.rows) this.by_kinds.set(`${x}|${y}`, row).set(`${y}|${x}`, row);
    }
    return this.by_kinds.get(`${this.kind_of.get(a)}|${this.kind_of.get(b)}`);
  }

  /** Pairs of things that may touch. */
  *meeting() {
    const all = this.things;
    for (let i = 0; i < all.length; ++i)
      for (let j = i + 1; j < all.length; ++j)
        if (!(all[i].still && all[j].still) && !this.tied.has(this.key(all[i].id, all[j].id)) && this.meet(all[i], all[j])) yield [all[i], all[j]];
  }

  /** Pairs of things, one of which can move, that may not touch though both have shapes. */
  *kept_apart() {
    const all = this.things;
    if (!this.filtered && this.tied.size === 0) return;
    for (let i = 0; i < all.length; ++i)
      for (let j = i + 1; j < all.length; ++j) {
        if (all[i].still && all[j].still) continue;
        if (this.tied.has(this.key(all[i].id, all[j].id)) || !this.meet(all[i], all[j])) yield [all[i].id, all[j].id];
      }
  }
}
