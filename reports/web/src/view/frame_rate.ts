// How often the page draws: over the last second for people, in all for tests.
declare global {
  interface Window {
    cylonFrames?: { frames: number; seconds: number }; // drawn since the page was opened
  }
}

export class FrameRate {
  private readonly times: number[] = []; // of the last second [ms]
  private start = -1;
  private readonly total = { frames: 0, seconds: 0 };

  constructor() {
    window.cylonFrames = this.total;
  }

  tick(now: number): void {
    if (this.start < 0) this.start = now;
    ++this.total.frames;
    this.total.seconds = (now - this.start) / 1000;
    this.times.push(now);
    while (this.times[0]! < now - 1000) this.times.shift();
  }

  /** Frames per second, from the first to the last of the last second. */
  get perSecond(): number {
    const n = this.times.length;
    return n < 2 ? 0 : (1000 * (n - 1)) / (this.times[n - 1]! - this.times[0]!);
  }
}
