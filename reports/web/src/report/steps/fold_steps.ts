// Sweeps to a matrix of scenarios and engines: which step each engine needs (harness/results/step_matrix.h chooses).
import type { Trade } from '../../shared/documents';
import { buildOf } from '../builds';
import { commandOf, sweepKey } from '../sweeps';

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
  file: number; // of the sweep, from 0
  sweep: string; // its key on the page of speed against accuracy
  source: string; // "cylon matrix", where another row has the same scenario; "" elsewhere
  measure: string; // what the errors are of
  cells: Map<string, StepCell>;
}

export interface StepMatrix {
  engines: string[];
  builds: Map<string, string>; // by engine; '': native code
  rows: StepRow[];
  scenarios: number; // of which several rows may be one
}

/** What a row needs; null: the table gives none. */
function stepsOf({ measures, by, cells }: Table) {
  const measure = measures.find((m) => m.name === by);
  return cells && measure ? { measure, cells } : null;
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

/** Names a sweep among those of the same scenario: by its command, and by its file where commands are the same. */
function sourceOf(row: StepRow, rows: StepRow[], trades: Trade[]): string {
  const same = rows.filter(({ scenario }) => scenario === row.scenario);
  if (same.length === 1) return '';
  const command = commandOf(trades[row.file]!);
  const alone = same.filter(({ file }) => commandOf(trades[file]!) === command).length === 1;
  return command && alone ? command : `${command || 'file'} (${row.file + 1})`;
}

/** How many scenarios have a row, or several. */
export function stepScenarios(trades: Trade[]): number {
  return new Set(trades.flatMap((trade) => trade.tables.filter(stepsOf).map(({ scenario }) => scenario))).size;
}

/** Tables of programs that are older than the cells are left out. */
export function foldSteps(trades: Trade[]): StepMatrix {
  const engines: string[] = [];
  const builds = new Map<string, string>();
  const rows: StepRow[] = [];
  for (const [file, trade] of trades.entries())
    for (const table of trade.tables) {
      const found = stepsOf(table);
      if (!found) continue;
      const { measure } = found;
      const costs = costsOf(trade, table);
      const cells = found.cells.map((cell) => cellOf(table, cell, costs));
      for (const { engine, version } of cells) {
        if (!engines.includes(engine)) engines.push(engine);
        if (version) builds.set(engine, buildOf(version));
      }
      rows.push({
        scenario: table.scenario,
        file,
        sweep: sweepKey(trades, file, table),
        source: '',
        measure: `${measure.name} against ${measure.against}`,
        cells: new Map(cells.map((cell) => [cell.engine, cell])),
      });
    }
  for (const row of rows) row.source = sourceOf(row, rows, trades);
  return { engines, builds, rows, scenarios: stepScenarios(trades) };
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
