// Blocks of a report: gzip in base64, one per <script type="application/gzip;base64" id="block-N">, so that a
// trace is unpacked when somebody looks at it and not before.
import type { Floats, Motion, Steps, Trace } from './documents';

/** The unpacked bytes of a block; throws where the page has no such block. */
export async function unpack(block: number): Promise<Uint8Array> {
  const text = document.getElementById(`block-${block}`)?.textContent;
  if (text == null) throw new Error(`the report has no block ${block}`);
  const packed = Uint8Array.from(atob(text.trim()), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export async function unpackJson<T>(block: number): Promise<T> {
  return JSON.parse(new TextDecoder().decode(await unpack(block))) as T;
}

/** States of all bodies at ascending times. */
export interface Frames {
  time: Float32Array; // [s]
  position: Float32Array; // [frame][body][3]
  orientation: Float32Array; // [frame][body][4]: w, x, y, z
}

/** A trace whose arrays are read when asked for.  Layout: u32 little-endian length of the header, the header as
 * JSON, zeros up to a multiple of 4, then the arrays; offsets count from there. */
export class TraceBlock {
  readonly trace: Trace;
  private readonly start: number;

  constructor(private readonly bytes: Uint8Array) {
    const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true);
    this.trace = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length))) as Trace;
    this.start = Math.ceil((4 + length) / 4) * 4;
  }

  static async of(block: number): Promise<TraceBlock> {
    return new TraceBlock(await unpack(block));
  }

  floats(where: Floats): Float32Array {
    const at = this.bytes.byteOffset + this.start + where.offset;
    return new Float32Array(this.bytes.buffer.slice(at, at + 4 * where.count));
  }

  /** [frame][channel] */
  steps(where: Steps): Float32Array {
    const channels = where.min.length;
    const out = new Float32Array(where.frames * channels);
    let at = this.start + where.offset;
    for (let c = 0; c < channels; ++c) {
      let k = 0;
      for (let frame = 0; frame < where.frames; ++frame) {
        let zigzag = 0;
        let shift = 0;
        let byte: number;
        do {
          byte = this.bytes[at++] ?? 0;
          zigzag |= (byte & 0x7f) << shift;
          shift += 7;
        } while (byte & 0x80);
        k += (zigzag >>> 1) ^ -(zigzag & 1);
        out[frame * channels + c] = k === 0 ? NaN : where.min[c]! + where.step[c]! * (k - 1);
      }
    }
    return out;
  }

  frames(motion: Motion): Frames {
    return { time: this.floats(motion.time), position: this.steps(motion.position), orientation: this.steps(motion.orientation) };
  }
}
