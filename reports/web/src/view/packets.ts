// Cuts the bytes of /api/stream into messages, however the network cut them.  Layout: u32 little-endian
// length of the header, u32 bytes of the payload, the header as JSON, the payload.
import type { Message } from '../shared/live';

export interface Packet {
  message: Message;
  payload: Float32Array;
}

const mostHeader = 64 * 1024 * 1024; // bytes; more is no message but bytes out of step
const mostPayload = 256 * 1024 * 1024;

export class PacketReader {
  private bytes = new Uint8Array(1 << 16);
  private begin = 0;
  private end = 0;
  private readonly text = new TextDecoder();

  /** The messages that are complete with this chunk.  Throws where the bytes cannot be messages. */
  push(chunk: Uint8Array): Packet[] {
    this.append(chunk);
    const packets: Packet[] = [];
    for (let packet = this.next(); packet; packet = this.next()) packets.push(packet);
    return packets;
  }

  private append(chunk: Uint8Array): void {
    const left = this.end - this.begin;
    if (this.end + chunk.length > this.bytes.length) {
      const room =
        left + chunk.length > this.bytes.length ? new Uint8Array(2 * (left + chunk.length)) : this.bytes;
      room.set(this.bytes.subarray(this.begin, this.end));
      this.bytes = room;
      [this.begin, this.end] = [0, left];
    }
    this.bytes.set(chunk, this.end);
    this.end += chunk.length;
  }

  private next(): Packet | null {
    if (this.end - this.begin < 8) return null;
    const sizes = new DataView(this.bytes.buffer, this.begin, 8);
    const [header, payload] = [sizes.getUint32(0, true), sizes.getUint32(4, true)];
    if (header > mostHeader || payload > mostPayload || payload % 4 !== 0)
      throw new Error(`the stream is out of step: a header of ${header} and a payload of ${payload} bytes`);
    if (this.end - this.begin < 8 + header + payload) return null;
    const from = this.begin + 8;
    const message = JSON.parse(this.text.decode(this.bytes.subarray(from, from + header))) as Message;
    const floats = new Float32Array(this.bytes.slice(from + header, from + header + payload).buffer);
    this.begin += 8 + header + payload;
    return { message, payload: floats };
  }
}
