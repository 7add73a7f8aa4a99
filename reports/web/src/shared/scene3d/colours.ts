// Colours of bodies, and those that the page's style sheet gives.
import type { Colour } from './segments';

/** Okabe and Ito's palette, told apart with any colour vision (without black; yellow darkened). */
const palette = ['#0072b2', '#e69f00', '#009e73', '#cc79a7', '#56b4e9', '#d55e00', '#c9b800', '#8a8a8a'];

export function hexColour(text: string): Colour | null {
  const match = /^#([0-9a-f]{2})([0-9a-f]{2})([0-9a-f]{2})$/i.exec(text);
  return match ? (match.slice(1).map((h) => parseInt(h, 16) / 255) as Colour) : null;
}

/** A body's own colour, else one by its place; a locked body is darker. */
export function bodyColour(body: { color: string; locked: boolean }, index: number): Colour {
  const colour = hexColour(body.color) ?? hexColour(palette[index % palette.length]!)!;
  return body.locked ? (colour.map((c) => 0.62 * c) as Colour) : colour;
}

export interface Theme {
  ground: Colour;
  ink: Colour;
  faint: Colour; // grids
  arrows: { velocity: Colour; momentum: Colour; 'angular momentum': Colour; impulse: Colour; normal: Colour };
}

const light: Theme['arrows'] = {
  velocity: hexColour('#0b5cad')!,
  momentum: hexColour('#0a7d4f')!,
  'angular momentum': hexColour('#8b3fa8')!,
  impulse: hexColour('#c2410c')!,
  normal: hexColour('#666666')!,
};
const dark: Theme['arrows'] = {
  velocity: hexColour('#6db6ff')!,
  momentum: hexColour('#4ade9c')!,
  'angular momentum': hexColour('#d79bf0')!,
  impulse: hexColour('#ff9d5c')!,
  normal: hexColour('#b0b0b0')!,
};

export const mix = (a: Colour, b: Colour, k: number): Colour => [
  a[0] + k * (b[0] - a[0]),
  a[1] + k * (b[1] - a[1]),
  a[2] + k * (b[2] - a[2]),
];

export const css = (c: Colour): string => `rgb(${c.map((x) => Math.round(255 * x)).join(' ')})`;

/** Any colour that a style sheet can say, read back from a canvas as "#rrggbb". */
function cssColour(text: string, otherwise: Colour): Colour {
  const context = text && document.createElement('canvas').getContext('2d');
  if (!context) return otherwise;
  context.canvas.width = context.canvas.height = 1;
  context.fillStyle = '#010203';
  context.fillStyle = text;
  context.fillRect(0, 0, 1, 1);
  const [r, g, b] = context.getImageData(0, 0, 1, 1).data;
  if (r === 1 && g === 2 && b === 3) return otherwise;
  return [r! / 255, g! / 255, b! / 255];
}

/** Ground and ink from --ground and --ink where an element stands; else after the system's light or dark. */
export function readTheme(element: Element): Theme {
  const style = getComputedStyle(element);
  const night = matchMedia('(prefers-color-scheme: dark)').matches;
  const ground = cssColour(style.getPropertyValue('--ground').trim(), night ? [0.07, 0.08, 0.1] : [1, 1, 1]);
  const ink = cssColour(
    style.getPropertyValue('--ink').trim(),
    night ? [0.92, 0.93, 0.95] : [0.1, 0.1, 0.12],
  );
  const brightness = (c: Colour): number => 0.3 * c[0] + 0.6 * c[1] + 0.1 * c[2];
  return { ground, ink, faint: mix(ground, ink, 0.22), arrows: brightness(ground) < 0.5 ? dark : light };
}
