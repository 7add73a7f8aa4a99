// Energy, momentum and angular momentum against time, as the harness computed them from the states.
import { useMemo, useState } from 'preact/hooks';

import type { TraceBlock } from '../../shared/block';
import type { TotalCurve } from '../../shared/documents';
import { TimePlot } from '../../shared/plot';
import type { TimeCursor } from '../../shared/plot_cursor';
import type { Curve } from '../../shared/plot_data';
import { short } from '../numbers';
import { CurveTable, described } from './curve_table';
import type { Compared } from './error_curves';

const pictures: { title: string; names: TotalCurve['name'][] }[] = [
  { title: 'Energy', names: ['energy', 'kinetic energy'] },
  { title: 'Momentum', names: ['momentum'] },
  { title: 'Angular momentum', names: ['angular momentum'] },
];

function read(block: TraceBlock, of: TotalCurve, change: boolean, label: string, style: number): Curve {
  const value = Float64Array.from(block.floats(of.value));
  const start = value[0] ?? 0;
  return { label, style, time: block.floats(of.time), value: change ? value.map((x) => x - start) : value };
}

function curvesOf(
  names: TotalCurve['name'][],
  block: TraceBlock,
  other: Compared | null,
  change: boolean,
): Curve[] {
  const own = block.trace.totals.filter((t) => names.includes(t.name));
  return own.flatMap((total, i) => {
    const name = `${total.name}${total.component ? `, ${total.component}` : ''}`;
    const same = (t: TotalCurve) => t.name === total.name && t.component === total.component;
    const theirs = other?.block.trace.totals.find(same);
    const curves = [read(block, total, change, name, i)];
    if (other && theirs)
      curves.push({ ...read(other.block, theirs, change, `${other.engine}: ${name}`, i), faint: true });
    return curves;
  });
}

interface TotalCurvesProps {
  block: TraceBlock;
  other: Compared | null;
  cursor: TimeCursor;
}

export function TotalCurves({ block, other, cursor }: TotalCurvesProps) {
  const [change, setChange] = useState(true);
  const list = useMemo(
    () =>
      pictures.map(({ title, names }) => ({
        title,
        unit: block.trace.totals.find((t) => names.includes(t.name))?.unit ?? '',
        curves: curvesOf(names, block, other, change),
      })),
    [block, other, change],
  );
  return (
    <section aria-labelledby="totals-heading">
      <h3 id="totals-heading">Energy and momenta against time</h3>
      <label class="on-screen">
        <input type="checkbox" checked={change} onChange={() => setChange(!change)} /> change since the start
      </label>
      {block.trace.totals.length === 0 ? <p class="empty">The trace holds none.</p> : null}
      <div class="total-plots">
        {list
          .filter(({ curves }) => curves.length > 0)
          .map(({ title, unit, curves }) => {
            const axis = `${change ? '\u0394 ' : ''}${title.toLowerCase()} [${unit}]`;
            return (
              <figure key={title}>
                <TimePlot
                  curves={curves}
                  label={described(title, curves, unit)}
                  axis={axis}
                  log={false}
                  cursor={cursor}
                  number={short}
                  height={250}
                />
                <figcaption>
                  <CurveTable curves={curves} cursor={cursor} log={false} unit={unit} caption={axis} />
                </figcaption>
              </figure>
            );
          })}
      </div>
      <p class="note">
        Curves are stored in single precision: a change below 6e-8 of the value itself does not show. The
        verdicts above come from the whole states.
      </p>
    </section>
  );
}
