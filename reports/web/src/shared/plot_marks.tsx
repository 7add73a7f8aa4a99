// How curves are told apart: by colour, by dashes and by markers, so that each alone is enough.
import { color } from './theme';

const dashes = [[], [9, 4], [2, 3], [9, 3, 2, 3], [15, 4], [5, 2]];

export interface Look {
  color: string; // a name of theme.css
  dash: number[]; // [px]
  marker: number;
}

type Point = [number, number];

// Outlines in units of the marker's radius.
const outlines: Point[][] = [
  [
    [0.9, 0],
    [0.78, 0.45],
    [0.45, 0.78],
    [0, 0.9],
    [-0.45, 0.78],
    [-0.78, 0.45],
    [-0.9, 0],
    [-0.78, -0.45],
    [-0.45, -0.78],
    [0, -0.9],
    [0.45, -0.78],
    [0.78, -0.45],
  ],
  [
    [-0.8, -0.8],
    [0.8, -0.8],
    [0.8, 0.8],
    [-0.8, 0.8],
  ],
  [
    [0, -1.05],
    [1, 0.75],
    [-1, 0.75],
  ],
  [
    [0, -1.15],
    [1.15, 0],
    [0, 1.15],
    [-1.15, 0],
  ],
  [
    [0, 1.05],
    [1, -0.75],
    [-1, -0.75],
  ],
  [
    [-0.35, -1],
    [0.35, -1],
    [0.35, -0.35],
    [1, -0.35],
    [1, 0.35],
    [0.35, 0.35],
    [0.35, 1],
    [-0.35, 1],
    [-0.35, 0.35],
    [-1, 0.35],
    [-1, -0.35],
    [-0.35, -0.35],
  ],
  [
    [0, -1.1],
    [1.05, -0.34],
    [0.65, 0.9],
    [-0.65, 0.9],
    [-1.05, -0.34],
  ],
];

export function lookOf(style: number): Look {
  return {
    color: `--series-${(style % 8) + 1}`,
    dash: dashes[style % dashes.length]!,
    marker: style % outlines.length,
  };
}

/** An SVG path around (x, y). */
export function markerPath(marker: number, x: number, y: number, radius: number): string {
  const points = outlines[marker]!.map(
    ([dx, dy]) => `${(x + radius * dx).toFixed(2)},${(y + radius * dy).toFixed(2)}`,
  );
  return `M${points.join('L')}Z`;
}

/** On a canvas; `scale` is its pixels per CSS pixel. */
export function drawMarker(
  context: CanvasRenderingContext2D,
  style: number,
  x: number,
  y: number,
  scale: number,
): void {
  const { marker, color: name } = lookOf(style);
  context.fillStyle = color(name);
  context.fill(new Path2D(markerPath(marker, x, y, 4 * scale)));
}

/** The sample of a curve for a legend. */
export function Sample({ style, faint = false }: { style: number; faint?: boolean }) {
  const look = lookOf(style);
  const paint = `var(${look.color})`;
  return (
    <svg class="sample" width="40" height="14" aria-hidden="true">
      <line
        x1="0"
        x2="40"
        y1="7"
        y2="7"
        stroke={paint}
        stroke-width={faint ? 1 : 2}
        stroke-dasharray={look.dash.join(' ')}
      />
      <path
        d={markerPath(look.marker, 20, 7, faint ? 3 : 4.5)}
        fill={faint ? 'var(--ground)' : paint}
        stroke={paint}
      />
    </svg>
  );
}
