// The time that a reader looks at, shared by plots, pictures and read-outs, and the span of time that plots
// show.
import { useEffect, useState } from 'preact/hooks';

export type Span = [from: number, to: number];

export class TimeCursor {
  private pinned: number;
  private hovered: number | null = null;
  private zoomed: Span | null = null;
  running = false; // by itself: pointers do not move it
  private readonly listeners = new Set<() => void>();

  constructor(
    readonly whole: Span, // [s]
    time: number,
  ) {
    this.pinned = this.within(time);
  }

  /** Where the reader points, else where the cursor stays [s]. */
  get time(): number {
    return this.hovered ?? this.pinned;
  }

  /** Where the cursor stays [s]. */
  get pin(): number {
    return this.pinned;
  }

  set pin(time: number) {
    this.pinned = this.within(time);
    this.announce();
  }

  /** Looks at a time as long as the pointer is there; null: no more. */
  hover(time: number | null): void {
    const next = time === null || this.running ? null : this.within(time);
    if (next === this.hovered) return;
    this.hovered = next;
    this.announce();
  }

  /** The part of the time that plots show; null: all. */
  get window(): Span | null {
    return this.zoomed;
  }

  set window(span: Span | null) {
    const all = span !== null && span[0] <= this.whole[0] && span[1] >= this.whole[1];
    const next = all ? null : span;
    if (next?.[0] === this.zoomed?.[0] && next?.[1] === this.zoomed?.[1]) return;
    this.zoomed = next;
    this.announce();
  }

  /** Shows half the time that is shown, around the cursor. */
  lookCloser(): void {
    const [from, to] = this.zoomed ?? this.whole;
    const half = (to - from) / 4;
    const middle = Math.min(to - half, Math.max(from + half, this.time));
    this.window = [middle - half, middle + half];
  }

  listen(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => void this.listeners.delete(listener);
  }

  private within(time: number): number {
    return Math.min(this.whole[1], Math.max(this.whole[0], time));
  }

  private announce(): void {
    for (const listener of this.listeners) listener();
  }
}

/** Draws the caller anew, at most once a frame, when the cursor moves. */
export function useCursor(cursor: TimeCursor): number {
  const [, set] = useState(0);
  useEffect(() => {
    let frame = 0;
    const stop = cursor.listen(() => {
      frame ||= requestAnimationFrame(() => {
        frame = 0;
        set((n) => n + 1);
      });
    });
    return () => {
      stop();
      cancelAnimationFrame(frame);
    };
  }, [cursor]);
  return cursor.time;
}
