// A worker of an engine in JavaScript as the harness starts it, spoken to line by line; and scenes for it.
import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {fileURLToPath} from 'node:url';

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../../..');
const folder = path.join(root, 'reference/simulators/js');

/** The engines whose packages are here. */
export const engines = fs.readFileSync(path.join(root, 'reference/simulators/engines.txt'), 'utf8').split('\n')
  .map((row) => row.trim().split(/\s+/)).filter((row) => row[4] === 'js' && row[5]?.startsWith('npm:'))
  .filter((row) => fs.existsSync(path.join(folder, 'node_modules', row[5].slice(4), 'package.json'))).map((row) => row[1]);

/** Lines to a worker and the end of its input: {code, messages, stderr}; a frame is {frame: {first, stride, states}}, with
 *  the numbers of each state. `from` is the folder of worker.mjs. */
export function talk(engine, lines, from = folder) {
  const bin = fs.mkdtempSync(path.join(os.tmpdir(), 'cylon-js-'));
  const worker = path.join(bin, `cylon-worker-${engine}`);
  fs.symlinkSync(path.join(from, 'worker.mjs'), worker);
  const input = lines.map((line) => (typeof line === 'string' ? line : JSON.stringify(line)) + '\n').join('');
  const done = spawnSync(process.execPath, [worker], {input, maxBuffer: 1 << 28, timeout: 120e3});
  fs.rmSync(bin, {recursive: true});
  return {code: done.status, messages: messages_of(done.stdout), stderr: done.stderr.toString()};
}

function messages_of(bytes) {
  const messages = [];
  for (let at = 0; at < bytes.length;) {
    if (bytes.toString('latin1', at, at + 4) === 'CYLF') {
      const count = bytes.readUInt32LE(at + 4), size = Number(bytes.readBigUInt64LE(at + 24));
      const numbers = Array.from({length: size / 8}, (_, i) => bytes.readDoubleLE(at + 32 + 8 * i));
      const each = numbers.length / count;
      messages.push({frame: {
        first: Number(bytes.readBigUInt64LE(at + 8)), stride: Number(bytes.readBigUInt64LE(at + 16)), size,
        states: Array.from({length: count}, (_, i) => numbers.slice(i * each, (i + 1) * each))}});
      at += 32 + size;
    } else {
      const end = bytes.indexOf(10, at);
      messages.push(JSON.parse(bytes.toString('utf8', at, end)));
      at = end + 1;
    }
  }
  return messages;
}

export const body = (members) => ({
  name: 'a', position: [0.3, -0.2, 0.7], velocity: [1, 0.5, -2], angular_velocity: [0.4, -1.1, 0.6], orientation: [1, 0, 0, 0],
  mass: 1.7, inertia: [0.3, 0, 0, 0, 0.4, 0, 0, 0, 0.5], locked: false, collide: false, color: '#808080', ...members});
export const scene = (members) => ({
  body: [body()], spring: [], drag: [], thrust: [], drive: [], attraction: [], water: [], joint: [], plane: [], material: [],
  gravity: [0.1, -9.7, 0.2], impacts: 'sequential', ...members});
export const load = (members) => ({cmd: 'load', scene: scene(), dt: 1e-3, path: '', integrator: '', options: {}, ...members});
export const run = (members) => ({cmd: 'run', steps: 10, every: 1, at: [], watch: [], ...members});
