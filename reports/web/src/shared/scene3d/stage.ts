// Something that draws a picture on a canvas.
import type { View } from './orbit';
import type { Picture } from './picture';

export interface Stage {
  readonly canvas: HTMLCanvasElement;
  readonly webgl: boolean;
  readonly lost: boolean; // nothing can be drawn for now
  onChange: (() => void) | null; // the canvas was lost or is back
  show(picture: Picture): void; // another picture from now on
  draw(view: View): void;
  dispose(): void;
}
