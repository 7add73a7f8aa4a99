// Sweeps to a matrix of scenarios and engines: which step each engine needs (harness/results/step_matrix.h chooses).
import type { Trade } from '../../shared/documents';
import { buildOf } from '../builds';

type Table = Trade['tables'][number];
type Cells = NonNullable<Table['cells']>;

export interface Reach {
  error: number;
  step: number | null; // [s]; null: not reached
  tolerance: number | null; // of an integrator that controls its error
  cost: number | null; // CPU seconds per simulated second
  coarsestTried: boolean;
  why: string; // where it is not reached
}

export interface StepCell {
  engine: string;
  version: string;
  integrator: string;
  order: number | null; // observed
  closedForm: boolean;
  adaptive: boolean;
  substeps: number; // in each step
  refusal: string; // "": the engine runs the scene
  avoidable: string; // engines that can run what this one refuses
  reach: Reach[];
  errors: { dt: number; error: number | null }[]; // from the coarsest step to the finest
}

export interface StepRow {
  scenario: string;
  measure: string; // what the errors are of
  cells: Map<string, StepCell>;
}

export interface StepMatrix {
  engines: string[];
  builds: Map<string, string>; // by engine; '': native code
  rows: StepRow[];
}

function costsOf(trade: Trade, table: Table): Map<string, number | null> {
  const key = (t: Trade['times'][number]) => [t.engine, t.integrator, t.dt_text, t.tolerance ?? ''].join('\u0000');
  return new Map(
    trade.times.filter((t) => t.scenario === table.scenario).map((t) => [key(t), t.cpu_seconds_per_second]),
  );
}

function cellOf(table: Table, cell: Cells[number], costs: Map<string, number | null>): StepCell {
  const of = table.series[cell.series]!;
  const reach = cell.reach.map(({ error, point: at, coarsest_tried, why }): Reach => {
    const point = at === null ? null : of.points[at]!;
    const key = point ? [of.engine, of.integrator, point.dt_text, point.tolerance ?? ''].join('\u0000') : '';
    return {
      error,
      step: point?.dt ?? null,
      tolerance: point?.tolerance ?? null,
      cost: costs.get(key) ?? null,
      coarsestTried: coarsest_tried,
      why,
    };
  });
  return {
    engine: of.engine,
    version: of.version,
    integrator: of.integrator,
    order: of.observed_order,
    closedForm: of.closed_form ?? false,
    adaptive: of.adaptive,
    substeps: of.substeps ?? 1,
    refusal: cell.refusal,
    avoidable: cell.avoidable,
    reach,
    errors: of.points.map((p) => ({ dt: p.dt, error: p.errors[table.by ?? ''] ?? null })),
  };
}

/** Tables of programs that are older than the cells are left out. */
export function foldSteps(trades: Trade[]): StepMatrix {
  const engines: string[] = [];
  const builds = new Map<string, string>();
  const rows: StepRow[] = [];
  for (const trade of trades)
    for (const table of trade.tables) {
      const measure = table.measures.find((m) => m.name === table.by);
      if (!table.cells || !measure) continue;
      const costs = costsOf(trade, table);
      const cells = table.cells.map((cell) => cellOf(table, cell, costs));
      for (const { engine, version } of cells) {
        if (!engines.includes(engine)) engines.push(engine);
        if (version) builds.set(engine, buildOf(version));
      }
      rows.push({
        scenario: table.scenario,
        measure: `${measure.name} against ${measure.against}`,
        cells: new Map(cells.map((cell) => [cell.engine, cell])),
      });
    }
  return { engines, builds, rows };
}

export function isInHouse(engine: string): boolean {
  return /^in-house(-float)?(\/|$)/.test(engine);
}

/** -log10 of the error at the coarsest tried step of at most `dt` [s]; null: there is none. */
export function digitsAt(cell: StepCell, dt: number): { dt: number; digits: number } | null {
  const at = cell.errors.find((p) => p.dt <= dt * (1 + 1e-9));
  if (!at || at.error === null) return null;
  return { dt: at.dt, digits: Math.min(16, -Math.log10(Math.max(at.error, 1e-16))) };
}
