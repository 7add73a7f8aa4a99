// Where the bodies of a lane have been lately, in an array that a picture draws as trails.
export class TrailRecorder {
  positions: Float32Array;
  frames = 0;
  private readonly most: number;

  /** Memory for about `points` positions, at least 32 frames. */
  constructor(
    readonly bodies: number,
    points = 60000,
  ) {
    this.most = Math.max(32, Math.min(1000, Math.floor(points / Math.max(bodies, 1))));
    this.positions = this.room();
  }

  private room(): Float32Array {
    return new Float32Array(3 * this.bodies * this.most);
  }

  add(position: Float32Array): void {
    const frame = 3 * this.bodies;
    if (this.frames === this.most) {
      // The older half goes.  Another array, since pictures take frames that they have seen as unchanged.
      const kept = this.most >> 1;
      const next = this.room();
      next.set(this.positions.subarray((this.most - kept) * frame));
      this.positions = next;
      this.frames = kept;
    }
    this.positions.set(position, this.frames * frame);
    ++this.frames;
  }

  clear(): void {
    this.positions = this.room();
    this.frames = 0;
  }
}
