// Points of a sweep with their costs, which the document keeps apart, and who dominates whom.
import type { Ending, Trade } from '../../shared/documents';
import { stepInWords } from '../../shared/durations';
import { buildOf } from '../builds';

export type Table = Trade['tables'][number];
export type Measure = Table['measures'][number];
type Times = Trade['times'][number];

export interface Point {
  series: number;
  dt: number; // [s]
  dtText: string;
  tolerance: number | null; // of integrators that control their error
  error: number | null;
  cost: number | null; // CPU seconds per simulated second
  perBodyStep: number | null; // [s]
  status: Ending;
  reason: string;
  onFront: boolean;
  dominatedBy: string;
}

export interface Series {
  label: string;
  of: Table['series'][number];
  points: Point[]; // in the order of the sweep
}

function key(engine: string, integrator: string, dtText: string, tolerance: number | null): string {
  return [engine, integrator, dtText, tolerance ?? ''].join('\u0000');
}

/** The builds of a sweep, that of native code first. */
export function buildsOf(list: Series[]): string[] {
  return [...new Set(list.map((s) => buildOf(s.of.version)))].sort();
}

export function isDrawn(p: Point): boolean {
  return p.error !== null && p.cost !== null && p.error > 0 && p.cost > 0;
}

/** Marks the points than which none is both cheaper and better. */
function markFront(points: Point[]): void {
  const drawn = points.filter((p) => p.error !== null && p.cost !== null);
  drawn.sort((a, b) => a.cost! - b.cost! || a.error! - b.error!);
  let best: Point | null = null;
  for (const p of drawn) {
    p.onFront = best === null || p.error! < best.error!;
    p.dominatedBy = '';
    if (p.onFront) best = p;
  }
}

/** The series with the errors of one measure.  The program's own front is kept for the measure that it was
 * made by. */
export function join(trade: Trade, table: Table, measure: string): Series[] {
  const costs = new Map<string, Times>();
  for (const t of trade.times)
    if (t.scenario === table.scenario) costs.set(key(t.engine, t.integrator, t.dt_text, t.tolerance), t);
  const list = table.series.map((of, series) => ({
    label: `${of.engine} ${of.integrator}`,
    of,
    points: of.points.map((p): Point => {
      const times = costs.get(key(of.engine, of.integrator, p.dt_text, p.tolerance));
      return {
        series,
        dt: p.dt,
        dtText: p.dt_text,
        tolerance: p.tolerance,
        error: p.errors[measure] ?? null,
        cost: times?.cpu_seconds_per_second ?? null,
        perBodyStep: times?.seconds_per_body_step ?? null,
        status: p.status,
        reason: p.reason,
        onFront: times?.on_front ?? false,
        dominatedBy: times?.dominated_by ?? '',
      };
    }),
  }));
  if (measure !== table.by)
    for (const build of buildsOf(list))
      markFront(list.filter((s) => buildOf(s.of.version) === build).flatMap((s) => s.points));
  return list;
}

/** "1/60" or "1/60, tolerance 1e-6". */
export function settingOf(p: Point): string {
  return p.tolerance === null ? stepInWords(p.dtText) : `${stepInWords(p.dtText)}, tolerance ${p.tolerance}`;
}
