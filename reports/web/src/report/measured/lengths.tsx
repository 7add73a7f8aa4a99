// What the data say of their own lengths, without any engine: two signs, and by which side the body lies on.
import { useMemo } from 'preact/hooks';

import type { Lengths, Prediction } from '../../shared/measured_documents';
import { TimePlot } from '../../shared/plot';
import { TimeCursor } from '../../shared/plot_cursor';
import type { Curve } from '../../shared/plot_data';
import { CurveTable, described } from '../cell/curve_table';
import { short } from '../numbers';
import { useWidth } from '../use_width';
import { visible } from '../visible';
import { estimateText } from './data_sets';

const height = 150;
const margin = { left: 128, right: 16, top: 8, bottom: 30 };

interface Sign {
  label: string;
  values: number[];
  mean: Lengths['flight'];
}

function signs({ each, flight, rest }: Lengths): Sign[] {
  const known = (x: number | null): x is number => x !== null;
  return [
    { label: 'from free flight', values: each.map((run) => run.flight).filter(known), mean: flight },
    {
      label: 'from heights at rest',
      values: each.flatMap(({ height, half }) => (height !== null && half ? [height / half] : [])),
      mean: rest,
    },
  ].filter(({ values }) => values.length > 0);
}

/** A dot for each run, spread so that they do not hide each other; a bar for the interval of the mean. */
function Dots({ of, title }: { of: Sign[]; title: string }) {
  const [host, width] = useWidth<HTMLDivElement>(900);
  const all = [...of.flatMap(({ values }) => values), 1];
  const span = Math.max(...all) - Math.min(...all) || 0.01;
  const [low, high] = [Math.min(...all) - 0.05 * span, Math.max(...all) + 0.05 * span];
  const x = (v: number) => margin.left + ((v - low) / (high - low)) * (width - margin.left - margin.right);
  const row = (height - margin.top - margin.bottom) / of.length;
  const told = of.map(({ label, mean }) => `${label}: mean ${estimateText(mean, 1, 4)}`).join('; ');
  const tick = 10 ** Math.floor(Math.log10(high - low));
  const step = (high - low) / tick > 4 ? tick : tick / 2;
  const ticks: number[] = [];
  for (let i = Math.ceil(low / step); i * step <= high; ++i) ticks.push(i * step);
  return (
    <div ref={host} class="dots">
      <svg width={width} height={height} role="img" aria-label={visible(`Lengths of ${title}, measured over true. ${told}`)}>
        {ticks.map((t) => (
          <g key={t}>
            <line class="grid" x1={x(t)} x2={x(t)} y1={margin.top} y2={height - margin.bottom} />
            <text x={x(t)} y={height - margin.bottom + 16} text-anchor="middle">
              {short(t, 5)}
            </text>
          </g>
        ))}
        <line class="one" x1={x(1)} x2={x(1)} y1={margin.top} y2={height - margin.bottom} />
        {of.map(({ label, values, mean }, k) => (
          <g key={label}>
            <text x={margin.left - 8} y={margin.top + (k + 0.5) * row + 4} text-anchor="end">
              {label}
            </text>
            {values.map((v, i) => (
              <circle key={i} cx={x(v)} cy={margin.top + (k + 0.15 + 0.7 * ((i * 0.618034) % 1)) * row} r="2" />
            ))}
            {mean.low !== null && mean.high !== null ? (
              <line class="mean" x1={x(mean.low)} x2={x(mean.high)} y1={margin.top + (k + 0.5) * row} y2={margin.top + (k + 0.5) * row} />
            ) : null}
          </g>
        ))}
      </svg>
    </div>
  );
}

const mean = (values: number[]) => values.reduce((sum, x) => sum + x, 0) / values.length;

/** The mean height for each side that is up: a centre that is off would show as a difference of opposite sides. */
function Sides({ each }: { each: Lengths['each'] }) {
  const sides = [...new Set(each.map(({ side }) => side))].filter((side) => side !== 0).sort((a, b) => a - b);
  if (sides.length === 0) return null;
  return (
    <table>
      <caption>Heights of the centre at rest, by the side of the body that is up</caption>
      <thead>
        <tr>
          {['side up', 'runs', 'height [mm]', 'half of the thickness [mm]', 'measured/true'].map((head) => (
            <th key={head} scope="col">
              {head}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {sides.map((side) => {
          const runs = each.filter((run) => run.side === side && run.height !== null && run.half !== null);
          const [height, half] = [mean(runs.map((run) => run.height!)), mean(runs.map((run) => run.half!))];
          return (
            <tr key={side}>
              <th scope="row">
                {side > 0 ? '+' : '-'}
                {'xyz'[Math.abs(side) - 1]}
              </th>
              <td class="number">{runs.length}</td>
              <td class="number">{(1000 * height).toFixed(2)}</td>
              <td class="number">{(1000 * half).toFixed(2)}</td>
              <td class="number">{(height / half).toFixed(4)}</td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}

/** Heights of a flight less the parabola of the scene's gravity that lies nearest: right lengths leave noise alone. */
function Falls({ of }: { of: Prediction }) {
  const curves = useMemo<Curve[]>(
    () =>
      of.drawn.runs.flatMap(({ run, time, off_the_fall: off = [] }, style) =>
        off.length > 0
          ? [{ label: `run ${run}`, style, time: time.slice(0, off.length), value: off.map((h) => 1000 * h) }]
          : [],
      ),
    [of],
  );
  const cursor = useMemo(
    () => new TimeCursor([0, Math.max(...curves.map(({ time }) => time[time.length - 1]!), 1e-3)], 0),
    [curves],
  );
  if (curves.length === 0) return null;
  return (
    <figure>
      <TimePlot
        curves={curves}
        label={described('Heights in free flight less the fall of the model', curves, 'mm')}
        axis="off the fall [mm]"
        log={false}
        cursor={cursor}
        number={short}
        height={200}
      />
      <figcaption>
        <CurveTable curves={curves} cursor={cursor} log={false} unit="mm" caption="Heights in free flight less the fall of the model" />
      </figcaption>
    </figure>
  );
}

const verdict = ({ low, high }: Lengths['flight']) =>
  low !== null && high !== null && low <= 1 && 1 <= high ? '1 is inside the interval' : '1 is outside the interval';

export function LengthsView({ of }: { of: Prediction }) {
  const { lengths } = of;
  if (!lengths) return null;
  const rough = lengths.each.flatMap(({ roughness }) => (roughness === null ? [] : [roughness]));
  const list = signs(lengths);
  return (
    <section aria-labelledby="lengths-heading">
      <h4 id="lengths-heading">What the data say of their lengths</h4>
      <ul>
        <li>
          Free flight: a fall of {estimateText(lengths.flight, lengths.gravity, 3)} m/s², where it is{' '}
          {short(lengths.gravity)}; measured over true {estimateText(lengths.flight, 1, 4)} in {lengths.flight.runs} runs:{' '}
          {verdict(lengths.flight)}
          {rough.length > 0 ? `. Heights lie ${short(1000 * mean(rough), 2)} mm off a parabola of any fall (mean of root mean squares)` : ''}.
        </li>
        <li>
          Rest: the centre lies {estimateText(lengths.height, 1000, 2)} mm up; measured over true{' '}
          {estimateText(lengths.rest, 1, 4)} in {lengths.rest.runs} runs: {verdict(lengths.rest)}
          {lengths.tilt === null ? '' : `. There the measured side is tilted by ${short(1000 * lengths.tilt, 3)} mrad (root mean square)`}.
        </li>
      </ul>
      {list.length > 0 ? <Dots of={list} title={of.title} /> : null}
      <div class="scroll" tabIndex={0} role="region" aria-label="Heights at rest by side">
        <Sides each={lengths.each} />
      </div>
      <Falls of={of} />
    </section>
  );
}
