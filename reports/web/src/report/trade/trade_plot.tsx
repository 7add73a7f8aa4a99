// Error against cost, both logarithmic: a line per engine and integrator, a point per step, the front ringed.
import { useMemo, useState } from 'preact/hooks';

import { lookOf, markerPath } from '../../shared/plot_marks';
import { duration } from '../../shared/durations';
import { short } from '../numbers';
import { useWidth } from '../use_width';
import { visible } from '../visible';
import { type LogAxis, logAxis } from './axis';
import { isDrawn, type Point, type Series, settingOf } from './join';

const height = 480;
const margin = { left: 62, right: 14, top: 12, bottom: 46 };
const reach = 30; // [px] from a point at which it is named

interface Placed {
  point: Point;
  x: number;
  y: number;
}

function Grid({ x, y, width, error }: { x: LogAxis; y: LogAxis; width: number; error: string }) {
  const [bottom, right] = [height - margin.bottom, width - margin.right];
  return (
    <g class="grid">
      {x.ticks.map(({ at, label }) => (
        <g key={label}>
          <line x1={at} x2={at} y1={margin.top} y2={bottom} />
          <text x={at} y={bottom + 16} text-anchor="middle">
            {label}
          </text>
        </g>
      ))}
      {y.ticks.map(({ at, label }) => (
        <g key={label}>
          <line x1={margin.left} x2={right} y1={at} y2={at} />
          <text x={margin.left - 6} y={at + 4} text-anchor="end">
            {label}
          </text>
        </g>
      ))}
      <text x={(margin.left + right) / 2} y={height - 8} text-anchor="middle">
        CPU seconds per simulated second
      </text>
      <text transform={`translate(14 ${(margin.top + bottom) / 2}) rotate(-90)`} text-anchor="middle">
        {visible(error)}
      </text>
    </g>
  );
}

function Line({ placed, style }: { placed: Placed[]; style: number }) {
  const { color, dash, marker } = lookOf(style);
  const paint = `var(${color})`;
  return (
    <g>
      <polyline
        points={placed.map(({ x, y }) => `${x.toFixed(1)},${y.toFixed(1)}`).join(' ')}
        stroke={paint}
        stroke-dasharray={dash.join(' ')}
      />
      {placed.map(({ point, x, y }, i) => (
        <g key={i}>
          {point.onFront ? <circle class="front" cx={x} cy={y} r="8" /> : null}
          <path d={markerPath(marker, x, y, 4.5)} fill={paint} />
        </g>
      ))}
    </g>
  );
}

function told(list: Series[], point: Point): string {
  const front = point.onFront
    ? 'nothing is both cheaper and better'
    : point.dominatedBy && `dominated by ${point.dominatedBy}`;
  return visible(
    [
      `${list[point.series]!.label} at ${settingOf(point)}`,
      `error ${short(point.error)}`,
      `${short(point.cost)} CPU s/s`,
      `${duration(point.perBodyStep)} per body-step`,
      front,
    ]
      .filter(Boolean)
      .join('; '),
  );
}

interface TradePlotProps {
  list: Series[];
  hidden: Set<number>;
  error: string; // what the axis says
  level: number | null; // what the scenario allows, in the measure's unit
  label: string;
}

export function TradePlot({ list, hidden, error, level, label }: TradePlotProps) {
  const [host, width] = useWidth<HTMLDivElement>(900);
  const [named, name] = useState<Point | null>(null);
  const { x, y, lines } = useMemo(() => {
    const drawn = list.flatMap((s) => s.points.filter(isDrawn)); // hidden ones too: axes stay where they are
    const xAxis = logAxis(
      drawn.map((p) => p.cost!),
      margin.left,
      width - margin.right,
    );
    const yAxis = logAxis(
      [...drawn.map((p) => p.error!), ...(level ? [level] : [])],
      height - margin.bottom,
      margin.top,
    );
    const place = (point: Point): Placed => ({
      point,
      x: xAxis.place(point.cost!),
      y: yAxis.place(point.error!),
    });
    return { x: xAxis, y: yAxis, lines: list.map((s) => s.points.filter(isDrawn).map(place)) };
  }, [list, width, level]);

  const point = (event: PointerEvent) => {
    const box = (event.currentTarget as Element).getBoundingClientRect();
    const away = (p: Placed) => Math.hypot(p.x - (event.clientX - box.left), p.y - (event.clientY - box.top));
    const near = lines.flatMap((line, i) => (hidden.has(i) ? [] : line)).sort((a, b) => away(a) - away(b))[0];
    name(near && away(near) < reach ? near.point : null);
  };

  return (
    <div ref={host} class="trade-plot">
      <svg
        width={width}
        height={height}
        role="img"
        aria-label={visible(label)}
        onPointerMove={point}
        onPointerLeave={() => name(null)}
      >
        <Grid x={x} y={y} width={width} error={error} />
        {level ? (
          <g class="level">
            <line x1={margin.left} x2={width - margin.right} y1={y.place(level)} y2={y.place(level)} />
            <text x={width - margin.right - 4} y={y.place(level) - 5} text-anchor="end">
              allowed {short(level)}
            </text>
          </g>
        ) : null}
        {lines.map((placed, i) => (hidden.has(i) ? null : <Line key={i} placed={placed} style={i} />))}
      </svg>
      <p class="named on-screen">
        {named ? told(list, named) : 'Point at a setting to read it; every one stands in the tables below.'}
      </p>
    </div>
  );
}
