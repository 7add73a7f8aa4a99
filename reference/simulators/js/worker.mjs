#!/usr/bin/env node
// A worker (docs/protocol.md) for engines in JavaScript and WebAssembly.  The build links cylon-worker-NAME to this file;
// NAME says which module of this folder is the engine.
//
// A module exports `about`, what it says of itself (settings.mjs; its joints: joints.mjs; `substeps`, of the values of its
// options and the step, where a step has several parts with gravity of their own), and `start()`, which gives {version, load(scene, dt,
// values), defaults()}.  A world that load() gives has step(), push(i, force, torque), read(i): {position,
// orientation, velocity, spin}, free() and, where there is something to say of a run, remarks(); where a mass may change,
// set_mass(i, mass).
import fs from 'node:fs';
import path from 'node:path';
import {Forces, settings as force_settings} from './forces.mjs';
import {require_joints} from './joints.mjs';
import {Malformed, read_request} from './requests.mjs';
import {Unsupported, prepare, require_masses} from './scene.mjs';
import {Impossible, choose, hello, settings_of} from './settings.mjs';

// The protocol has the real stdout; whatever the engine prints goes to stderr.
console.log = console.info = console.warn = console.error;

const most_remarks = 100, numbers_per_body = 13, largest_payload = 262144, header_bytes = 32;

// ---- Pipes --------------------------------------------------------------------------------------------

const pause = new Int32Array(new SharedArrayBuffer(4));
function patiently(call) {
  for (;;) try {
    return call();
  } catch (error) {
    if (error.code === 'EOF') return 0;
    if (error.code !== 'EAGAIN') throw error;
    Atomics.wait(pause, 0, 0, 1);
  }
}

function write(bytes) {
  for (let at = 0; at < bytes.length;) at += patiently(() => fs.writeSync(1, bytes, at));
}
const say = (answer) => write(Buffer.from(JSON.stringify(answer) + '\n'));

function* lines() {
  const chunk = Buffer.alloc(1 << 16);
  let parts = [];
  for (;;) {
    const count = patiently(() => fs.readSync(0, chunk));
    if (count === 0) return;
    let from = 0;
    for (let end; (end = chunk.subarray(0, count).indexOf(10, from)) >= 0; from = end + 1) {
      yield Buffer.concat([...parts, chunk.subarray(from, end)]).toString();
      parts = [];
    }
    parts.push(Buffer.from(chunk.subarray(from, count)));
  }
}

// ---- Frames -------------------------------------------------------------------------------------------

class Frame {
  constructor(bodies) {
    this.bytes = bodies * numbers_per_body * 8;
    this.most = Math.max(1, Math.floor(largest_payload / Math.max(1, this.bytes)));
    this.buffer = Buffer.alloc(header_bytes + this.most * this.bytes);
    this.states = 0;
  }

  fits(step) {
    if (this.states < 2) return this.states < this.most;
    return this.states < this.most && step === this.first + this.states * this.stride;
  }

  add(step, world, bodies) {
    if (this.states === 0) this.first = step, this.stride = 1;
    if (this.states === 1) this.stride = step - this.first;
    let at = header_bytes + this.states * this.bytes;
    for (let i = 0; i < bodies; ++i) {
      const s = world.read(i);
      for (const part of [s.position, s.orientation, s.velocity, s.spin])
        for (const x of part) at = this.buffer.writeDoubleLE(x, at);
    }
    ++this.states;
  }

  send() {
    const b = this.buffer;
    b.write('CYLF', 0, 'latin1');
    b.writeUInt32LE(this.states, 4);
    b.writeBigUInt64LE(BigInt(this.first), 8);
    b.writeBigUInt64LE(BigInt(this.stride), 16);
    b.writeBigUInt64LE(BigInt(this.states * this.bytes), 24);
    write(b.subarray(0, header_bytes + this.states * this.bytes));
    this.states = 0;
  }
}

// ---- Times --------------------------------------------------------------------------------------------

/** CPU time of this process with all its threads: those of the compiler and of garbage collection belong to the engine. */
function cpu_ns() {
  const {user, system} = process.cpuUsage();
  return 1e3 * (user + system);
}
const wall_ns = () => 1e6 * performance.now();

/** CPU time of what is between begin() and end(): the share of those spans in the CPU time of the batch around them. */
class StepTimer {
  total = 0;
  begin_batch() { this.cpu = cpu_ns(), this.wall = wall_ns(), this.inside = 0; }
  begin() { this.started = wall_ns(); }
  end() { this.inside += wall_ns() - this.started; }
  end_batch() {
    const wall = Math.max(1, wall_ns() - this.wall);
    this.total += (cpu_ns() - this.cpu) * Math.min(1, this.inside / wall);
  }
}

// ---- The conversation ---------------------------------------------------------------------------------

class Session {
  constructor(about, engine) { this.about = about, this.engine = engine; }

  load(request) {
    this.end();
    const before = cpu_ns();
    const chosen = choose(this.about, request);
    if (request.tolerance) throw new Malformed(`tolerance: ${this.about.title} has no integrator that takes one`);
    const scene = prepare(request.scene);
    require_masses(this.about, scene);
    require_joints(this.about, scene);
    this.scene = scene, this.dt = request.dt;
    chosen.values.integrator = chosen.integrator;
    this.world = this.engine.load(scene, request.dt, chosen.values);
    this.forces = new Forces(scene);
    this.load_ns = cpu_ns() - before;
    say({
      ok: 'load', path: chosen.path, integrator: chosen.integrator, order: this.world.order ?? 1, gyroscopic: this.about.gyroscopic(chosen.values),
      substeps: this.about.substeps?.(chosen.values, request.dt) ?? 1,
      settings: [...settings_of(this.about, chosen), ...force_settings(this.forces.any)], unforceable: this.about.unforceable,
    });
    const start = new Frame(scene.bodies.length);
    start.add(0, this.world, scene.bodies.length);
    start.send();
  }

  end() {
    if (this.world) this.world.free();
    this.world = undefined;
  }

  step(number) {
    if (this.forces.any) {
      const t = (number - 1) * this.dt;
      const wrenches = this.forces.at(t, this.scene.bodies.map((_, i) => this.world.read(i)));
      for (const i of this.forces.changing) this.world.set_mass(i, this.forces.masses[i]);
      for (const body of this.scene.bodies)
        if (!body.locked) this.world.push(body.index, wrenches[body.index].force, wrenches[body.index].torque);
    }
    this.world.step();
  }

  run({steps, every, at = []}) {
    if (!this.world) throw new Malformed('cmd: each run needs a load before it');
    const bodies = this.scene.bodies.length, frame = new Frame(bodies), timer = new StepTimer();
    const wanted = new Set(at);
    let frames = 0;
    const send = () => {
      timer.end_batch();
      frame.send();
      ++frames;
      timer.begin_batch();
    };
    timer.begin_batch();
    for (let step = 0; step < steps;) {
      timer.begin();
      do this.step(++step); while (step < steps && step % every !== 0 && !wanted.has(step));
      timer.end();
      if (!frame.fits(step)) send();
      frame.add(step, this.world, bodies);
    }
    if (frame.states > 0) send();
    say({ok: 'run', steps, frames, step_ns: timer.total, load_ns: this.load_ns, remarks: this.world.remarks?.().slice(0, most_remarks) ?? []});
    this.load_ns = 0;
    this.end();
  }

  obey(request) {
    if (request.cmd === 'hello') say(hello(this.about, this.engine.version));
    else if (request.cmd === 'load') this.load(request);
    else this.run(request);
  }
}

/** What is said in place of an answer, or nothing: the engine failed, and one that failed once is not to be trusted. */
function answer_to(error, cmd) {
  if (error instanceof Malformed || error instanceof Impossible) return {error: error.message};
  if (error instanceof Unsupported) return {unsupported: error.message};
  if (cmd === 'run') return {error: error.message, last: true};
}

function serve(session) {
  for (const line of lines()) {
    let request;
    try {
      request = read_request(line);
      if (request.cmd === 'quit') return 0;
      session.obey(request);
    } catch (error) {
      const answer = answer_to(error, request?.cmd);
      if (!answer) throw error;
      say({...answer, last: undefined});
      if (answer.last) return 1;
    }
  }
  return 0;
}

/** A package that is not installed, or not whole, is no failure of the engine. */
function refuse_to_start(error) {
  const absent = error.code === 'ERR_MODULE_NOT_FOUND' || error.code === 'MODULE_NOT_FOUND';
  const says = `${error.name}: ${error.message.split('\n')[0]}`;
  say({unsupported: absent ? `its npm package is not installed; \`./run engines\` installs it (${says})`
    : `it does not start in Node ${process.versions.node} (${says}); where its npm package is damaged, \`./run engines\` installs it anew once the folder node_modules beside its worker is deleted`});
  return 1;
}

async function main() {
  const name = path.basename(process.argv[1]).replace('cylon-worker-', '');
  let module, engine;
  try {
    module = await import(`./${name}.mjs`);
    engine = await module.start();
  } catch (error) {
    return refuse_to_start(error);
  }
  return serve(new Session(module.about, engine));
}

try {
  process.exit(await main());
} catch (error) {
  console.error(error.stack ?? String(error));
  console.error(`${error.name}: ${error.message}`);  // the last line is the reason that a report shows
  process.exit(1);
}
