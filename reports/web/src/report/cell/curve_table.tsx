// Curves as numbers: at the cursor, at their extremes, at the first violation.  It is the plot's legend and
// stands for the plot where nobody can see it.
import { useMemo } from 'preact/hooks';

import { type Curve, extremes, nearest } from '../../shared/plot_data';
import { type TimeCursor, useCursor } from '../../shared/plot_cursor';
import { Sample } from '../../shared/plot_marks';
import { count, short } from '../numbers';
import { visible } from '../visible';

function at(curve: Curve, time: number): string {
  const i = nearest(curve.time, time);
  if (i < 0) return 'no samples';
  return `${short(curve.value[i]!)} at ${short(curve.time[i]!, 5)} s`;
}

function remarks(curve: Curve, log: boolean): string {
  const e = extremes(curve);
  if (!e) return curve.value.length === 0 ? 'no samples' : 'nothing finite';
  const out: string[] = [];
  if (log && e.zeros > 0) out.push(`${count(e.zeros, 'sample')} exactly 0, drawn on the lower edge`);
  if (e.lost > 0)
    out.push(`${count(e.lost, 'sample')} not finite (or above 3.4e38), the first at ${short(e.lostAt)} s`);
  return out.join('; ');
}

interface RowProps {
  curve: Curve;
  cursor: TimeCursor;
  log: boolean;
  violations: boolean; // whether there is a column for them
}

function Row({ curve, cursor, log, violations }: RowProps) {
  const time = useCursor(cursor);
  const e = useMemo(() => extremes(curve), [curve]);
  const first = curve.violation;
  return (
    <tr>
      <th scope="row">
        <Sample style={curve.style} faint={curve.faint ?? false} /> {visible(curve.label)}
      </th>
      <td class="number at-cursor">{at(curve, time)}</td>
      <td class="number">{e ? `${short(e.least)} at ${short(e.leastAt)} s` : ''}</td>
      <td class="number">{e ? `${short(e.greatest)} at ${short(e.greatestAt)} s` : ''}</td>
      {violations ? (
        <td class="number">{first ? `${short(first.value)} at ${short(first.time)} s` : ''}</td>
      ) : null}
      <td>{remarks(curve, log)}</td>
    </tr>
  );
}

interface CurveTableProps {
  curves: Curve[];
  cursor: TimeCursor;
  log: boolean;
  unit: string;
  caption: string;
}

export function CurveTable({ curves, cursor, log, unit, caption }: CurveTableProps) {
  const violations = curves.some((curve) => curve.violation);
  const heads = [`curve${unit ? ` [${unit}]` : ''}`, 'at the cursor', 'least', 'greatest'];
  heads.push(...(violations ? ['first violation', 'remarks'] : ['remarks']));
  return (
    <div class="scroll curves" tabIndex={0} role="region" aria-label={caption}>
      <table>
        <thead>
          <tr>
            {heads.map((head) => (
              <th key={head} scope="col">
                {head}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {curves.map((curve, i) => (
            <Row key={i} curve={curve} cursor={cursor} log={log} violations={violations} />
          ))}
        </tbody>
      </table>
    </div>
  );
}

/** One sentence per curve, for the picture's description. */
export function described(title: string, curves: Curve[], unit: string): string {
  const lines = curves.map((curve) => {
    const e = extremes(curve);
    const most = e ? `greatest ${short(e.greatest)} ${unit} at ${short(e.greatestAt)} s` : 'nothing finite';
    const first = curve.violation ? `, first beyond its tolerance at ${short(curve.violation.time)} s` : '';
    return `${visible(curve.label)}: ${most}${first}`;
  });
  return `${title}. ${lines.join('. ')}.`;
}
