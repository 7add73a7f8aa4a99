// Axes and a scale bar over a picture.
import type { Vector } from '../documents';
import { round125 } from './bounds';
import { css, mix } from './colours';
import type { Theme } from './colours';
import { metresPerPixel } from './orbit';
import type { View } from './orbit';

const units: [number, string][] = [
  [1e9, 'Gm'],
  [1e6, 'Mm'],
  [1e3, 'km'],
  [1, 'm'],
  [1e-2, 'cm'],
  [1e-3, 'mm'],
  [1e-6, 'µm'],
  [1e-9, 'nm'],
];

/** A length of one, two or five in a unit that suits it: "20 cm". */
export function metres(x: number): string {
  const [size, name] = units.find(([size]) => x >= 0.9999 * size) ?? units[units.length - 1]!;
  return `${Number((x / size).toPrecision(3))} ${name}`;
}

/** Height of the strip along the lower edge that they take [css px]: a sheet over all would cost a fifth of
 * the drawing where the processor draws. */
export const strip = 80;

/** On a canvas that is as wide as the picture and `strip` high. */
export function drawOver(
  context: CanvasRenderingContext2D,
  view: View,
  theme: Theme,
  grid: number | null,
): void {
  const { width, height, ratio } = view;
  context.setTransform(ratio, 0, 0, ratio, 0, ratio * (strip - height));
  context.clearRect(0, 0, width, height);
  context.font = '11px system-ui, sans-serif';
  context.textBaseline = 'middle';
  const ink = css(mix(theme.ink, theme.ground, 0.15));
  triad(context, view, ink, css(theme.ground));
  scaleBar(context, view, ink, css(theme.ground), grid);
}

/** Text that stays readable over anything. */
function write(
  context: CanvasRenderingContext2D,
  text: string,
  x: number,
  y: number,
  ink: string,
  ground: string,
): void {
  context.lineWidth = 3;
  context.lineJoin = 'round';
  context.strokeStyle = ground;
  context.strokeText(text, x, y);
  context.fillStyle = ink;
  context.fillText(text, x, y);
}

function triad(
  context: CanvasRenderingContext2D,
  { right, up, height }: View,
  ink: string,
  ground: string,
): void {
  const [x, y, l] = [34, height - 34, 22];
  const axis: Vector[] = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  context.textAlign = 'center';
  axis.forEach((_, i) => {
    const [dx, dy] = [right[i]! * l, -up[i]! * l];
    context.strokeStyle = ink;
    context.lineWidth = 1.5;
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(x + dx, y + dy);
    context.stroke();
    write(context, 'xyz'[i]!, x + 1.35 * dx, y + 1.35 * dy, ink, ground);
  });
}

function scaleBar(
  context: CanvasRenderingContext2D,
  view: View,
  ink: string,
  ground: string,
  grid: number | null,
): void {
  const k = metresPerPixel(view);
  const l = round125(Math.min(120, view.width / 4) * k);
  const [x, y] = [view.width - 14, view.height - 14];
  const left = x - l / k;
  context.strokeStyle = ink;
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(left, y - 4);
  context.lineTo(left, y);
  context.lineTo(x, y);
  context.lineTo(x, y - 4);
  context.stroke();
  context.textAlign = 'right';
  write(context, grid === null ? metres(l) : `${metres(l)} · grid ${metres(grid)}`, x, y - 11, ink, ground);
}
