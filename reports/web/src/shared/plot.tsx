// Curves over time: a thin shell around uPlot with logarithmic axes, the shared cursor and the page's
// colours.
import 'uplot/dist/uPlot.min.css';
import './plot.css';

import { useEffect, useRef } from 'preact/hooks';
import uPlot from 'uplot';

import { aligned, type Curve, floorOf } from './plot_data';
import { drawBands, drawExtras } from './plot_draw';
import { lookOf } from './plot_marks';
import type { TimeCursor } from './plot_cursor';
import { color, onTheme } from './theme';

export interface TimePlotProps {
  curves: Curve[];
  label: string; // of the whole picture, for screen readers: what it shows and what stands out
  axis: string; // what y is, with its unit
  log: boolean;
  cursor: TimeCursor;
  number: (value: number) => string;
  height?: number; // [px]
}

// Distances of ticks for values of any magnitude: what diverges reaches 1e38.
const distances = Array.from({ length: 130 }, (_, i) => i - 50).flatMap((power) =>
  [1, 2, 5].map((factor) => Number(`${factor}e${power}`)),
);

function axes(props: TimePlotProps): uPlot.Axis[] {
  const common = {
    stroke: () => color('--ink'),
    grid: { stroke: () => color('--line'), width: 1 },
    ticks: { stroke: () => color('--line'), width: 1 },
    font: '12px system-ui, sans-serif',
    labelFont: '12px system-ui, sans-serif',
    labelSize: 18,
    labelGap: 0,
  };
  const values = (_: uPlot, splits: (number | null)[]) =>
    splits.map((v) => (v === null ? '' : props.number(v)));
  return [
    { ...common, label: 'time [s]', values, incrs: distances, size: 34 },
    {
      ...common,
      label: props.axis,
      values,
      incrs: distances,
      size: 64,
      ...(props.log ? { splits: decadeSplits, filter: (_: uPlot, splits: number[]) => splits } : {}),
    },
  ];
}

/** Whole decades, so that the grid says what it is. */
function decades(_: uPlot, least: number, greatest: number): uPlot.Range.MinMax {
  const low = Math.floor(Math.log10(least));
  return [10 ** low, 10 ** Math.max(low + 1, Math.ceil(Math.log10(greatest)))];
}

const paperWidth = 680; // [px], within the margins of an upright A4 page
const pixelsPerSplit = 22;

/** Powers of ten, as many as there is room for; of few decades also their doubles and fives. */
function decadeSplits(u: uPlot, _: number, least: number, greatest: number): number[] {
  const [low, high] = [Math.round(Math.log10(least)), Math.round(Math.log10(greatest))];
  const room = Math.max(2, u.bbox.height / devicePixelRatio / pixelsPerSplit);
  const every = Math.ceil((high - low) / room);
  const between = 3 * (high - low) <= room ? [1, 2, 5] : [1];
  const out: number[] = [];
  for (let power = low; power <= high; power += every)
    for (const factor of between) out.push(factor * 10 ** power);
  return out.filter((value) => value <= greatest);
}

/** A constant lies in the middle, not on the edge of an axis to 100. */
function roomy(least: number | null, greatest: number | null): uPlot.Range.MinMax {
  if (least == null || greatest == null) return [-1, 1];
  if (least === greatest) return [least - (Math.abs(least) || 1), least + (Math.abs(least) || 1)];
  return uPlot.rangeNum(least, greatest, 0.1, true);
}

function options(props: TimePlotProps, width: number): uPlot.Options {
  const { curves, cursor, log } = props;
  const levels = curves.flatMap((c) => (c.allowed != null && c.allowed > 0 ? [c.allowed] : []));
  const [from, to] = cursor.window ?? cursor.whole;
  const edges = curves.flatMap(({ band }) => (band ? [...Array.from(band.low), ...Array.from(band.high)] : []));
  return {
    width,
    height: props.height ?? 260,
    legend: { show: false },
    scales: {
      x: { time: false, auto: false, min: from, max: to },
      y: log
        ? {
            distr: 3,
            range: (u, a, b) => decades(u, Math.min(a ?? 1, ...levels), Math.max(b ?? 1, ...levels)),
          }
        : {
            range: (_: uPlot, a: number, b: number) =>
              a == null ? roomy(a, b) : roomy(Math.min(a, ...edges), Math.max(b, ...edges)),
          },
    },
    series: [
      {},
      ...curves.map((curve) => ({
        stroke: () => color(lookOf(curve.style).color),
        width: curve.faint ? 1 : 2,
        dash: lookOf(curve.style).dash,
        points: { show: false },
      })),
    ],
    axes: axes(props),
    cursor: { y: false, points: { size: 7 }, drag: { dist: 6, x: true, y: false } },
    hooks: {
      setScale: [
        (u, key) => {
          const { min, max } = u.scales.x!;
          if (key === 'x' && min != null && max != null) cursor.window = [min, max];
        },
      ],
      drawAxes: [(u) => drawBands(u, curves)],
      draw: [(u) => drawExtras(u, curves, (allowed) => `allowed ${props.number(allowed)}`)],
    },
  };
}

/** Keeps the plot at the cursor's time and span. */
function follow(u: uPlot, cursor: TimeCursor): void {
  const [from, to] = cursor.window ?? cursor.whole;
  if (to > from && (u.scales.x!.min !== from || u.scales.x!.max !== to))
    u.setScale('x', { min: from, max: to });
  u.setCursor({ left: u.valToPos(cursor.time, 'x'), top: 0 }, false);
}

function listenTo(u: uPlot, cursor: TimeCursor): void {
  const time = (event: MouseEvent) => u.posToVal(event.clientX - u.over.getBoundingClientRect().left, 'x');
  u.over.addEventListener('mousemove', (event) => cursor.hover(time(event)));
  u.over.addEventListener('mouseleave', () => {
    cursor.hover(null);
    queueMicrotask(() => follow(u, cursor)); // uPlot has taken its own line away
  });
  u.over.addEventListener('click', (event) => (cursor.pin = time(event)));
  u.over.addEventListener('dblclick', () => (cursor.window = null));
}

export function TimePlot(props: TimePlotProps) {
  const host = useRef<HTMLDivElement>(null);
  const { curves, cursor, log, axis, height } = props;

  useEffect(() => {
    const node = host.current!;
    const data = aligned(curves, log ? floorOf(curves) : null) as uPlot.AlignedData;
    const u = new uPlot(options(props, Math.max(200, node.clientWidth)), data, node);
    listenTo(u, cursor);
    const fit = () => {
      const width = Math.max(200, node.clientWidth);
      if (width !== u.width) u.setSize({ width, height: u.height });
    };
    const onPaper = () => u.setSize({ width: paperWidth, height: u.height });
    const size = new ResizeObserver(fit);
    size.observe(node);
    addEventListener('beforeprint', onPaper);
    addEventListener('afterprint', fit);
    const stops = [cursor.listen(() => follow(u, cursor)), onTheme(() => u.redraw(false))];
    queueMicrotask(() => follow(u, cursor)); // after the first drawing has its scales
    return () => {
      size.disconnect();
      removeEventListener('beforeprint', onPaper);
      removeEventListener('afterprint', fit);
      for (const stop of stops) stop();
      u.destroy();
    };
  }, [curves, cursor, log, axis, height]);

  return <div class="plot" ref={host} role="img" aria-label={props.label} />;
}
