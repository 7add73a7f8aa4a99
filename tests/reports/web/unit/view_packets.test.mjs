// The viewer's stream, however the network cuts it.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load } from '../bundle_for_test.mjs';

const { PacketReader } = await load('view/packets.ts');

function bytesOf(message, floats) {
  const header = Buffer.from(JSON.stringify(message));
  const sizes = Buffer.alloc(8);
  sizes.writeUInt32LE(header.length, 0);
  sizes.writeUInt32LE(4 * floats.length, 4);
  return Buffer.concat([sizes, header, Buffer.from(Float32Array.from(floats).buffer)]);
}

const sent = [
  [{ type: 'state', t: 0.25, name: 'Käfer ✓' }, [1.5, -2.25, NaN, Infinity]],
  [{ type: 'session', session: { title: '' } }, []],
  [{ type: 'state', t: 0.5 }, Array.from({ length: 3000 }, (_, i) => i / 4)],
];
const stream = Buffer.concat(sent.map(([message, floats]) => bytesOf(message, floats)));

function check(packets) {
  assert.equal(packets.length, sent.length);
  packets.forEach(({ message, payload }, i) => {
    assert.deepEqual(message, sent[i][0]);
    assert.deepEqual([...payload], sent[i][1]);
  });
}

for (const size of [1, 2, 3, 7, 64, 1000, stream.length])
  test(`chunks of ${size} bytes`, () => {
    const reader = new PacketReader();
    const packets = [];
    for (let at = 0; at < stream.length; at += size) packets.push(...reader.push(stream.subarray(at, at + size)));
    check(packets);
  });

test('every place for a single cut', () => {
  const short = Buffer.concat(sent.slice(0, 2).map(([message, floats]) => bytesOf(message, floats)));
  for (let cut = 0; cut <= short.length; ++cut) {
    const reader = new PacketReader();
    const packets = [...reader.push(short.subarray(0, cut)), ...reader.push(short.subarray(cut))];
    assert.deepEqual(packets.map((packet) => packet.message), sent.slice(0, 2).map(([message]) => message), `cut at ${cut}`);
  }
});

test('a message stays as it was when later ones come', () => {
  const reader = new PacketReader();
  const [first] = reader.push(bytesOf({ type: 'state', t: 1 }, [1, 2, 3]));
  for (let i = 0; i < 50; ++i) reader.push(bytesOf({ type: 'state', t: 2 }, Array(5000).fill(7)));
  assert.deepEqual([...first.payload], [1, 2, 3]);
});

test('bytes out of step are an error and no endless wait', () => {
  for (const [header, payload] of [[0xffffffff, 0], [10, 0xfffffff0], [10, 3]]) {
    const sizes = Buffer.alloc(8);
    sizes.writeUInt32LE(header, 0);
    sizes.writeUInt32LE(payload, 4);
    assert.throws(() => new PacketReader().push(sizes), /out of step/);
  }
  const noJson = bytesOf({}, []);
  noJson.write('no', 8);
  assert.throws(() => new PacketReader().push(noJson), SyntaxError);
});
