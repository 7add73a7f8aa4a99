// Pictures of the views for --record: one per 1/30 s of simulated time, each after the answer to the one before.
import type { Session } from '../shared/live';
import type { Scene3D } from '../shared/scene3d/index';

export const perSecond = 30;

/** A name that ends in .toml is a scenario that the server writes; anything else is a folder of pictures. */
export const wantsPictures = (session: Session): boolean => session.recording !== '' && !/\.toml$/i.test(session.recording);

/** Views side by side in one picture. */
async function together(pictures: Scene3D[], names: string[]): Promise<Blob> {
  if (pictures.length === 1) return pictures[0]!.png();
  const images = await Promise.all((await Promise.all(pictures.map((p) => p.png()))).map((blob) => createImageBitmap(blob)));
  const line = 24;
  const canvas = document.createElement('canvas');
  canvas.width = images.reduce((sum, image) => sum + image.width, 0);
  canvas.height = line + Math.max(...images.map((image) => image.height));
  const context = canvas.getContext('2d')!;
  const style = getComputedStyle(document.documentElement);
  context.fillStyle = style.getPropertyValue('--ground').trim() || '#ffffff';
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.fillStyle = style.getPropertyValue('--ink').trim() || '#000000';
  context.font = '14px system-ui, sans-serif';
  let x = 0;
  images.forEach((image, i) => {
    context.fillText(names[i] ?? '', x + 8, 17);
    context.drawImage(image, x, line);
    x += image.width;
    image.close();
  });
  return new Promise((resolve, reject) =>
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('the picture could not be kept'))), 'image/png'),
  );
}

export class Film {
  private last = -1;
  private busy = false;
  private stopped = false;

  constructor(
    private readonly send: (n: number, picture: Blob) => Promise<void>,
    private readonly failed: (why: string) => void,
  ) {}

  reset(): void {
    this.last = -1;
    this.stopped = false;
  }

  /** After a state at time t [s] was drawn. */
  take(t: number, pictures: Scene3D[], names: string[]): void {
    const n = Math.floor(t * perSecond + 1e-6);
    if (this.busy || this.stopped || pictures.length === 0 || n <= this.last) return;
    this.last = n;
    this.busy = true;
    together(pictures, names)
      .then((picture) => this.send(n, picture))
      .catch((error: unknown) => {
        this.stopped = true;
        this.failed(`recording stopped: ${error instanceof Error ? error.message : String(error)}`);
      })
      .finally(() => (this.busy = false));
  }
}
