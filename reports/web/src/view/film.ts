// Pictures of the views for --record: one per 1/30 s of simulated time, each after the answer to the last.
import type { Session } from '../shared/live';
import type { Scene3D } from '../shared/scene3d/index';

export const perSecond = 30;

/** A name that ends in .toml is a scenario that the server writes; anything else is a folder of pictures. */
export const wantsPictures = (session: Session): boolean =>
  session.recording !== '' && !/\.toml$/i.test(session.recording);

const line = 24; // height of the names [px]

/** Views side by side in one picture, their names above. */
function together(canvas: HTMLCanvasElement, pictures: Scene3D[], names: string[]): Promise<Blob> {
  const width = pictures.reduce((sum, picture) => sum + picture.size.width, 0);
  const height = line + Math.max(...pictures.map((picture) => picture.size.height));
  if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
  const context = canvas.getContext('2d', { willReadFrequently: true })!;
  const style = getComputedStyle(document.documentElement);
  context.fillStyle = style.getPropertyValue('--ground').trim() || '#ffffff';
  context.fillRect(0, 0, width, height);
  context.fillStyle = style.getPropertyValue('--ink').trim() || '#000000';
  context.font = '14px system-ui, sans-serif';
  let x = 0;
  pictures.forEach((picture, i) => {
    context.fillText(names[i] ?? '', x + 8, 17);
    picture.paint(context, x, line);
    x += picture.size.width;
  });
  return new Promise((resolve, reject) =>
    canvas.toBlob(
      (blob) => (blob ? resolve(blob) : reject(new Error('the picture could not be kept'))),
      'image/png',
    ),
  );
}

export class Film {
  private last = -1;
  private busy = false;
  private stopped = false;
  private slowed = 0; // when [ms]
  private readonly canvas = document.createElement('canvas');

  /** `slower`: pictures were missed; the speed must fall for a film without gaps. */
  constructor(
    private readonly send: (n: number, picture: Blob) => Promise<void>,
    private readonly failed: (why: string) => void,
    private readonly slower: () => void,
  ) {}

  reset(): void {
    this.last = -1;
    this.stopped = false;
  }

  /** After a state at time t [s] was drawn, at `now` [ms] of the page's clock. */
  take(t: number, now: number, pictures: Scene3D[], names: string[]): void {
    const n = Math.floor(t * perSecond + 1e-6);
    if (this.stopped || pictures.length === 0 || n <= this.last) return;
    if (n > this.last + 1 && this.last >= 0 && now - this.slowed > 700) {
      this.slowed = now;
      this.slower();
    }
    if (this.busy) return;
    this.last = n;
    this.busy = true;
    together(this.canvas, pictures, names)
      .then((picture) => this.send(n, picture))
      .catch((error: unknown) => {
        this.stopped = true;
        this.failed(`recording stopped: ${error instanceof Error ? error.message : String(error)}`);
      })
      .finally(() => (this.busy = false));
  }
}
