// One series of the history as a small plot over its runs, with its change points marked.
import type { History } from '../../shared/documents';
import { markerPath } from '../../shared/plot_marks';
import { short } from '../numbers';
import { visible } from '../visible';

export type HistorySeries = History['series'][number];

const width = 340;
const height = 110;
const margin = { left: 66, right: 10, top: 10, bottom: 20 };

/** At least a tenth of the value high, so that noise in the last digits does not look like a change. */
function range(values: number[]): [number, number] {
  const least = Math.min(...values);
  const greatest = Math.max(...values);
  const middle = (least + greatest) / 2;
  const half = Math.max(0.58 * (greatest - least), 0.05 * Math.abs(middle)) || 1;
  return [middle - half, middle + half];
}

export function SeriesPlot({ of }: { of: HistorySeries }) {
  const { points } = of;
  const finite = points.flatMap((p, i) =>
    typeof p.value === 'number' && Number.isFinite(p.value) ? [{ i, value: p.value }] : [],
  );
  if (finite.length === 0) return <p class="note">no finite values</p>;
  const values = finite.map((p) => p.value);
  const [low, high] = range(of.scale === 'ratio' ? [...values, 1] : values);
  const [bottom, right] = [height - margin.bottom, width - margin.right];
  const x = (i: number) =>
    margin.left +
    (points.length > 1 ? (i / (points.length - 1)) * (right - margin.left) : (right - margin.left) / 2);
  const y = (value: number) => bottom - ((value - low) / (high - low)) * (bottom - margin.top);
  const least = Math.min(...values);
  const greatest = Math.max(...values);
  const last = short(values[values.length - 1]);
  const spans = `least ${short(least)}, greatest ${short(greatest)}, last ${last} ${of.unit}`;
  const label = `${points.length} runs, ${spans}; ${of.changes.length} change points`;
  return (
    <svg class="series-plot" width={width} height={height} role="img" aria-label={visible(label)}>
      {[margin.top, bottom].map((at, i) => (
        <text key={i} x={margin.left - 5} y={at + 4} text-anchor="end">
          {short(i === 0 ? high : low, 3)}
        </text>
      ))}
      <line class="frame" x1={margin.left} x2={right} y1={bottom} y2={bottom} />
      {of.scale === 'ratio' ? <line class="anchor" x1={margin.left} x2={right} y1={y(1)} y2={y(1)} /> : null}
      {of.changes.map((change) => (
        <g key={change.id} class={`change ${change.state}`}>
          <line x1={x(change.index)} x2={x(change.index)} y1={margin.top} y2={bottom} />
          <path d={markerPath(4, x(change.index), margin.top, 5)} />
        </g>
      ))}
      <polyline points={finite.map((p) => `${x(p.i).toFixed(1)},${y(p.value).toFixed(1)}`).join(' ')} />
      {points.length <= 60
        ? finite.map((p) => <circle key={p.i} cx={x(p.i)} cy={y(p.value)} r="2.5" />)
        : null}
      <text x={margin.left} y={height - 5}>
        run {points[0]!.run}
      </text>
      <text x={right} y={height - 5} text-anchor="end">
        run {points[points.length - 1]!.run}
      </text>
    </svg>
  );
}
