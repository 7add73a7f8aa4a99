// Errors against time with what is allowed: each in its unit, or all as shares of what is allowed.
import { useMemo, useState } from 'preact/hooks';

import type { TraceBlock } from '../../shared/block';
import type { ErrorCurve } from '../../shared/documents';
import { TimePlot } from '../../shared/plot';
import type { TimeCursor } from '../../shared/plot_cursor';
import type { Curve } from '../../shared/plot_data';
import { short } from '../numbers';
import type { ClaimRow } from './claims';
import { CurveTable, described } from './curve_table';

export interface Compared {
  engine: string;
  block: TraceBlock;
}

interface Group {
  unit: string;
  curves: Curve[];
}

function read(block: TraceBlock, of: ErrorCurve, share: boolean, label: string, style: number): Curve {
  const scale = share && of.allowed ? of.allowed : 1;
  const value = block.floats(of.value);
  const first = of.first_violation;
  return {
    label,
    style,
    time: block.floats(of.time),
    value: scale === 1 ? value : value.map((x) => x / scale),
    allowed: share ? 1 : of.allowed,
    violation: first ? { time: first.time, value: first.value === null ? null : first.value / scale } : null,
  };
}

function groups(rows: ClaimRow[], block: TraceBlock, other: Compared | null, share: boolean): Group[] {
  const out = new Map<string, Group>();
  const add = (unit: string, curve: Curve) => {
    const key = share ? '' : unit;
    const group = out.get(key) ?? { unit: key, curves: [] };
    group.curves.push(curve);
    out.set(key, group);
  };
  for (const { curve, index } of rows) {
    if (!curve || (share && !curve.allowed)) continue;
    add(curve.unit, read(block, curve, share, curve.claim, index));
    const theirs = other?.block.trace.errors.find((e) => e.claim === curve.claim);
    if (other && theirs)
      add(theirs.unit, {
        ...read(other.block, theirs, share, `${other.engine}: ${theirs.claim}`, index),
        faint: true,
      });
  }
  return [...out.values()];
}

interface ErrorCurvesProps {
  rows: ClaimRow[]; // those to show
  block: TraceBlock;
  other: Compared | null;
  cursor: TimeCursor;
}

export function ErrorCurves({ rows, block, other, cursor }: ErrorCurvesProps) {
  const [chosen, choose] = useState<boolean | null>(null);
  const units = new Set(rows.flatMap((row) => (row.curve ? [row.curve.unit] : [])));
  const share = chosen ?? units.size > 1;
  const list = useMemo(() => groups(rows, block, other, share), [rows, block, other, share]);
  const unmeasured = rows.filter((row) => !row.curve?.allowed).length;
  return (
    <section aria-labelledby="errors-heading">
      <h3 id="errors-heading">Errors against time</h3>
      <fieldset class="choice on-screen">
        <legend class="unseen">Scale of the errors</legend>
        <label>
          <input type="radio" name="error-scale" checked={!share} onChange={() => choose(false)} /> in their
          units
        </label>
        <label>
          <input type="radio" name="error-scale" checked={share} onChange={() => choose(true)} /> over what is
          allowed
        </label>
      </fieldset>
      {list.length === 0 ? <p class="empty">No claim is chosen: tick claims in the table above.</p> : null}
      {share && unmeasured > 0 ? (
        <p class="note">{unmeasured} of the chosen claims allow nothing and are left out.</p>
      ) : null}
      {list.map(({ unit, curves }) => {
        const axis = share ? 'error / allowed' : `error [${unit || '1'}]`;
        return (
          <figure key={unit}>
            <TimePlot
              curves={curves}
              label={described('Errors against time', curves, share ? 'times what is allowed' : unit)}
              axis={axis}
              log
              cursor={cursor}
              number={short}
            />
            <figcaption>
              <CurveTable
                curves={curves}
                cursor={cursor}
                log
                unit={share ? 'of allowed' : unit}
                caption={axis}
              />
            </figcaption>
          </figure>
        );
      })}
      <p class="note">
        Dashed levels: what is allowed. Ringed crosses: the first violation. Drag to look closer, double-click
        for all.
      </p>
    </section>
  );
}
